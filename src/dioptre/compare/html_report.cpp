// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>

#include "dioptre/compare/reports.h"
#include "dioptre/core/page.h"

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

}  // namespace

std::string html_report(const Comparison& comparison, std::string_view png) {
  const std::array fills{PageFill{"{{PICTURE}}", base64(png)},
                         PageFill{"{{DATA}}", within_script(json_report(comparison))}};
  return fill_page(embedded::compare_page_html(), fills);
}

}  // namespace dioptre
