// SPDX-License-Identifier: Apache-2.0
// height_field: heights from an image or a function. All rules were measured.
#include <algorithm>
#include <cmath>

#include "dioptre/io/image/read_image.h"
#include "dioptre/io/pov/syntax/grammar.h"
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kLargestSide = 1 << 14;
constexpr std::int64_t kMostPoints = 1 << 24;
constexpr float kStep = 0x1p-16f;  ///< heights are whole numbers of these, under 65536

/// The heights of a palette's entries are their numbers times 256 steps.
constexpr float kPaletteScale = 256 / 65535.0f;

/// The number of the colour that an image read with kPaletteScale has.
float number_of(float height) {
  return std::fmin(std::round(std::fmax(height, 0.0f) / kPaletteScale), 255.0f);
}

/// The whole number of steps below a value from 0 to 1; not a number counts as 0.
float steps(double value) {
  return static_cast<float>(std::trunc(65535 * std::fmin(std::fmax(value, 0), 1)));
}

/// `function WIDTH, DEPTH { ... }`, the keyword taken.
HeightGrid parse_function_heights(Parser& parser) {
  const SourcePosition where = parser.position();
  const auto width = parse_whole(parser, 0, kLargestSide);
  parser.skip_comma();
  const auto depth = parse_whole(parser, 0, kLargestSide);
  if (width < 2 || depth < 2) parser.fail_at(where, "a height_field needs at least 2 x 2 points");
  if (width * depth > kMostPoints) parser.fail_at(where, "this height_field has too many points");
  const FunctionId function = parser.parse_function();
  constexpr std::uint64_t kWorkPerPoint = 256;
  parser.charge(static_cast<std::uint64_t>(width * depth) * kWorkPerPoint);
  HeightGrid grid{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(depth), {}};
  grid.heights.reserve(static_cast<std::size_t>(width * depth));
  SceneQueries& queries = parser.queries();
  for (std::int64_t j = 0; j < depth; ++j) {
    for (std::int64_t i = 0; i < width; ++i) {
      const double place[] = {static_cast<double>(i) / static_cast<double>(width - 1),
                              1 - static_cast<double>(j) / static_cast<double>(depth - 1), 0};
      grid.heights.push_back(kStep * steps(queries.call(parser.scene(), function, place)));
    }
  }
  return grid;
}

/// Whether all values are those of bytes, and not of 16 bits.
bool from_bytes(const ImageData& image) {
  constexpr float kRounding = 1e-4f;
  return std::all_of(image.pixels.begin(), image.pixels.end(),
                     [](float v) { return std::fabs(std::round(v * 255) - v * 255) <= kRounding; });
}

float grey_of(float red, float green, float blue) {
  return red * 0.297f + green * 0.589f + blue * 0.114f;
}

/// How an image's colours become heights.
struct HeightRule {
  bool bytes = false;  ///< all values are
  bool png = false;    ///< whose grey bytes are rounded down
};

/// The height of a pixel in steps. Bytes of colours are the high (red) and low (green) half.
float height_of(const float* pixel, std::uint32_t channels, HeightRule rule) {
  if (channels >= 3) {
    if (rule.bytes) return std::round(pixel[0] * 255) * 256 + std::round(pixel[1] * 255);
    return steps(double{grey_of(pixel[0], pixel[1], pixel[2])});
  }
  if (channels == 1 && rule.bytes && rule.png) {
    return std::floor(grey_of(pixel[0], pixel[0], pixel[0]) * 255) * 257;
  }
  return std::round(std::fmin(std::fmax(pixel[0], 0.0f), 1.0f) * 65535);
}

