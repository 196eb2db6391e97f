// SPDX-License-Identifier: Apache-2.0
// The kinds of patterns and their parameters.
#include "dioptre/io/pov/syntax/patterns.h"

#include <utility>

#include "dioptre/io/image/read_density.h"

namespace dioptre::pov {
namespace {

/// The patterns that are only a keyword.
bool set_plain(Keyword keyword, Pattern& pattern) {
  switch (keyword) {
#define DIOPTRE_PLAIN(name) \
  case Keyword::k##name:    \
    pattern.data = name{};  \
    return true;
    DIOPTRE_PLAIN(Agate)
    DIOPTRE_PLAIN(Aoi)
    DIOPTRE_PLAIN(Boxed)
    DIOPTRE_PLAIN(Bozo)
    DIOPTRE_PLAIN(Brick)
    DIOPTRE_PLAIN(Bumps)
    DIOPTRE_PLAIN(Cells)
    DIOPTRE_PLAIN(Checker)
    DIOPTRE_PLAIN(Crackle)
    DIOPTRE_PLAIN(Cubic)
    DIOPTRE_PLAIN(Cylindrical)
    DIOPTRE_PLAIN(Dents)
    DIOPTRE_PLAIN(Facets)
    DIOPTRE_PLAIN(Granite)
    DIOPTRE_PLAIN(Hexagon)
    DIOPTRE_PLAIN(Leopard)
    DIOPTRE_PLAIN(Marble)
    DIOPTRE_PLAIN(Onion)
    DIOPTRE_PLAIN(Planar)
    DIOPTRE_PLAIN(Quilted)
    DIOPTRE_PLAIN(Radial)
    DIOPTRE_PLAIN(Ripples)
    DIOPTRE_PLAIN(Spherical)
    DIOPTRE_PLAIN(Spotted)
    DIOPTRE_PLAIN(Square)
    DIOPTRE_PLAIN(Triangular)
    DIOPTRE_PLAIN(Waves)
    DIOPTRE_PLAIN(Wood)
    DIOPTRE_PLAIN(Wrinkles)
#undef DIOPTRE_PLAIN
    default:
      return false;
  }
}

Slope parse_slope(Parser& parser) {
  Slope slope;
  const bool braces = parser.accept('{');
  const auto range = [&](double& low, double& high) {
    if (!parser.accept(',')) return;
    low = parser.parse_float();
    parser.skip_comma();
    high = parser.parse_float();
  };
  slope.direction = parser.parse_vec3();
  if (!braces) return slope;  // a comma is the caller's: the depth of a normal (measured)
  range(slope.slope_low, slope.slope_high);
  if (parser.accept(Keyword::kAltitude)) {
    slope.altitude = parser.parse_vec3();
    range(slope.altitude_low, slope.altitude_high);
  }
  parser.expect('}', "after the slope");
  return slope;
}

std::uint32_t parse_iterations(Parser& parser) {
  return static_cast<std::uint32_t>(parse_whole(parser, 1, 1 << 24));
}

/// mandel, julia or magnet, the keyword taken.
Fractal parse_fractal(Parser& parser, Keyword keyword) {
  Fractal fractal;
  if (keyword == Keyword::kMagnet) {
    fractal.magnet = true;
    fractal.magnet_type = static_cast<std::uint32_t>(parse_whole(parser, 1, 2));
    keyword = keyword_at(parser);
    if (keyword != Keyword::kMandel && keyword != Keyword::kJulia) {
      parser.fail_expected("mandel or julia");
    }
    parser.next();
  }
  if (keyword == Keyword::kJulia) {
    fractal.julia = true;
    fractal.constant = parser.parse_vec2();
    parser.skip_comma();
  }
  fractal.iterations = parse_iterations(parser);
  return fractal;
}

Spiral parse_spiral(Parser& parser, bool two_sided) {
  Spiral spiral;
  spiral.arms = static_cast<std::uint32_t>(parse_whole(parser, 0, 1 << 20));
  spiral.two_sided = two_sided;
  return spiral;
}

Gradient parse_gradient(Parser& parser) {
  const Vec3 direction = parser.parse_vec3();
  if (direction == Vec3{}) {
    parser.fail("the direction of the gradient is zero", "give it one, such as y");
  }
  return {direction};
}

PigmentPattern parse_pigment_pattern(Parser& parser) { return {parse_pigment(parser, {})}; }

/// The object of an object pattern; the list of its two parts and a closing brace follow.
void parse_object_pattern(Parser& parser, Pattern& pattern) {
  parser.expect('{', "after object");
  Item item = parse_object(parser);
  if (!item.drawn) {
    parser.not_rendered("object pattern of a shape that is not rendered");
    item.object.geometry = ShapeData{Sphere{{}, 0}};
  }
  pattern.data = ObjectPattern{add_part(parser, std::move(item.object), item.where)};
  parser.skip_comma();
}

/// The file of a density_file, behind the keyword.
DensityFile parse_density_file(Parser& parser) {
  if (!parser.accept(Keyword::kDf3)) parser.fail_expected("df3");
  const SourcePosition where = parser.position();
  DensityFile file;
  file.path = parser.find_file(parser.parse_file_name());
  const std::string bytes = parser.read_file(file.path);
  parser.charge(bytes.size() * sizeof(float));
  Result<DensityGrid> grid = decode_density(bytes);
  if (!grid) parser.fail_at(where, grid.error().message);
  file.data = std::move(*grid);
  return file;
}

/// The patterns that take something behind the keyword, which is the next token.
std::optional<BlockPattern> parse_parametric_kind(Parser& parser, Keyword keyword,
                                                  Pattern& pattern) {
  switch (keyword) {
    case Keyword::kGradient:
      parser.next();
      pattern.data = parse_gradient(parser);
      break;
    case Keyword::kSlope:
      parser.next();
      pattern.data = parse_slope(parser);
      break;
    case Keyword::kSpiral1:
    case Keyword::kSpiral2:
      parser.next();
      pattern.data = parse_spiral(parser, keyword == Keyword::kSpiral2);
      break;
    case Keyword::kMandel:
    case Keyword::kJulia:
    case Keyword::kMagnet:
      parser.next();
      pattern.data = parse_fractal(parser, keyword);
      break;
    case Keyword::kTiling:
      parser.next();
      parser.not_rendered("tiling");
      pattern.data = Tiling{static_cast<std::uint32_t>(parse_whole(parser, 1, 24))};
      break;
    case Keyword::kFunction:
      parser.next();
      pattern.data = FunctionPattern{parser.parse_function()};
      break;
    case Keyword::kPigmentPattern:
      parser.next();
      pattern.data = parse_pigment_pattern(parser);
      break;
    case Keyword::kImagePattern:
      parser.next();
      pattern.data = ImagePattern{parse_image(parser, ImageUse::kPattern)};
      break;
    case Keyword::kDensityFile:
      parser.next();
      pattern.data = parse_density_file(parser);
      break;
    case Keyword::kPavement:
      parser.next();
      parser.not_rendered("pavement");
      pattern.data = Bozo{};
      break;
    case Keyword::kObject:
      parser.next();
      parse_object_pattern(parser, pattern);
      return BlockPattern{2, true};
    default:
      return std::nullopt;
  }
  return BlockPattern{parts_of(pattern), false};
}

bool parse_wave(Parser& parser, Pattern& pattern) {
  const auto set = [&](Wave wave) {
    parser.next();
    pattern.wave = wave;
    pattern.own_wave = true;
    return true;
  };
  switch (keyword_at(parser)) {
    case Keyword::kRampWave:
      return set(Wave::kRamp);
    case Keyword::kTriangleWave:
      return set(Wave::kTriangle);
    case Keyword::kSineWave:
      return set(Wave::kSine);
    case Keyword::kScallopWave:
      return set(Wave::kScallop);
    case Keyword::kCubicWave:
      return set(Wave::kCubic);
    case Keyword::kPolyWave:
      set(Wave::kPoly);
      pattern.wave_exponent = parser.at_expression() ? parser.parse_float() : 1;
      return true;
    default:
      return false;
  }
}

/// The pattern's own data if it is of that kind, else a place to read a useless parameter into.
template <class T>
T& data_as(Pattern& pattern, T& other) {
  T* data = std::get_if<T>(&pattern.data);
  return data ? *data : other;
}

bool parse_fractal_modifier(Parser& parser, Pattern& pattern) {
  Fractal* fractal = std::get_if<Fractal>(&pattern.data);
  if (!fractal) return false;
  if (parser.accept(Keyword::kExponent)) {
    fractal->exponent = static_cast<std::uint32_t>(parse_whole(parser, 2, 33));
  } else if (parser.accept(Keyword::kExterior)) {
    fractal->exterior_type = static_cast<std::uint32_t>(parse_whole(parser, 0, 8));
    parser.skip_comma();
    fractal->exterior_factor = parser.parse_float();
  } else if (parser.accept(Keyword::kInterior)) {
    fractal->interior_type = static_cast<std::uint32_t>(parse_whole(parser, 0, 6));
    parser.skip_comma();
    fractal->interior_factor = parser.parse_float();
  } else {
    return false;
  }
  return true;
}

/// The parameters of crackle and facets.
bool parse_cell_modifier(Parser& parser, Pattern& pattern) {
  Crackle no_crackle;
  Facets no_facets;
  switch (keyword_at(parser)) {
    case Keyword::kForm:
      parser.next();
      data_as(pattern, no_crackle).form = parser.parse_vec3();
      return true;
    case Keyword::kMetric: {
      parser.next();
      const double metric = parser.parse_float();
      data_as(pattern, no_crackle).metric = metric;
      data_as(pattern, no_facets).metric = metric;
      return true;
    }
    case Keyword::kOffset:
      parser.next();
      data_as(pattern, no_crackle).offset = parser.parse_float();
      return true;
    case Keyword::kSolid:
      parser.next();
      data_as(pattern, no_crackle).solid = parser.parse_flag();
      return true;
    case Keyword::kCoords:
      parser.next();
      data_as(pattern, no_facets).coords = parser.parse_float();
      return true;
    case Keyword::kSize:
      parser.next();
      data_as(pattern, no_facets).size = parser.parse_float();
      return true;
    default:
      return false;
  }
}

bool parse_kind_modifier(Parser& parser, Pattern& pattern) {
  Agate no_agate;
  Brick no_brick;
  Quilted no_quilted;
  switch (keyword_at(parser)) {
    case Keyword::kAgateTurb:
      parser.next();
      data_as(pattern, no_agate).turbulence = parser.parse_float();
      return true;
    case Keyword::kBrickSize:
      parser.next();
      data_as(pattern, no_brick).size = parser.parse_vec3();
      return true;
    case Keyword::kMortar:
      parser.next();
      data_as(pattern, no_brick).mortar = parser.parse_float();
      return true;
    case Keyword::kControl0:
      parser.next();
      data_as(pattern, no_quilted).control0 = parser.parse_float();
      return true;
    case Keyword::kControl1:
      parser.next();
      data_as(pattern, no_quilted).control1 = parser.parse_float();
      return true;
    default:
      return parse_cell_modifier(parser, pattern) || parse_fractal_modifier(parser, pattern);
  }
}

/// How many parts each kind of pattern has.
struct Count {
  std::size_t operator()(const Checker&) const { return 2; }
  std::size_t operator()(const Brick&) const { return 2; }
  std::size_t operator()(const Hexagon&) const { return 3; }
  std::size_t operator()(const Square&) const { return 4; }
  std::size_t operator()(const Triangular&) const { return 6; }
  std::size_t operator()(const Cubic&) const { return 6; }
  std::size_t operator()(const ObjectPattern&) const { return 2; }
  template <class T>
  std::size_t operator()(const T&) const {
    return 0;
  }
};
}  // namespace

std::size_t parts_of(const Pattern& pattern) { return std::visit(Count{}, pattern.data); }

std::optional<BlockPattern> parse_pattern_kind(Parser& parser, Pattern& pattern) {
  const Keyword keyword = keyword_at(parser);
  if (set_plain(keyword, pattern)) {
    if (keyword == Keyword::kFacets) parser.not_rendered("facets");
    parser.next();
    return BlockPattern{parts_of(pattern), false};
  }
  return parse_parametric_kind(parser, keyword, pattern);
}

bool parse_pattern_modifier(Parser& parser, Pattern& pattern) {
  if (parse_wave(parser, pattern) || parse_kind_modifier(parser, pattern)) return true;
  if (parser.accept(Keyword::kFrequency)) {
    pattern.frequency = parser.parse_float();
  } else if (parser.accept(Keyword::kPhase)) {
    pattern.phase = parser.parse_float();
  } else if (parser.accept(Keyword::kNoiseGenerator)) {
    pattern.noise_generator = static_cast<std::uint32_t>(parse_whole(parser, 1, 3));
  } else if (parser.accept(Keyword::kInterpolate)) {
    DensityFile no_file;
    data_as(pattern, no_file).interpolation = static_cast<std::uint32_t>(parse_whole(parser, 0, 2));
  } else {
    return parse_warp_modifier(parser, pattern.warps);
  }
  return true;
}

Pattern parse_pattern_block(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after pattern");
  Pattern pattern;
  while (!parser.accept('}')) {
    if (const auto kind = parse_pattern_kind(parser, pattern)) {
      if (kind->in_braces) parser.expect('}', "after the object");
    } else if (!parser.accept(',') && !parse_pattern_modifier(parser, pattern)) {
      parser.fail_expected("a pattern, a pattern modifier or '}'");
    }
  }
  return pattern;
}

}  // namespace dioptre::pov
