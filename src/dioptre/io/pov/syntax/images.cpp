// SPDX-License-Identifier: Apache-2.0
// image_map, bump_map, material_map and image_pattern.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "dioptre/io/image/read_image.h"
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kLargestSide = 1 << 14;
constexpr std::int64_t kMostPixels = 1 << 24;
constexpr int kPaletteEntries = 256;
constexpr std::size_t kMostShares = 1 << 16;

/// How the names of a format's files end.
struct FormatEndings {
  Keyword format;
  std::size_t count;
  std::string_view endings[2];
};
constexpr FormatEndings kFormats[] = {
    {Keyword::kBmp, 1, {".bmp"}},           {Keyword::kExr, 1, {".exr"}},
    {Keyword::kGif, 1, {".gif"}},           {Keyword::kHdr, 1, {".hdr"}},
    {Keyword::kJpeg, 2, {".jpg", ".jpeg"}}, {Keyword::kPgm, 1, {".pgm"}},
    {Keyword::kPng, 1, {".png"}},           {Keyword::kPot, 1, {".pot"}},
    {Keyword::kPpm, 1, {".ppm"}},           {Keyword::kSys, 0, {}},
    {Keyword::kTga, 1, {".tga"}},           {Keyword::kTiff, 2, {".tif", ".tiff"}},
};

/// A function's value as a pixel of 16 bits: what is too large or negative wraps round as integers
/// do, and what no integer of 32 bits holds is 0 (measured).
float pixel_of(double value) {
  constexpr double kSteps = 65535, kLimit = 0x1p31;
  const double steps = std::trunc(kSteps * value);
  if (!(std::abs(steps) < kLimit)) return 0;
  const auto low_bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(steps)) & 0xffff;
  return static_cast<float>(low_bits / kSteps);
}

/// Pixels from a function of the unit square, `function WIDTH, HEIGHT {...}`, the keyword taken.
/// The first row has y = 0, and the last row and column are at 1 (measured).
Shared<ImageData> parse_function_image(Parser& parser) {
  const auto width = parse_whole(parser, 1, kLargestSide);
  parser.skip_comma();
  const auto height = parse_whole(parser, 1, kLargestSide);
  if (width * height > kMostPixels) parser.fail("the image of the function is too large");
  const FunctionId function = parser.parse_function();
  ImageData data;
  data.width = static_cast<std::uint32_t>(width);
  data.height = static_cast<std::uint32_t>(height);
  data.channels = 1;
  constexpr std::uint64_t kWorkPerPixel = 256;
  parser.charge(static_cast<std::uint64_t>(width * height) * kWorkPerPixel);
  data.pixels.reserve(static_cast<std::size_t>(width * height));
  SceneQueries& queries = parser.queries();
  for (std::int64_t row = 0; row < height; ++row) {
    for (std::int64_t column = 0; column < width; ++column) {
      const double place[] = {static_cast<double>(column) / static_cast<double>(width - 1),
                              static_cast<double>(row) / static_cast<double>(height - 1), 0};
      data.pixels.push_back(pixel_of(queries.call(parser.scene(), function, place)));
    }
  }
  return data;
}

ImageSource::Mapping mapping_of(std::int64_t type) {
  switch (type) {
    case 1:
      return ImageSource::Mapping::kSpherical;
    case 2:
      return ImageSource::Mapping::kCylindrical;
    case 5:
      return ImageSource::Mapping::kToroidal;
    default:
      return ImageSource::Mapping::kPlanar;
  }
}

ImageSource::Interpolation interpolation_of(std::int64_t type) {
  switch (type) {
    case 2:
      return ImageSource::Interpolation::kBilinear;
    case 3:
      return ImageSource::Interpolation::kBicubic;
    case 4:
      return ImageSource::Interpolation::kNormalizedDistance;
    default:
      return ImageSource::Interpolation::kNone;
  }
}

/// `all SHARE`, or `NUMBER, SHARE` for one colour of a palette; the last one counts. The share of
/// all goes into the entries where some have their own.
void parse_shares(Parser& parser, double& all, std::vector<EntryShare>& entries) {
  const SourcePosition where = parser.position();
  const double number = parser.parse_float();
  if (!(number > -1 && number < kPaletteEntries)) {
    parser.fail_at(where, "a palette has colours 0 to 255");
  }
  parser.skip_comma();
  const auto share = static_cast<float>(parser.parse_float());
  if (entries.empty() && all != 0) {
    const auto of_all = static_cast<float>(std::exchange(all, 0));
    for (int i = 0; i < kPaletteEntries; ++i) {
      entries.push_back({static_cast<std::uint8_t>(i), of_all});
    }
  }
  if (entries.size() >= kMostShares) parser.fail_at(where, "too many colours with transparency");
  entries.push_back({static_cast<std::uint8_t>(number), share});
}

/// `filter all F`, or `filter NUMBER, F`.
void parse_filter(Parser& parser, ImageSource& image, ReadImageOptions& options) {
  parser.next();
  if (!parser.accept(Keyword::kAll)) {
    return parse_shares(parser, image.filter_all, options.entry_filters);
  }
  image.filter_all = parser.parse_float();
  options.entry_filters.clear();
}

