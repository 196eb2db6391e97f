// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "dioptre/core/source.h"

namespace dioptre {

/// Where each object of a scene was written; kept beside the scene.
struct SourceMap {
  std::vector<std::string> files;
  std::vector<SourcePosition> objects;  ///< by object id; may be shorter than the scene's objects
};

}  // namespace dioptre
