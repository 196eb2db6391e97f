// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/poly/poly.h"

#include <algorithm>
#include <cmath>

#include "dioptre/core/roots.h"
#include "dioptre/geometry/quadratic.h"

namespace dioptre {
namespace {

/// A polynomial in the ray's parameter.
struct Univariate {
  std::array<double, kMaxDegree + 1> c{};
  std::size_t degree = 0;

  /// this * (a + b t) + constant, in place.
  void step(double a, double b, double constant) {
    ++degree;
    c[degree] = 0;
    for (std::size_t k = degree; k > 0; --k) c[k] = c[k] * a + c[k - 1] * b;
    c[0] = c[0] * a + constant;
  }
  void add(const Univariate& other) {
    for (std::size_t k = degree + 1; k <= other.degree; ++k) c[k] = 0;
    degree = std::max(degree, other.degree);
    for (std::size_t k = 0; k <= other.degree; ++k) c[k] += other.c[k];
  }
};

class PreparedPoly final : public Shape {
 public:
  explicit PreparedPoly(const Poly& poly) : order_(poly.order), coefficients_(poly.coefficients) {}

  Bounds bounds() const override { return Bounds::all(); }
  bool contains(Vec3 p) const override { return jet(p).value <= 0; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const double shift = closest_approach(ray, {});
    if (!std::isfinite(shift)) return false;
    const Ray near{ray.at(shift), ray.direction};
    Univariate along = restrict_to(near);
    const double reach = rescale(along);
    const std::span<const double> c(along.c.data(), along.degree + 1);
    if (!(reach > 0) || !std::isfinite(reach)) return c[0] <= 0;

    // All roots lie in s in [-1, 1], where t = shift + reach s.
    const PolynomialRoots roots = polynomial_roots(c, {-1, 1});
    bool state = roots.count % 2 == 0 ? value_at(c, 1) <= 0 : value_at(c, 1) > 0;
    bool inside = state;
    const double misplaced = shift_error(ray, shift) * length(ray.direction);
    for (std::size_t i = 0; i < roots.count; ++i) {
      const double t = roots.t[i] * reach + shift;
      state = !state;
      if (t <= range.min) inside = state;
      if (!range.surrounds(t)) continue;
      const double moved =
          roots.error[i] * reach + 2 * kRounding * (std::fabs(t) + std::fabs(shift));
      out.push_back({.t = t,
                     .error = moved + position_error(near, roots.t[i] * reach, misplaced),
                     .entering = state});
    }
    return inside;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 position = ray.at(crossing.t);
    Vec3 normal = jet(position).gradient;
    const double size = length(normal);
    normal = size > 0 ? normal / size : Vec3{0, 1, 0};
    return {position, normal, normal, {}};
  }

 private:
  /// A value with its three partial derivatives.
  struct Jet {
    double value = 0;
    Vec3 gradient;
  };

  /// Horner's scheme in x, y and z at once, in the order in which the coefficients are stored.
  Jet jet(Vec3 p) const {
    const double* c = coefficients_.data();
    Jet in_x;
    for (int i = order_; i >= 0; --i) {
      Jet in_y;
      for (int j = order_ - i; j >= 0; --j) {
        Jet in_z;
        for (int k = order_ - i - j; k >= 0; --k) in_z = multiply_add(in_z, p.z, 2, *c++);
        in_y = add(multiply_add(in_y, p.y, 1, 0), in_z);
      }
      in_x = add(multiply_add(in_x, p.x, 0, 0), in_y);
    }
    return in_x;
  }
  static Jet multiply_add(Jet j, double x, std::size_t axis, double constant) {
    j.gradient *= x;
    j.gradient[axis] += j.value;
    j.value = j.value * x + constant;
    return j;
  }
  static Jet add(Jet a, const Jet& b) { return {a.value + b.value, a.gradient + b.gradient}; }

  /// The polynomial along a ray, by the same scheme over polynomials in t.
  Univariate restrict_to(const Ray& ray) const {
    const Vec3 o = ray.origin, d = ray.direction;
    const double* c = coefficients_.data();
    Univariate in_x;
    for (int i = order_; i >= 0; --i) {
      Univariate in_y;
      for (int j = order_ - i; j >= 0; --j) {
        Univariate in_z;
        in_z.c[0] = *c++;
        for (int k = order_ - i - j - 1; k >= 0; --k) in_z.step(o.z, d.z, *c++);
        if (j < order_ - i) in_y.step(o.y, d.y, 0);
        in_y.add(in_z);
      }
      if (i < order_) in_x.step(o.x, d.x, 0);
      in_x.add(in_y);
    }
    return in_x;
  }

  static double value_at(std::span<const double> c, double t) {
    double v = 0;
    for (std::size_t k = c.size(); k-- > 0;) v = v * t + c[k];
    return v;
  }

  /// Substitutes t = reach s with a power of two that brings all roots into s in [-1, 1], and
  /// scales the coefficients to at most 1.  Returns the reach; 0 if nothing depends on t.
  static double rescale(Univariate& along) {
    const double bound = root_bound({along.c.data(), along.degree + 1});
    if (!(bound > 0) || !std::isfinite(bound)) return 0;
    int exponent = 0;
    std::frexp(bound, &exponent);
    const int n = static_cast<int>(along.degree);
    int largest = -1 << 20;
    for (int k = 0; k <= n; ++k) {
      int own = 0;
      std::frexp(along.c[k], &own);
      if (along.c[k] != 0) largest = std::max(largest, own + k * exponent);
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
    const double* c = coefficients_.data();
    double in_x = 0;
    for (int i = order_; i >= 0; --i) {
      double in_y = 0;
      for (int j = order_ - i; j >= 0; --j) {
        double in_z = 0;
        for (int k = order_ - i - j; k >= 0; --k) in_z = in_z * p.z + std::fabs(*c++);
        in_y = in_y * p.y + in_z;
      }
      in_x = in_x * p.x + in_y;
    }
    return in_x;
  }

  int order_;
  std::vector<double> coefficients_;
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
