// SPDX-License-Identifier: Apache-2.0
// Widths of orthographic images were measured with POV-Ray 3.7.
#include "dioptre/io/pov/syntax/syntax_test_support.h"

namespace dioptre::pov {
namespace {

Camera camera_of(const std::string& contents) {
  return scene_of("camera { " + contents + " }").camera;
}

TEST(Camera, DefaultsAreThoseOfTheLanguage) { EXPECT_EQ(camera_of(""), Camera{}); }

TEST(Camera, AngleSetsTheLengthOfDirection) {
  const Camera camera = camera_of("right 4*x angle 90");
  EXPECT_NEAR(length(camera.direction), 2, 1e-12);
}

TEST(Camera, LookAtKeepsLengthsAndHandedness) {
  for (const char* right : {"right 2*x", "right -2*x"}) {
    const Camera camera = camera_of(std::string(right) + " location <1, 2, 3> look_at <4, 0, 7>");
    EXPECT_NEAR(length(camera.right), 2, 1e-12);
    EXPECT_NEAR(length(camera.up), 1, 1e-12);
    EXPECT_NEAR(length(camera.direction), 1, 1e-12);
    const double side = dot(cross(camera.up, camera.direction), camera.right);
    EXPECT_EQ(side > 0, std::string(right) == "right 2*x");
    EXPECT_NEAR(length(cross(camera.direction, Vec3{3, -2, 4})), 0, 1e-12);
  }
}

TEST(Camera, LookAtActsAfterEverythingElse) {
  EXPECT_EQ(camera_of("location -5*z right 2*x angle 40 look_at x"),
            camera_of("look_at x angle 40 right 2*x location -5*z"));
}

TEST(Camera, OrthographicWidthIsGivenOrThatOfThePerspectiveView) {
  const auto width = [](const std::string& contents) {
    return length(camera_of("orthographic " + contents).right);
  };
  EXPECT_NEAR(width("location -5*z right 4*x up 3*y look_at 0"), 4, 1e-12);
  EXPECT_NEAR(width("location -5*z look_at 0"), 6.65, 1e-12);
  EXPECT_NEAR(width("location -5*z direction 2*z look_at 0"), 3.325, 1e-12);
  EXPECT_NEAR(width("location -10*z"), 14.63, 1e-12);
  EXPECT_NEAR(width("location -5*z right 4*x up 3*y angle 60 look_at 0"), 5.7735, 1e-4);
}

TEST(Camera, ThatLooksAlongTheSkyKeepsItsRight) {
  const Camera down = camera_of("location 10*y look_at 0");
  EXPECT_EQ(down.right, (Vec3{1.33, 0, 0}));
  EXPECT_EQ(down.up, (Vec3{0, 0, 1}));
  EXPECT_EQ(camera_of("location -10*y look_at 0").up, (Vec3{0, 0, -1}));
}

TEST(Camera, FocusIsADistanceAlongTheDirection) {
  EXPECT_NEAR(camera_of("location -5*z focal_point <1, 1, 2> aperture 1").focal_distance, 7, 1e-12);
}

TEST(Camera, TheSecondAngleNeedsNoComma) {
  EXPECT_EQ(camera_of("spherical angle 300 100"), camera_of("spherical angle 300, 100"));
  EXPECT_EQ(camera_of("spherical angle 300 100").vertical_angle, 100);
}

TEST(Camera, ThroughWhichNothingIsSeenIsAnError) {
  for (const auto& [contents, reason] :
       {std::pair{"direction 0", "the direction vector of the camera has no direction"},
        std::pair{"right 0", "the right vector of the camera has no direction"},
        std::pair{"up 0", "the up vector of the camera has no direction"},
        std::pair{"angle 1e-300", "the direction vector of the camera has no direction"},
        std::pair{"right z", "the direction, right and up vectors of the camera lie in one plane"},
        std::pair{"location 1e308*10", "the location of the camera is not finite"},
        std::pair{"angle 0", "the angle of the camera must be between 0 and 180 degrees"},
        std::pair{"angle 180", "the angle of the camera must be between 0 and 180 degrees"},
        std::pair{"aperture 1 focal_point -z", "the focal point must lie in front of the camera"},
        std::pair{"aperture -1", "the aperture of the camera must be a number of at least 0"}}) {
    const std::string text = said(std::string("camera { ") + contents + " }");
    EXPECT_EQ(text.find("t.pov:2:"), 0u) << text;
    EXPECT_NE(text.find(std::string("error: ") + reason), std::string::npos) << text;
  }
}

constexpr const char* kTwoMeshes =
    "mesh { triangle { 0, x, y } } mesh { triangle { 0, x, y } translate z } ";

TEST(Camera, OfMeshesTakesTheZOfLocationAndDirection) {
  const Camera camera = camera_of(std::string("mesh_camera { 2 0 5 ") + kTwoMeshes +
                                  "} location <7, 8, -0.5> direction -2*z");
  EXPECT_EQ(camera.kind, Camera::Kind::kMesh);
  EXPECT_EQ(camera.mesh.rays_per_pixel, 2u);
  EXPECT_EQ(camera.mesh.distribution, MeshCamera::Distribution::kEach);
  EXPECT_EQ(camera.mesh.max_distance, 5);
  EXPECT_EQ(camera.reach(), 5);
  EXPECT_EQ(camera.mesh.offset, -0.5);
  EXPECT_TRUE(camera.mesh.backwards);
  ASSERT_EQ(camera.mesh.meshes.size(), 2u);
  EXPECT_EQ(camera.mesh.meshes[1].transform, translation({0, 0, 1}));
}

TEST(Camera, OfMeshesThatNothingCanBeSeenFromIsAnError) {
  for (const auto& [contents, reason] :
       {std::pair{std::string("1 0"), "the mesh camera has no mesh"},
        std::pair{std::string("1 0 sphere { 0, 1 }"), "a mesh camera looks out of meshes only"},
        std::pair{std::string("3 0 ") + kTwoMeshes, "there must be a mesh for each ray"},
        std::pair{std::string("2 3 ") + kTwoMeshes, "distributions 2 and 3 have one ray"},
        std::pair{std::string("1 4 ") + kTwoMeshes, "the distribution of a mesh camera"},
        std::pair{std::string("1 0 ") + kTwoMeshes + "smooth", "smooth is for distribution 3"}}) {
    const std::string text = said("camera { mesh_camera { " + contents + " } }");
    EXPECT_NE(text.find(reason), std::string::npos) << text;
  }
}

TEST(Camera, ImpossibleOnesAreErrors) {
  EXPECT_EQ(said("camera { location 0 look_at 0 }"),
            "t.pov:2:21: error: the camera looks at its own location\n"
            "   2 | camera { location 0 look_at 0 }\n"
            "     |                     ^\n"
            "     = note: move location or look_at\n");
}

}  // namespace
}  // namespace dioptre::pov
