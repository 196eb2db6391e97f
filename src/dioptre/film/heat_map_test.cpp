// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/heat_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dioptre/film/color_map.h"
#include "dioptre/film/display.h"
#include "dioptre/film/lettering.h"

namespace dioptre {
namespace {

/// L* of CIE 1976.
double lightness(const std::array<std::uint8_t, 3>& color) {
  const auto light = [&](std::size_t k) { return srgb_decode(color[k] / 255.0); };
  const double y = 0.2126 * light(0) + 0.7152 * light(1) + 0.0722 * light(2);
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

std::array<std::uint8_t, 3> pixel(const EncodedImage& image, std::uint32_t x, std::uint32_t y) {
  const std::uint16_t* v = &image.values[(std::size_t{y} * image.width + x) * 3];
  return {static_cast<std::uint8_t>(v[0]), static_cast<std::uint8_t>(v[1]),
          static_cast<std::uint8_t>(v[2])};
}

/// How many white pixels there are below a row.
std::ptrdiff_t white_below(const EncodedImage& image, std::uint32_t row) {
  std::ptrdiff_t count = 0;
  for (std::uint32_t y = row; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      count += pixel(image, x, y) == std::array<std::uint8_t, 3>{255, 255, 255};
    }
  }
  return count;
}

TEST(Viridis, LightnessRisesEvenly) {
  const double first = lightness(viridis(0)), last = lightness(viridis(1));
  EXPECT_NEAR(first, 15, 2);
  EXPECT_NEAR(last, 91, 2);
  for (int i = 0; i <= 100; ++i) {
    EXPECT_NEAR(lightness(viridis(i / 100.0)), first + (last - first) * i / 100, 2.5) << i;
  }
}

TEST(Viridis, ItsColoursAreThoseOfThePaper) {
  const std::pair<double, std::array<int, 3>> known[] = {{0, {68, 1, 84}},
                                                         {0.25, {59, 82, 139}},
                                                         {0.5, {33, 145, 140}},
                                                         {0.75, {94, 201, 98}},
                                                         {1, {253, 231, 37}}};
  for (const auto& [value, color] : known) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(viridis(value)[k], color[k], 6) << value;
  }
}

TEST(Viridis, WhatLiesOutsideIsTheNearerEnd) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const double low : {-1.0, -kInf, std::nan("")}) EXPECT_EQ(viridis(low), viridis(0));
  for (const double high : {1.5, kInf}) EXPECT_EQ(viridis(high), viridis(1));
}

TEST(Lettering, TextStaysWithinItsBoxAndThePicture) {
  EncodedImage image;
  image.width = 60, image.height = 20;
  image.values.assign(60 * 20 * 3, 0);
  draw_text(image, 3, 2, 2, "A1.");
  int white = 0;
  for (std::uint32_t y = 0; y < 20; ++y) {
    for (std::uint32_t x = 0; x < 60; ++x) {
      if (pixel(image, x, y)[0] == 0) continue;
      ++white;
      EXPECT_GE(x, 3u);
      EXPECT_LT(x, 3 + 2 * text_width("A1."));
      EXPECT_GE(y, 2u);
      EXPECT_LT(y, 2 + 2 * kLetterHeight);
    }
  }
  EXPECT_GT(white, 50);
  draw_text(image, 55, 15, 3, "beyond the edge");
  draw_text(image, 4'000'000'000u, 4'000'000'000u, 1, "far");
}

TEST(HeatMap, HasThePictureItsSizeAndALegend) {
  for (const std::uint32_t width : {1u, 100u, 320u, 1000u}) {
    ImageLayer layer{"rays", "Y", std::vector<float>(width * 10)};
    for (std::size_t i = 0; i < layer.values.size(); ++i) layer.values[i] = static_cast<float>(i);
    const EncodedImage map = heat_map(layer, width, 10, "per pixel");
    EXPECT_EQ(map.width, std::max(width, kLegendWidth));
    EXPECT_EQ(map.height, 10 + legend_height(width));
    EXPECT_EQ(map.values.size(), std::size_t{map.width} * map.height * 3);
    EXPECT_EQ(pixel(map, 0, 0), viridis(0));
    EXPECT_EQ(pixel(map, width - 1, 9), viridis(1));
    EXPECT_GT(white_below(map, 10), 200);
    EXPECT_EQ(white_below(map, map.height - 1), 0);
  }
}

TEST(HeatMap, EqualStepsAreEqualForCostsAndEqualRatiosForDistances) {
  std::vector<float> values;
  for (int i = 0; i <= 100; ++i) values.push_back(static_cast<float>(std::pow(100, i / 100.0)));
  const ImageLayer cost{"time", "Y", values}, depth{"depth", "Z", values};
  const double top = values[99];
  const EncodedImage even = heat_map(cost, 101, 1, ""), log = heat_map(depth, 101, 1, "");
  for (std::uint32_t i = 0; i < 100; ++i) {
    EXPECT_EQ(pixel(even, i, 0), viridis(values[i] / top)) << i;
    EXPECT_EQ(pixel(log, i, 0), viridis(std::log(values[i]) / std::log(top))) << i;
  }
}

TEST(HeatMap, AFewLargeValuesDoNotDarkenTheRest) {
  ImageLayer layer{"time", "Y", std::vector<float>(1000, 1.0f)};
  layer.values[3] = 1e30f;
  const EncodedImage map = heat_map(layer, 100, 10, "");
  EXPECT_EQ(pixel(map, 0, 0), viridis(1));
  EXPECT_EQ(pixel(map, 3, 0), viridis(1));
}

TEST(HeatMap, AnyValuesGiveAPicture) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const float odd[] = {0, -1, 1e-45f, 3e38f, kInf, -kInf, std::nanf("")};
  for (const char* channels : {"Y", "Z"}) {
    for (const float a : odd) {
      for (const float b : odd) {
        const ImageLayer layer{"depth", channels, {a, b}};
        const EncodedImage map = heat_map(layer, 2, 1, "");
        const bool dark = pixel(map, 0, 0)[0] == pixel(map, 0, 0)[2];
        EXPECT_EQ(dark, !std::isfinite(a)) << a << " " << b;
      }
    }
  }
}

}  // namespace
}  // namespace dioptre
