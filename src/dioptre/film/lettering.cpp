// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/lettering.h"

#include <algorithm>

namespace dioptre {
namespace {

/// The rows of a letter from top to bottom, five dots each.
struct Letter {
  char letter;
  const char* dots;
};
constexpr Letter kLetters[] = {
    {'0', " ### #   ##  ### # ###  ##   # ### "}, {'1', "  #   ##    #    #    #    #   ### "},
    {'2', " ### #   #    #   #   #   #   #####"}, {'3', "#####   #   #     #     ##   # ### "},
    {'4', "   #   ##  # # #  # #####   #    # "}, {'5', "######    ####     #    ##   # ### "},
    {'6', "  ##  #   #    #### #   ##   # ### "}, {'7', "#####    #   #   #   #    #    #   "},
    {'8', " ### #   ##   # ### #   ##   # ### "}, {'9', " ### #   ##   # ####    #   #  ##  "},
    {'A', " ### #   ##   ##   #######   ##   #"}, {'B', "#### #   ##   ##### #   ##   ##### "},
    {'C', " ### #   ##    #    #    #   # ### "}, {'D', "#### #   ##   ##   ##   ##   ##### "},
    {'E', "######    #    #### #    #    #####"}, {'F', "######    #    #### #    #    #    "},
    {'G', " ### #   ##    # ####   ##   # ####"}, {'H', "#   ##   ##   #######   ##   ##   #"},
    {'I', " ###   #    #    #    #    #   ### "}, {'J', "  ###   #    #    #    # #  #  ##  "},
    {'K', "#   ##  # # #  ##   # #  #  # #   #"}, {'L', "#    #    #    #    #    #    #####"},
    {'M', "#   ### ### # ## # ##   ##   ##   #"}, {'N', "#   ##   ###  ## # ##  ###   ##   #"},
    {'O', " ### #   ##   ##   ##   ##   # ### "}, {'P', "#### #   ##   ##### #    #    #    "},
    {'Q', " ### #   ##   ##   ## # ##  #  ## #"}, {'R', "#### #   ##   ##### # #  #  # #   #"},
    {'S', " #####    #     ###     #    ##### "}, {'T', "#####  #    #    #    #    #    #  "},
    {'U', "#   ##   ##   ##   ##   ##   # ### "}, {'V', "#   ##   ##   ##   ##   # # #   #  "},
    {'W', "#   ##   ##   ## # ## # ## # # # # "}, {'X', "#   ##   # # #   #   # # #   ##   #"},
    {'Y', "#   ##   ##   # # #   #    #    #  "}, {'Z', "#####    #   #   #   #   #    #####"},
    {'.', "                          ##   ##  "}, {',', "                     ##    #   #   "},
    {'+', "       #    #  #####  #    #       "}, {'-', "               #####               "},
    {'>', "#     #     #     #   #   #   #    "},
};

const char* dots_of(char c) {
  if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  for (const Letter& letter : kLetters) {
    if (letter.letter == c) return letter.dots;
  }
  return "                                   ";
}

/// A white square.
void draw_dot(EncodedImage& image, std::uint64_t x, std::uint64_t y, std::uint32_t scale) {
  for (std::uint64_t j = y; j < std::min<std::uint64_t>(y + scale, image.height); ++j) {
    for (std::uint64_t i = x; i < std::min<std::uint64_t>(x + scale, image.width); ++i) {
      for (std::uint32_t k = 0; k < image.channels; ++k) {
        image.values[(j * image.width + i) * image.channels + k] = 255;
      }
    }
  }
}

}  // namespace

void draw_text(EncodedImage& image, std::uint32_t x, std::uint32_t y, std::uint32_t scale,
               std::string_view text) {
  for (std::size_t n = 0; n < text.size(); ++n) {
    const char* dots = dots_of(text[n]);
    for (std::uint32_t i = 0; i < 5 * kLetterHeight; ++i) {
      if (dots[i] != '#') continue;
      draw_dot(image, x + (n * kLetterPitch + i % 5) * scale, y + std::uint64_t{i / 5} * scale,
               scale);
    }
  }
}

}  // namespace dioptre
