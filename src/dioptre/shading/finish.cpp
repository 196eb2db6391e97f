// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/finish.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "dioptre/core/rng.h"

namespace dioptre {
namespace {

constexpr Color kWhite{1, 1, 1};

/// A number in [0, 1) that changes from point to point and does not depend on anything else.
double grain(const LightGeometry& g) {
  std::uint64_t bits = mix_bits(std::bit_cast<std::uint64_t>(g.to_viewer.x));
  bits = mix_bits(bits ^ std::bit_cast<std::uint64_t>(g.to_viewer.y));
  bits = mix_bits(bits ^ std::bit_cast<std::uint64_t>(g.to_light.x));
  return to_unit(mix_bits(bits ^ std::bit_cast<std::uint64_t>(g.to_light.y)));
}

Color diffuse(const SurfaceLayer& layer, const LightGeometry& g, double n_dot_l,
              bool double_illuminate) {
  const Finish& finish = *layer.finish;
  const bool front = n_dot_l > 0 || double_illuminate;
  const double amount = front ? finish.diffuse : finish.diffuse_back;
  if (amount == 0) return {};
  double term = diffuse_term(finish, amount, std::fabs(n_dot_l));
  // The grain is as strong on a dark surface as on a bright one (measured).
  if (finish.crand > 0) term = std::max(0.0, term - finish.crand * grain(g));
  return layer.pigment.color * (static_cast<float>(term) * layer.opacity());
}

Color highlights(const SurfaceLayer& layer, const LightGeometry& g, double n_dot_l) {
  const Finish& finish = *layer.finish;
  double term = 0;
  if (finish.phong > 0) {
    term += phong_term(finish, dot(reflect(-g.to_viewer, g.normal), g.to_light));
  }
  if (finish.specular > 0) {
    const Vec3 half = g.to_light + g.to_viewer;
    const double size = length(half);
    if (size > 0) term += specular_term(finish, dot(half, g.normal) / size);
  }
  if (term == 0) return {};
  return metallic_tint(layer.pigment.color, finish.metallic, n_dot_l) * static_cast<float>(term);
}

}  // namespace

Color glow(const SurfaceLayer& layer, Color ambient_light) {
  const Finish& finish = *layer.finish;
  return (finish.ambient * ambient_light + finish.emission) * layer.pigment.color * layer.opacity();
}

ReflectedLight reflected_light(const SurfaceLayer& layer, const LightGeometry& geometry,
                               bool double_illuminate, bool no_highlights) {
  const double n_dot_l = dot(geometry.normal, geometry.to_light);
  ReflectedLight light;
  if (n_dot_l == 0) return light;
  light.diffuse = diffuse(layer, geometry, n_dot_l, double_illuminate);
  if (n_dot_l > 0 && !no_highlights) light.highlights = highlights(layer, geometry, n_dot_l);
  return light;
}

Color reflectance(const SurfaceLayer& layer, Vec3 direction, double ior) {
  if (!mirrors(layer)) return {};
  const Finish& finish = *layer.finish;
  const double cosine = std::clamp(-dot(direction, layer.normal), 0.0, 1.0);
  Color share = finish.reflection_min;
  if (finish.reflection_max != finish.reflection_min) {
    const double grazing = finish.reflection_fresnel
                               ? fresnel_reflectance(cosine, ior)
                               : std::pow(1 - cosine, finish.reflection_falloff);
    share += (finish.reflection_max - finish.reflection_min) * static_cast<float>(grazing);
  }
  return share * metallic_tint(layer.pigment.color, finish.reflection_metallic, cosine);
}

Color softened(const Finish& finish, Color seen) {
  const double power = 1 / finish.reflection_exponent;
  const auto soft = [&](float v) {
    return v > 0 ? static_cast<float>(std::pow(static_cast<double>(v), power)) : 0.0f;
  };
  return {soft(seen.r), soft(seen.g), soft(seen.b)};
}

double diffuse_term(const Finish& finish, double amount, double cosine) {
  const double brilliance = finish.brilliance;
  const double term = amount * (brilliance == 1 ? cosine : std::pow(cosine, brilliance));
  return finish.diffuse_albedo ? term * (brilliance + 1) / 2 : term;
}

double phong_term(const Finish& finish, double cosine) {
  if (!(cosine > 0)) return 0;
  const double term = finish.phong * std::pow(cosine, finish.phong_size);
  return finish.phong_albedo ? term * (finish.phong_size + 1) / 2 : term;
}

double specular_term(const Finish& finish, double cosine) {
  if (!(cosine > 0)) return 0;
  const double power = finish.roughness == 0 ? 0 : 1 / finish.roughness;  // (measured)
  const double term = finish.specular * std::pow(cosine, power);
  return finish.specular_albedo ? term * (power + 2) / 8 : term;
}

Color metallic_tint(Color pigment, double amount, double cosine) {
  if (amount == 0) return kWhite;
  const double x = 2 / std::numbers::pi * std::acos(std::clamp(cosine, 0.0, 1.0));
  const double from_pole = x - 1.12;
  const double grazing = 0.014567 / (from_pole * from_pole) - 0.011612;
  const Color tint = pigment + (kWhite - pigment) * static_cast<float>(grazing);
  return kWhite + (tint - kWhite) * static_cast<float>(amount);
}

}  // namespace dioptre