HeightGrid heights_of(const ImageData& image, bool png) {
  const HeightRule rule{from_bytes(image), png};
  HeightGrid grid{image.width, image.height, {}};
  grid.heights.reserve(std::size_t{image.width} * image.height);
  for (std::uint32_t row = image.height; row-- > 0;) {
    const float* pixel = image.pixels.data() + std::size_t{row} * image.width * image.channels;
    for (std::uint32_t i = 0; i < image.width; ++i, pixel += image.channels) {
      grid.heights.push_back(kStep * height_of(pixel, image.channels, rule));
    }
  }
  return grid;
}

bool has_ending(const std::string& path, std::string_view ending) {
  return path.size() >= ending.size() && std::equal(ending.rbegin(), ending.rend(), path.rbegin(),
                                                    [](char a, char b) { return a == (b | 0x20); });
}

struct Modifiers {
  ReadImageOptions image;
  double water_level = 0;
  bool smooth = false;
};

void parse_gamma(Parser& parser, ReadImageOptions& options) {
  if (parser.accept(Keyword::kSrgb)) {
    options.gamma.reset();
  } else {
    options.gamma = parser.parse_float();
  }
}

void parse_modifiers(Parser& parser, Modifiers& modifiers) {
  for (;;) {
    if (parser.accept(Keyword::kSmooth)) {
      modifiers.smooth = parser.parse_flag();
    } else if (parser.accept(Keyword::kWaterLevel)) {
      modifiers.water_level = parser.parse_float();
    } else if (parser.accept(Keyword::kGamma)) {
      parse_gamma(parser, modifiers.image);
    } else if (parser.accept(Keyword::kPremultiplied)) {
      parser.parse_flag();
    } else if (!parser.accept(',')) {
      return;
    }
  }
}

/// The heights of a `pot` image: the numbers of the colours in its left half are the high bytes,
/// those in its right half the low ones (measured).
HeightGrid heights_of_halves(const ImageData& image) {
  HeightGrid grid{image.width / 2, image.height, {}};
  grid.heights.reserve(std::size_t{grid.width} * grid.depth);
  for (std::uint32_t row = image.height; row-- > 0;) {
    const float* left = image.pixels.data() + std::size_t{row} * image.width * image.channels;
    const float* right = left + std::size_t{grid.width} * image.channels;
    for (std::uint32_t i = 0; i < grid.width;
         ++i, left += image.channels, right += image.channels) {
      grid.heights.push_back(kStep * (256 * number_of(*left) + number_of(*right)));
    }
  }
  return grid;
}

HeightGrid read_heights(Parser& parser, const std::string& path, SourcePosition where,
                        ReadImageOptions options, bool halves) {
  options.language_version = parser.version();
  options.max_pixels =
      std::min(options.max_pixels, parser.budgets().memory_bytes / kDecodedPixelBytes);
  options.palette_scale = kPaletteScale;
  Result<ImageData> image = read_image(path, options);
  if (!image) parser.fail_at(where, image.error().message);
  if (image->width < (halves ? 4 : 2) || image->height < 2) {
    parser.fail_at(where, std::string("a height_field needs an image of at least ") +
                              (halves ? "4" : "2") + " x 2 pixels");
  }
  parser.charge(2 * image->pixels.size() * sizeof(float));
  if (halves) return heights_of_halves(*image);
  return heights_of(*image, has_ending(path, ".png"));
}

}  // namespace

void parse_height_field(Parser& parser, Item& item) {
  HeightField field;
  Modifiers modifiers;
  if (parser.accept(Keyword::kFunction)) {
    field.grid = parse_function_heights(parser);
    parse_modifiers(parser, modifiers);
  } else {
    const Keyword format = take_image_format(parser);
    const SourcePosition where = parser.position();
    const std::string path = parse_image_path(parser, format);
    modifiers.image.gamma = 1;
    parse_modifiers(parser, modifiers);
    field.grid = read_heights(parser, path, where, modifiers.image, format == Keyword::kPot);
  }
  field.water_level = modifiers.water_level;
  field.smooth = modifiers.smooth;
  item.object.geometry = ShapeData{std::move(field)};
}

}  // namespace dioptre::pov
