// SPDX-License-Identifier: Apache-2.0
// camera { ... }
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

/// The most rays of a mesh camera's pixel.
constexpr std::int64_t kMostRays = 1 << 20;

/// Where a camera without look_at looks.
constexpr Vec3 kDefaultTarget{0, 0, 1};

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Reads the contents of one camera. Angle and look_at act on the vectors as they are at the end,
/// and after them all transforms, wherever they stand (measured).
class CameraParser {
 public:
  CameraParser(Parser& parser, Camera& camera) : parser_(parser), camera_(camera) {}

  /// Up to the closing brace, which is taken.
  void parse() {
    while (!parser_.accept('}')) {
      if (parser_.accept(',')) continue;
      if (const auto named = take<Camera>(parser_)) {
        camera_ = *named;
        finished_ = true;
      } else if (const auto by = parse_transforms(parser_)) {
        transform_ = then(transform_, *by);
      } else if (!parse_kind() && !parse_vectors() && !parse_lens()) {
        parser_.fail_expected("a camera modifier or '}'");
      }
    }
    if (!finished_) finish();
    transform(transform_);
  }

 private:
  using Kind = Camera::Kind;

  bool kind(Kind kind) {
    parser_.next();
    camera_.kind = kind;
    return true;
  }

  bool parse_kind() {
    switch (keyword_at(parser_)) {
      case Keyword::kPerspective:
        return kind(Kind::kPerspective);
      case Keyword::kOrthographic:
        return kind(Kind::kOrthographic);
      case Keyword::kFisheye:
        return kind(Kind::kFisheye);
      case Keyword::kUltraWideAngle:
        return kind(Kind::kUltraWideAngle);
      case Keyword::kOmnimax:
        return kind(Kind::kOmnimax);
      case Keyword::kPanoramic:
        return kind(Kind::kPanoramic);
      case Keyword::kSpherical:
        return kind(Kind::kSpherical);
      case Keyword::kCylinder:
        kind(Kind::kCylinder);
        camera_.cylinder_type = static_cast<std::uint32_t>(parse_whole(parser_, 1, 4));
        return true;
      case Keyword::kMeshCamera:
        parse_mesh_camera();
        return true;
      default:
        return false;
    }
  }

  /// mesh_camera { RAYS, DISTRIBUTION [, MAX_DISTANCE] mesh {...} ... [smooth] }
  void parse_mesh_camera() {
    const Parser::Nesting nesting(parser_);
    kind(Kind::kMesh);
    MeshCamera& mesh = camera_.mesh = {};
    parser_.expect('{', "to begin the camera's meshes");
    mesh.rays_per_pixel = static_cast<std::uint32_t>(parse_whole(parser_, 1, kMostRays));
    parser_.skip_comma();
    mesh.distribution = static_cast<MeshCamera::Distribution>(parse_distribution());
    parser_.skip_comma();
    if (parser_.at_expression()) mesh.max_distance = std::max(0.0, parser_.parse_float());
    while (!parser_.accept('}')) {
      if (parser_.accept(Keyword::kSmooth)) {
        mesh.smooth = true;
      } else if (!parser_.accept(',')) {
        parse_camera_mesh();
      }
    }
    check_mesh_camera();
  }

  std::int64_t parse_distribution() {
    const SourcePosition where = parser_.position();
    const std::int64_t number = parse_whole(parser_, -1, 4);
    if (number < 0 || number > 3) {
      parser_.fail_at(where, "the distribution of a mesh camera must be 0 to 3");
    }
    return number;
  }

  void parse_camera_mesh() {
    const SourcePosition where = parser_.position();
    const Item item = parse_object(parser_);
    const auto* shape = std::get_if<ShapeData>(&item.object.geometry);
    const Mesh* mesh = shape ? std::get_if<Mesh>(shape) : nullptr;
    if (!mesh) parser_.fail_at(where, "a mesh camera looks out of meshes only");
    camera_.mesh.meshes.push_back({mesh->data, item.object.transform});
  }

