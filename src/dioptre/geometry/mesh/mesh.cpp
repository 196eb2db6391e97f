// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "dioptre/accel/part_structure.h"
#include "dioptre/geometry/triangle/smooth_normal.h"
#include "dioptre/geometry/triangle/triangle_hit.h"

namespace dioptre {
namespace {

using Face = MeshData::Face;

/// The order of hits along a ray; hits at the same t come in the order of their faces.
bool before(const Crossing& a, const Crossing& b) {
  return a.t != b.t ? a.t < b.t : a.face < b.face;
}

class PreparedMesh final : public Shape {
 public:
  PreparedMesh(const Mesh& mesh, const ShapeOptions& options)
      : data_(mesh.data), inside_vector_(mesh.inside_vector), solid_(inside_vector_ != Vec3{}) {
    std::vector<Bounds> boxes(data_->faces.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) boxes[i] = face_bounds(i);
    tree_ = PartStructure(options.accelerator, boxes, 4);
  }

  Bounds bounds() const override { return tree_.bounds(); }
  bool solid() const override { return solid_; }

  bool contains(Vec3 p) const override {
    if (!solid_ || !bounds().contains(p)) return false;
    bool inside = false;
    for_each_hit({p, inside_vector_}, {0, kInfinity},
                 [&](const Crossing&, Interval&) { inside = !inside; });
    return inside;
  }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const std::size_t first = out.size();
    // A solid's state at range.min follows from all that comes after it, where it is outside.
    for_each_hit(ray, {range.min, solid_ ? kInfinity : range.max},
                 [&](const Crossing& hit, Interval&) { out.push_back(hit); });
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), before);
    if (!solid_) return false;
    if (range.min == -kInfinity && (out.size() - first) % 2 != 0) out.pop_back();  // not closed
    const bool inside = (out.size() - first) % 2 != 0;
    bool entering = !inside;
    for (std::size_t i = first; i < out.size(); ++i, entering = !entering) {
      out[i].entering = entering;
    }
    while (out.size() > first && !(out.back().t < range.max)) out.pop_back();
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    bool found = false;
    for_each_hit(ray, range, [&](const Crossing& hit, Interval& rest) {
      if (found && !before(hit, out)) return;
      found = true;
      out = hit;
      rest.max = hit.t;
    });
    if (!found || !solid_) return found;
    out.entering = false;
    const Crossing nearest = out;
    for_each_hit(ray, {range.min, kInfinity}, [&](const Crossing& hit, Interval&) {
      if (before(nearest, hit)) out.entering = !out.entering;
    });
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Face& face = data_->faces[crossing.face];
    const double v = crossing.u, w = crossing.v;
    const auto [a, b, c] = corners(face);
    Surface s;
    s.position = a + v * (b - a) + w * (c - a);
    s.normal = unit_or_zero(cross(c - a, b - a));
    if (s.normal == Vec3{}) s.normal = -unit_or_zero(ray.direction);
    if (solid_ && (dot(s.normal, ray.direction) > 0) == crossing.entering) s.normal = -s.normal;
    s.shading_normal = s.normal;
    if (!data_->normals.empty()) {
      const auto& normals = data_->normals;
      const Vec3 first = normals[face.normals[0]], second = normals[face.normals[1]];
      const Vec3 third = normals[face.normals[2]];
      // A face whose three normals are the same is flat, whatever they are (measured).
      if (first == second && second == third) return s;
      s.shading_normal = smooth_normal(
          {unit_or_zero(first), unit_or_zero(second), unit_or_zero(third)}, v, w, s.normal);
    }
    return s;
  }

  Vec2 uv(const Ray&, const Crossing& crossing) const override {
    const double v = crossing.u, w = crossing.v;
    const auto& uvs = data_->uvs;
    if (uvs.empty()) return {v, w};
    const auto& corners = data_->faces[crossing.face].uvs;
    return (1 - v - w) * uvs[corners[0]] + v * uvs[corners[1]] + w * uvs[corners[2]];
  }

  /// Between its corners a face shows what lies between their textures.
  void texture_shares(const Ray&, const Crossing& crossing,
                      std::vector<TextureShare>& out) const override {
    const auto& textures = data_->faces[crossing.face].textures;
    const double v = crossing.u, w = crossing.v;
    if (textures[0] == textures[1] && textures[1] == textures[2]) {
      if (textures[0] != MeshData::kNoTexture) out.push_back({textures[0], 1});
      return;
    }
    const std::array<double, 3> shares{1 - v - w, v, w};
    for (std::size_t i = 0; i < 3; ++i) out.push_back({textures[i], shares[i]});
  }

 private:
  std::array<Vec3, 3> corners(const Face& face) const {
    const auto& all = data_->corners;
    return {all[face.corners[0]], all[face.corners[1]], all[face.corners[2]]};
  }

  /// Empty for a face that nothing can hit: two of its corners are one; or, in a sheet, that has no
  /// area. (In a solid, a face whose corners are on one line may close a gap of rounding size.)
  Bounds face_bounds(std::uint32_t index) const {
    const auto [a, b, c] = corners(data_->faces[index]);
    if (a == b || b == c || c == a || (!solid_ && degenerate(a, b, c))) return {};
    return unite(unite(Bounds{a, a}, b), c);
  }

  /// Calls sink(hit, range) for the hits in the range, in no order; it may lower range.max.
  template <class Sink>
  void for_each_hit(const Ray& ray, Interval range, Sink&& sink) const {
    if (ray.direction == Vec3{}) return;
    const TriangleRay triangle_ray(ray);
    const double least = range.min, most = range.max;
    tree_.traverse(ray, range, [&](std::uint32_t index, Interval& rest) {
      const auto [a, b, c] = corners(data_->faces[index]);
      if (!line_meets_triangle(triangle_ray, a, b, c)) return true;
      const TriangleHit hit = triangle_hit(triangle_ray, a, b, c);
      if (!(least < hit.t && hit.t < most)) return true;
      sink(crossing_of(hit, index), rest);
      return true;
    });
  }

  Shared<MeshData> data_;
  Vec3 inside_vector_;
  bool solid_;
  PartStructure tree_;
};

