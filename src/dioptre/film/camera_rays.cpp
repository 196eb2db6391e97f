// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dioptre {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

/// The unit vector along v, or nothing if there is none.
std::optional<Vec3> unit(Vec3 v) {
  const double l = length(v);
  if (!std::isfinite(l) || l <= 0) return std::nullopt;
  const Vec3 n = v / l;
  if (!is_finite(n) || length_squared(n) < 0.5) return std::nullopt;
  return n;
}

/// The angle from the axis at a distance from the centre of an OMNIMAX frame of radius 1, radians
/// (Max 1983, "Computer graphics distortion for IMAX and OMNIMAX projection").
double omnimax_angle(double r) {
  const double r2 = r * r;
  return r * (1.411269 + r2 * (-0.09439 + r2 * 0.25674));
}

/// A place of the image in the disc of an OMNIMAX frame. A wide image shows the top of the disc and
/// cuts its bottom off, at most down to 45 degrees under the axis.
Vec2 omnimax_frame(Vec2 at, double aspect) {
  constexpr double kRadiusOf45Degrees = 0.558286;
  const double half_height = std::max(1 / aspect, (1 + kRadiusOf45Degrees) / 2);
  return {2 * at.x * aspect * half_height, 2 * at.y * half_height + std::max(0.0, 1 - half_height)};
}

}  // namespace

CameraRays::CameraRays(const Camera& camera)
    : camera_(camera),
      forward_(normalize(camera.direction)),
      right_(normalize(camera.right)),
      up_(normalize(camera.up)),
      right_length_(length(camera.right)),
      up_length_(length(camera.up)) {
  if (camera_.angle == 0) camera_.angle = camera_.kind == Camera::Kind::kSpherical ? 360 : 180;
  if (camera_.vertical_angle == 0) camera_.vertical_angle = camera_.angle / 2;
}

Result<CameraRays> CameraRays::prepare(const Camera& camera) {
  if (camera.kind == Camera::Kind::kMesh) {
    auto mesh = MeshRays::prepare(camera.mesh);
    if (!mesh) return tl::unexpected(mesh.error());
    CameraRays rays(camera);
    rays.mesh_ = std::move(*mesh);
    return rays;
  }
  if (!is_finite(camera.location)) return fail("the camera's location is not finite");
  const auto forward = unit(camera.direction), right = unit(camera.right), up = unit(camera.up);
  if (!forward) return fail("the camera's direction has no length");
  if (!right) return fail("the camera's right vector has no length");
  if (!up) return fail("the camera's up vector has no length");
  if (std::fabs(dot(*forward, cross(*right, *up))) < 1e-12) {
    return fail("the camera's direction, right and up vectors lie in one plane");
  }
  if (!std::isfinite(camera.angle) || !std::isfinite(camera.vertical_angle)) {
    return fail("the camera's angle is not finite");
  }
  if (!std::isfinite(camera.aperture) || camera.aperture < 0) {
    return fail("the camera's aperture must be a number of at least 0");
  }
  if (camera.aperture > 0 && !(std::isfinite(camera.focal_distance) && camera.focal_distance > 0)) {
    return fail("the camera's focal point must lie in front of it");
  }
  if (camera.kind == Camera::Kind::kCylinder &&
      (camera.cylinder_type < 1 || camera.cylinder_type > 4)) {
    return fail("the camera's cylinder type must be 1 to 4");
  }
  return CameraRays(camera);
}

std::optional<Ray> CameraRays::ray(double x, double y, std::uint32_t width, std::uint32_t height,
                                   Vec2 lens, std::uint32_t number) const {
  if (mesh_) return mesh_->ray(x, y, width, height, number);
  const double across = x / width - 0.5, upwards = 0.5 - y / height;
  if (!has_lens()) return pinhole(across, upwards);
  const std::optional<Ray> sharp = pinhole(across, upwards);
  return sharp ? through_lens(*sharp, lens) : std::nullopt;
}

