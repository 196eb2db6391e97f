// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/bicubic_patch/patch_pieces.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/triangle/smooth_normal.h"

namespace dioptre {
namespace {

using Net = std::array<Vec3, 16>;

/// Halves the curve of the four points from `first` on, `stride` apart, in both nets: de
/// Casteljau's algorithm.
void halve(Net& low, Net& high, std::size_t first, std::size_t stride) {
  const std::size_t i0 = first, i1 = i0 + stride, i2 = i1 + stride, i3 = i2 + stride;
  const Vec3 a = low[i0], b = low[i1], c = low[i2], d = low[i3];
  const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), cd = 0.5 * (c + d);
  const Vec3 abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
  low[i1] = ab, low[i2] = abc, low[i3] = middle;
  high[i0] = middle, high[i1] = bcd, high[i2] = cd, high[i3] = d;
}

struct Part {
  Net net;
  PatchPiece piece;
};

/// Leaves the first rows in `low`, and returns the last ones.
Part split_rows(Part& low) {
  Part high = low;
  for (std::size_t column = 0; column < 4; ++column) halve(low.net, high.net, column, 4);
  low.piece.rows *= 0.5f;
  high.piece.rows = low.piece.rows;
  high.piece.row += low.piece.rows;
  return high;
}

Part split_columns(Part& low) {
  Part high = low;
  for (std::size_t row = 0; row < 4; ++row) halve(low.net, high.net, 4 * row, 1);
  low.piece.columns *= 0.5f;
  high.piece.columns = low.piece.columns;
  high.piece.column += low.piece.columns;
  return high;
}

/// Whether all control points are near the plane through the first three corners; where the first
/// two are one, the last takes the place of the second (measured).
bool is_flat(const Net& net, double flatness) {
  const Vec3 a = net[0], b = net[3] == a ? net[15] : net[3];
  const Vec3 normal = unit_or_zero(cross(b - a, net[12] - a));
  if (normal == Vec3{}) return false;
  return std::all_of(net.begin(), net.end(),
                     [&](Vec3 p) { return std::fabs(dot(normal, p - a)) <= flatness; });
}

class Pieces {
 public:
  Pieces(double flatness, std::size_t most) : flatness_(flatness), most_(most) {}

  /// False if there are too many.
  bool add(Part part, std::uint32_t u_steps, std::uint32_t v_steps) {
    if ((u_steps == 0 && v_steps == 0) || (flatness_ > 0 && is_flat(part.net, flatness_))) {
      if (found_.size() == most_) return false;
      part.piece.corners = {part.net[0], part.net[3], part.net[12], part.net[15]};
      found_.push_back(part.piece);
      return true;
    }
    if (u_steps == 0) return add_columns(part, 0, v_steps);
    const Part last = split_rows(part);
    return add_columns(part, u_steps - 1, v_steps) && add_columns(last, u_steps - 1, v_steps);
  }

  std::vector<PatchPiece> take() { return std::move(found_); }

 private:
  bool add_columns(Part part, std::uint32_t u_steps, std::uint32_t v_steps) {
    if (v_steps == 0) return add(part, u_steps, 0);
    const Part last = split_columns(part);
    return add(part, u_steps, v_steps - 1) && add(last, u_steps, v_steps - 1);
  }

  double flatness_;
  std::size_t most_;
  std::vector<PatchPiece> found_;
};

struct Basis {
  std::array<double, 4> value, slope;  ///< the slopes are a third of the true ones
};

Basis basis_at(double t) {
  const double s = 1 - t;
  return {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
          {-s * s, s * s - 2 * s * t, 2 * s * t - t * t, t * t}};
}

}  // namespace

std::optional<std::vector<PatchPiece>> patch_pieces(const BicubicPatch& patch, std::size_t most) {
  // Halving more often than there are bits in a part's place can only pile up pieces of no size.
  constexpr std::uint32_t kMostSteps = 20;
  Pieces pieces(patch.flatness, most);
  if (!pieces.add({patch.points, {}}, std::min(patch.u_steps, kMostSteps),
                  std::min(patch.v_steps, kMostSteps))) {
    return std::nullopt;
  }
  return pieces.take();
}

Vec3 patch_normal(const BicubicPatch& patch, Vec2 place) {
  const Basis across = basis_at(place.x), down = basis_at(place.y);
  Vec3 along_row, along_column;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const Vec3 p = patch.points[4 * row + column];
      along_row += down.value[row] * across.slope[column] * p;
      along_column += down.slope[row] * across.value[column] * p;
    }
  }
  const Vec3 normal = unit_or_zero(cross(along_column, along_row));
  return normal == Vec3{} ? Vec3{1, 0, 0} : normal;
}

}  // namespace dioptre
