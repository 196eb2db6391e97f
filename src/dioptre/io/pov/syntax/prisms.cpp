// SPDX-License-Identifier: Apache-2.0
// prism: `[spline] [sweep] height, height, count, points`.
#include <algorithm>
#include <cmath>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kMostPoints = std::int64_t{1} << 26;

bool parse_kind(Parser& parser, Prism& prism) {
  if (const std::optional<OutlineSpline> spline = parse_outline_spline(parser)) {
    prism.spline = *spline;
  } else if (parser.accept(Keyword::kLinearSweep)) {
    prism.conic = false;
  } else if (parser.accept(Keyword::kConicSweep)) {
    prism.conic = true;
  } else {
    return false;
  }
  return true;
}

/// Tells which points are meant to be the same: those nearer to each other than what rounding may
/// have moved them, for points of this size. `cos(0)` and `cos(2*pi)` close an outline.
class SamePoint {
 public:
  explicit SamePoint(const std::vector<Vec2>& points) {
    constexpr double kShare = 1e-10;
    for (const Vec2 p : points) near_ = std::max({near_, std::abs(p.x), std::abs(p.y)});
    near_ *= kShare;
  }
  bool operator()(Vec2 a, Vec2 b) const {
    return std::abs(a.x - b.x) <= near_ && std::abs(a.y - b.y) <= near_;
  }

 private:
  double near_ = 0;
};

/// Cuts the points into closed outlines: each goes on until the point where its curve begins comes
/// back; a cubic one has one point more.
void cut_outlines(Parser& parser, Prism& prism, std::vector<Vec2>& points) {
  const SamePoint same(points);
  const std::size_t before = prism.spline == OutlineSpline::kLinear ? 0 : 1;
  const std::size_t after = prism.spline == OutlineSpline::kCubic ? 1 : 0;
  std::size_t begin = 0;
  while (begin < points.size()) {
    const std::size_t first = begin + before;
    std::size_t last = first + 2;
    while (last < points.size() && !same(points[last], points[first])) ++last;
    if (last < points.size()) points[last] = points[first];
    if (last + after >= points.size()) {
      if (last >= points.size()) parser.warn("the outline of the prism is open: it is closed");
      last = points.size() - 1;
    } else {
      last += after;
    }
    const auto at = [&](std::size_t i) { return points.begin() + static_cast<std::ptrdiff_t>(i); };
    prism.outlines.emplace_back(at(begin), at(last + 1));
    begin = last + 1;
  }
}

/// Bezier pieces in groups of four: an outline ends where a group ends at its beginning.
void cut_bezier(Parser& parser, Prism& prism, const std::vector<Vec2>& points) {
  if (points.size() % 4 != 0) {
    parser.fail("a bezier_spline needs four points for each piece, found " +
                std::to_string(points.size()));
  }
  const SamePoint same(points);
  std::vector<Vec2> outline;
  for (std::size_t i = 0; i < points.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) outline.push_back(points[i + k]);
    if (!same(outline.back(), outline.front())) continue;
    outline.back() = outline.front();
    prism.outlines.push_back(std::move(outline));
    outline.clear();
  }
  if (outline.empty()) return;
  parser.warn("the outline of the prism is open: it is closed");
  prism.outlines.push_back(std::move(outline));
}

}  // namespace

std::optional<OutlineSpline> parse_outline_spline(Parser& parser) {
  if (parser.accept(Keyword::kLinearSpline)) return OutlineSpline::kLinear;
  if (parser.accept(Keyword::kQuadraticSpline)) return OutlineSpline::kQuadratic;
  if (parser.accept(Keyword::kCubicSpline)) return OutlineSpline::kCubic;
  if (parser.accept(Keyword::kBezierSpline)) return OutlineSpline::kBezier;
  return std::nullopt;
}

void parse_prism(Parser& parser, Item& item) {
  Prism prism;
  while (parse_kind(parser, prism)) {
  }
  prism.height1 = parser.parse_float();
  parser.skip_comma();
  prism.height2 = parser.parse_float();
  parser.skip_comma();
  const SourcePosition where = parser.position();
  const std::int64_t count = parse_whole(parser, 0, kMostPoints);
  std::vector<Vec2> points;
  for (std::int64_t i = 0; i < count; ++i) {
    parser.skip_comma();
    points.push_back(parser.parse_vec2());
  }
  const std::size_t fewest = least_points(prism.spline, true);
  if (points.size() < fewest) {
    parser.fail_at(where, "this prism needs at least " + std::to_string(fewest) + " points");
  }
  if (prism.spline == OutlineSpline::kBezier) {
    cut_bezier(parser, prism, points);
  } else {
    cut_outlines(parser, prism, points);
  }
  item.object.geometry = ShapeData{std::move(prism)};
}

}  // namespace dioptre::pov
