// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/isosurface/line_search.h"

#include <algorithm>
#include <cmath>

namespace dioptre {
namespace {

/// How far below 0 a positive field may fall within a piece of width h, with values a and b at its
/// ends and slopes within `slope`: the lower end of both cones' common bound.
double lowest(double a, double b, double h, Interval slope) {
  if (slope.min >= 0) return a;
  if (slope.max <= 0) return b;
  const bool from_low = slope.min > -kInfinity, from_high = slope.max < kInfinity;
  if (!from_low && !from_high) return -kInfinity;
  if (!from_low) return b - slope.max * h;
  if (!from_high) return a + slope.min * h;
  const double meeting = (b - a - slope.max * h) / (slope.min - slope.max);
  return a + slope.min * std::clamp(meeting, 0.0, h);
}

/// How much a piece must shrink at once for that to be better than halving it.
constexpr double kWorthShortening = 0.5;

/// The largest power of 1/2 below the accuracy.
double cell_below(double accuracy) {
  int exponent = 0;
  std::frexp(std::clamp(accuracy, 0x1p-40, 1.0), &exponent);
  const double power = std::ldexp(1, exponent - 1);
  return power < accuracy ? power : 0.5 * power;
}

}  // namespace

LineSearch::LineSearch(const FieldLine& line, const Options& options)
    : line_(line),
      steepest_(options.steepest),
      finest_(std::clamp(options.finest, 0x1p-40, 1.0)),
      cell_(cell_below(options.accuracy)),
      from_to_(options.from_to) {
  const Piece whole{0, 1, line.value(0), line.value(1)};
  first_inside_ = whole.value_low < 0;
  last_inside_ = whole.value_high < 0;
  pieces_[count_++] = whole;
}

bool LineSearch::next(SignChange& out) {
  while (count_ > 0) {
    const Piece piece = pieces_[--count_];
    if (piece.high <= from_to_.min) {
      if (!began_) began_inside_ = piece.value_high < 0;
      continue;
    }
    if (piece.low >= from_to_.max) {
      if (!began_) began_inside_ = piece.value_low < 0;
      count_ = 0;
      return false;
    }
    Interval slope;
    const Verdict verdict = judge(piece, slope);
    if (verdict == Verdict::kDivide) {
      --left_;
      if (!shorten(piece, slope)) divide(piece);
      continue;
    }
    if (!began_) began_ = true, began_inside_ = piece.value_low < 0;
    if (verdict == Verdict::kEmpty) continue;
    out = refine(piece);
    return true;
  }
  return false;
}

LineSearch::Verdict LineSearch::judge(const Piece& piece, Interval& slope) const {
  const bool changes = piece.changes();
  const IntervalJet jet = line_.range(piece.low, piece.high);
  if (!changes && !jet.value.contains(0)) return Verdict::kEmpty;
  slope = jet.slope;
  if (slope.min >= 0 || slope.max <= 0) return changes ? Verdict::kOneChange : Verdict::kEmpty;
  const Interval stated{-steepest_, steepest_};
  if (!changes && excluded(piece, is_unbounded(slope) ? intersect(slope, stated) : slope)) {
    return Verdict::kEmpty;
  }
  if (piece.high - piece.low > finest_ && left_ > 0) return Verdict::kDivide;
  return changes ? Verdict::kOneChange : Verdict::kEmpty;
}

bool LineSearch::excluded(const Piece& piece, Interval slope) {
  const double h = piece.high - piece.low;
  if (piece.value_low < 0) return lowest(-piece.value_low, -piece.value_high, h, -slope) > 0;
  return lowest(piece.value_low, piece.value_high, h, slope) > 0;
}

/// Leaves out what lies before and after all places where the field may vanish. The signs at the
/// ends stay as they are.
bool LineSearch::shorten(const Piece& piece, Interval slope) {
  if (is_unbounded(slope)) return false;
  const double h = piece.high - piece.low;
  const bool low_inside = piece.value_low < 0, high_inside = piece.value_high < 0;
  const double skip_low = piece.value_low / (low_inside ? -slope.max : -slope.min);
  const double skip_high = piece.value_high / (high_inside ? slope.min : slope.max);
  const double low = std::max(skip_low, 0.0), high = h - std::max(skip_high, 0.0);
  if (!(high - low < kWorthShortening * h) || !(high > low)) return false;
  const double margin = 0x1p-10 * (high - low);
  Piece rest{std::max(piece.low, piece.low + (low - margin)),
             std::min(piece.high, piece.low + (high + margin)), 0, 0};
  rest.value_low = line_.value(rest.low);
  rest.value_high = line_.value(rest.high);
  if (!(rest.low < rest.high)) return false;
  if ((rest.value_low < 0) != low_inside || (rest.value_high < 0) != high_inside) return false;
  pieces_[count_++] = rest;
  return true;
}

void LineSearch::divide(const Piece& piece) {
  const double middle = 0.5 * (piece.low + piece.high), value = line_.value(middle);
  pieces_[count_++] = {middle, piece.high, value, piece.value_high};
  pieces_[count_++] = {piece.low, middle, piece.value_low, value};
}

/// T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a
/// nonlinear function without using derivatives", 1997: inverse quadratic interpolation where the
/// last three points allow it, else bisection. It begins with the chord and ends within a cell.
SignChange LineSearch::refine(const Piece& piece) const {
  constexpr double kTolerance = 0x1p-42;
  constexpr int kMostRounds = 80;
  double x1 = piece.high, f1 = piece.value_high, x2 = piece.low, f2 = piece.value_low;
  double share = f1 / (f1 - f2);
  for (int round = 0; round < kMostRounds; ++round) {
    if (std::ceil(x1 / cell_) == std::ceil(x2 / cell_)) break;
    const double least = kTolerance / std::fabs(x2 - x1);
    if (!(least < 0.5)) break;
    if (!(share >= 0 && share <= 1)) share = 0.5;
    const double x = x1 + std::clamp(share, least, 1 - least) * (x2 - x1), f = line_.value(x);
    double x3 = x2, f3 = f2;
    if ((f < 0) == (f1 < 0)) {
      x3 = x1, f3 = f1;
    } else {
      x2 = x1, f2 = f1;
    }
    x1 = x, f1 = f;
    const double xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);
    const bool smooth = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
    share = smooth ? f1 / (f2 - f1) * f3 / (f2 - f3) +
                         (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
                   : 0.5;
  }
  const double end = std::min(std::ceil(std::max(x1, x2) / cell_) * cell_, 1.0);
  return {end, end - std::min(x1, x2), piece.value_high < 0};
}

}  // namespace dioptre
