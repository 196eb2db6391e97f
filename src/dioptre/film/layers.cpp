// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/layers.h"

#include <algorithm>
#include <string>

#include "dioptre/film/display.h"

namespace dioptre {
namespace {

using Kind = LayerKind;
constexpr std::array<LayerInfo, kLayerKinds> kInfos{{
    {Kind::kAmbient, "ambient", "RGB", ""},
    {Kind::kDiffuse, "diffuse", "RGB", ""},
    {Kind::kSpecular, "specular", "RGB", ""},
    {Kind::kReflected, "reflected", "RGB", ""},
    {Kind::kRefracted, "refracted", "RGB", ""},
    {Kind::kRays, "rays", "Y", "per pixel"},
    {Kind::kSteps, "steps", "Y", "per pixel"},
    {Kind::kTests, "tests", "Y", "per pixel"},
    {Kind::kSpans, "spans", "Y", "per pixel"},
    {Kind::kDepth, "depth", "Z", "in units"},
    {Kind::kTime, "time", "Y", "in ns per pixel"},
}};

struct Group {
  std::string_view name;
  LayerSet kinds;
};
constexpr Group kGroups[] = {
    {"terms", LayerSet::terms()}, {"cost", LayerSet::costs()}, {"all", LayerSet::all()}};

/// The kinds that a name stands for, as far as they are allowed.
LayerSet kinds_of(std::string_view name, LayerSet allowed) {
  LayerSet found;
  for (const LayerInfo& info : kInfos) {
    if (name == info.name && allowed.has(info.kind)) found.add(info.kind);
  }
  for (const Group& group : kGroups) {
    for (const LayerInfo& info : kInfos) {
      const bool meant = name == group.name && group.kinds.has(info.kind);
      if (meant && allowed.has(info.kind)) found.add(info.kind);
    }
  }
  return found;
}

std::string known_names(LayerSet allowed) {
  std::string names;
  const auto add = [&](std::string_view name) {
    names += (names.empty() ? "" : ", ") + std::string(name);
  };
  for (const LayerInfo& info : kInfos) {
    if (allowed.has(info.kind)) add(info.name);
  }
  for (const Group& group : kGroups) {
    if (allowed.has_any(group.kinds)) add(group.name);
  }
  return names;
}

/// What a colour's value becomes in linear light, over what it was.
float linear_share(float value, const Settings& settings) {
  const float linear = to_linear(value, settings);
  if (linear == value) return 1;
  return value > 0 ? linear / value : 0;
}

}  // namespace

std::span<const LayerInfo, kLayerKinds> layer_infos() { return kInfos; }

const LayerInfo& layer_info(LayerKind kind) { return kInfos[static_cast<std::size_t>(kind)]; }

Result<LayerSet> read_layers(std::string_view names, LayerSet allowed) {
  LayerSet set;
  for (std::size_t start = 0; start <= names.size();) {
    const std::size_t end = std::min(names.find(',', start), names.size());
    const std::string_view name = names.substr(start, end - start);
    const LayerSet found = kinds_of(name, allowed);
    if (found.empty()) {
      return fail("unknown layer '" + std::string(name.substr(0, 80)) +
                  "'; known: " + known_names(allowed));
    }
    set = set | found;
    start = end + 1;
  }
  return set;
}

void to_linear(std::span<ImageLayer> layers, const Image& image, const Settings& settings) {
  if (layers.empty()) return;
  for (std::size_t at = 0; at < image.pixels.size(); ++at) {
    const Color c = image.pixels[at];
    const float shares[] = {linear_share(c.r, settings), linear_share(c.g, settings),
                            linear_share(c.b, settings)};
    for (ImageLayer& layer : layers) {
      if (layer.channels != "RGB") continue;
      for (std::size_t k = 0; k < 3; ++k) layer.values[3 * at + k] *= shares[k];
    }
  }
}

}  // namespace dioptre
