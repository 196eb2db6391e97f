// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/color_map.h"

#include <algorithm>
#include <cmath>

namespace dioptre {
namespace {

/// For red, green and blue, the coefficient of 1 first.
constexpr double kPolynomials[3][7] = {
    {0.2777273272234177, 0.1050930431085774, -0.3308618287255563, -4.634230498983486,
     6.228269936347081, 4.776384997670288, -5.435455855934631},
    {0.005407344544966578, 1.404613529898575, 0.214847559468213, -5.799100973351585,
     14.17993336680509, -13.74514537774601, 4.645852612178535},
    {0.3340998053353061, 1.384590162594685, 0.09509516302823659, -19.33244095627987,
     56.69055260068105, -65.35303263337234, 26.3124352495832},
};

}  // namespace

std::array<std::uint8_t, 3> viridis(double value) {
  const double t = value > 0 ? std::min(value, 1.0) : 0;
  std::array<std::uint8_t, 3> color;
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (int i = 6; i >= 0; --i) sum = sum * t + kPolynomials[k][i];
    color[k] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(sum, 0.0, 1.0)));
  }
  return color;
}

}  // namespace dioptre
