// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/julia_fractal/julia_fractal.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dioptre/core/newton.h"
#include "dioptre/geometry/julia_fractal/function_orbit.h"
#include "dioptre/geometry/julia_fractal/julia_orbit.h"
#include "dioptre/geometry/triangle/smooth_normal.h"

namespace dioptre {
namespace {

/// More iterations change nothing that can be seen.
constexpr std::uint32_t kMostIterations = 500;
constexpr double kMostPrecision = 1e5;

/// The three dimensions of space within the four of the fractal.
struct Slice {
  explicit Slice(const JuliaFractal& julia) {
    const auto& n = julia.slice_normal;
    along = {-n[0] / n[3], -n[1] / n[3], -n[2] / n[3]};
    offset = julia.slice_distance * std::sqrt(dioptre::dot(n, n)) / n[3];
  }
  Quad point(Vec3 p) const { return {p.x, p.y, p.z, offset + dot(along, p)}; }
  Quad vector(Vec3 v) const { return {v.x, v.y, v.z, dot(along, v)}; }

  Vec3 along;  ///< the slope of the fourth coordinate
  double offset;
};

/// A ray in four dimensions.
struct Line {
  Quad origin, direction;

  Quad point(double t) const {
    Quad p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = origin[i] + t * direction[i];
    return p;
  }
};

/// How samples are laid along a ray (measured).
enum class Samples {
  kByDistance,  ///< as far on as the solid is about away, but at least 1 / precision
  kEven,        ///< 1 / precision apart, from half of that on
};

/// What lies between samples of the ray that are both inside or both outside is not found.
template <class Orbit, bool kSmooth, Samples kSamples>
class PreparedJulia final : public Shape {
 public:
  /// The solid lies in a ball of `bound`, and samples begin in one of `radius`.
  PreparedJulia(const JuliaFractal& julia, double bound, double radius, Orbit orbit)
      : slice_(julia),
        bound_(bound),
        radius_(radius * (1 + 1e-9)),
        step_(1 / std::fmin(std::fmax(julia.precision, 1), kMostPrecision)),
        orbit_(orbit) {}

  Bounds bounds() const override {
    const Vec3 corner = bound_ * Vec3{1, 1, 1};
    return {-corner, corner};
  }
  double cost() const override { return 300; }
  bool contains(Vec3 p) const override { return orbit_.inside(slice_.point(p)); }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    return search(ray, range, [&](const Crossing& found) {
      if (!(found.t < range.max)) return false;
      out.push_back(found);
      return true;
    });
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    bool any = false;
    search(ray, range, [&](const Crossing& found) {
      any = found.t < range.max;
      if (any) out = found;
      return false;
    });
    return any;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    Surface s;
    s.position = ray.at(crossing.t);
    s.normal = unit_or_zero(gradient(s.position, true));
    if (s.normal == Vec3{}) s.normal = unit_or_zero(ray.direction);
    if ((dot(s.normal, ray.direction) > 0) == crossing.entering) s.normal = -s.normal;
    // Powers are shaded as by the next iterate, and as if the slice were level (measured).
    if (kSmooth) s.shading_normal = unit_or_zero(gradient(s.position, false));
    if (s.shading_normal == Vec3{}) s.shading_normal = s.normal;
    return s;
  }

 private:
  Vec3 gradient(Vec3 p, bool exact) const {
    const Quad start = slice_.point(p);
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      Vec3 axis;
      axis[i] = 1;
      const Quad direction = exact ? slice_.vector(axis) : Quad{axis.x, axis.y, axis.z, 0};
      double value;
      orbit_.evaluate(start, direction, value, out[i], exact ? 0 : 1);
    }
    return out;
  }

