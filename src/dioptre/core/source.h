// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace dioptre {

/// A place in a source file. Lines and columns count from 1; line 0 means unknown.
struct SourcePosition {
  std::uint32_t file = 0;  ///< index into SourceMap::files
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  bool operator==(const SourcePosition&) const = default;
};

}  // namespace dioptre
