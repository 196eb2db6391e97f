// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/pigments/pigment_evaluator.h"

#include "dioptre/shading/maps/position_map.h"
#include "dioptre/shading/patterns/pattern_evaluator.h"

namespace dioptre {
namespace {

PigmentColor mix(const PigmentColor& a, const PigmentColor& b, float share) {
  return a * (1 - share) + b * share;
}

class Solid final : public PigmentEvaluator {
 public:
  explicit Solid(const PigmentColor& color) : color_(color) {}
  PigmentColor color(const Lookup&) const override { return color_; }

 private:
  PigmentColor color_;
};

class ColorMap final : public PigmentEvaluator {
 public:
  ColorMap(const ColorMapPigment& pigment, const PatternServices& services)
      : pattern_(pigment.pattern, services), places_(pigment.entries, pigment.list) {
    colors_.reserve(pigment.entries.size());
    for (const ColorEntry& entry : pigment.entries) colors_.push_back(entry.color);
  }
  PigmentColor color(const Lookup& at) const override {
    if (colors_.empty()) return {};
    const MapPlace place = places_.find(pattern_.value(at.position, at.viewpoint));
    if (place.share == 0) return colors_[place.first];
    return mix(colors_[place.first], colors_[place.second], place.share);
  }

 private:
  PatternEvaluator pattern_;
  PositionMap places_;
  std::vector<PigmentColor> colors_;
};

/// Its pigments live in the space inside the pattern's warps.
class PigmentMap final : public PigmentEvaluator {
 public:
  PigmentMap(const PigmentMapPigment& pigment, const PigmentTable& table,
             const PatternServices& services)
      : table_(table), pattern_(pigment.pattern, services), places_(pigment.entries, pigment.list) {
    for (const PigmentEntry& entry : pigment.entries) pigments_.push_back(entry.pigment);
  }
  PigmentColor color(const Lookup& at) const override {
    const Nesting nesting;
    if (pigments_.empty() || nesting.too_deep()) return {};
    const Lookup inside = at.at(pattern_.warps().apply(at.position));
    const MapPlace place = places_.find(pattern_.value_inside(inside.position, at.viewpoint));
    const PigmentId first = pigments_[place.first], second = pigments_[place.second];
    if (place.share == 0 || first == second) return table_.color(first, inside);
    if (place.share == 1) return table_.color(second, inside);
    return mix(table_.color(first, inside), table_.color(second, inside), place.share);
  }

 private:
  const PigmentTable& table_;
  PatternEvaluator pattern_;
  PositionMap places_;
  std::vector<PigmentId> pigments_;
};

class Average final : public PigmentEvaluator {
 public:
  Average(const AveragePigment& pigment, const PigmentTable& table)
      : table_(table), warps_(pigment.warps, false), weights_(average_weights(pigment.entries)) {
    for (const PigmentEntry& entry : pigment.entries) pigments_.push_back(entry.pigment);
  }
  PigmentColor color(const Lookup& at) const override {
    const Nesting nesting;
    if (nesting.too_deep()) return {};
    const Lookup inside = at.at(warps_.apply(at.position));
    PigmentColor sum;
    for (std::size_t i = 0; i < pigments_.size(); ++i) {
      if (weights_[i] != 0) sum = sum + table_.color(pigments_[i], inside) * weights_[i];
    }
    return sum;
  }

 private:
  const PigmentTable& table_;
  WarpList warps_;
  std::vector<float> weights_;
  std::vector<PigmentId> pigments_;
};

/// Clear where the image does not reach.
class Image final : public PigmentEvaluator {
 public:
  Image(const ImagePigment& pigment, const ImageSampler& image)
      : image_(image), warps_(pigment.warps, false) {}
  PigmentColor color(const Lookup& at) const override {
    constexpr PigmentColor kClear{{1, 1, 1}, 0, 1};
    return image_.color(warps_.apply(at.position)).value_or(kClear);
  }

 private:
  const ImageSampler& image_;
  WarpList warps_;
};

class OnSurface final : public PigmentEvaluator {
 public:
  OnSurface(PigmentId pigment, const PigmentTable& table) : table_(table), pigment_(pigment) {}
  PigmentColor color(const Lookup& at) const override {
    const Nesting nesting;
    return nesting.too_deep() ? PigmentColor{} : table_.color(pigment_, at.at_uv());
  }

 private:
  const PigmentTable& table_;
  PigmentId pigment_;
};

struct Maker {
  const PigmentTable& table;
  const std::vector<ImageSampler>& images;
  const PatternServices& services;
  using Made = std::unique_ptr<const PigmentEvaluator>;

  Made operator()(const SolidPigment& p) const { return std::make_unique<Solid>(p.color); }
  Made operator()(const ColorMapPigment& p) const {
    return std::make_unique<ColorMap>(p, services);
  }
  Made operator()(const PigmentMapPigment& p) const {
    return std::make_unique<PigmentMap>(p, table, services);
  }
  Made operator()(const AveragePigment& p) const { return std::make_unique<Average>(p, table); }
  Made operator()(const ImagePigment& p) const {
    if (p.image.index >= images.size()) return std::make_unique<Solid>(PigmentColor{});
    return std::make_unique<Image>(p, images[p.image.index]);
  }
  Made operator()(const UvPigment& p) const {
    return std::make_unique<OnSurface>(p.pigment, table);
  }
};

bool opaque_color(const PigmentColor& c) { return c.filter == 0 && c.transmit == 0; }

/// Whether a pigment is opaque if those that it is made of are as `opaque` says.
struct IsOpaque {
  const std::vector<ImageSampler>& images;
  const std::vector<bool>& opaque;

  bool at(PigmentId id) const { return id.index >= opaque.size() || opaque[id.index]; }
  bool all(const std::vector<PigmentEntry>& entries) const {
    for (const PigmentEntry& entry : entries) {
      if (!at(entry.pigment)) return false;
    }
    return true;
  }
  bool operator()(const SolidPigment& p) const { return opaque_color(p.color); }
  bool operator()(const ColorMapPigment& p) const {
    for (const ColorEntry& entry : p.entries) {
      if (!opaque_color(entry.color)) return false;
    }
    return true;
  }
  bool operator()(const PigmentMapPigment& p) const { return all(p.entries); }
  bool operator()(const AveragePigment& p) const { return all(p.entries); }
  bool operator()(const ImagePigment& p) const {
    return p.image.index >= images.size() || images[p.image.index].opaque();
  }
  bool operator()(const UvPigment& p) const { return at(p.pigment); }
};

}  // namespace

void PigmentTable::compile(const Scene& scene, const std::vector<ImageSampler>& images,
                           const PatternServices& services) {
  pigments_.reserve(scene.pigments.size());
  for (const Pigment& pigment : scene.pigments) {
    pigments_.push_back(std::visit(Maker{*this, images, services}, pigment.data));
  }
  find_opaque(scene, images);
}

void PigmentTable::find_opaque(const Scene& scene, const std::vector<ImageSampler>& images) {
  opaque_.assign(scene.pigments.size(), true);
  // Clear parts make their wholes clear, until nothing changes: two rounds if parts come first.
  constexpr int kMostRounds = 32;
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < opaque_.size(); ++i) {
      if (!opaque_[i] || std::visit(IsOpaque{images, opaque_}, scene.pigments[i].data)) continue;
      opaque_[i] = false;
      changed = true;
    }
    if (!changed) return;
  }
  opaque_.assign(scene.pigments.size(), false);
}

}  // namespace dioptre