/// `transmit all T`, which takes the place of what a palette says and adds to what other images do
/// (measured), or `transmit NUMBER, T`.
void parse_transmit(Parser& parser, ImageSource& image, ReadImageOptions& options) {
  parser.next();
  if (!parser.accept(Keyword::kAll)) {
    return parse_shares(parser, image.transmit_all, options.entry_transmits);
  }
  image.transmit_all = parser.parse_float();
  options.entry_transmits.clear();
  options.opaque_palette = true;
}

bool parse_image_modifier(Parser& parser, ImageSource& image, ReadImageOptions& options) {
  switch (keyword_at(parser)) {
    case Keyword::kGamma:
      parser.next();
      if (parser.accept(Keyword::kSrgb)) {
        options.gamma.reset();
      } else {
        options.gamma = parser.parse_float();
      }
      return true;
    case Keyword::kPremultiplied:
      parser.next();
      parser.parse_flag();
      return true;
    case Keyword::kMapType:
      parser.next();
      image.mapping = mapping_of(parse_whole(parser, 0, 100));
      return true;
    case Keyword::kInterpolate:
      parser.next();
      image.interpolation = interpolation_of(parse_whole(parser, 0, 100));
      return true;
    case Keyword::kOnce:
      parser.next();
      image.once = parser.parse_flag();
      return true;
    case Keyword::kUseColor:
    case Keyword::kUseColour:
      parser.next();
      image.use_color = parser.parse_flag();
      return true;
    case Keyword::kUseIndex:
      parser.next();
      image.use_color = !parser.parse_flag();
      return true;
    case Keyword::kUseAlpha:
      parser.next();
      image.use_alpha = parser.parse_flag();
      return true;
    case Keyword::kFilter:
      parse_filter(parser, image, options);
      return true;
    case Keyword::kTransmit:
      parse_transmit(parser, image, options);
      return true;
    default:
      return parser.accept(',');
  }
}

Shared<ImageData> read_pixels(Parser& parser, const std::string& path, SourcePosition where,
                              const ReadImageOptions& options) {
  ReadImages& images = parser.read_images();
  if (const Shared<ImageData>* known = images.find(path, options)) return *known;
  Result<ImageData> data = read_image(path, options);
  if (!data) parser.fail_at(where, data.error().message);
  parser.charge(data->pixels.size() * sizeof(float));
  Shared<ImageData> pixels = std::move(*data);
  images.keep(path, options, pixels);
  return pixels;
}

/// Heights and numbers are the values of the file as they are, without its gamma (measured). An
/// entry of a palette is as high as its number if bumps ask for that, and not scaled to 1
/// (measured); a pattern has the colours' greys in any case (measured).
void read_as(ImageUse use, bool use_color, ReadImageOptions& options) {
  options.grey_light_bytes = true;
  if (use == ImageUse::kColor) return;
  options.entry_transmits.clear();
  options.entry_filters.clear();
  options.opaque_palette = false;
  if (!options.gamma) options.gamma = 1;
  options.working_gamma = 1;
  if (use == ImageUse::kNumbers) options.palette_scale = 1 / 255.0f;
  if (use == ImageUse::kBumps && !use_color) options.palette_scale = 1;
}

}  // namespace

Keyword take_image_format(Parser& parser) {
  const Keyword format = keyword_at(parser);
  const bool known =
      std::any_of(std::begin(kFormats), std::end(kFormats),
                  [&](const FormatEndings& formats) { return formats.format == format; });
  if (!known) return Keyword::kNotAKeyword;
  parser.next();
  return format;
}

std::string parse_image_path(Parser& parser, Keyword format) {
  const std::string name = parser.parse_file_name();
  for (const FormatEndings& endings : kFormats) {
    if (endings.format != format) continue;
    return parser.find_file(name, std::span(endings.endings).first(endings.count));
  }
  return parser.find_file(name);
}

ImageId parse_image(Parser& parser, ImageUse use, const std::function<bool()>& other) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "to begin the image");
  ImageSource image;
  ReadImageOptions options;
  options.language_version = parser.version();
  options.max_pixels =
      std::min(options.max_pixels, parser.budgets().memory_bytes / kDecodedPixelBytes);
  const Settings& settings = parser.scene().settings;
  if (settings.gamma_correction) options.working_gamma = settings.assumed_gamma;
  const Keyword format = take_image_format(parser);
  const SourcePosition where = parser.position();
  const bool made = parser.accept(Keyword::kFunction);
  if (made) {
    image.data = parse_function_image(parser);
  } else {
    image.path = parse_image_path(parser, format);
  }
  while (parse_image_modifier(parser, image, options) || (other && other())) {
  }
  parser.expect('}', "after the image");
  read_as(use, image.use_color, options);
  image.use_color = use == ImageUse::kColor;
  if (!made) image.data = read_pixels(parser, image.path, where, options);
  return append(parser.scene().images, std::move(image));
}

}  // namespace dioptre::pov
