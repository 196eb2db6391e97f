// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <utility>

#include "dioptre/core/shared.h"
#include "dioptre/io/image/read_image.h"

namespace dioptre::pov {

/// The images read last: a file that a scene names again and again is decoded once.
class ReadImages {
 public:
  /// The pixels of that file read in the same way; null if they are not remembered.
  const Shared<ImageData>* find(const std::string& path, const ReadImageOptions& options) const {
    for (const Entry& entry : entries_) {
      if (entry.path == path && entry.options == options) return &entry.data;
    }
    return nullptr;
  }
  void keep(std::string path, ReadImageOptions options, Shared<ImageData> data) {
    constexpr std::size_t kMost = 64;
    entries_.push_front({std::move(path), std::move(options), std::move(data)});
    if (entries_.size() > kMost) entries_.pop_back();
  }

 private:
  struct Entry {
    std::string path;
    ReadImageOptions options;
    Shared<ImageData> data;
  };
  std::deque<Entry> entries_;  ///< the newest first
};

}  // namespace dioptre::pov
