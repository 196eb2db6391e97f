// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/image/palette_numbers.h"

#include <algorithm>
#include <cstdint>

namespace dioptre {
namespace {

std::size_t byte_at(std::string_view bytes, std::size_t at) {
  return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}

/// Two bytes, the low one first.
std::size_t word_at(std::string_view bytes, std::size_t at) {
  return byte_at(bytes, at) + 256 * byte_at(bytes, at + 1);
}

/// Writes the number of each entry into its first three bytes.
void number_entries(std::string& bytes, std::size_t at, std::size_t count, std::size_t size) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3 && at + i * size + k < bytes.size(); ++k) {
      bytes[at + i * size + k] = static_cast<char>(i);
    }
  }
}

/// The number of entries that the flags of a GIF's screen or image tell; 0 without a palette.
std::size_t gif_entries(std::size_t flags) {
  return (flags & 0x80) != 0 ? std::size_t{2} << (flags & 7) : 0;
}

/// Calls change(at) for the flags of each graphic control of a GIF whose blocks begin at `at`, and
/// gives the place behind them.
template <class Change>
std::size_t for_each_control(const std::string& bytes, std::size_t at, Change change) {
  while (byte_at(bytes, at) == 0x21) {
    const bool control = byte_at(bytes, at + 1) == 0xf9;
    at += 2;
    if (control && at + 1 < bytes.size()) change(at + 1);
    while (byte_at(bytes, at) != 0) at += 1 + byte_at(bytes, at);
    ++at;
  }
  return at;
}

/// Where the blocks of a GIF begin: behind its screen's palette.
std::size_t gif_blocks(const std::string& bytes) {
  constexpr std::size_t kScreen = 13;
  return kScreen + 3 * gif_entries(byte_at(bytes, 10));
}

/// Numbers the palette of the screen and that of the first image (CompuServe, "Graphics Interchange
/// Format 89a", 1990).
std::optional<std::string> number_gif(std::string bytes) {
  constexpr std::size_t kScreen = 13, kImage = 10;
  const std::size_t entries = gif_entries(byte_at(bytes, 10));
  number_entries(bytes, kScreen, entries, 3);
  bytes = with_opaque_entries(std::move(bytes));
  const std::size_t at = for_each_control(bytes, gif_blocks(bytes), [](std::size_t) {});
  const std::size_t own = gif_entries(byte_at(bytes, at + 9));
  number_entries(bytes, at + kImage, own, 3);
  if (entries == 0 && own == 0) return std::nullopt;
  return bytes;
}

std::optional<std::string> number_bmp(std::string bytes) {
  constexpr std::size_t kFileHeader = 14;
  const std::size_t header = word_at(bytes, kFileHeader), pixels = word_at(bytes, 10);
  const bool old = header == 12;
  const std::size_t bits = word_at(bytes, old ? 24 : 28), size = old ? 3 : 4;
  const std::size_t begin = kFileHeader + header;
  if (bits > 8 || pixels <= begin) return std::nullopt;
  number_entries(bytes, begin, std::min((pixels - begin) / size, std::size_t{1} << bits), size);
  return bytes;
}

/// The new palette has three bytes for each entry, whatever the old one had.
std::optional<std::string> number_tga(std::string_view bytes) {
  constexpr std::size_t kHeader = 18;
  const std::size_t kind = byte_at(bytes, 2), first = word_at(bytes, 3), count = word_at(bytes, 5);
  const bool mapped = byte_at(bytes, 1) == 1 && (kind == 1 || kind == 9);
  if (!mapped || first != 0 || count == 0 || byte_at(bytes, 16) != 8) return std::nullopt;
  const std::size_t begin = kHeader + byte_at(bytes, 0);
  const std::size_t end = begin + count * ((byte_at(bytes, 7) + 7) / 8);
  if (end > bytes.size()) return std::nullopt;
  std::string numbered(bytes.substr(0, begin));
  numbered[7] = 24;
  numbered.resize(begin + 3 * count);
  number_entries(numbered, begin, count, 3);
  numbered += bytes.substr(end);
  return numbered;
}

}  // namespace

std::string with_opaque_entries(std::string gif) {
  for_each_control(gif, gif_blocks(gif),
                   [&](std::size_t flags) { gif[flags] &= static_cast<char>(~1); });
  return gif;
}

std::optional<std::string> with_palette_of_numbers(std::string_view bytes) {
  if (bytes.starts_with("GIF8")) return number_gif(std::string(bytes));
  if (bytes.starts_with("BM")) return number_bmp(std::string(bytes));
  return number_tga(bytes);
}

}  // namespace dioptre
