// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "dioptre/film/image.h"
#include "dioptre/io/image/decoders.h"

/// The codecs of formats that need large libraries. They are a module of their own, loaded when a
/// file asks for one; see CodecModule for what each does.
namespace dioptre::codecs {

Result<DecodedImage> decode_tiff(std::string_view bytes, std::uint64_t max_pixels);
Result<DecodedImage> decode_exr(std::string_view bytes, std::uint64_t max_pixels);
Result<std::string> encode_exr(const Image& linear, std::span<const ImageLayer> layers, bool half);

}  // namespace dioptre::codecs
