// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "dioptre/core/interval.h"
#include "dioptre/film/antialias.h"
#include "dioptre/film/camera_rays.h"
#include "dioptre/film/display.h"
#include "dioptre/film/lens_samples.h"
#include "dioptre/film/transfer_curve.h"

namespace dioptre {
namespace {

using Kind = Camera::Kind;
constexpr Kind kKinds[] = {Kind::kPerspective,    Kind::kOrthographic, Kind::kFisheye,
                           Kind::kUltraWideAngle, Kind::kOmnimax,      Kind::kPanoramic,
                           Kind::kCylinder,       Kind::kSpherical};

Camera square_camera(Kind kind, double angle = 0) {
  Camera camera;
  camera.kind = kind;
  camera.right = {1, 0, 0};
  camera.angle = angle;
  return camera;
}

TEST(CameraRays, TheCentreLooksAlongTheDirection) {
  for (const Kind kind : kKinds) {
    const auto rays = CameraRays::prepare(square_camera(kind));
    ASSERT_TRUE(rays);
    const auto ray = rays->ray(5, 4, 10, 8);
    ASSERT_TRUE(ray);
    EXPECT_NEAR(length(ray->direction - Vec3{0, 0, 1}), 0, 1e-15);
  }
}

TEST(CameraRays, DirectionsAreUnitAndMirrorSymmetric) {
  for (const Kind kind : kKinds) {
    const auto rays = CameraRays::prepare(square_camera(kind, 120));
    for (double x = 0.5; x < 8; ++x) {
      const auto left = rays->ray(x, 2.5, 8, 8), right = rays->ray(8 - x, 2.5, 8, 8);
      ASSERT_EQ(left.has_value(), right.has_value());
      if (!left) continue;
      EXPECT_NEAR(length(left->direction), 1, 1e-14);
      EXPECT_NEAR(left->direction.x, -right->direction.x, 1e-14);
      EXPECT_NEAR(left->direction.y, right->direction.y, 1e-14);
    }
  }
}

/// Directions of pixel (5, 1) of an 8 x 8 image at angle 120, measured with POV-Ray 3.7 on a sphere
/// coloured by direction.
TEST(CameraRays, ProjectionsAgreeWithPovRay) {
  struct Case {
    Kind kind;
    double angle, right;
    Vec3 direction;
  };
  const Case cases[] = {
      {Kind::kPerspective, 0, 1, {0.1762, 0.2936, 0.9396}},
      {Kind::kFisheye, 180, 1, {0.4685, 0.7809, 0.4131}},
      {Kind::kFisheye, 180, 2, {0.7677, 0.6397, 0.0373}},
      {Kind::kUltraWideAngle, 120, 1, {0.3727, 0.5929, 0.7138}},
      {Kind::kUltraWideAngle, 120, 2, {0.3798, 0.3190, 0.8683}},
      {Kind::kOmnimax, 180, 1, {0.4450, 0.7416, 0.5020}},
      {Kind::kOmnimax, 180, 1.2, {0.4342, 0.7960, 0.4217}},
      {Kind::kOmnimax, 180, 2, {0.6262, 0.7585, 0.1801}},
      {Kind::kPanoramic, 120, 1, {0.3086, 0.8315, 0.4620}},
      {Kind::kPanoramic, 120, 2, {0.5444, 0.7333, 0.4074}},
      {Kind::kCylinder, 120, 1, {0.3653, 0.2983, 0.8818}},
      {Kind::kSpherical, 180, 1, {0.4900, 0.4714, 0.7333}},
      {Kind::kSpherical, 0, 2, {0.5133, 0.8315, 0.2126}},
  };
  for (const Case& c : cases) {
    Camera camera = square_camera(c.kind, c.angle);
    camera.right.x = c.right;
    const auto ray = CameraRays::prepare(camera)->ray(5.5, 1.5, 8, 8);
    ASSERT_TRUE(ray);
    EXPECT_NEAR(length(ray->direction - c.direction), 0, 2e-4) << static_cast<int>(c.kind);
  }
}

TEST(CameraRays, TheOmnimaxFilmEndsBelowTheHorizonInAPlaneOf45Degrees) {
  const auto rays = CameraRays::prepare(square_camera(Kind::kOmnimax));
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const auto ray = rays->ray(i + 0.5, j + 0.5, 64, 64);
      const bool on_film = std::hypot(i - 31.5, j - 31.5) <= 32;
      if (ray) EXPECT_GE(ray->direction.y, -ray->direction.z - 1e-12);
      if (j < 32) EXPECT_EQ(ray.has_value(), on_film);
    }
  }
  EXPECT_TRUE(rays->ray(32, 49, 64, 64));
  EXPECT_FALSE(rays->ray(32, 51, 64, 64));
  EXPECT_FALSE(rays->ray(60, 45, 64, 64));
}

