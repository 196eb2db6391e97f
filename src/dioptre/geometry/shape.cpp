// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/shape.h"

namespace dioptre {

bool Shape::nearest(const Ray& ray, Interval range, Crossing& out) const {
  thread_local Crossings found;
  const std::size_t first = found.size();  // a shape may ask another one from within crossings
  crossings(ray, range, found);
  bool any = false;
  for (std::size_t i = first; i < found.size() && !any; ++i) {
    if (!found[i].visible) continue;
    out = found[i];
    any = true;
  }
  found.resize(first);
  return any;
}

}  // namespace dioptre
