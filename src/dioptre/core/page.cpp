// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/page.h"

namespace dioptre {

std::string fill_page(std::string_view page, std::span<const PageFill> fills) {
  std::string out;
  for (const PageFill& fill : fills) {
    const std::size_t mark = page.find(fill.mark);
    if (mark == page.npos) break;
    out.append(page.substr(0, mark)).append(fill.text);
    page.remove_prefix(mark + fill.mark.size());
  }
  return out.append(page);
}

std::string within_script(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace dioptre
