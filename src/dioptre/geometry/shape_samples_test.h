// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "dioptre/geometry/shapes.h"

namespace dioptre {

/// A primitive with parameters for the laws to try.
struct ShapeSample {
  std::string name;
  ShapeData data;
  bool convex = false;
};

/// At least one for each alternative of ShapeData.
std::vector<ShapeSample> shape_samples();

/// How the samples are prepared: with fields that some of them are made of.
const ShapeOptions& sample_options();

}  // namespace dioptre
