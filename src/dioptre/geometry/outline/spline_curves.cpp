// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/outline/spline_curves.h"

#include <cmath>
#include <string>

namespace dioptre {
namespace {

using Points = std::vector<Vec2>;

const char* name_of(OutlineSpline spline) {
  switch (spline) {
    case OutlineSpline::kQuadratic:
      return "quadratic";
    case OutlineSpline::kCubic:
      return "cubic";
    case OutlineSpline::kBezier:
      return "bezier";
    case OutlineSpline::kLinear:
      break;
  }
  return "linear";
}

std::vector<Curve> lines(const Points& p) {
  std::vector<Curve> curves;
  for (std::size_t i = 1; i < p.size(); ++i) curves.push_back(line(p[i - 1], p[i]));
  return curves;
}

/// Between p[i] and p[i+1]: the parabola that is at p[i-1], p[i], p[i+1] at -1, 0, 1.
std::vector<Curve> parabolas(const Points& p) {
  std::vector<Curve> curves;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    curves.push_back(quadratic(p[i], p[i] + 0.25 * (p[i + 1] - p[i - 1]), p[i + 1]));
  }
  return curves;
}

/// Between p[i] and p[i+1]: the cubic whose slope at each is half the step between its neighbours
/// (Catmull and Rom, 1974).
std::vector<Curve> catmull_rom(const Points& p) {
  std::vector<Curve> curves;
  for (std::size_t i = 1; i + 2 < p.size(); ++i) {
    curves.push_back(cubic(p[i], p[i] + (1.0 / 6) * (p[i + 1] - p[i - 1]),
                           p[i + 1] - (1.0 / 6) * (p[i + 2] - p[i]), p[i + 1]));
  }
  return curves;
}

std::vector<Curve> bezier_groups(const Points& p) {
  std::vector<Curve> curves;
  for (std::size_t i = 0; i + 3 < p.size(); i += 4) {
    curves.push_back(cubic(p[i], p[i + 1], p[i + 2], p[i + 3]));
  }
  return curves;
}

}  // namespace

Result<void> check_points(const char* shape, OutlineSpline spline, const Points& points,
                          bool closed) {
  const std::size_t least = least_points(spline, closed);
  const std::string found = ", found " + std::to_string(points.size());
  if (points.size() < least) {
    return fail(std::string(shape) + " needs at least " + std::to_string(least) + " points for a " +
                name_of(spline) + " spline" + found);
  }
  if (spline == OutlineSpline::kBezier && points.size() % 4 != 0) {
    return fail(std::string(shape) + " needs four points for each bezier segment" + found +
                " points");
  }
  for (const Vec2 p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      return fail(std::string(shape) + " point is not finite");
    }
  }
  return {};
}

std::vector<Curve> spline_curves(OutlineSpline spline, const Points& points) {
  switch (spline) {
    case OutlineSpline::kQuadratic:
      return parabolas(points);
    case OutlineSpline::kCubic:
      return catmull_rom(points);
    case OutlineSpline::kBezier:
      return bezier_groups(points);
    case OutlineSpline::kLinear:
      break;
  }
  return lines(points);
}

}  // namespace dioptre
