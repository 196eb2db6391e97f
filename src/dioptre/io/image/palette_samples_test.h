// SPDX-License-Identifier: Apache-2.0
// One image of 8 x 2 pixels with a palette of 8 colours, in three formats.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace dioptre {

/// The numbers of the pixels' colours: the upper row from left to right, then the lower one.
inline const std::vector<float> kPaletteNumbers = {0, 1, 2, 4, 7, 3, 5, 6, 6, 5, 3, 7, 4, 2, 1, 0};
/// Entry 2 is green.
inline constexpr unsigned char kPalette[8][3] = {{0, 0, 0},     {255, 0, 0},    {0, 255, 0},
                                                 {255, 255, 0}, {10, 60, 200},  {255, 0, 255},
                                                 {0, 255, 255}, {255, 255, 255}};

/// By ImageMagick 6.9.
inline std::string palette_gif() {
  constexpr unsigned char kBytes[] = {
      0x47, 0x49, 0x46, 0x38, 0x39, 0x61, 0x08, 0x00, 0x02, 0x00, 0xf2, 0x00, 0x00,
      0x00, 0x00, 0x00, 0xff, 0x00, 0x00, 0x00, 0xff, 0x00, 0xff, 0xff, 0x00, 0x0a,
      0x3c, 0xc8, 0xff, 0x00, 0xff, 0x00, 0xff, 0xff, 0xff, 0xff, 0xff, 0x2c, 0x00,
      0x00, 0x00, 0x00, 0x08, 0x00, 0x02, 0x00, 0x00, 0x03, 0x0b, 0x08, 0x21, 0x74,
      0x53, 0xc6, 0x94, 0x71, 0x88, 0x08, 0x20, 0x01, 0x00, 0x3b};
  return {reinterpret_cast<const char*>(kBytes), sizeof kBytes};
}

/// The palette with the blue byte first and some bytes behind each entry, then the lower and the
/// upper row.
inline std::string palette_and_rows(std::size_t padding) {
  std::string bytes;
  for (const auto& color : kPalette) {
    for (int k = 3; k-- > 0;) bytes += static_cast<char>(color[k]);
    bytes.append(padding, '\0');
  }
  for (int k = 0; k < 16; ++k) bytes += static_cast<char>(kPaletteNumbers[(k + 8) % 16]);
  return bytes;
}

inline std::string palette_bmp() {
  using namespace std::string_literals;
  return "BM\x66\0\0\0\0\0\0\0\x56\0\0\0"  // the file's size, where its pixels begin
         "\x28\0\0\0\x08\0\0\0\2\0\0\0\1\0\x08\0\0\0\0\0"
         "\x10\0\0\0\0\0\0\0\0\0\0\0\x08\0\0\0\0\0\0\0"s +
         palette_and_rows(1);
}

inline std::string palette_tga() {
  using namespace std::string_literals;
  return "\0\1\1\0\0\x08\0\x18\0\0\0\0\x08\0\2\0\x08\0"s + palette_and_rows(0);
}

/// The files with their names.
inline std::vector<std::pair<std::string, std::string>> palette_files() {
  return {{"p.gif", palette_gif()}, {"p.bmp", palette_bmp()}, {"p.tga", palette_tga()}};
}

}  // namespace dioptre