  /// The part of a line in the ball; empty if it passes it.
  Interval clip(const Ray& ray) const {
    const double squared = dioptre::dot(ray.direction, ray.direction);
    const double middle = -dioptre::dot(ray.origin, ray.direction) / squared;
    const Vec3 nearest = ray.at(middle);
    const double rest = radius_ * radius_ - dioptre::dot(nearest, nearest);
    if (!(rest > 0)) return {};
    const double half = std::sqrt(rest / squared);
    if (!std::isfinite(middle - half) || !std::isfinite(middle + half)) return {};
    return {middle - half, middle + half};
  }

  /// Calls found(crossing) in order for those beyond range.min, until it returns false, and returns
  /// whether the ray is inside just after range.min.
  template <class Found>
  bool search(const Ray& ray, Interval range, Found&& found) const {
    const Interval ball = clip(ray);
    if (ball.empty() || ball.min >= range.max || ball.max <= range.min) return false;
    const Line line{slice_.point(ray.origin), slice_.vector(ray.direction)};
    Sample last{ball.min, false};
    bool any = false, starts_inside = false;
    const auto next = [&](double t, bool inside) {
      const Sample before = last;
      last = {t, inside};
      if (inside != before.inside) {
        const Crossing crossing = crossing_between(line, before.t, t, inside);
        if (crossing.t > range.min) {
          if (!any) starts_inside = !inside;
          any = true;
          if (!found(crossing)) return false;
        }
      }
      return t < range.max;
    };
    const double step = step_ / length(ray.direction);
    // Samples are laid from the ray's origin on, and apart from that behind it.
    const Interval behind{ball.min, std::min(ball.max, 0.0)};
    const Interval ahead{std::max(ball.min, 0.0), ball.max};
    bool more = true;
    if (!behind.empty() && range.min < 0) {
      more = lay_samples(line, behind, step, next) &&
             next(behind.max, orbit_.inside(line.point(behind.max)));
    } else if (ball.min < 0) {
      last = {0, orbit_.inside(line.point(0))};
    }
    if (more && !ahead.empty() && lay_samples(line, ahead, step, next)) next(ball.max, false);
    return any ? starts_inside : last.inside;
  }

  struct Sample {
    double t;
    bool inside;
  };

  /// Calls next(t, inside) for samples within the range until it returns false, and returns that.
  template <class Next>
  bool lay_samples(const Line& line, Interval range, double step, Next&& next) const {
    if constexpr (kSamples == Samples::kByDistance) {
      for (double t = range.min; t < range.max;) {
        const auto distance = orbit_.distance(line.point(t));
        if (!next(t, !distance)) return false;
        t += distance ? std::fmax(*distance * step / step_, step) : step;
      }
      return true;
    } else {
      return lay_even_samples(line, range, step, next);
    }
  }

  /// Runs of samples that are surely all inside or all outside count as two.
  template <class Next>
  bool lay_even_samples(const Line& line, Interval range, double step, Next&& next) const {
    struct Run {
      double first, count;
    };
    std::array<Run, 64> runs;
    runs[0] = {0, std::ceil((range.max - range.min) / step - 0.5)};
    for (std::size_t count = runs[0].count > 0 ? 1 : 0; count > 0;) {
      const Run run = runs[--count];
      const double low = range.min + (run.first + 0.5) * step;
      const double high = range.min + (run.first + run.count - 0.5) * step;
      if (run.count == 1) {
        if (!next(low, orbit_.inside(line.point(low)))) return false;
        continue;
      }
      const double half = 0.5 * (high - low);
      const auto verdict = orbit_.classify(line.point(low + half), line.direction,
                                           half + 0x1p-48 * std::fabs(low + half));
      if (verdict == JuliaVerdict::kUnknown) {
        const double part = std::floor(run.count / 2);
        runs[count++] = {run.first + part, run.count - part};
        runs[count++] = {run.first, part};
        continue;
      }
      const bool inside = verdict == JuliaVerdict::kInside;
      if (!next(low, inside) || !next(high, inside)) return false;
    }
    return true;
  }