TEST(CameraRays, APinholeSeesASphereAsADiscOfTheKnownArea) {
  Camera camera = square_camera(Kind::kPerspective);
  camera.direction = {0, 0, 0.5};
  const auto rays = CameraRays::prepare(camera);
  int inside = 0;
  for (int y = 0; y < 1000; ++y) {
    for (int x = 0; x < 1000; ++x) {
      const Vec3 d = rays->ray(x + 0.5, y + 0.5, 1000, 1000)->direction;
      if (25 * (1 - d.z * d.z) < 1) ++inside;
    }
  }
  EXPECT_NEAR(inside, 32724.92, 33);
}

TEST(CameraRays, AllLensPointsMeetInTheFocus) {
  Camera camera = square_camera(Kind::kPerspective);
  camera.aperture = 0.4;
  camera.focal_distance = 5;
  const auto rays = CameraRays::prepare(camera);
  const Ray first = *rays->ray(2.5, 3.5, 8, 8, {0.5, 0.5});
  const Vec3 focus = first.at(5 / first.direction.z);
  for (double u = 0; u < 1; u += 0.11) {
    const Ray ray = *rays->ray(2.5, 3.5, 8, 8, {u, 1 - u});
    EXPECT_LE(length(ray.origin), 0.1 * std::numbers::sqrt2 + 1e-12);
    EXPECT_NEAR(length(ray.at(dot(focus - ray.origin, ray.direction)) - focus), 0, 1e-12);
  }
}

TEST(CameraRays, BadCamerasAreRefused) {
  const double bad[] = {0, std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity};
  for (const double v : bad) {
    for (Vec3 Camera::*member : {&Camera::direction, &Camera::right, &Camera::up}) {
      Camera camera;
      camera.*member = {v, v, v};
      EXPECT_FALSE(CameraRays::prepare(camera));
    }
  }
  Camera flat;
  flat.up = flat.right;
  EXPECT_FALSE(CameraRays::prepare(flat));
}

TEST(Antialias, TheDifferenceIsThatOfPovRay) {
  EXPECT_NEAR(antialias_difference({0.2f, 0, 0}, {}, 0.4), 0.525, 1e-3);
  EXPECT_NEAR(antialias_difference({0.5f, 0.5f, 0.5f}, {0.7f, 0.7f, 0.7f}, 0.4), 0.3275, 1e-3);
}

TEST(Antialias, BothSidesOfAStepAreRefined) {
  Image image(4, 3);
  for (std::uint32_t y = 0; y < 3; ++y) {
    for (std::uint32_t x = 2; x < 4; ++x) image.at(x, y) = {1, 1, 1};
  }
  const auto marked = pixels_to_refine(image, {}, 0, 0, 4, 3);
  for (std::uint32_t k = 0; k < 12; ++k) EXPECT_EQ(marked[k], k % 4 == 1 || k % 4 == 2);
}

TEST(Antialias, AVerticalEdgeHasTheKnownWeights) {
  const auto edge = [](double at) {
    return [at](double x, double) { return FilmSample{x < at ? Color{} : Color{1, 1, 1}, 1}; };
  };
  AntialiasSettings settings;
  settings.method = 1;
  const auto value = [&](double at) {
    return refine_on_grid(0, 0, edge(at)(0.5, 0.5), settings, edge(at)).color.r;
  };
  EXPECT_NEAR(value(0.25), 0.7, 1e-6);  // columns count .3 .4 .3
  EXPECT_NEAR(value(0.75), 0.3, 1e-6);
  settings.depth = 9;
  EXPECT_NEAR(value(0.25), 0.75, 1.0 / 9);
}

