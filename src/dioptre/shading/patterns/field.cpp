// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dioptre/shading/patterns/blocks.h"
#include "dioptre/shading/patterns/crackle.h"
#include "dioptre/shading/patterns/density.h"
#include "dioptre/shading/patterns/fractal.h"
#include "dioptre/shading/patterns/quilted.h"

namespace dioptre {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

template <class Function>
class FunctionField final : public Field {
 public:
  explicit FunctionField(Function function) : function_(std::move(function)) {}
  double value(Vec3 p, const Viewpoint& viewpoint) const override {
    if constexpr (std::is_invocable_v<Function, Vec3, const Viewpoint&>) {
      return function_(p, viewpoint);
    } else {
      return function_(p);
    }
  }

 private:
  Function function_;
};

template <class Function>
std::unique_ptr<const Field> field(Function function) {
  return std::make_unique<FunctionField<Function>>(std::move(function));
}

/// Values over 1 begin again at 0, before the wave stage with its own period (measured).
double below_one(double v) { return v > 1 ? std::fmod(v, 1.0) : v; }

double granite(Vec3 p, NoiseGenerator generator) {
  double sum = 0, scale = 4, weight = 1;
  for (int i = 0; i < 6; ++i) {
    const double n = noise(scale * p, generator);
    sum += weight * (generator == NoiseGenerator::kOriginal ? std::fabs(0.5 - n)
                                                            : std::min(0.5, std::fabs(1 - 2 * n)));
    scale *= 2;
    weight /= 2;
  }
  return std::min(1.0, sum);
}

double wrinkles(Vec3 p, NoiseGenerator generator) {
  double sum = 0, scale = 1, weight = 0.5;
  for (int i = 0; i < 10; ++i) {
    sum += weight * std::clamp(spread_noise(scale * p, generator), 0.0, 1.0);
    scale *= 2;
    weight /= 2;
  }
  return sum;
}

/// Circular waves around the sources, in phase: the mean of their heights.
double ripples(Vec3 p, std::uint32_t sources, const FieldOptions& options) {
  double sum = 0;
  for (std::uint32_t i = 0; i < sources; ++i) {
    const double distance = length(p - wave_source(i).position);
    sum += std::sin(kTurn * (distance * options.frequency + options.phase));
  }
  return 0.5 + 0.5 * sum / sources;
}

/// The same with a frequency for each source, lower ones being higher.
double waves(Vec3 p, std::uint32_t sources, const FieldOptions& options) {
  double sum = 0;
  for (std::uint32_t i = 0; i < sources; ++i) {
    const WaveSource& source = wave_source(i);
    const double distance = length(p - source.position) * source.frequency;
    sum += std::sin(kTurn * (distance * options.frequency + options.phase)) / source.frequency;
  }
  return 0.5 + 0.2 * sum / sources;
}

/// The angle about z in turns, 0 to 1, counter-clockwise from -y.
double turns(Vec3 p) {
  const double t = p.x == 0 && p.y == 0 ? 0 : std::atan2(p.x, -p.y) / kTurn;
  return t < 0 ? t + 1 : t;
}

/// A triangle wave of period 1 between 0 and 1.
double triangle(double v) {
  v -= std::floor(v);
  return v < 0.5 ? 2 * v : 2 - 2 * v;
}

/// The angle whose sine is v, -1/2 to 1/2 half turns to 0 to 1.
double share_of_half_turn(double v) {
  return 0.5 + std::asin(std::clamp(v, -1.0, 1.0)) / std::numbers::pi;
}

/// The weighted mean of how steep and how high a point is; the vectors' lengths are the weights.
double slope_value(Vec3 p, const Viewpoint& viewpoint, const Slope& slope) {
  const auto rescaled = [](double v, double low, double high) {
    return high != low ? (v - low) / (high - low) : v;
  };
  const double steep_weight = length(slope.direction), high_weight = length(slope.altitude);
  if (!(steep_weight + high_weight > 0)) return 0;
  double sum = 0;
  if (steep_weight > 0) {
    const double sine = dot(viewpoint.normal, slope.direction) / steep_weight;
    sum += steep_weight * rescaled(share_of_half_turn(sine), slope.slope_low, slope.slope_high);
  }
  if (high_weight > 0) {
    const double height = dot(p, slope.altitude) / high_weight;
    sum += high_weight * rescaled(height, slope.altitude_low, slope.altitude_high);
  }
  return below_one(sum / (steep_weight + high_weight));
}

/// Makes the field of each kind of pattern.
struct Maker {
  const FieldOptions& options;
  const PatternServices& services;
  using Made = std::unique_ptr<const Field>;

