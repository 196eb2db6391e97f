// SPDX-License-Identifier: Apache-2.0
// image_map, bump_map, material_map and image_pattern.
#include <algorithm>

#include "dioptre/io/image/read_image.h"
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kLargestSide = 1 << 14;
constexpr std::int64_t kMostPixels = 1 << 24;
constexpr std::size_t kRememberedImages = 64;

/// Pixels from a function of the unit square, `function WIDTH, HEIGHT {...}`, the keyword taken.
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
      const double place[] = {static_cast<double>(column) / static_cast<double>(width),
                              1 - static_cast<double>(row + 1) / static_cast<double>(height), 0};
      data.pixels.push_back(static_cast<float>(queries.call(parser.scene(), function, place)));
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

/// `filter all F`, or `filter INDEX, F` for one colour of a palette.
void parse_transparency(Parser& parser, double& all) {
  parser.next();
  if (parser.accept(Keyword::kAll)) {
    all = parser.parse_float();
    return;
  }
  parser.parse_float();
  parser.skip_comma();
  parser.parse_float();
  parser.not_rendered("transparency of single palette colours");
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
      parse_transparency(parser, image.filter_all);
      return true;
    case Keyword::kTransmit:
      parse_transparency(parser, image.transmit_all);
      return true;
    default:
      return parser.accept(',');
  }
}

/// The same file read as colours shortly before, if any.
const ImageSource* find_read(const Scene& scene, const std::string& path) {
  const auto& images = scene.images;
  for (std::size_t i = images.size(); i-- > 0 && images.size() - i <= kRememberedImages;) {
    if (images[i].path == path && images[i].use_color) return &images[i];
  }
  return nullptr;
}

Shared<ImageData> read_pixels(Parser& parser, const std::string& path, SourcePosition where,
                              const ReadImageOptions& options) {
  const ImageSource* known = options.gamma ? nullptr : find_read(parser.scene(), path);
  if (known) return known->data;
  Result<ImageData> data = read_image(path, options);
  if (!data) parser.fail_at(where, data.error().message);
  parser.charge(data->pixels.size() * sizeof(float));
  return std::move(*data);
}

/// Heights and numbers are the values of the file as they are, without its gamma (measured). An
/// entry of a palette is as high as its number if bumps ask for that, and not scaled to 1
/// (measured); a pattern has the colours' greys in any case (measured).
void read_as(ImageUse use, bool use_color, ReadImageOptions& options) {
  if (use == ImageUse::kColor) return;
  if (!options.gamma) options.gamma = 1;
  if (use == ImageUse::kNumbers) options.palette_scale = 1 / 255.0f;
  if (use == ImageUse::kBumps && !use_color) options.palette_scale = 1;
}

}  // namespace

void skip_image_format(Parser& parser) {
  switch (keyword_at(parser)) {
    case Keyword::kGif:
    case Keyword::kTga:
    case Keyword::kPng:
    case Keyword::kJpeg:
    case Keyword::kTiff:
    case Keyword::kPgm:
    case Keyword::kPpm:
    case Keyword::kSys:
    case Keyword::kHdr:
    case Keyword::kExr:
    case Keyword::kPot:
      parser.next();
      break;
    default:
      break;
  }
}

ImageId parse_image(Parser& parser, ImageUse use, const std::function<bool()>& other) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "to begin the image");
  ImageSource image;
  ReadImageOptions options;
  options.language_version = parser.version();
  options.max_pixels =
      std::min(options.max_pixels, parser.budgets().memory_bytes / kDecodedPixelBytes);
  skip_image_format(parser);
  const SourcePosition where = parser.position();
  const bool made = parser.accept(Keyword::kFunction);
  if (made) {
    image.data = parse_function_image(parser);
  } else {
    image.path = parser.find_file(parser.parse_file_name());
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
