// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/affine.h"

namespace dioptre {

/// A space placed in another by an affine map: takes points into it, and normals (covectors, which
/// do not keep their length) both ways. A singular map counts as the identity.
class Space {
 public:
  explicit Space(const Affine& transform) : to_outside_(transform), same_(transform == Affine{}) {
    if (const auto back = inverse(transform)) {
      to_inside_ = *back;
    } else {
      to_outside_ = {};
      same_ = true;
    }
  }

  Vec3 point_inside(Vec3 p) const { return same_ ? p : to_inside_.point(p); }
  Vec3 normal_inside(Vec3 n) const { return same_ ? n : to_outside_.covector(n); }
  Vec3 normal_outside(Vec3 n) const { return same_ ? n : to_inside_.covector(n); }

 private:
  Affine to_outside_, to_inside_;
  bool same_;
};

}  // namespace dioptre