TEST(Antialias, CornersGiveTheShareOfAnEdgeToTheLastDivision) {
  AntialiasSettings settings;
  settings.method = 2;
  settings.depth = 4;
  for (double at = 0.03; at < 1; at += 0.1) {
    const auto edge = [&](double x, double) {
      return FilmSample{x < at ? Color{} : Color{1, 1, 1}, 1};
    };
    const float value = CornerRefiner(settings, edge).pixel(0, 0).color.r;
    EXPECT_NEAR(value, 1 - at, 1.0 / 16);
  }
}

TEST(Display, HalfIsWhatPovRayWrites) {
  Image image(1, 1);
  image.at(0, 0) = {0.25f, 0, 1e9f};
  DisplayOptions options;
  options.bits = 16;
  const EncodedImage out = encode(image, {}, options);
  EXPECT_EQ(out.values, (std::vector<std::uint16_t>{35199, 0, 65535}));
}

TEST(Display, OldScenesGoToTheFileAsTheyAre) {
  Image image(1, 1);
  image.at(0, 0) = {0.5f, std::numeric_limits<float>::quiet_NaN(), -1};
  Settings settings;
  settings.gamma_correction = false;
  const EncodedImage out = encode(image, settings, {});
  EXPECT_EQ(out.values, (std::vector<std::uint16_t>{128, 0, 0}));
  EXPECT_FALSE(out.gamma_known);
}

TEST(Display, DitheringKeepsTheMean) {
  Image image(64, 64);
  for (Color& c : image.pixels) c = {0.3003f, 0.3003f, 0.3003f};
  DisplayOptions options;
  options.file_gamma = 1;
  options.dither = true;
  double sum = 0;
  for (const std::uint16_t v : encode(image, {}, options).values) sum += v;
  EXPECT_NEAR(sum / (64 * 64 * 3), 0.3003 * 255, 0.02);
}

TEST(Display, TransferCurvesAreTheirCurveRounded) {
  const std::vector<std::function<double(float)>> curves = {
      [](float v) { return double{v}; },
      [](float v) { return srgb_encode(v); },
      [](float v) { return std::pow(v, 1 / 2.2); },
      [](float v) { return srgb_encode(static_cast<float>(std::pow(v, 2.2))); },
  };
  for (const auto& exact : curves) {
    for (const double top : {1.0, 255.0, 1023.0, 65535.0}) {
      const TransferCurve curve(exact, top);
      for (int i = 0; i <= 200000; ++i) {
        const float v = i % 2 ? i / 200000.0f : std::exp2(-i / 8000.0f);
        ASSERT_EQ(curve.level(v), std::floor(exact(v) * top + 0.5)) << v << " of " << top;
      }
      EXPECT_EQ(curve.level(2), top);
      EXPECT_EQ(curve.level(-1), 0);
      EXPECT_EQ(curve.level(std::numeric_limits<float>::quiet_NaN()), 0);
    }
  }
}

TEST(Display, TheSrgbCurveIsUndoneByItsInverse) {
  for (double v = 0; v <= 1; v += 0.01) EXPECT_NEAR(srgb_decode(srgb_encode(v)), v, 1e-6);
}

/// After how many samples a lens has looked enough if the first few of them are white, the others
/// black; as POV-Ray 3.7 renders such pixels.
TEST(LensSamples, StopWhereSceneFilesExpectIt) {
  const struct {
    std::uint32_t most;
    double confidence, variance;
    std::array<int, 3> samples;  ///< with one, two and three white ones
  } cases[] = {{37, 0.975, 1.0 / 255, {23, 27, 31}}, {37, 0.9, 1.0 / 128, {19, 23, 27}},
               {37, 0.975, 1.0 / 64, {19, 19, 23}},  {37, 0.9, 0, {37, 37, 37}},
               {12, 0.9, 0.01, {11, 12, 12}},        {7, 0.9, 1e-3, {7, 7, 7}}};
  for (const auto& c : cases) {
    Camera camera;
    camera.aperture = 1;
    camera.blur_samples = c.most;
    camera.confidence = c.confidence;
    camera.variance = c.variance;
    const LensSamples lens(camera);
    for (int white = 1; white <= 3; ++white) {
      int taken = 0;
      lens.mean(0.5, 0.5, 1, [&](double, double, Vec2) {
        const float value = taken++ < white ? 1 : 0;
        return FilmSample{{value, value, value}, 1};
      });
      EXPECT_EQ(taken, c.samples[static_cast<std::size_t>(white - 1)]) << c.most << " " << white;
    }
  }
}

}  // namespace
}  // namespace dioptre
