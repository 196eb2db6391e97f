// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/textures/texture_looks.h"

#include "dioptre/shading/maps/position_map.h"
#include "dioptre/shading/patterns/pattern_evaluator.h"
#include "dioptre/shading/space.h"

namespace dioptre {
namespace {

/// Brings the normals of the layers from `first` on out of a space in which the undisturbed normal
/// is `inside`, to where it is `outside`.
void bring_out(const Space& space, Vec3 inside, Vec3 outside, std::size_t first,
               std::vector<SurfaceLayer>& layers) {
  for (std::size_t i = first; i < layers.size(); ++i) {
    Vec3& normal = layers[i].normal;
    normal = normal == inside ? outside : space.normal_outside(normal);
  }
}

class Layers final : public TextureLook {
 public:
  Layers(const LayeredTexture& texture, const TextureParts& parts) : parts_(parts) {
    layers_.reserve(texture.layers.size());
    for (std::size_t i = texture.layers.size(); i-- > 0;) {
      const TextureLayer& layer = texture.layers[i];
      layers_.push_back({layer.pigment, layer.normal, layer.finish, Space(layer.transform)});
    }
  }

  void evaluate(const Lookup& at, Vec3 normal, float weight, TextureSample& out) const override {
    const auto first = static_cast<std::uint32_t>(out.layers.size());
    for (const Layer& layer : layers_) {
      Lookup inside = at.at(layer.space.point_inside(at.position));
      SurfaceLayer& made = out.layers.emplace_back();
      made.normal = disturbed(layer, inside, normal);
      made.finish = &layer.finish;
      made.old_opacity = parts_.old_opacity;
      // Patterns that look at the surface see its bumps.
      if (made.normal != normal) inside.viewpoint.normal = normalize(made.normal);
      made.pigment = parts_.pigments.color(layer.pigment, inside);
    }
    out.stacks.push_back({weight, first, static_cast<std::uint32_t>(layers_.size())});
  }

  Color transmittance(const Lookup& at) const override {
    Color through{1, 1, 1};
    for (const Layer& layer : layers_) {
      if (parts_.pigments.opaque(layer.pigment)) return {};
    }
    for (const Layer& layer : layers_) {
      const Lookup inside = at.at(layer.space.point_inside(at.position));
      through *= parts_.pigments.color(layer.pigment, inside).transmittance();
      if (is_black(through)) break;
    }
    return through;
  }

 private:
  struct Layer {
    PigmentId pigment;
    NormalId normal;
    Finish finish;
    Space space;
  };
  Vec3 disturbed(const Layer& layer, const Lookup& inside, Vec3 normal) const {
    if (!layer.normal) return normal;
    const Vec3 n = layer.space.normal_inside(normal);
    const Vec3 made = parts_.normals.disturb(layer.normal, inside, n);
    return made == n ? normal : layer.space.normal_outside(made);
  }

  const TextureParts parts_;
  std::vector<Layer> layers_;  ///< the top one first
};

/// Textures of a table with weights that sum to 1.
struct Share {
  TextureId texture;
  float weight;
};

/// Textures of textures of textures may not make more stacks than this.
constexpr std::size_t kMostStacks = 256;

void evaluate_share(const TextureTable& table, const Share& share, const Lookup& at, Vec3 normal,
                    float weight, TextureSample& out) {
  if (share.weight == 0 || out.stacks.size() >= kMostStacks) return;
  table.evaluate(share.texture, at, normal, share.weight * weight, out);
}

/// Its textures live in the space inside the pattern's warps.
class Map final : public TextureLook {
 public:
  Map(const TextureMap& map, const TextureTable& table, const PatternServices& services)
      : table_(table),
        pattern_(map.pattern, services),
        space_(pattern_.warps().transform()),
        places_(map.entries, map.list) {
    for (const TextureEntry& entry : map.entries) textures_.push_back(entry.texture);
  }

  void evaluate(const Lookup& at, Vec3 normal, float weight, TextureSample& out) const override {
    if (textures_.empty()) return;
    const Lookup inside = at.at(pattern_.warps().apply(at.position));
    const Vec3 n = space_.normal_inside(normal);
    const std::size_t first = out.layers.size();
    for (const Share& share : shares(inside).both) {
      evaluate_share(table_, share, inside, n, weight, out);
    }
    bring_out(space_, n, normal, first, out.layers);
  }

  Color transmittance(const Lookup& at) const override {
    if (textures_.empty()) return {1, 1, 1};
    const Lookup inside = at.at(pattern_.warps().apply(at.position));
    Color sum;
    for (const Share& share : shares(inside).both) {
      if (share.weight != 0) sum += table_.transmittance(share.texture, inside) * share.weight;
    }
    return sum;
  }