/// Says which of a face's three indices is too large; empty if none.
std::string wrong_index(const std::array<std::uint32_t, 3>& indices, std::size_t size,
                        std::size_t face, const char* what) {
  for (const std::uint32_t index : indices) {
    if (index < size) continue;
    return "mesh face " + std::to_string(face) + " refers to " + what + " " +
           std::to_string(index) + " of " + std::to_string(size);
  }
  return {};
}

std::string what_is_wrong(const MeshData& data) {
  if (data.faces.size() >= 0xffffffffu) return "mesh has too many faces";
  for (std::size_t i = 0; i < data.corners.size(); ++i) {
    if (!is_finite(data.corners[i])) return "mesh corner " + std::to_string(i) + " is not finite";
  }
  for (std::size_t i = 0; i < data.faces.size(); ++i) {
    const Face& face = data.faces[i];
    std::string wrong = wrong_index(face.corners, data.corners.size(), i, "corner");
    if (wrong.empty() && !data.normals.empty()) {
      wrong = wrong_index(face.normals, data.normals.size(), i, "normal");
    }
    if (wrong.empty() && !data.uvs.empty()) {
      wrong = wrong_index(face.uvs, data.uvs.size(), i, "texture coordinate");
    }
    if (!wrong.empty()) return wrong;
  }
  return {};
}

}  // namespace

Result<ShapePtr> prepare(const Mesh& mesh, const ShapeOptions& options) {
  std::string wrong = what_is_wrong(*mesh.data);
  if (wrong.empty() && !is_finite(mesh.inside_vector)) wrong = "mesh inside_vector is not finite";
  if (!wrong.empty()) return fail(std::move(wrong));
  return std::make_unique<PreparedMesh>(mesh, options);
}

}  // namespace dioptre
