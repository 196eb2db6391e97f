// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "dioptre/shading/patterns/pattern_evaluator.h"

namespace dioptre {
namespace {

/// Values printed by POV-Ray 3.7.0.10, see the head of the file.
struct Golden {
  struct Noise {
    Vec3 point;
    double generators[3];
    Vec3 turbulence;
  };
  std::vector<Noise> noise;
  std::map<std::string, std::vector<double>> patterns;

  Golden() {
    std::ifstream file(DIOPTRE_SOURCE_DIR "/src/dioptre/shading/noise/golden.tsv");
    std::string line;
    while (std::getline(file, line)) {
      if (line.empty() || line[0] == '#') continue;
      std::istringstream fields(line);
      std::string name, number;
      std::getline(fields, name, '\t');
      std::vector<double> v;
      while (std::getline(fields, number, '\t')) v.push_back(std::stod(number));
      if (name == "noise") {
        noise.push_back({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}});
      } else {
        patterns[name] = v;
      }
    }
  }
};

const Golden& golden() {
  static const Golden values;
  return values;
}

Pattern with(PatternData data) {
  Pattern pattern;
  pattern.data = std::move(data);
  return pattern;
}
Pattern turbulent(PatternData data, double amount) {
  Pattern pattern = with(std::move(data));
  pattern.warps.push_back(Turbulence{{amount, amount, amount}});
  return pattern;
}
Pattern frequent(PatternData data, double frequency) {
  Pattern pattern = with(std::move(data));
  pattern.frequency = frequency;
  return pattern;
}

std::map<std::string, Pattern> known_patterns() {
  return {{"agate", with(Agate{})},
          {"agate agate_turb 0.5", with(Agate{0.5})},
          {"boxed", with(Boxed{})},
          {"bozo", with(Bozo{})},
          {"bozo turbulence 0.5", turbulent(Bozo{}, 0.5)},
          {"brick", with(Brick{})},
          {"bumps", with(Bumps{})},
          {"cells", with(Cells{})},
          {"checker", with(Checker{})},
          {"crackle", with(Crackle{})},
          {"crackle form <-1,1,0> metric 1", with(Crackle{.metric = 1})},
          {"crackle form <1,0,0>", with(Crackle{.form = {1, 0, 0}})},
          {"crackle solid", with(Crackle{.solid = true})},
          {"cubic", with(Cubic{})},
          {"cylindrical", with(Cylindrical{})},
          {"dents", with(Dents{})},
          {"gradient <1,2,3>", with(Gradient{{1, 2, 3}})},
          {"gradient x", with(Gradient{{1, 0, 0}})},
          {"granite", with(Granite{})},
          {"hexagon", with(Hexagon{})},
          {"julia <0.353,0.288>,30",
           with(Fractal{.julia = true, .constant = {0.353, 0.288}, .iterations = 30})},
          {"leopard", with(Leopard{})},
          {"magnet 1 mandel 20", with(Fractal{.magnet = true, .iterations = 20})},
          {"mandel 25 exponent 3", with(Fractal{.iterations = 25, .exponent = 3})},
          {"mandel 50", with(Fractal{.iterations = 50})},
          {"marble", with(Marble{})},
          {"marble turbulence 0.7", turbulent(Marble{}, 0.7)},
          {"onion", with(Onion{})},
          {"planar", with(Planar{})},
          {"quilted", with(Quilted{})},
          {"quilted control0 0.3 control1 0.7", with(Quilted{0.3, 0.7})},
          {"radial", with(Radial{})},
          {"radial frequency 6", frequent(Radial{}, 6)},
          {"ripples", with(Ripples{})},
          {"spherical", with(Spherical{})},
          {"spiral1 3", with(Spiral{3})},
          {"spiral2 4", with(Spiral{4, true})},
          {"spotted", with(Spotted{})},
          {"waves", with(Waves{})},
          {"wood", with(Wood{})},
          {"wood turbulence 0.2", turbulent(Wood{}, 0.2)},
          {"wrinkles", with(Wrinkles{})}};
}

PatternServices services_of(const Scene& scene) {
  PatternServices services;
  services.scene = &scene;
  services.call = [](FunctionId, std::span<const double>) { return 0.0; };
  services.pigment = [](PigmentId, Vec3) { return PigmentColor{}; };
  services.inside = [](ObjectId, Vec3) { return false; };
  return services;
}

TEST(Noise, AgreesWithTheGoldenValues) {
  ASSERT_EQ(golden().noise.size(), 20u);
  for (const auto& [p, generators, turbulence] : golden().noise) {
    for (int g = 1; g <= 3; ++g) {
      EXPECT_NEAR(noise(p, static_cast<NoiseGenerator>(g)), generators[g - 1], 1e-12);
    }
    const Vec3 v = vector_turbulence(p, {});
    EXPECT_LT(length(v - turbulence), 1e-9);
  }
}

TEST(Pattern, AgreesWithTheGoldenValues) {
  const Scene scene;
  const auto known = known_patterns();
  ASSERT_EQ(golden().patterns.size(), known.size());
  for (const auto& [name, expected] : golden().patterns) {
    ASSERT_TRUE(known.contains(name)) << name;
    const PatternEvaluator pattern(known.at(name), services_of(scene));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(pattern.value(golden().noise[i].point, {}), expected[i], 1e-9)
          << name << " at point " << i;
    }
  }
}

TEST(Pattern, EveryKindStaysInItsRangeAndSurvivesOddPoints) {
  const Scene scene;
  const double huge = 1e300, inf = std::numeric_limits<double>::infinity();
  for (const auto& [name, description] : known_patterns()) {
    const PatternEvaluator pattern(description, services_of(scene));
    for (const double v : {0.0, 1.0, -1.0, 0.5, 1e6, -1e9, huge, -huge, inf, std::nan("")}) {
      for (const Vec3 p : {Vec3{v, 0, 0}, Vec3{0, v, 0}, Vec3{v, v, v}}) {
        const double value = pattern.value(p, {});
        if (!(std::fabs(v) <= 1e9)) continue;
        EXPECT_GE(value, -2.1e-5) << name << ' ' << v;
        EXPECT_LE(value, pattern.block() ? 5 : 1.00001) << name << ' ' << v;
      }
    }
  }
}

}  // namespace
}  // namespace dioptre
