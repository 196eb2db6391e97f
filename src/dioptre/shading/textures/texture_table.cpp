// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/textures/texture_table.h"

#include <cmath>

#include "dioptre/shading/textures/texture_looks.h"

namespace dioptre {
namespace {

Lookup lookup_of(const TexturePoint& point) {
  return {point.position, {point.normal, point.view}, point.uv};
}

/// Whether a texture is opaque if those that it is made of are as `opaque` says.
struct IsOpaque {
  const PigmentTable& pigments;
  const std::vector<bool>& opaque;

  bool at(TextureId id) const { return id.index < opaque.size() && opaque[id.index]; }
  bool all(const std::vector<TextureEntry>& entries) const {
    for (const TextureEntry& entry : entries) {
      if (!at(entry.texture)) return false;
    }
    return !entries.empty();
  }
  bool operator()(const LayeredTexture& t) const {
    for (const TextureLayer& layer : t.layers) {
      if (pigments.opaque(layer.pigment)) return true;
    }
    return false;
  }
  bool operator()(const TextureMap& t) const { return all(t.entries); }
  bool operator()(const AverageTexture& t) const { return all(t.entries); }
  bool operator()(const MaterialMap& t) const {
    for (const TextureId texture : t.textures) {
      if (!at(texture)) return false;
    }
    return !t.textures.empty();
  }
  bool operator()(const UvTexture& t) const { return at(t.texture); }
};

}  // namespace

void TextureTable::compile(const Scene& scene, const TextureParts& parts,
                           const PatternServices& services) {
  looks_.reserve(scene.textures.size());
  for (const Texture& texture : scene.textures) {
    looks_.push_back(make_texture_look(texture, *this, parts, services));
  }
  find_opaque(scene, parts.pigments);
}

void TextureTable::find_opaque(const Scene& scene, const PigmentTable& pigments) {
  opaque_.assign(scene.textures.size(), true);
  // Clear parts make their wholes clear, until nothing changes: two rounds if parts come first.
  constexpr int kMostRounds = 32;
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < opaque_.size(); ++i) {
      if (!opaque_[i] || std::visit(IsOpaque{pigments, opaque_}, scene.textures[i].data)) continue;
      opaque_[i] = false;
      changed = true;
    }
    if (!changed) return;
  }
  opaque_.assign(scene.textures.size(), false);
}

void TextureTable::append(TextureId id, float weight, const TexturePoint& point,
                          TextureSample& out) const {
  std::size_t i = out.layers.size();
  evaluate(id, lookup_of(point), point.normal, weight, out);
  for (; i < out.layers.size(); ++i) {
    SurfaceLayer& layer = out.layers[i];
    if (layer.normal == point.normal) continue;
    const double size = length(layer.normal);
    layer.normal = size > 0 && std::isfinite(size) ? layer.normal / size : point.normal;
  }
}

void TextureTable::evaluate(TextureId id, const Lookup& at, Vec3 normal, float weight,
                            TextureSample& out) const {
  const Nesting nesting;
  if (id.index >= looks_.size() || nesting.too_deep()) return;
  looks_[id.index]->evaluate(at, normal, weight, out);
}

Color TextureTable::transmittance(TextureId id, const TexturePoint& point) const {
  if (opaque(id)) return {};
  return transmittance(id, lookup_of(point));
}

Color TextureTable::transmittance(TextureId id, const Lookup& at) const {
  const Nesting nesting;
  if (id.index >= looks_.size() || nesting.too_deep()) return {1, 1, 1};
  return looks_[id.index]->transmittance(at);
}

}  // namespace dioptre
