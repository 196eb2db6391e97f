// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/image/codec_module.h"

#include <dlfcn.h>

#include <filesystem>
#include <vector>

namespace dioptre {
namespace {

/// Where modules may be: beside the program, where an installation has them, where they were built.
std::vector<std::filesystem::path> module_folders() {
  std::vector<std::filesystem::path> folders;
  std::error_code problem;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", problem);
  if (!problem) {
    folders.push_back(program.parent_path());
    folders.push_back(program.parent_path().parent_path() / "lib/dioptre");
  }
  folders.push_back(DIOPTRE_MODULE_FOLDER);
  return folders;
}

Result<const CodecModule*> open_module() {
  std::string why;
  for (const std::filesystem::path& folder : module_folders()) {
    const std::filesystem::path path = folder / "libdioptre_codecs.so";
    void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    const void* codecs = module != nullptr ? ::dlsym(module, "dioptre_codecs") : nullptr;
    if (codecs != nullptr) return static_cast<const CodecModule*>(codecs);
    const char* reason = ::dlerror();
    why += std::string("; ") + (reason != nullptr ? reason : "it cannot be opened");
  }
  return fail("this format needs the module of codecs" + why);
}

}  // namespace

Result<const CodecModule*> load_codecs() {
  static const Result<const CodecModule*> codecs = open_module();
  return codecs;
}

Result<DecodedImage> decode_tiff(std::string_view bytes, std::uint64_t max_pixels) {
  return load_codecs().and_then(
      [&](const CodecModule* codecs) { return codecs->decode_tiff(bytes, max_pixels); });
}

Result<DecodedImage> decode_exr(std::string_view bytes, std::uint64_t max_pixels) {
  return load_codecs().and_then(
      [&](const CodecModule* codecs) { return codecs->decode_exr(bytes, max_pixels); });
}

}  // namespace dioptre
