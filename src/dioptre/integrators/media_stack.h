// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "dioptre/render/render_scene.h"

namespace dioptre {

/// The solids that a ray is in, the last entered on top. Crossing the surface of a solid that is on
/// the stack leaves it, whatever its sense: so overlapping parts of one glass act as air, as in the
/// scene language. Beyond 32 solids the rest are not remembered.
class MediaStack {
 public:
  struct Entry {
    InteriorId interior;
    const Item* item = nullptr;
    bool operator==(const Entry&) const = default;
  };

  /// The entry for a surface: solids that share an interior are one.
  static Entry entry(InteriorId interior, const Item* item) {
    return interior ? Entry{interior, nullptr} : Entry{{}, item};
  }

  bool contains(Entry e) const {
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (entries_[i] == e) return true;
    }
    return false;
  }
  void enter(Entry e, bool hollow) {
    if (size_ == entries_.size()) return;
    hollow_[size_] = hollow;
    entries_[size_++] = e;
  }
  void leave(Entry e) {
    for (std::uint32_t i = size_; i-- > 0;) {
      if (entries_[i] != e) continue;
      for (std::uint32_t j = i + 1; j < size_; ++j) {
        entries_[j - 1] = entries_[j];
        hollow_[j - 1] = hollow_[j];
      }
      --size_;
      return;
    }
  }
  /// The innermost interior; none in the open.
  InteriorId top() const {
    for (std::uint32_t i = size_; i-- > 0;) {
      if (entries_[i].interior) return entries_[i].interior;
    }
    return {};
  }
  /// True if every solid around lets the atmosphere in.
  bool in_atmosphere() const {
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (!hollow_[i]) return false;
    }
    return true;
  }
  const Entry* begin() const { return entries_.data(); }
  const Entry* end() const { return entries_.data() + size_; }

 private:
  std::array<Entry, 32> entries_;
  std::array<bool, 32> hollow_{};
  std::uint32_t size_ = 0;
};

}  // namespace dioptre
