// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/image/codec_module.h"

#include <dlfcn.h>

namespace dioptre {
namespace {

Result<const CodecModule*> open_module() {
  // Found by the run path of the program (see CMakeLists.txt).
  void* module = ::dlopen("libdioptre_codecs.so", RTLD_NOW | RTLD_LOCAL);
  const void* codecs = module != nullptr ? ::dlsym(module, "dioptre_codecs") : nullptr;
  if (codecs != nullptr) return static_cast<const CodecModule*>(codecs);
  const char* why = ::dlerror();
  return fail(std::string("this format needs the module of codecs: ") +
              (why != nullptr ? why : "it cannot be opened"));
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
