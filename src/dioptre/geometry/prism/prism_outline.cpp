// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/prism/prism_outline.h"

#include <cmath>
#include <string>

namespace dioptre {
namespace {

using Points = std::vector<Vec2>;

struct SplineKind {
  const char* name;
  std::size_t least_points;
};

SplineKind kind_of(PrismSpline spline) {
  switch (spline) {
    case PrismSpline::kQuadratic:
      return {"quadratic", 4};
    case PrismSpline::kCubic:
      return {"cubic", 5};
    case PrismSpline::kBezier:
      return {"bezier", 4};
    case PrismSpline::kLinear:
      break;
  }
  return {"linear", 3};
}

void add_linear(const Points& p, Outline& outline) {
  outline.move_to(p[0]);
  for (std::size_t i = 1; i < p.size(); ++i) outline.add(line(p[i - 1], p[i]));
}

/// Between p[i] and p[i+1]: the parabola that is at p[i-1], p[i], p[i+1] at -1, 0, 1.
void add_quadratic(const Points& p, Outline& outline) {
  outline.move_to(p[1]);
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    outline.add(quadratic(p[i], p[i] + 0.25 * (p[i + 1] - p[i - 1]), p[i + 1]));
  }
}

/// Between p[i] and p[i+1]: the cubic whose slope at each is half the step between its neighbours
/// (Catmull and Rom, 1974).
void add_cubic(const Points& p, Outline& outline) {
  outline.move_to(p[1]);
  for (std::size_t i = 1; i + 2 < p.size(); ++i) {
    outline.add(cubic(p[i], p[i] + (1.0 / 6) * (p[i + 1] - p[i - 1]),
                      p[i + 1] - (1.0 / 6) * (p[i + 2] - p[i]), p[i + 1]));
  }
}

/// A group that does not begin where the last one ended begins a new loop.
void add_bezier(const Points& p, Outline& outline) {
  for (std::size_t i = 0; i + 3 < p.size(); i += 4) {
    if (i == 0 || !(p[i] == p[i - 1])) outline.move_to(p[i]);
    outline.add(cubic(p[i], p[i + 1], p[i + 2], p[i + 3]));
  }
}

}  // namespace

Result<Outline> prism_outline(const Prism& prism) {
  if (prism.outlines.empty()) return fail("prism needs an outline");
  const SplineKind kind = kind_of(prism.spline);
  Outline outline;
  for (const Points& points : prism.outlines) {
    if (points.size() < kind.least_points) {
      return fail(std::string("prism needs at least ") + std::to_string(kind.least_points) +
                  " points for a " + kind.name + " spline, found " + std::to_string(points.size()));
    }
    if (prism.spline == PrismSpline::kBezier && points.size() % 4 != 0) {
      return fail("prism needs four points for each bezier segment, found " +
                  std::to_string(points.size()) + " points");
    }
    for (const Vec2 p : points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return fail("prism point is not finite");
    }
    switch (prism.spline) {
      case PrismSpline::kLinear:
        add_linear(points, outline);
        break;
      case PrismSpline::kQuadratic:
        add_quadratic(points, outline);
        break;
      case PrismSpline::kCubic:
        add_cubic(points, outline);
        break;
      case PrismSpline::kBezier:
        add_bezier(points, outline);
        break;
    }
  }
  outline.close();
  return outline;
}

}  // namespace dioptre
