// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/cylinder/cylinder.h"

#include "dioptre/geometry/cone/cone.h"

namespace dioptre {

/// A cylinder is the cone that does not grow.
Result<ShapePtr> prepare(const Cylinder& cylinder) {
  if (!(length(cylinder.cap - cylinder.base) > 0)) {
    return fail("cylinder: both ends are at the same point");
  }
  return prepare(
      Cone{cylinder.base, cylinder.radius, cylinder.cap, cylinder.radius, cylinder.open});
}

}  // namespace dioptre
