// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/sphere_sweep/sweep_spans.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/outline/bernstein.h"

namespace dioptre {
namespace {

constexpr double binomial(std::size_t n, std::size_t k) {
  double result = 1;
  for (std::size_t i = 0; i < k; ++i) {
    result = result * static_cast<double>(n - i) / static_cast<double>(i + 1);
  }
  return result;
}

/// C(A,i) C(B,j) / C(A+B,i+j).
template <std::size_t A, std::size_t B>
constexpr auto product_weights() {
  std::array<std::array<double, B + 1>, A + 1> w{};
  for (std::size_t i = 0; i <= A; ++i) {
    for (std::size_t j = 0; j <= B; ++j) {
      w[i][j] = binomial(A, i) * binomial(B, j) / binomial(A + B, i + j);
    }
  }
  return w;
}

/// out += factor * a * b.
template <std::size_t A, std::size_t B, std::size_t C>
void add_product(double factor, const std::array<double, A>& a, const std::array<double, B>& b,
                 std::array<double, C>& out) {
  static_assert(C + 1 == A + B);
  static constexpr auto kWeights = product_weights<A - 1, B - 1>();
  for (std::size_t i = 0; i < A; ++i) {
    const double scaled = factor * a[i];
    for (std::size_t j = 0; j < B; ++j) out[i + j] += kWeights[i][j] * scaled * b[j];
  }
}

template <std::size_t N>
Bernstein<N - 1> derivative(const Bernstein<N>& b) {
  Bernstein<N - 1> d;
  for (std::size_t i = 0; i < N; ++i) d[i] = static_cast<double>(N) * (b[i + 1] - b[i]);
  return d;
}

template <std::size_t N>
double largest_size(const Bernstein<N>& b) {
  double most = 0;
  for (const double c : b) most = std::max(most, std::fabs(c));
  return most;
}

/// What the search for one piece knows.
class Search {
 public:
  Search(const SweepPiece& piece, Vec3 origin, const std::array<Vec3, 3>& axes)
      : piece_(piece), origin_(origin), axes_(axes) {}

  template <std::size_t N>
  SweepSpans run() {
    Bernstein<N> along, x, y, radius;
    for (std::size_t i = 0; i <= N; ++i) {
      const Vec3 c = piece_.center[i] - origin_;
      along[i] = dot(c, axes_[0]);
      x[i] = dot(c, axes_[1]);
      y[i] = dot(c, axes_[2]);
      radius[i] = piece_.radius[i];
    }
    Bernstein<2 * N> half2{};  // the squared half chord
    add_product(1, radius, radius, half2);
    add_product(-1, x, x, half2);
    add_product(-1, y, y, half2);
    if (std::all_of(half2.begin(), half2.end(), [](double c) { return c < 0; })) return {};
    cut_stretches<2 * N>(half2);
    look_at_ends();
    look_at_turns<N>(along, half2);
    return spans_;
  }

 private:
  /// Where the squared half chord is not negative.
  template <std::size_t M>
  void cut_stretches(const Bernstein<M>& half2) {
    const SignChanges<M> changes = sign_changes<M>(half2);
    double begin = 0;
    bool within = half2[0] >= 0;
    for (std::size_t i = 0; i < changes.count; ++i) {
      if (within) add_stretch(begin, changes.at[i].s);
      within = !within;
      begin = changes.at[i].s;
    }
    if (within) add_stretch(begin, 1);
  }
  void add_stretch(double begin, double end) {
    if (spans_.count < kMostSweepSpans) stretches_[spans_.count++] = {begin, end};
  }

  void look_at_ends() {
    for (std::size_t i = 0; i < spans_.count; ++i) {
      widen(i, stretches_[i].min);
      widen(i, stretches_[i].max);
    }
  }

  template <std::size_t N>
  void look_at_turns(const Bernstein<N>& along, const Bernstein<2 * N>& half2) {
    const Bernstein<N - 1> speed = derivative<N>(along);
    Bernstein<2 * N - 1> slope = derivative<2 * N>(half2);  // 2 w w'
    for (double& c : slope) c *= 0.5;
    // Where the path is at right angles to the line, the two solutions fall together.
    constexpr double kSmall = 3e-7;
    const double widest = std::sqrt(largest_size<2 * N>(half2));
    if (largest_size<N - 1>(speed) * widest <= kSmall * largest_size<2 * N - 1>(slope)) {
      return look_at<2 * N - 1>(slope);
    }
    if constexpr (N > 1) look_at<N - 1>(speed);
    Bernstein<2 * N - 2> speed2{};
    add_product(1, speed, speed, speed2);
    Bernstein<4 * N - 2> turns{};
    add_product(1, speed2, half2, turns);
    add_product(-1, slope, slope, turns);
    look_at<4 * N - 2>(turns);
  }

  template <std::size_t M>
  void look_at(const Bernstein<M>& zero) {
    const SignChanges<M> changes = sign_changes<M>(zero);
    for (std::size_t i = 0; i < changes.count; ++i) {
      const double s = changes.at[i].s;
      for (std::size_t k = 0; k < spans_.count; ++k) {
        if (stretches_[k].contains(s)) widen(k, s);
      }
    }
  }

  /// Takes the sphere at s into a span.
  void widen(std::size_t index, double s) {
    const Vec3 c = piece_.center_at(s) - origin_;
    const double r = piece_.radius_at(s);
    const double along = dot(c, axes_[0]), x = dot(c, axes_[1]), y = dot(c, axes_[2]);
    const double half = std::sqrt(std::max(0.0, r * r - x * x - y * y));
    SweepSpan& span = spans_.at[index];
    if (along - half < span.enter.distance) span.enter = {along - half, s};
    if (along + half > span.exit.distance) span.exit = {along + half, s};
  }

  const SweepPiece& piece_;
  Vec3 origin_;
  const std::array<Vec3, 3>& axes_;
  SweepSpans spans_;
  std::array<Interval, kMostSweepSpans> stretches_{};
};

template <std::size_t N>
bool inside(const SweepPiece& piece, Vec3 p) {
  Bernstein<N> x, y, z, radius;
  for (std::size_t i = 0; i <= N; ++i) {
    const Vec3 c = piece.center[i] - p;
    x[i] = c.x, y[i] = c.y, z[i] = c.z;
    radius[i] = piece.radius[i];
  }
  Bernstein<2 * N> depth{};
  add_product(1, radius, radius, depth);
  for (const Bernstein<N>& coordinate : {x, y, z}) add_product(-1, coordinate, coordinate, depth);
  return depth[0] >= 0 || depth[2 * N] >= 0 || sign_changes<2 * N>(depth).count > 0;
}

}  // namespace

SweepSpans sweep_spans(const SweepPiece& piece, Vec3 origin, const std::array<Vec3, 3>& axes) {
  Search search(piece, origin, axes);
  return piece.degree == 1 ? search.run<1>() : search.run<3>();
}

bool inside_piece(const SweepPiece& piece, Vec3 p) {
  return piece.degree == 1 ? inside<1>(piece, p) : inside<3>(piece, p);
}

}  // namespace dioptre
