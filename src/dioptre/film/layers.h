// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "dioptre/core/result.h"
#include "dioptre/film/image.h"
#include "dioptre/scene/settings.h"

namespace dioptre {

/// What can be told of a pixel beside its colour.
///
/// The first five are the terms of the light of an eye ray (T. Whitted, "An Improved Illumination
/// Model for Shaded Display", 1980), as the first surface that it meets has them; their sum is the
/// colour. Background, mists on the way and the glow of a surface are ambient; highlights are
/// specular; all that a mirrored ray brings is reflected, all that comes through, refracted. The
/// light that total reflection keeps inside counts as refracted.
/// The others tell what the pixel cost, all of its samples together.
enum class LayerKind : std::uint8_t {
  kAmbient,
  kDiffuse,
  kSpecular,
  kReflected,
  kRefracted,
  kRays,   ///< traced: from the eye, mirrored, through surfaces and to lights
  kSteps,  ///< of walks through the scene's accelerator: nodes, cells or volumes looked at
  kTests,  ///< of rays with items; a whole CSG solid or mesh is one item
  kSpans,  ///< ends of the stretches in which rays are inside of items, up to where they end
  kDepth,  ///< distance from the eye to the nearest surface; infinite if there is none
  kTime,   ///< of a processor, in nanoseconds
};

inline constexpr std::size_t kTerms = 5;
inline constexpr std::size_t kLayerKinds = 11;

/// A choice of kinds.
class LayerSet {
 public:
  static constexpr LayerSet terms() { return LayerSet((1u << kTerms) - 1); }
  static constexpr LayerSet all() { return LayerSet((1u << kLayerKinds) - 1); }
  static constexpr LayerSet costs() { return LayerSet(all().bits_ & ~terms().bits_); }

  constexpr LayerSet() = default;
  constexpr bool has(LayerKind kind) const { return (bits_ >> static_cast<int>(kind) & 1u) != 0; }
  constexpr bool has_any(LayerSet of) const { return (bits_ & of.bits_) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr void add(LayerKind kind) { bits_ |= 1u << static_cast<int>(kind); }
  constexpr LayerSet operator|(LayerSet b) const { return LayerSet(bits_ | b.bits_); }
  bool operator==(const LayerSet&) const = default;

 private:
  constexpr explicit LayerSet(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_ = 0;
};

/// How a kind is called and what its values are.
struct LayerInfo {
  LayerKind kind;
  std::string_view name;
  std::string_view channels;  ///< as ImageLayer::channels
  std::string_view unit;      ///< of the values; empty for light
};

/// All kinds, in their order.
std::span<const LayerInfo, kLayerKinds> layer_infos();
const LayerInfo& layer_info(LayerKind kind);

/// Reads names with commas in between; "all", "terms" and "cost" stand for several. Only kinds in
/// `allowed` are known; the error of another name lists them.
Result<LayerSet> read_layers(std::string_view names, LayerSet allowed);

/// Brings the layers of a picture that are light (`channels` "RGB") from the scene's own values
/// into linear light: in each pixel, every one keeps its share of the colour. So terms that sum to
/// the picture sum to the linear picture.
void to_linear(std::span<ImageLayer> layers, const Image& image, const Settings& settings);

}  // namespace dioptre
