// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/text/glyphs.h"

namespace dioptre {
namespace {

constexpr char32_t kReplacement = 0xfffd;

/// How many bytes follow this first byte; -1 if it cannot be one.
int bytes_after(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xc2 && first < 0xe0) return 1;
  if (first >= 0xe0 && first < 0xf0) return 2;
  if (first >= 0xf0 && first < 0xf5) return 3;
  return -1;
}

bool allowed(char32_t code, int after) {
  constexpr char32_t kLeast[] = {0, 0x80, 0x800, 0x10000};  // no longer form than needed
  return code >= kLeast[after] && code <= 0x10ffff && !(code >= 0xd800 && code < 0xe000);
}

}  // namespace

std::vector<char32_t> decode_utf8(const std::string& text) {
  std::vector<char32_t> codes;
  codes.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const int after = bytes_after(first);
    char32_t code = after <= 0 ? first : first & (0x3fu >> after);
    bool whole = after >= 0 && i + static_cast<std::size_t>(after) < text.size();
    for (int k = 1; whole && k <= after; ++k) {
      const auto byte = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
      whole = (byte & 0xc0) == 0x80;
      code = code << 6 | (byte & 0x3fu);
    }
    whole = whole && allowed(code, after);
    codes.push_back(whole ? code : kReplacement);
    i += whole ? static_cast<std::size_t>(after) + 1 : 1;
  }
  return codes;
}

}  // namespace dioptre
