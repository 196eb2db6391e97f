// SPDX-License-Identifier: Apache-2.0
#include "dioptre/scene/id_graph.h"

#include <array>
#include <cstdint>
#include <vector>

#include "dioptre/core/fields.h"

namespace dioptre {
namespace {

/// The vectors of a scene as ranges of node numbers of one graph.
class Nodes {
 public:
  explicit Nodes(const Scene& scene) : scene_(scene) {
    const std::size_t counts[] = {scene.objects.size(), scene.textures.size(),
                                  scene.pigments.size(), scene.normals.size(),
                                  scene.functions.size()};
    for (std::size_t k = 0; k < starts_.size() - 1; ++k) starts_[k + 1] = starts_[k] + counts[k];
  }
  std::size_t size() const { return starts_.back(); }

  std::size_t of(ObjectId id) const { return starts_[0] + id.index; }
  std::size_t of(TextureId id) const { return starts_[1] + id.index; }
  std::size_t of(PigmentId id) const { return starts_[2] + id.index; }
  std::size_t of(NormalId id) const { return starts_[3] + id.index; }
  std::size_t of(FunctionId id) const { return starts_[4] + id.index; }

  /// The nodes that the value of a node needs.
  std::vector<std::size_t> needs(std::size_t node) const;
  /// What a node itself asks of a texture's lookup.
  TextureNeeds own_needs(std::size_t node) const;
  std::size_t first_texture() const { return starts_[1]; }
  std::string pointer(std::size_t node) const;

 private:
  /// Shows all that a node's value depends on to a visitor.
  template <class Visitor>
  void show(std::size_t node, Visitor& visitor) const;
  std::size_t kind(std::size_t node) const {
    std::size_t k = 0;
    while (node >= starts_[k + 1]) ++k;
    return k;
  }
  const Scene& scene_;
  std::array<std::size_t, 6> starts_{};
};

/// Calls found(part) for a value and all values in it.
template <class Found>
class Walk {
 public:
  explicit Walk(Found found) : found_(found) {}

  template <class T>
  void operator()(const char*, const T& value) {
    add(value);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    for (const T& value : values) add(value);
  }
  template <class... T>
  void add(const std::variant<T...>& value) {
    std::visit([&](const auto& alternative) { add(alternative); }, value);
  }
  template <class T>
  void add(const T& value) {
    found_(value);
    if constexpr (HasFields<T>) T::fields(value, *this);
  }

 private:
  Found found_;
};

template <class Visitor>
void Nodes::show(std::size_t node, Visitor& visitor) const {
  const std::size_t k = kind(node), index = node - starts_[k];
  switch (k) {
    case 0:  // where a solid is does not depend on how it looks
      visitor.add(scene_.objects[index].geometry);
      visitor.add(scene_.objects[index].clipped_by);
      break;
    case 1:
      visitor.add(scene_.textures[index]);
      break;
    case 2:
      visitor.add(scene_.pigments[index]);
      break;
    case 3:
      visitor.add(scene_.normals[index]);
      break;
    default:
      visitor.add(scene_.functions[index]);
      break;
  }
}

std::vector<std::size_t> Nodes::needs(std::size_t node) const {
  std::vector<std::size_t> out;
  Walk collect([&](const auto& part) {
    if constexpr (requires { of(part); }) {
      if (part) out.push_back(of(part));
    }
  });
  show(node, collect);
  return out;
}

TextureNeeds Nodes::own_needs(std::size_t node) const {
  TextureNeeds own;
  Walk look([&]<class T>(const T& part) {
    if constexpr (std::is_same_v<T, NormalId>) own.surface = own.surface || part;
    constexpr bool kLooksAtSurface = std::is_same_v<T, Slope> || std::is_same_v<T, Aoi>;
    constexpr bool kLooksAtUv = std::is_same_v<T, UvTexture> || std::is_same_v<T, UvPigment> ||
                                std::is_same_v<T, UvNormal>;
    if constexpr (kLooksAtSurface) own.surface = true;
    if constexpr (kLooksAtUv) own.uv = true;
  });
  show(node, look);
  return own;
}

std::string Nodes::pointer(std::size_t node) const {
  constexpr const char* kNames[] = {"/objects/", "/textures/", "/pigments/", "/normals/",
                                    "/functions/"};
  const std::size_t k = kind(node);
  return kNames[k] + std::to_string(node - starts_[k]);
}

}  // namespace

std::string find_cycle(const Scene& scene) {
  enum class Mark : std::uint8_t { kNew, kOpen, kDone };
  struct Open {
    std::size_t node;
    std::vector<std::size_t> needs;
    std::size_t next = 0;
  };
  const Nodes nodes(scene);
  std::vector<Mark> marks(nodes.size(), Mark::kNew);
  std::vector<Open> stack;  // depth first without recursion: chains may be long
  for (std::size_t start = 0; start < nodes.size(); ++start) {
    if (marks[start] != Mark::kNew) continue;
    marks[start] = Mark::kOpen;
    stack.push_back({start, nodes.needs(start)});
    while (!stack.empty()) {
      Open& top = stack.back();
      if (top.next == top.needs.size()) {
        marks[top.node] = Mark::kDone;
        stack.pop_back();
        continue;
      }
      const std::size_t node = top.needs[top.next++];
      if (marks[node] == Mark::kOpen) return nodes.pointer(node) + ": needs itself";
      if (marks[node] == Mark::kDone) continue;
      marks[node] = Mark::kOpen;
      stack.push_back({node, nodes.needs(node)});
    }
  }
  return {};
}

std::vector<TextureNeeds> texture_needs(const Scene& scene) {
  const Nodes nodes(scene);
  std::vector<TextureNeeds> needs(nodes.size());
  std::vector<std::vector<std::size_t>> users(nodes.size());
  std::vector<std::size_t> pending;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    for (const std::size_t part : nodes.needs(node)) users[part].push_back(node);
    needs[node] = nodes.own_needs(node);
    if (needs[node].uv || needs[node].surface) pending.push_back(node);
  }
  while (!pending.empty()) {
    const TextureNeeds part = needs[pending.back()];
    const std::vector<std::size_t>& whole = users[pending.back()];
    pending.pop_back();
    for (const std::size_t user : whole) {
      TextureNeeds& own = needs[user];
      if ((own.uv || !part.uv) && (own.surface || !part.surface)) continue;
      own = {own.uv || part.uv, own.surface || part.surface};
      pending.push_back(user);
    }
  }
  const auto first = needs.begin() + static_cast<std::ptrdiff_t>(nodes.first_texture());
  return {first, first + static_cast<std::ptrdiff_t>(scene.textures.size())};
}

}  // namespace dioptre
