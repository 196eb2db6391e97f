// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dioptre/core/result.h"

namespace dioptre {

/// Where a scene may look for files, and which it may read and write. Links and ".." are resolved
/// before the question is decided.
class FileAccess {
 public:
  struct Options {
    std::string scene_folder;  ///< searched first; all below it may be read and written
    std::vector<std::string> search_folders;  ///< searched next; all below may be read
    std::vector<std::string> readable_paths, writable_paths;
    std::string scene_file;  ///< never written
  };
  struct Found {
    std::string path;
    bool other_case = false;  ///< the name was found only in other upper or lower case
  };
  explicit FileAccess(Options options);

  /// The file of that name along the search path. A name that is not there is tried in other upper
  /// and lower case. The Error says where it was looked for, or that it may not be read.
  Result<Found> find(const std::string& name) const;
  /// Whether there is nothing at all of that name along the search path: no file, no folder, and no
  /// file that may not be read.
  bool is_missing(const std::string& name) const;
  /// The whole file. Fails on folders, devices, and over `most_bytes`.
  Result<std::string> read(const std::string& path, std::uint64_t most_bytes) const;
  /// The path to write a file to, if that is allowed: not over a scene, a file of settings or
  /// anything hidden.
  Result<std::string> writable(const std::string& name) const;

 private:
  bool may_read(const std::filesystem::path& path) const;
  std::string why_not(const std::string& path, const std::string& folder) const;

  Options options_;
  std::string current_;
  std::vector<std::string> search_, library_, readable_, writable_;
  std::string scene_file_;
};

}  // namespace dioptre
