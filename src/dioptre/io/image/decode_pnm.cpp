// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "dioptre/io/image/decoders.h"

namespace dioptre {
namespace {

/// Reads the numbers of a PNM file; comments run from # to the end of the line.
class Numbers {
 public:
  explicit Numbers(std::string_view bytes) : bytes_(bytes) {}

  std::optional<std::uint32_t> next() {
    skip_blanks();
    const std::size_t start = at_;
    std::uint64_t value = 0;
    while (at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9') {
      value = value * 10 + static_cast<std::uint64_t>(bytes_[at_++] - '0');
      if (value > 0xffffffff) return std::nullopt;
    }
    if (at_ == start) return std::nullopt;
    return static_cast<std::uint32_t>(value);
  }
  std::size_t at() const { return at_; }

 private:
  void skip_blanks() {
    bool comment = false;
    for (; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      if (c == '#') comment = true;
      if (c == '\n' || c == '\r') comment = false;
      if (!comment && !(c == ' ' || (c >= '\t' && c <= '\r'))) return;
    }
  }
  std::string_view bytes_;
  std::size_t at_ = 2;  // after the two letters that name the format
};

}  // namespace

Result<DecodedImage> decode_pnm(std::string_view bytes, std::uint64_t max_pixels) {
  const char kind = bytes[1];
  const bool text = kind < '5';
  Numbers numbers(bytes);
  const auto bad = [&](const char* what) {
    return fail(std::string(what) + " (at byte " + std::to_string(numbers.at()) + ")");
  };
  const auto width = numbers.next(), height = numbers.next(), top = numbers.next();
  if (!width || !height || !top) return bad("the header is damaged");
  if (*top == 0 || *top > 65535) return bad("the largest value must be 1 to 65535");
  if (const auto size = check_image_size(*width, *height, max_pixels); !size) {
    return tl::unexpected(size.error());
  }
  DecodedImage image;
  image.curve = DecodedImage::Curve::kAsStored;
  image.data.width = *width;
  image.data.height = *height;
  image.data.channels = kind == '3' || kind == '6' ? 3 : 1;
  const std::size_t count = std::size_t{*width} * *height * image.data.channels;
  const std::size_t value_bytes = *top > 255 ? 2 : 1;
  const std::size_t start = numbers.at() + 1;
  const std::size_t least = text ? count : count * value_bytes;  // a digit takes a byte at least
  if (start > bytes.size() || least > bytes.size() - start) return bad("the file ends too early");
  image.data.pixels.resize(count);
  const float scale = 1.0f / static_cast<float>(*top);
  for (std::size_t k = 0; k < count; ++k) {
    std::uint32_t value = 0;
    if (text) {
      const auto number = numbers.next();
      if (!number) return bad("a number was expected");
      value = *number;
    } else {
      for (std::size_t b = 0; b < value_bytes; ++b) {
        value = value * 256 + static_cast<unsigned char>(bytes[start + k * value_bytes + b]);
      }
    }
    image.data.pixels[k] = static_cast<float>(value) * scale;
  }
  return image;
}

}  // namespace dioptre
