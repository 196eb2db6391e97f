// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "dioptre/io/image/decoders.h"

namespace dioptre {
namespace {

using Rgbe = std::array<unsigned char, 4>;

/// The pixels of a Radiance file (Ward 1991, "Real pixels"): flat, or each row's four planes
/// run-length coded.
class Rows {
 public:
  Rows(std::string_view bytes, std::size_t at) : bytes_(bytes), at_(at) {}
  std::size_t at() const { return at_; }

  /// Fills one row; false if the data ends or is damaged.
  bool read(std::vector<Rgbe>& row) {
    if (row.size() >= 8 && row.size() < 32768 && left() >= 4 && byte(0) == 2 && byte(1) == 2 &&
        (byte(2) & 0x80) == 0) {
      if (byte(2) * 256u + byte(3) != row.size()) return false;
      at_ += 4;
      return read_planes(row);
    }
    for (Rgbe& pixel : row) {
      if (left() < 4) return false;
      for (unsigned char& part : pixel) part = next();
    }
    return true;
  }

 private:
  std::size_t left() const { return bytes_.size() - at_; }
  unsigned char byte(std::size_t ahead) const {
    return static_cast<unsigned char>(bytes_[at_ + ahead]);
  }
  unsigned char next() { return static_cast<unsigned char>(bytes_[at_++]); }

  bool read_planes(std::vector<Rgbe>& row) {
    for (std::size_t plane = 0; plane < 4; ++plane) {
      for (std::size_t x = 0; x < row.size();) {
        if (left() < 2) return false;
        const unsigned char code = next();
        const bool run = code > 128;
        const std::size_t count = run ? code - 128u : code;
        if (count == 0 || count > row.size() - x || (!run && count > left())) return false;
        const unsigned char value = run ? next() : 0;
        for (std::size_t k = 0; k < count; ++k) row[x++][plane] = run ? value : next();
      }
    }
    return true;
  }

  std::string_view bytes_;
  std::size_t at_;
};

/// The text lines of the header.
std::optional<std::string_view> next_line(std::string_view bytes, std::size_t& at) {
  const std::size_t end = bytes.find('\n', at);
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = bytes.substr(at, end - at);
  at = end + 1;
  return line;
}

/// A line "-Y HEIGHT +X WIDTH": the only orientation in use.
bool parse_size(std::string_view line, std::uint32_t& width, std::uint32_t& height) {
  const std::size_t split = line.find(" +X ");
  if (!line.starts_with("-Y ") || split == std::string_view::npos) return false;
  const auto number = [](std::string_view text, std::uint32_t& out) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    return error == std::errc() && end == text.data() + text.size();
  };
  return number(line.substr(3, split - 3), height) && number(line.substr(split + 4), width);
}

float part_value(unsigned char part, unsigned char exponent) {
  if (exponent == 0) return 0;
  return static_cast<float>(std::ldexp(part + 0.5, exponent - 136));
}

}  // namespace

Result<DecodedImage> decode_hdr(std::string_view bytes, std::uint64_t max_pixels) {
  std::size_t at = 0;
  std::optional<std::string_view> line;
  do {
    line = next_line(bytes, at);
  } while (line && !line->empty());
  const auto size_line = line ? next_line(bytes, at) : std::nullopt;
  DecodedImage image;
  image.curve = DecodedImage::Curve::kLinear;
  ImageData& data = image.data;
  if (!size_line || !parse_size(*size_line, data.width, data.height)) {
    return fail("the header is damaged (at byte " + std::to_string(at) + ")");
  }
  if (const auto size = check_image_size(data.width, data.height, max_pixels); !size) {
    return tl::unexpected(size.error());
  }
  // A coded row takes 4 bytes and, per plane, 2 bytes for at most 127 pixels.
  const std::uint64_t least = data.height * (4 + std::uint64_t{data.width} / 127 * 8);
  if (least > bytes.size() - at) {
    return fail("the file ends too early (at byte " + std::to_string(bytes.size()) + ")");
  }
  Rows rows(bytes, at);
  std::vector<Rgbe> row(data.width);
  data.pixels.reserve(std::size_t{data.width} * data.height * 3);
  for (std::uint32_t y = 0; y < data.height; ++y) {
    if (!rows.read(row)) {
      return fail("the pixels are cut or damaged (at byte " + std::to_string(rows.at()) + ")");
    }
    for (const Rgbe& p : row) {
      for (int k = 0; k < 3; ++k) data.pixels.push_back(part_value(p[k], p[3]));
    }
  }
  return image;
}

}  // namespace dioptre
