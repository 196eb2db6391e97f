// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/expression.h"
#include "dioptre/geometry/container/container.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The points of a container where a function of x, y, z is less than a threshold.
///
/// Where bounds of the function and of its slope are known by interval arithmetic they alone decide
/// where its surface is looked for; `max_gradient` stands in where they are not.
struct Isosurface {
  static constexpr const char* kName = "isosurface";
  Id<Function> function;
  Container container;
  double threshold = 0;
  double accuracy = 0.001;      ///< stretches of a ray as short as this are not searched further
  double max_gradient = 1.1;    ///< the steepest that the function is said to be
  bool evaluate = false;        ///< max_gradient is found from the next three instead
  double least_gradient = 1;    ///< the first parameter of `evaluate`
  double overestimate = 1;      ///< the second: by how much its square root exceeds
  double attenuation = 0.7;     ///< the third; it steers a search that is not needed here
  bool open = false;            ///< where the container cuts the solid there is no surface
  std::uint32_t max_trace = 1;  ///< surfaces that a ray needs; all are found; 0: all

  bool operator==(const Isosurface&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("function", self.function);
    visit("container", self.container);
    visit("threshold", self.threshold);
    visit("accuracy", self.accuracy);
    visit("max_gradient", self.max_gradient);
    visit("evaluate", self.evaluate);
    visit("least_gradient", self.least_gradient);
    visit("overestimate", self.overestimate);
    visit("attenuation", self.attenuation);
    visit("open", self.open);
    visit("max_trace", self.max_trace);
  }
};

/// Checks the parameters and gets the function from `options.fields`. An error for no function, a
/// threshold that is not finite, and an impossible container.
Result<ShapePtr> prepare(const Isosurface& isosurface, const ShapeOptions& options);

}  // namespace dioptre
