// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "dioptre/core/result.h"
#include "dioptre/film/image.h"
#include "dioptre/io/image/decoders.h"

namespace dioptre {

/// The codecs whose libraries take longer to load than a small picture to render. They live in a
/// module, libdioptre_codecs.so, which is opened when a file first asks for one of them.
struct CodecModule {
  /// As the decoders of decoders.h.
  Result<DecodedImage> (*decode_tiff)(std::string_view bytes, std::uint64_t max_pixels);
  Result<DecodedImage> (*decode_exr)(std::string_view bytes, std::uint64_t max_pixels);
  /// The bytes of an OpenEXR file, as write_exr says. The picture has pixels.
  Result<std::string> (*encode_exr)(const Image& linear, std::span<const ImageLayer> layers,
                                    bool half);
};

/// Opens the module, looked for beside the program and where it is installed; it stays open. The
/// error says what is missing.
Result<const CodecModule*> load_codecs();

}  // namespace dioptre
