// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/dispersion.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dioptre {
namespace {

/// The colours of 70 equal stretches of the spectrum, from red to violet, as measured from what the
/// scene language's renderer shows behind a prism (to 3e-5; its values have three digits). Their
/// mean is nearly white: (0.9938, 1, 0.9962).
constexpr Color kSpectrum[] = {
    {0.686f, 0.0f, 0.0f},   {0.994f, 0.0f, 0.0f},   {1.274f, 0.0f, 0.0f},   {1.533f, 0.0f, 0.0f},
    {1.778f, 0.0f, 0.0f},   {1.995f, 0.0f, 0.0f},   {2.191f, 0.0f, 0.0f},   {2.366f, 0.0f, 0.0f},
    {2.52f, 0.0f, 0.0f},    {2.653f, 0.0f, 0.0f},   {2.765f, 0.0f, 0.0f},   {2.863f, 0.133f, 0.0f},
    {2.926f, 0.434f, 0.0f}, {2.968f, 0.714f, 0.0f}, {3.003f, 0.98f, 0.0f},  {3.003f, 1.232f, 0.0f},
    {2.989f, 1.456f, 0.0f}, {2.954f, 1.673f, 0.0f}, {2.891f, 1.876f, 0.0f}, {2.807f, 2.044f, 0.0f},
    {2.709f, 2.212f, 0.0f}, {2.583f, 2.359f, 0.0f}, {2.443f, 2.478f, 0.0f}, {2.268f, 2.59f, 0.0f},
    {2.086f, 2.688f, 0.0f}, {1.876f, 2.751f, 0.0f}, {1.652f, 2.821f, 0.0f}, {1.393f, 2.849f, 0.0f},
    {1.12f, 2.877f, 0.0f},  {0.826f, 2.884f, 0.0f}, {0.511f, 2.87f, 0.0f},  {0.175f, 2.842f, 0.0f},
    {0.0f, 2.793f, 0.021f}, {0.0f, 2.73f, 0.287f},  {0.0f, 2.646f, 0.546f}, {0.0f, 2.548f, 0.777f},
    {0.0f, 2.429f, 1.008f}, {0.0f, 2.303f, 1.218f}, {0.0f, 2.142f, 1.407f}, {0.0f, 1.981f, 1.596f},
    {0.0f, 1.792f, 1.764f}, {0.0f, 1.589f, 1.918f}, {0.0f, 1.365f, 2.058f}, {0.0f, 1.127f, 2.184f},
    {0.0f, 0.875f, 2.296f}, {0.0f, 0.602f, 2.394f}, {0.0f, 0.315f, 2.478f}, {0.0f, 0.0f, 2.548f},
    {0.0f, 0.0f, 2.604f},   {0.0f, 0.0f, 2.646f},   {0.0f, 0.0f, 2.674f},   {0.0f, 0.0f, 2.688f},
    {0.0f, 0.0f, 2.688f},   {0.0f, 0.0f, 2.667f},   {0.0f, 0.0f, 2.646f},   {0.0f, 0.0f, 2.597f},
    {0.0f, 0.0f, 2.548f},   {0.0f, 0.0f, 2.471f},   {0.07f, 0.0f, 2.387f},  {0.14f, 0.0f, 2.289f},
    {0.21f, 0.0f, 2.17f},   {0.252f, 0.0f, 2.051f}, {0.287f, 0.0f, 1.904f}, {0.308f, 0.0f, 1.75f},
    {0.315f, 0.0f, 1.582f}, {0.301f, 0.0f, 1.4f},   {0.287f, 0.0f, 1.197f}, {0.252f, 0.0f, 0.987f},
    {0.203f, 0.0f, 0.763f}, {0.14f, 0.0f, 0.525f}};
constexpr double kStretches = std::size(kSpectrum);

}  // namespace

double ior_of_color(const Interior& interior, double position) {
  if (interior.dispersion == 1) return interior.ior;
  return interior.ior * std::pow(interior.dispersion, position - 0.5);
}

Color color_share(std::uint32_t index, std::uint32_t colors) {
  const double width = kStretches / colors, begin = index * width, end = begin + width;
  const auto last = std::min<std::size_t>(std::size(kSpectrum), std::ceil(end));
  Color sum;
  for (auto i = static_cast<std::size_t>(begin); i < last; ++i) {
    const double left = std::max(begin, static_cast<double>(i));
    const double right = std::min(end, static_cast<double>(i + 1));
    sum += kSpectrum[i] * static_cast<float>((right - left) / kStretches);
  }
  return sum;
}

}  // namespace dioptre
