// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/poly/poly.h"

#include <algorithm>
#include <cmath>

#include "dioptre/core/roots.h"
#include "dioptre/geometry/poly/along_ray.h"
#include "dioptre/geometry/quadratic.h"

namespace dioptre {
namespace {

/// A polynomial in the ray's parameter. Coefficients beyond the degree are not set.
struct Univariate {
  std::array<double, kMaxDegree + 1> c;
  int degree = -1;  ///< -1: the zero polynomial

  /// this * (a + b t), in place.
  void step(double a, double b) {
    if (degree < 0) return;
    ++degree;
    c[degree] = c[degree - 1] * b;
    for (int k = degree - 1; k > 0; --k) c[k] = c[k] * a + c[k - 1] * b;
    c[0] *= a;
  }
  void add(double constant) {
    if (degree < 0) c[degree = 0] = 0;
    c[0] += constant;
  }
  void add(const Univariate& other) {
    const int common = std::min(degree, other.degree);
    for (int k = 0; k <= common; ++k) c[k] += other.c[k];
    for (int k = common + 1; k <= other.degree; ++k) c[k] = other.c[k];
    degree = std::max(degree, other.degree);
  }
  std::span<const double> coefficients() const {
    return {c.data(), static_cast<std::size_t>(degree + 1)};
  }
};

class PreparedPoly final : public Shape {
 public:
  explicit PreparedPoly(const Poly& poly)
      : order_(static_cast<int>(poly.order)), all_(poly.coefficients) {
    const double* c = poly.coefficients.data();
    for (int i = order_; i >= 0; --i) {
      for (int j = order_ - i; j >= 0; --j) {
        std::span<const double> row(c, static_cast<std::size_t>(order_ - i - j + 1));
        c += row.size();
        while (!row.empty() && row.front() == 0) row = row.subspan(1);
        const auto first = static_cast<std::uint32_t>(coefficients_.size());
        coefficients_.insert(coefficients_.end(), row.begin(), row.end());
        rows_.push_back({first, static_cast<std::uint32_t>(row.size())});
      }
    }
  }

  Bounds bounds() const override { return Bounds::all(); }
  bool contains(Vec3 p) const override { return jet(p).value <= 0; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Along along;
    if (!restrict_to(ray, along)) return false;
    const PolynomialRoots roots = solve(along, range, kMaxDegree);
    bool inside = roots.starts_negative;
    for (std::size_t i = 0; i < roots.count; ++i) {
      inside = !inside;
      out.push_back(crossing(along, roots, i, inside));
    }
    return roots.starts_negative;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    Along along;
    if (!restrict_to(ray, along)) return false;
    const PolynomialRoots roots = solve(along, range, 1);
    if (roots.count == 0) return false;
    out = crossing(along, roots, 0, !roots.starts_negative);
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 position = ray.at(crossing.t);
    Vec3 normal = jet(position).gradient;
    const double size = length(normal);
    normal = size > 0 ? normal / size : Vec3{0, 1, 0};
    return {position, normal, normal};
  }

 private:
  /// A value with its three partial derivatives.
  struct Jet {
    double value = 0;
    Vec3 gradient;
  };

  /// The stretch of a ray where all crossings lie: t = shift + reach s with s in [-1, 1]. It does
  /// not depend on the range asked, and so neither do the crossings, to the last bit.
  struct Along {
    Univariate in_s;
    Ray near;  ///< the ray from its point nearest to the origin
    double shift, reach;
    double misplaced;  ///< a bound on the error of that point
  };

  /// The coefficients of one power of x and one of y, from the highest power of z that counts.
  struct Row {
    std::uint32_t first, count;
  };

  /// False where the ray meets nothing because its numbers are not finite.
  bool restrict_to(const Ray& ray, Along& along) const {
    along.shift = closest_approach(ray, {});
    if (!std::isfinite(along.shift)) return false;
    along.near = {ray.at(along.shift), ray.direction};
    along.misplaced = shift_error(ray, along.shift) * length(ray.direction);
    along.in_s = restricted(along.near);
    along.reach = rescale(along.in_s);
    return std::isfinite(along.reach);
  }

  static PolynomialRoots solve(const Along& along, Interval range, std::size_t most) {
    const Interval wanted{(range.min - along.shift) / along.reach,
                          (range.max - along.shift) / along.reach};
    return polynomial_roots(along.in_s.coefficients(), wanted, most);
  }

  Crossing crossing(const Along& along, const PolynomialRoots& roots, std::size_t i,
                    bool entering) const {
    const double from_near = roots.t[i] * along.reach, t = from_near + along.shift;
    const double moved =
        roots.error[i] * along.reach + 2 * kRounding * (std::fabs(t) + std::fabs(along.shift));
    return {.t = t,
            .error = moved + position_error(along.near, from_near, along.misplaced),
            .entering = entering};
  }

  /// Calls row(coefficients) for each row, from the highest powers down, and next_y and next_x
  /// where the power of y or x goes down by one: Horner's scheme in three variables.
  template <class RowOf, class NextY, class NextX>
  void walk(RowOf&& row_of, NextY&& next_y, NextX&& next_x) const {
    const Row* row = rows_.data();
    for (int i = order_; i >= 0; --i) {
      for (int j = order_ - i; j >= 0; --j, ++row) {
        row_of(std::span<const double>(coefficients_.data() + row->first, row->count));
        if (j > 0) next_y();
      }
      next_x(i > 0);
    }
  }