 private:
  struct Shares {
    Share both[2];
  };
  Shares shares(const Lookup& inside) const {
    const MapPlace place = places_.find(pattern_.value_inside(inside.position, inside.viewpoint));
    const TextureId first = textures_[place.first], second = textures_[place.second];
    if (first == second) return {{{first, 1}, {second, 0}}};
    return {{{first, 1 - place.share}, {second, place.share}}};
  }

  const TextureTable& table_;
  PatternEvaluator pattern_;
  Space space_;
  PositionMap places_;
  std::vector<TextureId> textures_;
};

class Average final : public TextureLook {
 public:
  Average(const AverageTexture& average, const TextureTable& table) : table_(table) {
    const std::vector<float> weights = average_weights(average.entries);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      shares_.push_back({average.entries[i].texture, weights[i]});
    }
  }
  void evaluate(const Lookup& at, Vec3 normal, float weight, TextureSample& out) const override {
    for (const Share& share : shares_) evaluate_share(table_, share, at, normal, weight, out);
  }
  Color transmittance(const Lookup& at) const override {
    Color sum;
    for (const Share& share : shares_) {
      if (share.weight != 0) sum += table_.transmittance(share.texture, at) * share.weight;
    }
    return sum;
  }

 private:
  const TextureTable& table_;
  std::vector<Share> shares_;
};

/// Textures by the numbers of an image's pixels, which start again where they run out, but the
/// first number that has none stands for the last texture (measured).
class Material final : public TextureLook {
 public:
  Material(const MaterialMap& map, const TextureTable& table, const ImageSampler& image)
      : table_(table), image_(image), textures_(map.textures) {}
  void evaluate(const Lookup& at, Vec3 normal, float weight, TextureSample& out) const override {
    if (!textures_.empty()) table_.evaluate(texture(at), at, normal, weight, out);
  }
  Color transmittance(const Lookup& at) const override {
    return textures_.empty() ? Color{1, 1, 1} : table_.transmittance(texture(at), at);
  }

 private:
  TextureId texture(const Lookup& at) const {
    const std::size_t number = image_.index(at.position), count = textures_.size();
    return textures_[number == count ? count - 1 : number % count];
  }

  const TextureTable& table_;
  const ImageSampler& image_;
  std::vector<TextureId> textures_;
};

class OnSurface final : public TextureLook {
 public:
  OnSurface(TextureId texture, const TextureTable& table) : table_(table), texture_(texture) {}
  void evaluate(const Lookup& at, Vec3 normal, float weight, TextureSample& out) const override {
    table_.evaluate(texture_, at.at_uv(), normal, weight, out);
  }
  Color transmittance(const Lookup& at) const override {
    return table_.transmittance(texture_, at.at_uv());
  }

 private:
  const TextureTable& table_;
  TextureId texture_;
};

/// A texture moved by a transform.
class Moved final : public TextureLook {
 public:
  Moved(std::unique_ptr<const TextureLook> look, const Affine& transform)
      : look_(std::move(look)), space_(transform) {}
  void evaluate(const Lookup& at, Vec3 normal, float weight, TextureSample& out) const override {
    const std::size_t first = out.layers.size();
    const Vec3 n = space_.normal_inside(normal);
    look_->evaluate(at.at(space_.point_inside(at.position)), n, weight, out);
    bring_out(space_, n, normal, first, out.layers);
  }
  Color transmittance(const Lookup& at) const override {
    return look_->transmittance(at.at(space_.point_inside(at.position)));
  }

 private:
  std::unique_ptr<const TextureLook> look_;
  Space space_;
};

struct Maker {
  const TextureTable& table;
  const TextureParts& parts;
  const PatternServices& services;
  using Made = std::unique_ptr<const TextureLook>;

  Made operator()(const LayeredTexture& t) const { return std::make_unique<Layers>(t, parts); }
  Made operator()(const TextureMap& t) const { return std::make_unique<Map>(t, table, services); }
  Made operator()(const AverageTexture& t) const { return std::make_unique<Average>(t, table); }
  Made operator()(const MaterialMap& t) const {
    if (t.image.index >= parts.images.size()) {
      return std::make_unique<Layers>(LayeredTexture{}, parts);
    }
    return std::make_unique<Material>(t, table, parts.images[t.image.index]);
  }
  Made operator()(const UvTexture& t) const {
    return std::make_unique<OnSurface>(t.texture, table);
  }
};

}  // namespace

std::unique_ptr<const TextureLook> make_texture_look(const Texture& texture,
                                                     const TextureTable& table,
                                                     const TextureParts& parts,
                                                     const PatternServices& services) {
  auto look = std::visit(Maker{table, parts, services}, texture.data);
  if (texture.transform == Affine{}) return look;
  return std::make_unique<Moved>(std::move(look), texture.transform);
}

}  // namespace dioptre