  void check_mesh_camera() {
    const MeshCamera& mesh = camera_.mesh;
    using Distribution = MeshCamera::Distribution;
    if (mesh.meshes.empty()) parser_.fail("the mesh camera has no mesh");
    if (mesh.distribution == Distribution::kEach && mesh.rays_per_pixel > mesh.meshes.size()) {
      parser_.fail("with distribution 0 there must be a mesh for each ray of a pixel");
    }
    if (mesh.distribution >= Distribution::kSideBySide && mesh.rays_per_pixel > 1) {
      parser_.fail("distributions 2 and 3 have one ray per pixel");
    }
    if (mesh.smooth && mesh.distribution != Distribution::kUv) {
      parser_.fail("smooth is for distribution 3");
    }
  }

  bool vector(Vec3& value) {
    parser_.next();
    value = parser_.parse_vec3();
    return true;
  }
  bool number(double& value) {
    parser_.next();
    value = parser_.parse_float();
    return true;
  }

  bool parse_vectors() {
    switch (keyword_at(parser_)) {
      case Keyword::kLocation:
        return vector(camera_.location);
      case Keyword::kDirection:
        return vector(camera_.direction);
      case Keyword::kRight:
        has_size_ = true;
        return vector(camera_.right);
      case Keyword::kUp:
        has_size_ = true;
        return vector(camera_.up);
      case Keyword::kSky:
        return vector(camera_.sky);
      case Keyword::kLookAt:
        look_at_place_ = parser_.position();
        return vector(look_at_.emplace());
      case Keyword::kAngle:
        return parse_angle();
      default:
        return false;
    }
  }

  bool parse_angle() {
    const SourcePosition where = parser_.next().position;
    camera_.angle = parser_.parse_float();
    if (camera_.kind == Kind::kSpherical && (parser_.accept(',') || parser_.at_expression())) {
      camera_.vertical_angle = parser_.parse_float();
    }
    angle_at_ = where;
    has_angle_ = true;
    return true;
  }

  bool parse_lens() {
    switch (keyword_at(parser_)) {
      case Keyword::kAperture:
        return number(camera_.aperture);
      case Keyword::kFocalPoint:
        return vector(focal_point_.emplace());
      case Keyword::kBlurSamples:
        parser_.next();
        camera_.blur_samples = samples();
        if (parser_.accept(',')) {
          camera_.blur_samples_min = camera_.blur_samples;
          camera_.blur_samples = samples();
        }
        return true;
      case Keyword::kConfidence:
        return number(camera_.confidence);
      case Keyword::kVariance:
        return number(camera_.variance);
      case Keyword::kBokeh:
        parser_.next();
        parse_bokeh();
        return true;
      case Keyword::kNormal:
        parser_.next();
        camera_.normal = parse_normal(parser_, camera_.normal);
        return true;
      default:
        return false;
    }
  }

  std::uint32_t samples() { return static_cast<std::uint32_t>(parse_whole(parser_, 0, 1 << 20)); }

  void parse_bokeh() {
    const Parser::Nesting nesting(parser_);
    parser_.not_rendered("bokeh");
    parser_.expect('{', "after bokeh");
    if (!parser_.accept(Keyword::kPigment)) parser_.fail_expected("pigment");
    parse_pigment(parser_, {});
    parser_.expect('}', "after the pigment");
  }

  void finish() {
    if (has_angle_) apply_angle();
    if (camera_.kind == Kind::kOrthographic) fit_orthographic();
    if (look_at_) apply_look_at(*look_at_);
    if (focal_point_) apply_focus(*focal_point_);
  }

  /// The horizontal angle of view decides the length of the direction.
  void apply_angle() {
    const bool by_length =
        camera_.kind == Kind::kPerspective || camera_.kind == Kind::kOrthographic;
    if (!by_length) return;
    if (!(camera_.angle > 0 && camera_.angle < 180)) {
      parser_.fail_at(angle_at_, "the angle of the camera must be between 0 and 180 degrees");
    }
    const double size = length(camera_.direction);
    if (size == 0) return;
    const double wanted = 0.5 * length(camera_.right) / std::tan(radians(camera_.angle) / 2);
    camera_.direction *= wanted / size;
  }

  /// The image of an orthographic camera is as wide as the view of a perspective one is at the
  /// place looked at, unless its size is given by right or up and not by an angle.
  void fit_orthographic() {
    if (has_size_ && !has_angle_) return;
    const double size = length(camera_.direction);
    const double distance = length(look_at_.value_or(kDefaultTarget) - camera_.location);
    if (size == 0 || distance == 0) return;
    camera_.right *= distance / size;
    camera_.up *= distance / size;
  }

