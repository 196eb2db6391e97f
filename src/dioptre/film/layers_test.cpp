// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace dioptre {
namespace {

using testing::HasSubstr;

TEST(Layers, EachKindHasANameOfItsOwnAndIsReadByIt) {
  std::set<std::string_view> names;
  for (const LayerInfo& info : layer_infos()) {
    EXPECT_TRUE(names.insert(info.name).second);
    EXPECT_EQ(layer_info(info.kind).name, info.name);
    EXPECT_EQ(LayerSet::terms().has(info.kind), info.channels == "RGB");
    EXPECT_NE(LayerSet::terms().has(info.kind), LayerSet::costs().has(info.kind));
    LayerSet expected;
    expected.add(info.kind);
    const auto read = read_layers(info.name, LayerSet::all());
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, expected);
  }
}

TEST(Layers, GroupsAndListsAreSums) {
  EXPECT_EQ(*read_layers("terms", LayerSet::all()), LayerSet::terms());
  EXPECT_EQ(*read_layers("cost", LayerSet::all()), LayerSet::costs());
  EXPECT_EQ(*read_layers("all", LayerSet::all()), LayerSet::all());
  EXPECT_EQ(*read_layers("all", LayerSet::costs()), LayerSet::costs());
  EXPECT_EQ(*read_layers("cost,terms", LayerSet::all()), LayerSet::all());
  LayerSet two;
  two.add(LayerKind::kDepth);
  two.add(LayerKind::kDiffuse);
  EXPECT_EQ(*read_layers("diffuse,depth,diffuse", LayerSet::all()), two);
}

TEST(Layers, AWrongNameListsTheRightOnes) {
  for (const char* wrong : {"", ",", "rays,", "Rays", "rays steps", "colour", "rays,,time"}) {
    const auto read = read_layers(wrong, LayerSet::all());
    ASSERT_FALSE(read) << wrong;
    for (const LayerInfo& info : layer_infos()) {
      EXPECT_THAT(read.error().message, HasSubstr(std::string(info.name)));
    }
  }
  const auto term = read_layers("ambient", LayerSet::costs());
  ASSERT_FALSE(term);
  EXPECT_EQ(term.error().message,
            "unknown layer 'ambient'; known: rays, steps, tests, spans, depth, time, cost, all");
}

TEST(Layers, InLinearLightTheyStillSumToThePicture) {
  Settings settings;
  for (const double gamma : {1.0, 2.2, 0.5}) {
    settings.assumed_gamma = gamma;
    Image image(3, 1);
    image.pixels = {{0.2f, 1.5f, 0.0f}, {-0.5f, 0.7f, 1.0f}, {3.0f, 0.1f, 1e-3f}};
    std::vector<ImageLayer> layers{{"a", "RGB", {}}, {"b", "RGB", {}}, {"z", "Z", {1, 2, 3}}};
    for (const Color c : image.pixels) {
      for (const float v : {c.r, c.g, c.b}) {
        layers[0].values.push_back(0.25f * v);
        layers[1].values.push_back(0.75f * v);
      }
    }
    to_linear(layers, image, settings);
    for (std::size_t i = 0; i < 9; ++i) {
      const Color c = image.pixels[i / 3];
      const float v = i % 3 == 0 ? c.r : i % 3 == 1 ? c.g : c.b;
      const double expected = v > 0 ? std::pow(v, gamma) : 0;
      EXPECT_NEAR(layers[0].values[i] + layers[1].values[i], expected, 1e-6) << gamma;
    }
    EXPECT_EQ(layers[2].values, (std::vector<float>{1, 2, 3}));
  }
}

}  // namespace
}  // namespace dioptre