  Jet jet(Vec3 p) const {
    Jet in_x, in_y;
    walk(
        [&](std::span<const double> row) {
          Jet in_z;
          for (const double c : row) in_z = multiply_add(in_z, p.z, 2, c);
          in_y = add(in_y, in_z);
        },
        [&] { in_y = multiply_add(in_y, p.y, 1, 0); },
        [&](bool more) {
          in_x = add(in_x, in_y);
          in_y = {};
          if (more) in_x = multiply_add(in_x, p.x, 0, 0);
        });
    return in_x;
  }
  static Jet multiply_add(Jet j, double x, std::size_t axis, double constant) {
    j.gradient *= x;
    j.gradient[axis] += j.value;
    j.value = j.value * x + constant;
    return j;
  }
  static Jet add(Jet a, const Jet& b) { return {a.value + b.value, a.gradient + b.gradient}; }

  /// The polynomial along a ray.
  Univariate restricted(const Ray& ray) const {
    switch (order_) {
      case 2:
        return restricted_at_once<2>(ray);
      case 3:
        return restricted_at_once<3>(ray);
      case 4:
        return restricted_at_once<4>(ray);
      case 5:
        return restricted_at_once<5>(ray);
      case 6:
        return restricted_at_once<6>(ray);
      default:
        return restricted_by_rows(ray);
    }
  }

  template <std::size_t N>
  Univariate restricted_at_once(const Ray& ray) const {
    const auto along = AlongRay<N>::restrict(all_.data(), ray);
    Univariate in_t;
    in_t.degree = N;
    std::copy(along.begin(), along.end(), in_t.c.begin());
    return in_t;
  }

  /// By Horner's scheme over polynomials in t.
  Univariate restricted_by_rows(const Ray& ray) const {
    const Vec3 o = ray.origin, d = ray.direction;
    Univariate in_x, in_y;
    walk(
        [&](std::span<const double> row) {
          Univariate in_z;
          for (const double c : row) {
            in_z.step(o.z, d.z);
            in_z.add(c);
          }
          in_y.add(in_z);
        },
        [&] { in_y.step(o.y, d.y); },
        [&](bool more) {
          in_x.add(in_y);
          in_y.degree = -1;
          if (more) in_x.step(o.x, d.x);
        });
    return in_x;
  }

  /// Substitutes t = reach s with a power of two that brings all roots into s in [-1, 1], and
  /// scales the coefficients to at most 1. Returns the reach.
  static double rescale(Univariate& along) {
    while (along.degree > 0 && along.c[along.degree] == 0) --along.degree;
    const int n = along.degree;
    if (n < 1) return 1;
    for (int k = 0; k <= n; ++k) {
      if (!std::isfinite(along.c[k])) return kInfinity;
    }
    const int exponent = root_bound_exponent(along.coefficients());
    int largest = -1 << 20;
    for (int k = 0; k <= n; ++k) {
      if (along.c[k] != 0) largest = std::max(largest, exponent_of(along.c[k]) + k * exponent + 1);
    }
    if (std::abs(largest) + n * std::abs(exponent) < 1000) {
      const double reach = power_of_two(exponent);
      double scale = power_of_two(-largest);
      for (int k = 0; k <= n; ++k, scale *= reach) along.c[k] *= scale;
      return reach;
    }
    for (int k = 0; k <= n; ++k) along.c[k] = std::ldexp(along.c[k], k * exponent - largest);
    return std::ldexp(1.0, exponent);
  }

  /// What the rounding of the restriction to the ray adds to the error of t.
  double position_error(const Ray& near, double t, double misplaced) const {
    const Vec3 p = near.at(t);
    const Jet at = jet(p);
    const double steep = std::fabs(dot(at.gradient, near.direction));
    const double terms = magnitude(abs(p));
    const double residual = 4 * kRounding * order_ * terms + 2 * length(at.gradient) * misplaced;
    return steep > 0 ? residual / steep : 0;
  }

  /// The value at |p| with all coefficients positive: what rounding is relative to.
  double magnitude(Vec3 p) const {
    double in_x = 0, in_y = 0;
    walk(
        [&](std::span<const double> row) {
          double in_z = 0;
          for (const double c : row) in_z = in_z * p.z + std::fabs(c);
          in_y += in_z;
        },
        [&] { in_y *= p.y; },
        [&](bool more) {
          in_x += in_y;
          in_y = 0;
          if (more) in_x *= p.x;
        });
    return in_x;
  }

  int order_;
  std::vector<double> all_;           ///< Poly's coefficients
  std::vector<Row> rows_;             ///< in the order of Poly's coefficients
  std::vector<double> coefficients_;  ///< leading zeros of each row left out
};

}  // namespace

Result<ShapePtr> prepare(const Poly& poly) {
  const std::size_t n = poly.order;
  if (n < 2 || n > kMaxDegree) return fail("poly: the order must be 2 to 35");
  const std::size_t terms = (n + 1) * (n + 2) * (n + 3) / 6;
  if (poly.coefficients.size() != terms) {
    return fail("poly: order " + std::to_string(n) + " needs " + std::to_string(terms) +
                " coefficients, not " + std::to_string(poly.coefficients.size()));
  }
  for (const double c : poly.coefficients) {
    if (!std::isfinite(c)) return fail("poly: a coefficient is not finite");
  }
  return std::make_unique<PreparedPoly>(poly);
}

}  // namespace dioptre
