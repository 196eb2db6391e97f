// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/core/shared.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/density_grid.h"
#include "dioptre/scene/ids.h"

namespace dioptre {

/// A string literal as a template argument.
template <std::size_t N>
struct Literal {
  char text[N];
  constexpr Literal(const char (&t)[N]) { std::copy_n(t, N, text); }  // NOLINT: a literal
};

/// A pattern that has no parameters of its own.
template <Literal name>
struct PlainPattern {
  static constexpr const char* kName = name.text;
  bool operator==(const PlainPattern&) const = default;
  template <class Self, class Visitor>
  static void fields(Self&, Visitor&&) {}
};

using Aoi = PlainPattern<"aoi">;
using Boxed = PlainPattern<"boxed">;
using Bozo = PlainPattern<"bozo">;
using Bumps = PlainPattern<"bumps">;
using Cells = PlainPattern<"cells">;
using Checker = PlainPattern<"checker">;
using Cubic = PlainPattern<"cubic">;
using Cylindrical = PlainPattern<"cylindrical">;
using Dents = PlainPattern<"dents">;
using Granite = PlainPattern<"granite">;
using Hexagon = PlainPattern<"hexagon">;
using Leopard = PlainPattern<"leopard">;
using Marble = PlainPattern<"marble">;
using Onion = PlainPattern<"onion">;
using Planar = PlainPattern<"planar">;
using Radial = PlainPattern<"radial">;
using Ripples = PlainPattern<"ripples">;
using Spherical = PlainPattern<"spherical">;
using Spotted = PlainPattern<"spotted">;
using Square = PlainPattern<"square">;
using Triangular = PlainPattern<"triangular">;
using Waves = PlainPattern<"waves">;
using Wood = PlainPattern<"wood">;
using Wrinkles = PlainPattern<"wrinkles">;

/// Banded stone.
struct Agate {
  static constexpr const char* kName = "agate";
  double turbulence = 1;  ///< agate_turb
  bool operator==(const Agate&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("turbulence", self.turbulence);
  }
};

/// Bricks and mortar: entry 0 is the mortar, entry 1 the brick.
struct Brick {
  static constexpr const char* kName = "brick";
  Vec3 size{8, 3, 4.5};
  double mortar = 0.5;
  bool operator==(const Brick&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("size", self.size);
    visit("mortar", self.mortar);
  }
};

/// Cells around one random point in each unit cube.
struct Crackle {
  static constexpr const char* kName = "crackle";
  Vec3 form{-1, 1, 0};  ///< weights of the distances to the nearest three points
  double metric = 2;
  double offset = 0;
  bool solid = false;  ///< one value per cell
  bool operator==(const Crackle&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("form", self.form);
    visit("metric", self.metric);
    visit("offset", self.offset);
    visit("solid", self.solid);
  }
};

/// The values of a grid, which fills the unit cube; 0 outside.
struct DensityFile {
  static constexpr const char* kName = "density_file";
  std::string path;
  Shared<DensityGrid> data;
  std::uint32_t interpolation = 0;  ///< 0: none, 1: linear, 2: cubic
  bool operator==(const DensityFile&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("path", self.path);
    visit("data", self.data);
    visit("interpolation", self.interpolation);
  }
};

/// Flat faces (normals only).
struct Facets {
  static constexpr const char* kName = "facets";
  double coords = 0;  ///< scale; 0: by size
  double size = 0.1;
  double metric = 2;
  bool operator==(const Facets&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("coords", self.coords);
    visit("size", self.size);
    visit("metric", self.metric);
  }
};

/// Grows along a direction.
struct Gradient {
  static constexpr const char* kName = "gradient";
  Vec3 direction{0, 1, 0};  ///< any length but 0
  bool operator==(const Gradient&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("direction", self.direction);
  }
};

/// A quilt of unit cubes.
struct Quilted {
  static constexpr const char* kName = "quilted";
  double control0 = 1;
  double control1 = 1;
  bool operator==(const Quilted&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("control0", self.control0);
    visit("control1", self.control1);
  }
};

/// How much the surface faces a direction, with an optional share of height.
struct Slope {
  static constexpr const char* kName = "slope";
  Vec3 direction{0, 1, 0};
  double slope_low = 0;
  double slope_high = 1;
  Vec3 altitude;
  double altitude_low = 0;
  double altitude_high = 1;
  bool operator==(const Slope&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("direction", self.direction);
    visit("slope_low", self.slope_low);
    visit("slope_high", self.slope_high);
    visit("altitude", self.altitude);
    visit("altitude_low", self.altitude_low);
    visit("altitude_high", self.altitude_high);
  }
};

/// Arms that wind about z.
struct Spiral {
  static constexpr const char* kName = "spiral";
  std::uint32_t arms = 1;
  bool two_sided = false;  ///< spiral2
  bool operator==(const Spiral&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("arms", self.arms);
    visit("two_sided", self.two_sided);
  }
};

/// One of the tilings of the plane.
struct Tiling {
  static constexpr const char* kName = "tiling";
  std::uint32_t kind = 1;
  bool operator==(const Tiling&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("kind", self.kind);
  }
};

/// Escape-time fractals in the x-y plane.
struct Fractal {
  static constexpr const char* kName = "fractal";
  bool julia = false;
  bool magnet = false;
  Vec2 constant;  ///< of the julia forms
  std::uint32_t magnet_type = 1;
  std::uint32_t iterations = 10;
  std::uint32_t exponent = 2;
  std::uint32_t exterior_type = 1;
  double exterior_factor = 1;
  std::uint32_t interior_type = 0;
  double interior_factor = 1;
  bool operator==(const Fractal&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("julia", self.julia);
    visit("magnet", self.magnet);
    visit("constant", self.constant);
    visit("magnet_type", self.magnet_type);
    visit("iterations", self.iterations);
    visit("exponent", self.exponent);
    visit("exterior_type", self.exterior_type);
    visit("exterior_factor", self.exterior_factor);
    visit("interior_type", self.interior_type);
    visit("interior_factor", self.interior_factor);
  }
};

/// A user function of x, y, z.
struct FunctionPattern {
  static constexpr const char* kName = "function";
  FunctionId function;
  bool operator==(const FunctionPattern&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("function", self.function);
  }
};

/// The grey value of a pigment.
struct PigmentPattern {
  static constexpr const char* kName = "pigment_pattern";
  PigmentId pigment;
  bool operator==(const PigmentPattern&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pigment", self.pigment);
  }
};

/// Entry 0 outside an object, entry 1 inside.
struct ObjectPattern {
  static constexpr const char* kName = "object";
  ObjectId object;
  bool operator==(const ObjectPattern&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("object", self.object);
  }
};

/// A value from an image, which fills the unit square of x, y.
struct ImagePattern {
  static constexpr const char* kName = "image_pattern";
  ImageId image;
  bool operator==(const ImagePattern&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("image", self.image);
  }
};

/// The one list of patterns.
using PatternData =
    std::variant<Agate, Aoi, Boxed, Bozo, Brick, Bumps, Cells, Checker, Crackle, Cubic, Cylindrical,
                 Dents, DensityFile, Facets, Fractal, FunctionPattern, Gradient, Granite, Hexagon,
                 ImagePattern, Leopard, Marble, ObjectPattern, Onion, PigmentPattern, Planar,
                 Quilted, Radial, Ripples, Slope, Spherical, Spiral, Spotted, Square, Tiling,
                 Triangular, Waves, Wood, Wrinkles>;

/// Moves the point by turbulent vector noise.
struct Turbulence {
  static constexpr const char* kName = "turbulence";
  Vec3 amount;
  std::uint32_t octaves = 6;
  double omega = 0.5;
  double lambda = 2;
  bool operator==(const Turbulence&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("amount", self.amount);
    visit("octaves", self.octaves);
    visit("omega", self.omega);
    visit("lambda", self.lambda);
  }
};

/// Places what came before it in the list.
struct TransformWarp {
  static constexpr const char* kName = "transform";
  Affine transform;
  bool operator==(const TransformWarp&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("transform", self.transform);
  }
};

/// Repeats a slab of space along one axis.
struct RepeatWarp {
  static constexpr const char* kName = "repeat";
  std::uint32_t axis = 0;
  double width = 1;
  Vec3 offset;
  Vec3 flip{1, 1, 1};  ///< -1 mirrors every other copy
  bool operator==(const RepeatWarp&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("axis", self.axis);
    visit("width", self.width);
    visit("offset", self.offset);
    visit("flip", self.flip);
  }
};

/// Pulls the points of a ball to its centre, or pushes them out.
struct BlackHoleWarp {
  static constexpr const char* kName = "black_hole";
  Vec3 center;
  double radius = 1;
  double falloff = 2;
  double strength = 1;
  bool inverse = false;
  bool repeats = false;
  Vec3 repeat;
  Vec3 turbulence;
  bool operator==(const BlackHoleWarp&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("center", self.center);
    visit("radius", self.radius);
    visit("falloff", self.falloff);
    visit("strength", self.strength);
    visit("inverse", self.inverse);
    visit("repeats", self.repeats);
    visit("repeat", self.repeat);
    visit("turbulence", self.turbulence);
  }
};

/// Wraps the x-y plane of a pattern around a body.
struct MappingWarp {
  static constexpr const char* kName = "mapping";
  enum class Kind : std::uint8_t { kPlanar, kSpherical, kCylindrical, kToroidal, kCubic };
  Kind kind = Kind::kPlanar;
  Vec3 orientation{0, 0, 1};
  double distance_exponent = 0;
  double major_radius = 1;  ///< of the torus
  bool operator==(const MappingWarp&) const = default;
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("kind", self.kind);
    visit("orientation", self.orientation);
    visit("distance_exponent", self.distance_exponent);
    visit("major_radius", self.major_radius);
  }
};

