// SPDX-License-Identifier: Apache-2.0
#include <csetjmp>
#include <cstdio>
#include <vector>

// jpeglib.h needs stdio's types first.
#include <jpeglib.h>

#include "dioptre/io/image/decoders.h"

namespace dioptre {
namespace {

/// libjpeg's error handling: it must not return, so it jumps back. Warnings (cut or damaged data)
/// count as errors too.
struct JpegErrors {
  jpeg_error_mgr base;
  std::jmp_buf back;
  char problem[JMSG_LENGTH_MAX];
};
[[noreturn]] void jpeg_failed(j_common_ptr info) {
  auto* errors = reinterpret_cast<JpegErrors*>(info->err);
  errors->base.format_message(info, errors->problem);
  std::longjmp(errors->back, 1);
}
void jpeg_message(j_common_ptr info, int level) {
  if (level < 0) jpeg_failed(info);
}

bool start(jpeg_decompress_struct& info, JpegErrors& errors, std::string_view bytes) {
  if (setjmp(errors.back) != 0) return false;
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  info.out_color_space = info.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
  return true;
}

/// `out` has room for the whole image.
bool read_rows(jpeg_decompress_struct& info, JpegErrors& errors, std::vector<std::uint8_t>& out,
               std::size_t row) {
  if (setjmp(errors.back) != 0) return false;
  jpeg_start_decompress(&info);
  while (info.output_scanline < info.output_height) {
    JSAMPROW line = out.data() + info.output_scanline * row;
    jpeg_read_scanlines(&info, &line, 1);
  }
  jpeg_finish_decompress(&info);
  return true;
}

Result<DecodedImage> decode(jpeg_decompress_struct& info, JpegErrors& errors,
                            std::string_view bytes, std::uint64_t max_pixels) {
  const auto problem = [&] {
    const std::size_t left = info.src != nullptr ? info.src->bytes_in_buffer : 0;
    const std::size_t at = left <= bytes.size() ? bytes.size() - left : bytes.size();
    return fail(std::string(errors.problem) + " (at byte " + std::to_string(at) + ")");
  };
  if (!start(info, errors, bytes)) return problem();
  if (const auto size = check_image_size(info.image_width, info.image_height, max_pixels); !size) {
    return tl::unexpected(size.error());
  }
  DecodedImage image;
  image.data.width = info.image_width;
  image.data.height = info.image_height;
  image.data.channels = info.num_components == 1 ? 1 : 3;
  const std::size_t row = std::size_t{info.image_width} * image.data.channels;
  std::vector<std::uint8_t> raw(row * info.image_height);
  if (!read_rows(info, errors, raw, row)) return problem();
  image.data.pixels.assign(raw.begin(), raw.end());
  for (float& value : image.data.pixels) value /= 255.0f;
  return image;
}

}  // namespace

Result<DecodedImage> decode_jpeg(std::string_view bytes, std::uint64_t max_pixels) {
  jpeg_decompress_struct info{};
  JpegErrors errors{};
  info.err = jpeg_std_error(&errors.base);
  errors.base.error_exit = jpeg_failed;
  errors.base.emit_message = jpeg_message;
  jpeg_create_decompress(&info);
  Result<DecodedImage> image = decode(info, errors, bytes, max_pixels);
  jpeg_destroy_decompress(&info);
  return image;
}

}  // namespace dioptre
