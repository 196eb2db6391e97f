// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "dioptre/io/image/write_image.h"

namespace dioptre {
namespace {

/// False on failure, with errno set.
bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

tl::unexpected<Error> cannot_write(const std::string& path, int reason) {
  return fail("cannot write " + path + ": " + std::strerror(reason));
}

/// The permissions of a new file under the process's mask.
mode_t new_file_mode() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

Result<void> write_file(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    if (!write_all(STDOUT_FILENO, bytes)) return cannot_write("the standard output", errno);
    return {};
  }
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return cannot_write(path, EISDIR);
  if (exists && !S_ISREG(old.st_mode)) {  // a device or pipe is written in place
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) return cannot_write(path, errno);
    const bool written = write_all(file, bytes);
    const int reason = errno;
    if (::close(file) != 0 || !written) return cannot_write(path, reason);
    return {};
  }
  std::error_code ignored;
  const std::filesystem::path target =
      exists ? std::filesystem::canonical(path, ignored) : std::filesystem::path(path);
  // mkstemp puts its own letters in the place of the last six.
  const std::string ending = "." + std::string(6, 'X');
  std::string temporary = (target.empty() ? path : target.string()) + ending;
  const int file = ::mkstemp(temporary.data());
  if (file < 0) return cannot_write(path, errno);
  const mode_t mode = exists ? (old.st_mode & 07777) : new_file_mode();
  const bool good = write_all(file, bytes) && ::fchmod(file, mode) == 0 && ::fsync(file) == 0;
  int reason = errno;
  const bool closed = ::close(file) == 0;
  const std::string final_path = temporary.substr(0, temporary.size() - ending.size());
  if (!good || !closed || std::rename(temporary.c_str(), final_path.c_str()) != 0) {
    if (good) reason = errno;
    ::unlink(temporary.c_str());
    return cannot_write(path, reason);
  }
  return {};
}

}  // namespace dioptre
