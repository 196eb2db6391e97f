// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "dioptre/render/render_scene.h"

namespace dioptre {

/// The solids that a ray is in, the last entered on top. Crossing the surface of a solid that is on
/// the stack leaves it, whatever its sense: so overlapping parts of one glass act as air, as in the
/// scene language. Beyond 31 solids the rest are not remembered.
class MediaStack {
 public:
  /// One solid: the number of its medium and that of its interior, or its own address if it has
  /// none.
  class Entry {
   public:
    Entry() = default;  // left empty: stacks are made and copied for every ray
    Entry(const Part& part, const Item* item)
        : key_(part.interior ? kInterior | std::uint64_t{part.medium} << 32 | part.interior.index
                             : reinterpret_cast<std::uintptr_t>(item)) {}
    InteriorId interior() const {
      return key_ & kInterior ? InteriorId{static_cast<std::uint32_t>(key_)} : InteriorId{};
    }
    bool operator==(const Entry&) const = default;

   private:
    static constexpr std::uint64_t kInterior = std::uint64_t{1} << 63;
    std::uint64_t key_;
  };

  MediaStack() {}  // NOLINT: the entries stay uninitialised
  MediaStack(const MediaStack& other) { *this = other; }
  /// Copies what is on the stack only: rays copy their stack all the time, and it is mostly empty.
  MediaStack& operator=(const MediaStack& other) {
    size_ = other.size_;
    hollow_ = other.hollow_;
    std::copy_n(other.entries_.begin(), size_, entries_.begin());
    return *this;
  }

  /// The entry for a surface: parts of a whole that share the interior of the whole are one.
  static Entry entry(const Part& part, const Item* item) { return {part, item}; }

  bool contains(Entry e) const {
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (entries_[i] == e) return true;
    }
    return false;
  }
  void enter(Entry e, bool hollow) {
    if (size_ == kMost) return;
    hollow_ |= std::uint32_t{hollow} << size_;
    entries_[size_++] = e;
  }
  void leave(Entry e) {
    for (std::uint32_t i = size_; i-- > 0;) {
      if (entries_[i] != e) continue;
      std::copy(entries_.begin() + i + 1, entries_.begin() + size_, entries_.begin() + i);
      const std::uint32_t below = (1u << i) - 1;
      hollow_ = (hollow_ & below) | ((hollow_ >> 1) & ~below);
      --size_;
      return;
    }
  }
  bool empty() const { return size_ == 0; }
  /// The interior entered last; none in the open, and in a solid without one.
  InteriorId top() const { return size_ > 0 ? entries_[size_ - 1].interior() : InteriorId{}; }
  /// True if every solid around lets the atmosphere in.
  bool in_atmosphere() const { return hollow_ == (std::uint32_t{1} << size_) - 1; }
  const Entry* begin() const { return entries_.data(); }
  const Entry* end() const { return entries_.data() + size_; }

 private:
  static constexpr std::uint32_t kMost = 31;

  std::uint32_t size_ = 0;
  std::uint32_t hollow_ = 0;  ///< one bit per entry
  std::array<Entry, kMost> entries_;
};

}  // namespace dioptre