  void apply_look_at(Vec3 target) {
    const Vec3 towards = target - camera_.location;
    const double distance = length(towards);
    if (distance == 0) {
      parser_.fail_at(look_at_place_, "the camera looks at its own location",
                      "move location or look_at");
    }
    const bool mirrored = dot(cross(camera_.up, camera_.direction), camera_.right) <= 0;
    const double right_length = length(camera_.right);
    const double up_length = length(camera_.up);
    const double direction_length = length(camera_.direction);
    const Vec3 forward = towards / distance;
    Vec3 right = cross(camera_.sky, forward);
    if (length(right) == 0) {
      parser_.warn("the camera looks along its sky vector");
      right = camera_.right - dot(camera_.right, forward) * forward;
      if (length(right) == 0) right = cross(Vec3{forward.y, forward.z, forward.x}, forward);
      if (length(right) == 0) right = cross(Vec3{1, 0, 0}, forward);
    }
    right = normalize(right);
    const Vec3 up = cross(forward, right);
    camera_.direction = forward * direction_length;
    camera_.right = right * (mirrored ? -right_length : right_length);
    camera_.up = up * up_length;
  }

  void apply_focus(Vec3 point) {
    const double size = length(camera_.direction);
    if (size == 0) return;
    camera_.focal_distance = dot(point - camera_.location, camera_.direction) / size;
  }

  void transform(const Affine& by) {
    camera_.location = by.point(camera_.location);
    camera_.direction = by.vector(camera_.direction);
    camera_.right = by.vector(camera_.right);
    camera_.up = by.vector(camera_.up);
    // The z of location and direction alone count, as they are at the end (measured).
    if (camera_.kind != Kind::kMesh) return;
    camera_.mesh.offset = camera_.location.z;
    camera_.mesh.backwards = camera_.direction.z < 0;
  }

  Parser& parser_;
  Camera& camera_;
  Affine transform_;
  std::optional<Vec3> look_at_, focal_point_;
  bool has_angle_ = false;
  bool finished_ = false;  ///< a copy of a named camera: its vectors are final
  bool has_size_ = false;  ///< right or up was written
  SourcePosition angle_at_, look_at_place_;
};

bool has_direction(Vec3 v) { return length(v) > 0 && is_finite(v) && std::isfinite(length(v)); }

/// Refuses a camera through which nothing can be seen.
void check(Parser& parser, const Camera& camera, SourcePosition where) {
  if (camera.kind == Camera::Kind::kMesh) return;
  if (!is_finite(camera.location)) {
    parser.fail_at(where, "the location of the camera is not finite");
  }
  for (const auto& [vector, name] :
       {std::pair{camera.direction, "direction"}, std::pair{camera.right, "right"},
        std::pair{camera.up, "up"}}) {
    if (has_direction(vector)) continue;
    parser.fail_at(where, std::string("the ") + name + " vector of the camera has no direction",
                   "its length must be finite and not 0");
  }
  const Vec3 across = cross(normalize(camera.right), normalize(camera.up));
  if (std::abs(dot(normalize(camera.direction), across)) < 1e-12) {
    parser.fail_at(where, "the direction, right and up vectors of the camera lie in one plane",
                   "right points to the right of the picture, up to its top");
  }
  if (camera.aperture > 0 && !(camera.focal_distance > 0 && std::isfinite(camera.focal_distance))) {
    parser.fail_at(where, "the focal point must lie in front of the camera");
  }
  if (!(camera.aperture >= 0 && std::isfinite(camera.aperture))) {
    parser.fail_at(where, "the aperture of the camera must be a number of at least 0");
  }
  if (!std::isfinite(camera.angle) || !std::isfinite(camera.vertical_angle)) {
    parser.fail_at(where, "the angle of the camera is not finite");
  }
}

}  // namespace

Camera parse_camera(Parser& parser) {
  const Parser::Nesting nesting(parser);
  const SourcePosition where = parser.position();
  parser.expect('{', "after camera");
  Camera camera;
  CameraParser(parser, camera).parse();
  check(parser, camera, where);
  return camera;
}

}  // namespace dioptre::pov
