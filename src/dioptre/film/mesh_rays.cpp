// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/mesh_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace dioptre {
namespace {

using Distribution = MeshCamera::Distribution;
using Face = MeshData::Face;

bool within(const std::array<std::uint32_t, 3>& indices, std::size_t size) {
  return indices[0] < size && indices[1] < size && indices[2] < size;
}

bool well_formed(const MeshData& data) {
  for (const Face& face : data.faces) {
    if (!within(face.corners, data.corners.size())) return false;
    if (!data.normals.empty() && !within(face.normals, data.normals.size())) return false;
    if (!data.uvs.empty() && !within(face.uvs, data.uvs.size())) return false;
  }
  return std::all_of(data.corners.begin(), data.corners.end(), [](Vec3 p) { return is_finite(p); });
}

std::array<Vec3, 3> corners_of(const MeshData& data, std::size_t face) {
  const auto& corners = data.faces[face].corners;
  return {data.corners[corners[0]], data.corners[corners[1]], data.corners[corners[2]]};
}

std::string what_is_wrong(const MeshCamera& camera) {
  const Distribution distribution = camera.distribution;
  if (distribution > Distribution::kUv) return "the mesh camera's distribution must be 0 to 3";
  if (camera.meshes.empty()) return "the mesh camera has no mesh";
  if (camera.rays_per_pixel < 1) return "the mesh camera needs at least one ray per pixel";
  if (distribution == Distribution::kEach && camera.rays_per_pixel > camera.meshes.size()) {
    return "the mesh camera needs as many meshes as rays per pixel";
  }
  if (!std::isfinite(camera.offset) || !std::isfinite(camera.max_distance)) {
    return "the mesh camera's offset and distance must be finite";
  }
  for (const CameraMesh& mesh : camera.meshes) {
    if (!well_formed(*mesh.data)) return "a mesh of the mesh camera refers to what is not there";
  }
  return {};
}

}  // namespace

MeshRays::MeshRays(const MeshCamera& camera) : camera_(camera) {
  // Further rays of a sum are not shot (measured); nor are those of the distributions that know one
  // only.
  rays_per_pixel_ = camera.distribution == Distribution::kEach ? camera.rays_per_pixel : 1;
  for (const CameraMesh& mesh : camera_.meshes) to_mesh_.push_back(inverse(mesh.transform));
  if (camera.distribution == Distribution::kUv) uv_faces_ = UvFaces(camera.meshes[0].data);
}

Result<MeshRays> MeshRays::prepare(const MeshCamera& camera) {
  if (std::string wrong = what_is_wrong(camera); !wrong.empty()) return fail(std::move(wrong));
  return MeshRays(camera);
}

std::optional<Ray> MeshRays::ray(double x, double y, std::uint32_t width, std::uint32_t height,
                                 std::uint32_t number) const {
  x = std::clamp(x, 0.0, width - 1.0);
  y = std::clamp(y - 1, 0.0, height - 1.0);
  const double column = std::floor(x), row = std::floor(y);
  switch (camera_.distribution) {
    case Distribution::kEach:
      return from_face(number, row * width + column);
    case Distribution::kSum: {
      double face = row * width + column;
      for (std::size_t mesh = 0; mesh < camera_.meshes.size(); ++mesh) {
        const auto faces = static_cast<double>(camera_.meshes[mesh].data->faces.size());
        if (face < faces) return from_face(mesh, face);
        face -= faces;
      }
      return std::nullopt;
    }
    case Distribution::kSideBySide: {
      // Columns are not counted anew for each mesh, but rows are as long as its share (measured).
      const double share = static_cast<double>(width) / static_cast<double>(camera_.meshes.size());
      return from_face(static_cast<std::size_t>(x / share), row * std::floor(share) + column);
    }
    case Distribution::kUv:
      return from_uv({(x - 0.5) / width, 1 - (y + 0.5) / height});
  }
  return std::nullopt;
}

/// From the centroid of a face along its normal.
std::optional<Ray> MeshRays::from_face(std::size_t mesh, double face) const {
  if (mesh >= camera_.meshes.size()) return std::nullopt;
  const MeshData& data = *camera_.meshes[mesh].data;
  if (!(face < static_cast<double>(data.faces.size()))) return std::nullopt;
  const auto [a, b, c] = corners_of(data, static_cast<std::size_t>(face));
  return leaving(mesh, (a + b + c) / 3, cross(c - a, b - a));
}

/// From the place on the first mesh that wears a texture coordinate; the other meshes are not asked
/// (measured).
std::optional<Ray> MeshRays::from_uv(Vec2 uv) const {
  const auto place = uv_faces_.find(uv);
  if (!place) return std::nullopt;
  const MeshData& data = *camera_.meshes[0].data;
  const auto [a, b, c] = corners_of(data, place->face);
  const double v = place->v, w = place->w;
  Vec3 normal = cross(c - a, b - a);
  if (camera_.smooth && !data.normals.empty()) {
    const auto& normals = data.faces[place->face].normals;
    normal = (1 - v - w) * normalize(data.normals[normals[0]]) +
             v * normalize(data.normals[normals[1]]) + w * normalize(data.normals[normals[2]]);
  }
  return leaving(0, a + v * (b - a) + w * (c - a), normal);
}

/// The ray from a place on a mesh along the normal there, both in the mesh's own space.
std::optional<Ray> MeshRays::leaving(std::size_t mesh, Vec3 place, Vec3 normal) const {
  if (!to_mesh_[mesh]) return std::nullopt;
  const Vec3 across = normalize(to_mesh_[mesh]->covector(normal));
  if (!is_finite(across)) return std::nullopt;
  return Ray{camera_.meshes[mesh].transform.point(place) + camera_.offset * across,
             camera_.backwards ? -across : across};
}

}  // namespace dioptre