  Crossing crossing_between(const Line& line, double low, double high, bool entering) const {
    Crossing crossing;
    crossing.entering = entering;
    crossing.t = kSmooth ? root_between(line, low, high, entering)
                         : change_between(line, low, high, entering);
    const Quad point = line.point(crossing.t);
    const double size =
        std::sqrt(dioptre::dot(line.origin, line.origin)) +
        std::sqrt(dioptre::dot(line.direction, line.direction)) * std::fabs(crossing.t);
    double value, slope;
    orbit_.evaluate(point, line.direction, value, slope);
    const double error =
        (orbit_.noise(point, 0x1p-52 * size) + std::fabs(value)) / std::fabs(slope) +
        0x1p-50 * std::fabs(crossing.t);
    crossing.error = error < high - low ? error : high - low;
    return crossing;
  }

  /// By Newton's method on the logarithm of |h|^2, which is less steep than that by far.
  double root_between(const Line& line, double low, double high, bool entering) const {
    const double limit = bound_ * bound_;
    const auto evaluate = [&](double t, double& value, double& slope) {
      double over;
      orbit_.evaluate(line.point(t), line.direction, over, slope);
      value = std::log1p(over / limit);
      slope /= over + limit;
    };
    return bracketed_newton(evaluate, low, high, 0.5 * (low + high), !entering);
  }

  double change_between(const Line& line, double low, double high, bool entering) const {
    for (int i = 0; i < 64; ++i) {
      const double middle = 0.5 * (low + high);
      if (!(low < middle && middle < high)) break;
      (orbit_.inside(line.point(middle)) == entering ? high : low) = middle;
    }
    return high;
  }

  Slice slice_;
  double bound_, radius_, step_;
  Orbit orbit_;
};

template <bool kCube>
ShapePtr prepare_quaternion(const JuliaFractal& julia, std::uint32_t steps) {
  using Orbit = PowerOrbit<QuaternionPower<kCube>>;
  const double bound = 1 + std::sqrt(dioptre::dot(julia.parameter, julia.parameter));
  return std::make_unique<PreparedJulia<Orbit, true, Samples::kByDistance>>(
      julia, bound, std::fmax(bound, 2), Orbit(julia.parameter, bound, steps));
}

}  // namespace

Result<ShapePtr> prepare(const JuliaFractal& julia) {
  const auto finite = [](const std::array<double, 4>& v) {
    return std::all_of(v.begin(), v.end(), [](double x) { return std::fabs(x) < 1e100; });
  };
  if (!finite(julia.parameter) || !finite(julia.slice_normal) ||
      !(std::fabs(julia.slice_distance) < 1e100) || !std::isfinite(julia.exponent.x) ||
      !std::isfinite(julia.exponent.y)) {
    return fail("julia_fractal has a number that is not finite");
  }
  const double slope = std::sqrt(dioptre::dot(julia.slice_normal, julia.slice_normal)) /
                       std::fabs(julia.slice_normal[3]);
  if (!(slope < 1e9)) return fail("the slice of a julia_fractal needs a fourth component");
  const std::uint32_t steps = std::clamp(julia.max_iteration, 1u, kMostIterations) - 1;
  const bool cube = julia.function == JuliaFunction::kCube;
  if (julia.algebra == JuliaAlgebra::kQuaternion) {
    if (!cube && julia.function != JuliaFunction::kSqr) {
      return fail("a julia_fractal of quaternions is sqr or cube");
    }
    return cube ? prepare_quaternion<true>(julia, steps) : prepare_quaternion<false>(julia, steps);
  }
  constexpr double kBound = 4;
  if (cube || julia.function == JuliaFunction::kSqr) {
    using Orbit = PowerOrbit<HypercomplexSquare>;
    return std::make_unique<PreparedJulia<Orbit, true, Samples::kEven>>(
        julia, kBound, kBound, Orbit(julia.parameter, kBound, steps));
  }
  return std::make_unique<PreparedJulia<FunctionOrbit, false, Samples::kEven>>(
      julia, kBound, kBound, FunctionOrbit(julia, kBound, steps));
}

}  // namespace dioptre