/// One change of the space in which a pattern lives.
using Warp = std::variant<Turbulence, TransformWarp, RepeatWarp, BlackHoleWarp, MappingWarp>;

/// What a continuous pattern's value goes through: v -> wave(fmod(v frequency + phase, 1.00001)).
enum class Wave : std::uint8_t { kRamp, kTriangle, kSine, kScallop, kCubic, kPoly };

/// A function of space with values in [0, 1], or, for block patterns (checker, brick, ...), the
/// number of a block.
struct Pattern {
  PatternData data = Bozo{};
  /// As written, the first nearest to the pattern: a point meets the last one first. The keyword
  /// `turbulence` is always the first.
  std::vector<Warp> warps;
  Wave wave = Wave::kRamp;
  bool own_wave = false;  ///< false: the pattern's usual wave (marble and wood have a triangle)
  double wave_exponent = 1;
  double frequency = 1;
  double phase = 0;
  std::uint32_t noise_generator = 0;  ///< 1 to 3; 0: the scene's
  bool operator==(const Pattern&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("data", self.data);
    visit("warps", self.warps);
    visit("wave", self.wave);
    visit("own_wave", self.own_wave);
    visit("wave_exponent", self.wave_exponent);
    visit("frequency", self.frequency);
    visit("phase", self.phase);
    visit("noise_generator", self.noise_generator);
  }
};

}  // namespace dioptre
