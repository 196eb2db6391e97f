// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/file_access.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace dioptre {
namespace fs = std::filesystem;
namespace {

/// Links and dots resolved, as far as the path exists. Empty if that fails.
std::string resolved(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? std::string() : result.string();
}

bool is_below(const std::string& path, const std::string& folder) {
  if (folder.empty() || folder == "/" || !path.starts_with(folder)) return false;
  return path.size() == folder.size() || folder.back() == '/' || path[folder.size()] == '/';
}
bool is_below_any(const std::string& path, const std::vector<std::string>& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](const std::string& folder) { return is_below(path, folder); });
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool same_but_case(const std::string& a, const std::string& b) { return lower(a) == lower(b); }

/// The path below `folder` whose parts are those of `name` but for upper and lower case; the first
/// in alphabetical order; empty if there is none.
fs::path find_other_case(const fs::path& folder, const fs::path& name) {
  fs::path path = folder;
  for (const fs::path& part : name) {
    std::error_code error;
    if (part == "." || part == ".." || fs::exists(path / part, error)) {
      path /= part;
      continue;
    }
    std::string best;
    for (fs::directory_iterator entry(path, error), end; !error && entry != end;
         entry.increment(error)) {
      const std::string file = entry->path().filename().string();
      if (same_but_case(file, part.string()) && (best.empty() || file < best)) best = file;
    }
    if (best.empty()) return {};
    path /= best;
  }
  return is_file(path) ? path : fs::path();
}

void add(std::vector<std::string>& folders, const std::string& folder) {
  const std::string path = resolved(folder.empty() ? "." : folder);
  if (!path.empty() && std::find(folders.begin(), folders.end(), path) == folders.end()) {
    folders.push_back(path);
  }
}

}  // namespace

FileAccess::FileAccess(Options options) : options_(std::move(options)), current_(resolved(".")) {
  add(search_, options_.scene_folder);
  add(search_, ".");
  for (const std::string& path : options_.search_folders) {
    add(search_, path);
    add(library_, path);
  }
  writable_ = {resolved(options_.scene_folder.empty() ? "." : options_.scene_folder), current_};
  for (const std::string& path : options_.writable_paths) add(writable_, path);
  readable_ = search_;
  for (const std::string& path : options_.readable_paths) add(readable_, path);
  for (const std::string& path : writable_) add(readable_, path);
  if (!options_.scene_file.empty()) scene_file_ = resolved(options_.scene_file);
}

/// A library is the user's own installation: a link in it may lead out (Debian's fonts do), as long
/// as the name itself does not.
bool FileAccess::may_read(const fs::path& path) const {
  if (is_below_any(resolved(path), readable_)) return true;
  const fs::path folder = resolved(path.parent_path());
  return is_below_any((folder / path.filename()).string(), library_);
}

Result<FileAccess::Found> FileAccess::find(const std::string& name) const {
  if (name.empty()) return fail("a file name is empty");
  if (name.find('\0') != std::string::npos) return fail("a file name has a zero byte in it");
  const fs::path wanted(name);
  const std::vector<std::string> folders =
      wanted.is_absolute() ? std::vector<std::string>{"/"} : search_;
  for (const bool other_case : {false, true}) {
    for (const std::string& folder : folders) {
      if (wanted.is_absolute() && other_case) break;
      const fs::path path =
          other_case ? find_other_case(folder, wanted) : fs::path(folder) / wanted;
      if (path.empty() || !is_file(path)) continue;
      if (!may_read(path)) {
        return fail("'" + name + "' may not be read: it is outside the folders of this scene");
      }
      return Found{resolved(path), other_case};
    }
  }
  std::string places;
  if (!wanted.is_absolute()) {
    for (const std::string& folder : search_) places += (places.empty() ? "" : ", ") + folder;
    places = "; looked in " + places;
  }
  return fail("cannot find the file '" + name + "'" + places);
}

bool FileAccess::is_missing(const std::string& name) const {
  if (name.empty() || name.find('\0') != std::string::npos) return false;
  const fs::path wanted(name);
  std::error_code error;
  if (wanted.is_absolute()) return !fs::exists(fs::symlink_status(wanted, error));
  return std::none_of(search_.begin(), search_.end(), [&](const std::string& folder) {
    return fs::exists(fs::symlink_status(fs::path(folder) / wanted, error)) ||
           !find_other_case(folder, wanted).empty();
  });
}

Result<std::string> FileAccess::read(const std::string& path, std::uint64_t most_bytes) const {
  std::error_code error;
  if (!fs::exists(path, error)) return fail("there is no file '" + path + "'");
  if (fs::is_directory(path, error)) return fail("'" + path + "' is a folder, not a file");
  if (!is_file(path)) return fail("'" + path + "' is no plain file");
  const std::uint64_t size = fs::file_size(path, error);
  if (error) return fail("cannot open '" + path + "': " + error.message());
  if (size > most_bytes)
    return fail("'" + path + "' is larger than " + std::to_string(most_bytes) + " bytes");
  std::ifstream in(path, std::ios::binary);
  std::string text(size, '\0');
  if (!in || !in.read(text.data(), static_cast<std::streamsize>(size))) {
    return fail("cannot read '" + path + "': " + std::strerror(errno));
  }
  return text;
}

Result<std::string> FileAccess::writable(const std::string& name) const {
  if (name.empty()) return fail("a file name is empty");
  if (name.find('\0') != std::string::npos) return fail("a file name has a zero byte in it");
  const std::string path = resolved(name);
  const auto folder = std::find_if(writable_.begin(), writable_.end(),
                                   [&](const std::string& f) { return is_below(path, f); });
  if (path.empty() || folder == writable_.end()) {
    return fail("'" + name + "' may not be written: it is outside the folders of this scene");
  }
  const std::string reason = why_not(path, *folder);
  if (!reason.empty()) return fail("'" + name + "' may not be written: it is " + reason);
  return path;
}

/// What forbids to write a file that is below a folder for writing; empty if nothing does.
std::string FileAccess::why_not(const std::string& path, const std::string& folder) const {
  std::error_code error;
  // A link that is left after resolving leads to nothing yet.
  if (fs::is_symlink(path, error)) return "a link to a file that is not there";
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return "no plain file";
  if (path.find("/.", folder.size()) != std::string::npos) return "hidden";
  const std::string ending = lower(fs::path(path).extension().string());
  if (ending == ".ini") return "a file of settings";
  if (path == scene_file_ || (ending == ".pov" && fs::exists(status))) return "a scene";
  return {};
}

}  // namespace dioptre
