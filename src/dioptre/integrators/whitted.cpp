// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/whitted.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "dioptre/integrators/atmosphere.h"
#include "dioptre/integrators/spawn.h"
#include "dioptre/shading/attenuation.h"
#include "dioptre/shading/finish.h"

namespace dioptre {
namespace {

/// The mirror direction at a disturbed normal. A normal that faces away gives way to the true one,
/// and what would go below the surface is turned up again; on a smooth triangle the true one is the
/// interpolated normal, whatever the plane of the triangle (measured).
Vec3 mirror_direction(Vec3 direction, Vec3 normal, Vec3 true_normal) {
  if (dot(direction, normal) > 0) normal = true_normal;
  Vec3 mirrored = reflect(direction, normal);
  const double below = dot(mirrored, true_normal);
  if (below < 0) mirrored -= 2 * below * true_normal;
  return normalize(mirrored);
}

/// The share of the light from behind that comes through all layers.
Color filter_of(const TextureSample& sample, const TextureSample::Stack& stack) {
  Color filter{1, 1, 1};
  for (std::uint32_t i = 0; i < stack.count; ++i) {
    filter *= sample.layers[stack.first + i].pigment.transmittance();
  }
  return filter;
}

/// The index of refraction in what a ray was sent into last, for light of its place in the
/// spectrum.
double ior_in(const Scene& scene, const MediaStack& media, float position) {
  const InteriorId id = media.top();
  if (!id) return 1;
  const Interior& interior = at(scene.interiors, id);
  return position == kWhiteLight ? interior.ior : ior_of_color(interior, position);
}

/// What an interior leaves of the light that comes through its surface from behind, for a ray that
/// was inside for `distance` since the surface it met last. What the surface itself shines or
/// mirrors is not dimmed, nor is anything opaque inside (measured).
Color fading(const Scene& scene, const Part& part, const MediaStack& media, double distance) {
  if (!part.interior || !media.contains(MediaStack::entry(part, nullptr))) return {1, 1, 1};
  return attenuation(at(scene.interiors, part.interior), distance);
}

/// The index of refraction behind a surface over the one before it, for a ray inside `media`, as
/// far as Fresnel's law is concerned; 0 for a surface without an interior, and where a ray leaves a
/// solid within another one (measured).
double ior_behind(const Scene& scene, const Part& part, const MediaStack& media, float position) {
  if (!part.interior || !at(scene.interiors, part.interior).has_ior) return 0;
  MediaStack beyond = media;
  const MediaStack::Entry entry = MediaStack::entry(part, nullptr);
  if (beyond.contains(entry)) {
    beyond.leave(entry);
    if (!beyond.empty()) return 0;
  } else {
    beyond.enter(entry, false);
  }
  return ior_in(scene, beyond, position) / ior_in(scene, media, position);
}

/// What the exponent of a mirror makes of light, as a factor of each channel.
Color gain(const Finish& finish, Color light) {
  const Color soft = softened(finish, light);
  const auto ratio = [](float after, float before) { return before > 0 ? after / before : 0; };
  return {ratio(soft.r, light.r), ratio(soft.g, light.g), ratio(soft.b, light.b)};
}

/// Whether anything mirrors by Fresnel's law: then it counts which solids a ray is in, even hollow
/// ones that are filled with nothing.
bool any_fresnel(const Scene& scene) {
  return std::ranges::any_of(scene.textures, [](const Texture& texture) {
    const auto* layered = std::get_if<LayeredTexture>(&texture.data);
    return layered && std::ranges::any_of(layered->layers, [](const TextureLayer& layer) {
             return layer.finish.reflection_fresnel;
           });
  });
}

/// The rays of one path, each begun within the one before it: told to have ended when it is done.
class WatchedRays {
 public:
  explicit WatchedRays(RayObserver* observer) : observer_(observer) {}
  WatchedRays(const WatchedRays&) = delete;
  WatchedRays& operator=(const WatchedRays&) = delete;
  ~WatchedRays() {
    for (; observer_ && begun_ > 0; --begun_) observer_->end();
  }
  void go_on() { ++begun_; }
  void receive(LightTerm term, Color light) const {
    if (observer_) observer_->receive(term, light);
  }

