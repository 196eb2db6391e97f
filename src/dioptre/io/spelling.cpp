// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/spelling.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dioptre {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

bool is_misspelling(std::string_view written, std::string_view known) {
  constexpr std::size_t kShortest = 4, kLongest = 64;
  if (written.size() < kShortest || written.size() > kLongest) return false;
  const std::size_t allowed = written.size() / 3;
  if (known.size() > written.size() + allowed || written.size() > known.size() + allowed) {
    return false;
  }
  return edit_distance(written, known) <= allowed;
}

}  // namespace dioptre
