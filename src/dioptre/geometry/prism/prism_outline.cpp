// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/prism/prism_outline.h"

#include "dioptre/geometry/outline/spline_curves.h"

namespace dioptre {
namespace {

/// A curve that does not begin where the last one ended begins a new loop.
void add_loops(const std::vector<Curve>& curves, Outline& outline) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (i == 0 || curves[i].begin() != curves[i - 1].end()) outline.move_to(curves[i].begin());
    outline.add(curves[i]);
  }
}

}  // namespace

Result<Outline> prism_outline(const Prism& prism) {
  if (prism.outlines.empty()) return fail("prism needs an outline");
  Outline outline;
  for (const std::vector<Vec2>& points : prism.outlines) {
    const Result<void> checked = check_points("prism", prism.spline, points, true);
    if (!checked) return tl::unexpected<Error>(checked.error());
    add_loops(spline_curves(prism.spline, points), outline);
  }
  outline.close();
  return outline;
}

}  // namespace dioptre
