// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dioptre {

/// What goes to a marked place of a page.
struct PageFill {
  std::string_view mark;  ///< as it stands in the page
  std::string text;
};

/// The page with its marks replaced, in the order in which they stand there.
std::string fill_page(std::string_view page, std::span<const PageFill> fills);

/// JSON that may stand within a script element of HTML: no text in it can end that.
std::string within_script(std::string_view json);

}  // namespace dioptre