 private:
  RayObserver* observer_;
  std::uint32_t begun_ = 1;
};

}  // namespace

/// Tells the observer, if there is one, of the ray that a path begins with. trace() ends it.
void Whitted::begin(RayKind kind, const Path& path, Color share, RayObserver* observer) const {
  if (!observer) return;
  observer->begin({kind, path.ray, share, path.level,
                   ior_in(scene_.scene(), path.media, path.spectral_position)});
}

/// What one thread needs at hand, by depth of recursion; grows once and stays.
struct Whitted::Scratch {
  std::vector<std::unique_ptr<TextureSample>> samples;
  std::uint32_t depth = 0;
  RayLog* log = nullptr;
};

Whitted::Whitted(const RenderScene& scene, const IntegratorOptions& options)
    : scene_(scene),
      local_(scene, options),
      sky_(scene),
      films_(scene.scene().settings),
      rainbows_(scene.scene()),
      has_fog_(!scene.scene().atmosphere.fogs.empty()),
      disperses_(std::ranges::any_of(scene.scene().interiors, dioptre::disperses)),
      reflections_(options.quality >= 8),
      attenuation_(options.attenuation) {
  if (scene.scene().camera.kind == Camera::Kind::kMesh) return;  // it has no one place
  const Vec3 eye = scene.scene().camera.location;
  const bool fresnel = any_fresnel(scene.scene());
  for (const Item& item : scene.items()) {
    const Part& part = scene.first_part(item);
    if ((part.interior || !item.hollow || fresnel) && item.shape->contains(eye)) {
      camera_media_.enter(MediaStack::entry(part, &item), item.hollow);
    }
  }
}

Radiance Whitted::radiance(const Ray& camera_ray, RayLog& log) const {
  thread_local Scratch scratch;
  scratch.depth = 0;
  scratch.log = &log;
  ++log.counts.camera;
  Path path;
  path.ray = camera_ray;
  path.media = camera_media_;
  path.reach = scene_.scene().camera.reach();
  begin(RayKind::kCamera, path, {1, 1, 1}, log.observer);
  return trace(path, scratch);
}

bool Whitted::may_spawn(Color weight, std::uint32_t level) const {
  const Settings& settings = scene_.scene().settings;
  return level < settings.max_trace_level &&
         max_component(abs(weight)) >= static_cast<float>(settings.adc_bailout);
}

/// Follows one ray through all surfaces it goes straight or bent through, moving `path` along; what
/// is mirrored on the way is traced by recursion.
Radiance Whitted::trace(Path& path, Scratch& scratch) const {
  if (scratch.samples.size() <= scratch.depth) {
    scratch.samples.push_back(std::make_unique<TextureSample>());
  }
  TextureSample& sample = *scratch.samples[scratch.depth];
  Color radiance, through{1, 1, 1};
  for (WatchedRays watched(scratch.log->observer);; watched.go_on()) {
    Hit hit;
    Color reached{1, 1, 1};  // what the way to the surface leaves
    const bool found = scratch.log->clock.time([&] {
      return scene_.nearest(path.ray, {0, path.reach}, path.purpose, hit, scratch.log->walks);
    });
    path.reach = kInfinity;
    const double distance = found ? hit.crossing.t : kInfinity;
    if (found && path.attenuation > 0) {
      const auto left = static_cast<float>(std::exp(-path.attenuation * distance));
      path.weight *= left, through *= left, reached *= left;
    }
    if (path.media.in_atmosphere()) {
      const auto cross = [&](const FogEffect& mist) {
        radiance += through * mist.added;
        watched.receive(LightTerm::kBackground, reached * mist.added);
        through *= mist.transmittance;
        reached *= mist.transmittance;
      };
      if (has_fog_) cross(fog_effect(scene_, path.ray, distance));
      if (!rainbows_.empty()) cross(rainbows_.effect(path.ray, distance));
    }
    if (!found) {
      const Color sky = sky_.radiance(path.ray.direction);
      radiance += through * sky;
      watched.receive(LightTerm::kBackground, reached * sky);
      return {radiance, 1 - max_component(through)};
    }
    const SurfaceInteraction at = see(scene_, path.ray, hit, sample);
    if (scratch.log->observer) scratch.log->observer->meet(hit, at, sample);

    bool goes_on = false;
    Path next;
    Color next_through;
    for (std::size_t i = 0; i < sample.stacks.size(); ++i) {
      const TextureSample::Stack stack = sample.stacks[i];
      const Vertex vertex{
          {at, sample, stack, path.ray.direction, reached * stack.weight, path.media}, path};
      Color transmitted = filter_of(sample, stack);
      const bool clear = reflections_ && !is_black(transmitted);
      const std::uint32_t colors = disperses_ && clear ? colors_behind(vertex) : 1;
      if (colors > 1) {
        bool mirrored = false;
        const Color behind = disperse(vertex, hit, colors, scratch, mirrored);
        radiance += through * stack.weight * (behind + shade(vertex, scratch, !mirrored));
        continue;
      }
      const Passage passage = !clear ? Passage::kNone : transmit(vertex, hit, transmitted, next);
      radiance += through * stack.weight * shade(vertex, scratch, passage != Passage::kMirrored);
      if (passage == Passage::kNone || is_black(transmitted)) continue;
      ++scratch.log->counts.transmitted;
      begin(RayKind::kTransmitted, next, vertex.share * transmitted, scratch.log->observer);
      if (i + 1 == sample.stacks.size()) {
        next_through = through * transmitted * stack.weight;
        goes_on = true;
      } else {
        ++scratch.depth;
        radiance += through * transmitted * stack.weight * trace(next, scratch).color;
        --scratch.depth;
      }
    }
    if (!goes_on) return {radiance, 1};
    path = next;
    through = next_through;
  }
}

/// Takes the path on through a surface that filters light by `transmitted`, which becomes the share
/// of the light behind it that the path brings back.
Whitted::Passage Whitted::transmit(const Vertex& vertex, const Hit& hit, Color& transmitted,
                                   Path& next) const {
  const Path& path = vertex.path;
  transmitted *= left_by_mirrors(vertex);
  const Color weight = path.weight * transmitted * vertex.stack.weight;
  if (!may_spawn(weight, path.level)) return Passage::kNone;
  next = path;
  next.weight = weight;
  next.attenuation = attenuation_.transmitted;
  const Vec3 normal = vertex.sample.layers[vertex.stack.first].normal;
  const Passage passage = pass(vertex.at, hit, normal, next);
  if (passage == Passage::kMirrored) {
    transmitted = film_tint(vertex.layer(0), vertex.at, path.ray.direction, next.ray.direction);
  }
  transmitted *= fading(scene_.scene(), *vertex.at.part, path.media, hit.crossing.t);
  return passage;
}

/// What mirrors that conserve energy leave to the light that comes through. It counts in the weight
/// of the ray too, and total reflection by Fresnel's law leaves nothing (measured).
Color Whitted::left_by_mirrors(const Vertex& vertex) const {
  const Path& path = vertex.path;
  Color left{1, 1, 1};
  for (std::uint32_t i = 0; i < vertex.stack.count; ++i) {
    const SurfaceLayer& layer = vertex.layer(i);
    if (!layer.finish->conserve_energy || !mirrors(layer)) continue;
    const double ior =
        ior_behind(scene_.scene(), *vertex.at.part, path.media, path.spectral_position);
    left *= Color{1, 1, 1} - reflectance(layer, path.ray.direction, ior);
  }
  return left;
}

/// The light of one stack of layers by itself and, `with_mirrors`, by its mirrors.
Color Whitted::shade(const Vertex& vertex, Scratch& scratch, bool with_mirrors) const {
  const Part& part = *vertex.at.part;
  Color radiance = local_.at(vertex, *scratch.log);
  for (std::uint32_t i = 0; i < vertex.stack.count && with_mirrors && reflections_; ++i) {
    const SurfaceLayer& layer = vertex.layer(i);
    if (!mirrors(layer)) continue;
    const double ior =
        ior_behind(scene_.scene(), part, vertex.path.media, vertex.path.spectral_position);
    const Color share = reflectance(layer, vertex.path.ray.direction, ior);
    if (!is_black(share)) radiance += mirrored(vertex, layer, share, scratch);
  }
  return radiance;
}

/// What a mirror sends back: its share of the light that it sees, changed by the finish's exponent;
/// black where the ray would count for too little.
Color Whitted::mirrored(const Vertex& vertex, const SurfaceLayer& layer, Color share,
                        Scratch& scratch) const {
  const Path& path = vertex.path;
  Path mirrored = path;
  mirrored.weight = path.weight * (share * vertex.stack.weight);
  if (!may_spawn(mirrored.weight, path.level)) return {};
  const Vec3 normal = vertex.at.surface.shading_normal;
  mirrored.ray = spawn_ray(vertex.at, mirror_direction(path.ray.direction, layer.normal, normal));
  share *= film_tint(layer, vertex.at, path.ray.direction, mirrored.ray.direction);
  mirrored.level = path.level + 1;
  mirrored.attenuation = attenuation_.reflected;
  mirrored.purpose = RayPurpose::kReflection;
  const bool soft = layer.finish->reflection_exponent != 1;
  Color told = share;
  if (soft && scratch.log->observer) told *= gain(*layer.finish, seen(mirrored, scratch));
  ++scratch.log->counts.reflected;
  begin(RayKind::kReflected, mirrored, vertex.share * told, scratch.log->observer);
  ++scratch.depth;
  const Color radiance = trace(mirrored, scratch).color;
  --scratch.depth;
  return share * (soft ? softened(*layer.finish, radiance) : radiance);
}

/// The light along a path, looked at without telling the observer.
Color Whitted::seen(Path path, Scratch& scratch) const {
  RayLog unwatched;
  RayLog* const log = std::exchange(scratch.log, &unwatched);
  ++scratch.depth;
  const Color radiance = trace(path, scratch).color;
  --scratch.depth;
  scratch.log = log;
  return radiance;
}

/// What the film on a layer, if there is one, does to light that is mirrored.
Color Whitted::film_tint(const SurfaceLayer& layer, const SurfaceInteraction& at, Vec3 from,
                         Vec3 to) const {
  if (layer.finish->irid == 0) return {1, 1, 1};
  return films_.tint(*layer.finish, at.surface.position, dot(layer.normal, to - from));
}

/// Into how many colours the light splits that comes through a surface; 1 if it stays together, as
/// light of one colour does.
std::uint32_t Whitted::colors_behind(const Vertex& vertex) const {
  if (vertex.path.spectral_position != kWhiteLight) return 1;
  const Scene& scene = scene_.scene();
  for (const InteriorId id : {vertex.at.part->interior, vertex.path.media.top()}) {
    if (id && disperses(at(scene.interiors, id))) return at(scene.interiors, id).dispersion_samples;
  }
  return 1;
}

/// The light behind a surface, its colours looked for each in its own direction. Tells whether the
/// surface mirrors all of one of them.
Color Whitted::disperse(const Vertex& vertex, const Hit& hit, std::uint32_t colors,
                        Scratch& scratch, bool& mirrored) const {
  Color radiance;
  for (std::uint32_t i = 0; i < colors; ++i) {
    const Color share = color_share(i, colors);
    Path path = vertex.path;
    path.spectral_position = (static_cast<float>(i) + 0.5f) / static_cast<float>(colors);
    const Vertex colored{vertex, path};
    Path next;
    Color transmitted = filter_of(vertex.sample, vertex.stack);
    const Passage passage = transmit(colored, hit, transmitted, next);
    mirrored |= passage == Passage::kMirrored;
    transmitted *= share;
    if (passage == Passage::kNone || is_black(transmitted)) continue;
    next.weight *= share;
    ++scratch.log->counts.transmitted;
    begin(RayKind::kTransmitted, next, vertex.share * transmitted, scratch.log->observer);
    ++scratch.depth;
    radiance += transmitted * trace(next, scratch).color;
    --scratch.depth;
  }
  return radiance;
}

/// Sends the path on through the surface: straight, bent by Snell's law, or mirrored where nothing
/// can leave. All the light is mirrored then, whatever the texture filters or mirrors itself
/// (measured); the weight is still that of what is filtered.
Whitted::Passage Whitted::pass(const SurfaceInteraction& at, const Hit& hit, Vec3 normal,
                               Path& path) const {
  const MediaStack::Entry entry = MediaStack::entry(*at.part, hit.item);
  const double before = ior_in(scene_.scene(), path.media, path.spectral_position);
  MediaStack beyond = path.media;
  if (beyond.contains(entry)) {
    beyond.leave(entry);
  } else if (hit.item->shape->solid()) {
    beyond.enter(entry, hit.item->hollow);
  }
  const double ratio = before / ior_in(scene_.scene(), beyond, path.spectral_position);
  if (ratio == 1) {
    path.ray = spawn_ray(at, path.ray.direction);
    path.media = beyond;
    return Passage::kThrough;
  }
  ++path.level;
  if (const auto refracted = refract(path.ray.direction, normal, ratio)) {
    path.ray = spawn_ray(at, *refracted);
    path.media = beyond;
    return Passage::kThrough;
  }
  path.ray = spawn_ray(at, mirror_direction(path.ray.direction, normal, at.surface.shading_normal));
  return Passage::kMirrored;
}

}  // namespace dioptre
