// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/container/container.h"

#include "dioptre/geometry/box/box.h"
#include "dioptre/geometry/sphere/sphere.h"

namespace dioptre {

Result<ShapePtr> prepare(const Container& c) {
  return c.sphere ? prepare(Sphere{c.center, c.radius}) : prepare(Box{c.corner1, c.corner2});
}

}  // namespace dioptre