  Made noisy() const {
    return field([g = options.generator](Vec3 p) { return noise(p, g); });
  }
  std::uint32_t sources() const {
    return std::clamp(services.scene->settings.number_of_waves, 1u, kMaxWaveSources);
  }

  Made operator()(const Agate& agate) const {
    return field([g = options.generator, o = options.octaves, a = agate.turbulence](Vec3 p) {
      const double phase = 1.3 * a * scalar_turbulence(p, o, g) + 1.1 * p.z;
      return std::pow(0.5 * (1 + std::sin(kTurn * phase)), 0.77);
    });
  }
  Made operator()(const Aoi&) const {
    return field(
        [](Vec3, const Viewpoint& v) { return share_of_half_turn(-dot(v.normal, v.view)); });
  }
  Made operator()(const Boxed&) const {
    return field([](Vec3 p) { return std::max(0.0, 1 - max_component(abs(p))); });
  }
  Made operator()(const Bozo&) const { return noisy(); }
  Made operator()(const Bumps&) const { return noisy(); }
  Made operator()(const Spotted&) const { return noisy(); }
  Made operator()(const Brick& brick) const {
    return field([brick](Vec3 p) { return brick_block(p, brick); });
  }
  Made operator()(const Cells&) const {
    return field([](Vec3 p) {
      if (!(max_component(abs(p)) < 0x1p40)) p = {};
      const auto cell = [](double v) { return static_cast<std::int64_t>(std::floor(v)); };
      return random_value(cell_hash(cell(p.x), cell(p.y), cell(p.z)));
    });
  }
  Made operator()(const Checker&) const { return field(checker_block); }
  Made operator()(const Crackle& crackle) const {
    return field([crackle, g = options.generator](Vec3 p) { return crackle_value(p, crackle, g); });
  }
  Made operator()(const Cubic&) const { return field(cubic_block); }
  Made operator()(const Cylindrical&) const {
    return field([](Vec3 p) { return std::max(0.0, 1 - std::hypot(p.x, p.z)); });
  }
  Made operator()(const Dents&) const {
    return field([g = options.generator](Vec3 p) {
      const double n = noise(p, g);
      return n * n * n;
    });
  }
  Made operator()(const DensityFile& file) const {
    return field([file](Vec3 p) { return density_value(p, file); });
  }
  Made operator()(const Facets&) const {
    return field([](Vec3) { return 0.0; });  // a pattern for normals only
  }
  Made operator()(const Fractal& fractal) const {
    return field([fractal](Vec3 p) { return fractal_value(p, fractal); });
  }
  Made operator()(const FunctionPattern& pattern) const {
    return field([call = services.call, id = pattern.function](Vec3 p) {
      const double arguments[3] = {p.x, p.y, p.z};
      return below_one(call(id, arguments));
    });
  }
  Made operator()(const Gradient& gradient) const {
    return field([d = normalize(gradient.direction)](Vec3 p) { return below_one(dot(p, d)); });
  }
  Made operator()(const Granite&) const {
    return field([g = options.generator](Vec3 p) { return granite(p, g); });
  }
  Made operator()(const Hexagon&) const { return field(hexagon_block); }
  Made operator()(const ImagePattern& pattern) const {
    const bool known = services.images && pattern.image.index < services.images->size();
    if (!known) return field([](Vec3) { return 0.0; });
    return field(
        [&image = (*services.images)[pattern.image.index]](Vec3 p) { return image.height(p); });
  }
  Made operator()(const Leopard&) const {
    return field([](Vec3 p) {
      const double v = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3;
      return v * v;
    });
  }
  Made operator()(const Marble&) const {
    if (options.turbulence == Vec3{}) return field([](Vec3 p) { return p.x; });
    return field([o = options](Vec3 p) {
      return p.x + o.turbulence.x * scalar_turbulence(p, o.octaves, o.generator);
    });
  }
  Made operator()(const ObjectPattern& object) const {
    return field([inside = services.inside, id = object.object](Vec3 p) {
      return inside(id, p) ? 1.0 : 0.0;
    });
  }
  Made operator()(const Onion&) const {
    return field([](Vec3 p) { return std::fmod(length(p), 1.0); });
  }
  Made operator()(const PigmentPattern& pattern) const {
    return field([pigment = services.pigment, id = pattern.pigment](Vec3 p) {
      return static_cast<double>(gray(pigment(id, p).color));
    });
  }
  Made operator()(const Planar&) const {
    return field([](Vec3 p) { return std::max(0.0, 1 - std::fabs(p.y)); });
  }
  Made operator()(const Quilted& quilted) const {
    return field([quilted](Vec3 p) { return quilted_value(p, quilted); });
  }
  Made operator()(const Radial&) const {
    return field([](Vec3 p) {
      if (std::fabs(p.x) < 1e-3 && std::fabs(p.z) < 1e-3) return 0.25;
      return 0.25 + (std::atan2(p.x, p.z) + std::numbers::pi) / kTurn;
    });
  }
  Made operator()(const Ripples&) const {
    return field([n = sources(), o = options](Vec3 p) { return ripples(p, n, o); });
  }
  Made operator()(const Slope& slope) const {
    return field([slope](Vec3 p, const Viewpoint& v) { return slope_value(p, v, slope); });
  }
  Made operator()(const Spherical&) const {
    return field([](Vec3 p) { return std::max(0.0, 1 - length(p)); });
  }
  Made operator()(const Spiral& spiral) const {
    const auto winding = [n = static_cast<double>(spiral.arms), o = options](Vec3 p, double r) {
      const double v = n * turns(p) + r + p.z;
      if (o.turbulence == Vec3{}) return v;
      return v + o.turbulence.x * scalar_turbulence(p, o.octaves, o.generator);
    };
    if (!spiral.two_sided) {
      return field([winding](Vec3 p) { return winding(p, std::hypot(p.x, p.y)); });
    }
    return field([winding](Vec3 p) {
      const double r = std::hypot(p.x, p.y);
      return triangle(r) + triangle(winding(p, r));
    });
  }
  Made operator()(const Square&) const { return field(square_block); }
  Made operator()(const Tiling&) const { return field(square_block); }
  Made operator()(const Triangular&) const { return field(triangular_block); }
  Made operator()(const Waves&) const {
    return field([n = sources(), o = options](Vec3 p) { return waves(p, n, o); });
  }
  Made operator()(const Wood&) const {
    if (options.turbulence == Vec3{}) return field([](Vec3 p) { return std::hypot(p.x, p.y); });
    return field([o = options](Vec3 p) {
      const Vec3 moved = p + vector_turbulence(p, o.octaves);
      return std::hypot(p.x + std::sin(kTurn * moved.x * o.turbulence.x),
                        p.y + std::sin(kTurn * moved.y * o.turbulence.y));
    });
  }
  Made operator()(const Wrinkles&) const {
    return field([g = options.generator](Vec3 p) { return wrinkles(p, g); });
  }
};

}  // namespace

std::unique_ptr<const Field> make_field(const PatternData& data, const FieldOptions& options,
                                        const PatternServices& services) {
  return std::visit(Maker{options, services}, data);
}

bool is_block_pattern(const PatternData& data) {
  return std::holds_alternative<Checker>(data) || std::holds_alternative<Brick>(data) ||
         std::holds_alternative<Hexagon>(data) || std::holds_alternative<Square>(data) ||
         std::holds_alternative<Triangular>(data) || std::holds_alternative<Cubic>(data) ||
         std::holds_alternative<ObjectPattern>(data);
}

bool keeps_point(const PatternData& data) {
  return std::holds_alternative<Marble>(data) || std::holds_alternative<Wood>(data);
}

}  // namespace dioptre
