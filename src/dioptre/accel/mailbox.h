// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dioptre {

/// The set of items that one ray has met so far, so that an item listed in several cells is
/// reported once (Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing";
/// here per ray, so that threads share nothing). Allocates only for a ray that meets
/// more than 64 items. An item must be below 2^32 - 1.
class Mailbox {
 public:
  Mailbox() { fixed_.fill(kFree); }
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  /// Adds an item; false if it was there.
  bool insert(std::uint32_t item) {
    std::uint32_t& slot = find(item);
    if (slot == item) return false;
    slot = item;
    if (++used_ > (mask_ + 1) / 2) grow();
    return true;
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffff;

  /// The item's slot, or the free one where it belongs: open addressing, never full.
  std::uint32_t& find(std::uint32_t item) {
    std::size_t at = (item * std::uint64_t{0x9e3779b97f4a7c15} >> 32) & mask_;
    while (table_[at] != item && table_[at] != kFree) at = (at + 1) & mask_;
    return table_[at];
  }

  void grow() {
    std::vector<std::uint32_t> larger(2 * (mask_ + 1), kFree);
    const std::uint32_t* const old = table_;
    const std::size_t old_size = mask_ + 1;
    table_ = larger.data();
    mask_ = larger.size() - 1;
    for (std::size_t i = 0; i < old_size; ++i) {
      if (old[i] != kFree) find(old[i]) = old[i];
    }
    grown_ = std::move(larger);
  }

  std::array<std::uint32_t, 128> fixed_;
  std::vector<std::uint32_t> grown_;
  std::uint32_t* table_ = fixed_.data();
  std::size_t mask_ = 127, used_ = 0;
};

}  // namespace dioptre
