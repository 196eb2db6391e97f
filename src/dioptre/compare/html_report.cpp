// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>

#include "dioptre/compare/reports.h"

namespace dioptre {

namespace embedded {
/// The page, with places marked for the data and the picture.
std::string_view compare_page_html();
}  // namespace embedded

namespace {

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return out;
}

/// JSON that may stand within a script element: no text in it can end that.
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

}  // namespace

std::string html_report(const Comparison& comparison, std::string_view png) {
  struct Fill {
    std::string_view mark;
    std::string text;
  };
  const std::array fills{Fill{"{{PICTURE}}", base64(png)},
                         Fill{"{{DATA}}", within_script(json_report(comparison))}};
  std::string page;
  std::string_view rest = embedded::compare_page_html();
  for (const Fill& fill : fills) {
    const std::size_t mark = rest.find(fill.mark);
    page.append(rest.substr(0, mark)).append(fill.text);
    rest.remove_prefix(mark + fill.mark.size());
  }
  return page.append(rest);
}

}  // namespace dioptre