/// `x` and `y` are the place on the image from its centre, in widths to the right and heights
/// upwards.
std::optional<Ray> CameraRays::pinhole(double x, double y) const {
  if (camera_.kind == Camera::Kind::kPerspective) {
    return Ray{camera_.location, normalize(camera_.direction + x * camera_.right + y * camera_.up)};
  }
  const Vec2 at{x, y};
  const double angle = camera_.angle * kRadians;
  const auto along = [&](double right, double up, double forward) {
    return normalize(right * right_ + up * up_ + forward * forward_);
  };
  const Vec3 eye = camera_.location;
  switch (camera_.kind) {
    case Camera::Kind::kPerspective:
    case Camera::Kind::kMesh:
      break;
    case Camera::Kind::kOrthographic:
      return Ray{eye + at.x * camera_.right + at.y * camera_.up, forward_};
    case Camera::Kind::kFisheye: {
      const Vec2 p{2 * at.x * right_length_, 2 * at.y * up_length_};
      const double r = length(p);
      if (r > 1) return std::nullopt;
      if (r == 0) return Ray{eye, forward_};
      const double theta = r * angle / 2, s = std::sin(theta) / r;
      return Ray{eye, along(s * p.x, s * p.y, std::cos(theta))};
    }
    case Camera::Kind::kUltraWideAngle: {
      const double a = at.x * angle, b = at.y * angle * up_length_ / right_length_;
      return Ray{eye, along(std::sin(a), std::sin(b), std::cos(a) * std::cos(b))};
    }
    case Camera::Kind::kOmnimax: {
      const Vec2 p = omnimax_frame(at, right_length_ / up_length_);
      const double r = length(p);
      if (r > 1) return std::nullopt;
      if (r == 0) return Ray{eye, forward_};
      const double theta = omnimax_angle(r), s = std::sin(theta) / r;
      // The film ends 45 degrees below the horizon: what is further down is black (measured).
      if (s * p.y < -std::cos(theta)) return std::nullopt;
      return Ray{eye, along(s * p.x, s * p.y, std::cos(theta))};
    }
    case Camera::Kind::kPanoramic: {
      const double a = at.x * std::numbers::pi, b = at.y * std::numbers::pi;
      return Ray{eye, along(right_length_ * std::cos(b) * std::sin(a), up_length_ * std::sin(b),
                            std::cos(b) * std::cos(a))};
    }
    case Camera::Kind::kCylinder: {
      const bool vertical = camera_.cylinder_type % 2 == 1;
      const double turn = (vertical ? at.x : at.y) * angle;
      const double along_axis = vertical ? at.y * up_length_ : at.x * right_length_;
      const Vec3 axis = vertical ? up_ : right_;
      const Vec3 across = std::sin(turn) * (vertical ? right_ : up_) + std::cos(turn) * forward_;
      if (camera_.cylinder_type > 2) return Ray{eye + along_axis * axis, normalize(across)};
      return Ray{eye, normalize(across + along_axis * axis)};
    }
    case Camera::Kind::kSpherical: {
      const double a = at.x * angle, b = at.y * camera_.vertical_angle * kRadians;
      return Ray{eye, along(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a))};
    }
  }
  return std::nullopt;
}

/// Moves the origin over the aperture and aims at the point that is in focus.
std::optional<Ray> CameraRays::through_lens(const Ray& pinhole, Vec2 lens) const {
  const double ahead = dot(pinhole.direction, forward_);
  if (ahead <= 0) return pinhole;
  const Vec3 focus = pinhole.at(camera_.focal_distance / ahead);
  const Vec2 offset = camera_.aperture / 2 * (lens - Vec2{0.5, 0.5});
  const Vec3 origin = pinhole.origin + offset.x * right_ + offset.y * up_;
  return Ray{origin, normalize(focus - origin)};
}

}  // namespace dioptre
