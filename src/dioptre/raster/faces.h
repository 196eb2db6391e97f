// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/core/vec.h"

namespace dioptre {

/// A triangle that stands for part of the surface of an item of the scene.
struct Face {
  std::uint32_t corners[3];  ///< indices into FaceSet::corners
  std::uint32_t item;        ///< index into RenderScene::items
  float reach = 0;   ///< how far the true surface may be off, in depth; 0: the face is exact
  float margin = 0;  ///< how far it may lie beside the face, in pixels: the face is drawn wider
};

/// The faces that a scene is drawn with.
struct FaceSet {
  std::vector<Vec3> corners;  ///< in view space
  std::vector<Face> faces;

  /// More than this is refused: a gigabyte or two.
  static constexpr std::size_t kMost = std::size_t{1} << 25;
  bool has_room(std::size_t corner_count, std::size_t face_count) const {
    return corner_count <= kMost - corners.size() && face_count <= kMost - faces.size();
  }
};

/// What is said where a scene would take more faces than a FaceSet may hold.
inline tl::unexpected<Error> too_many_faces() {
  return fail("the scene takes too many faces for zbuffer; a smaller image takes fewer");
}

}  // namespace dioptre
