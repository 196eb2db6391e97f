// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dioptre::app {

/// An option of POV-Ray that means nothing here.
struct UnusedOption {
  const char* name;
  /// Values that ask for nothing beyond what happens anyway, between bars; "*": all do.
  const char* harmless;
  bool number = false;  ///< the value must be one
};

/// All of them, in alphabetical order.
const std::vector<UnusedOption>& unused_options();

/// Whether the value asks for something that will not happen.
bool asks_in_vain(const UnusedOption& option, std::string_view value);

}  // namespace dioptre::app
