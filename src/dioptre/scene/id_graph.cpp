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
  std::string pointer(std::size_t node) const;

 private:
  std::size_t kind(std::size_t node) const {
    std::size_t k = 0;
    while (node >= starts_[k + 1]) ++k;
    return k;
  }
  const Scene& scene_;
  std::array<std::size_t, 6> starts_{};
};

/// Collects the ids among the fields of a value.
class Collect {
 public:
  Collect(const Nodes& nodes, std::vector<std::size_t>& out) : nodes_(nodes), out_(out) {}

  template <class T>
  void operator()(const char*, const T& value) {
    add(value);
  }
  template <class T>
  void add(Id<T> id) {
    if constexpr (requires { nodes_.of(id); }) {
      if (id) out_.push_back(nodes_.of(id));
    }
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
    if constexpr (HasFields<T>) T::fields(value, *this);
  }

 private:
  const Nodes& nodes_;
  std::vector<std::size_t>& out_;
};

std::vector<std::size_t> Nodes::needs(std::size_t node) const {
  std::vector<std::size_t> out;
  Collect collect(*this, out);
  const std::size_t k = kind(node), index = node - starts_[k];
  switch (k) {
    case 0:  // where a solid is does not depend on how it looks
      collect.add(scene_.objects[index].geometry);
      collect.add(scene_.objects[index].clipped_by);
      break;
    case 1:
      collect.add(scene_.textures[index]);
      break;
    case 2:
      collect.add(scene_.pigments[index]);
      break;
    case 3:
      collect.add(scene_.normals[index]);
      break;
    default:
      collect.add(scene_.functions[index]);
      break;
  }
  return out;
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

}  // namespace dioptre
