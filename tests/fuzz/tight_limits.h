// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/io/load_scene.h"

namespace dioptre {

/// Budgets under which any scene is read within moments.
inline LoadOptions tight_limits() {
  LoadOptions options;
  options.budgets.steps = 100'000;
  options.budgets.objects = 10'000;
  options.budgets.nesting = 100;
  options.budgets.string_bytes = 1u << 16;
  options.budgets.array_elements = 1u << 16;
  options.budgets.written_bytes = 0;
  options.budgets.memory_bytes = 256u << 20;
  options.budgets.seconds = 0.5;
  return options;
}

}  // namespace dioptre
