// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/color.h"
#include "dioptre/scene/finish.h"
#include "dioptre/shading/fresnel.h"
#include "dioptre/shading/texture_evaluator.h"

namespace dioptre {

/// The directions at a point that one light shines on; all unit.
struct LightGeometry {
  Vec3 normal;  ///< facing the viewer
  Vec3 to_viewer;
  Vec3 to_light;
};

/// What a layer sends out by itself: ambient and emission.
Color glow(const SurfaceLayer& layer, Color ambient_light);

/// What a layer sends to the viewer of a light of intensity 1.
struct ReflectedLight {
  Color diffuse, highlights;
  Color sum() const { return diffuse + highlights; }
};

/// Shades a layer. `double_illuminate` shows light from behind as if it came from the front;
/// `no_highlights` leaves the highlights out.
ReflectedLight reflected_light(const SurfaceLayer& layer, const LightGeometry& geometry,
                               bool double_illuminate, bool no_highlights);

/// Whether a layer can mirror anything.
inline bool mirrors(const SurfaceLayer& layer) {
  return !is_black(layer.finish->reflection_max) || !is_black(layer.finish->reflection_min);
}

/// The share of the mirrored light that a layer adds, seen along `direction`. `ior` is the index of
/// refraction behind the surface over the one before it (for `fresnel`).
Color reflectance(const SurfaceLayer& layer, Vec3 direction, double ior);

/// Mirrored light as `exponent` changes it: to the power of its inverse (measured).
Color softened(const Finish& finish, Color seen);

/// The diffuse term of a finish for cos = N.L > 0: d cos^brilliance, times (brilliance + 1) / 2 if
/// the amount is an albedo.
double diffuse_term(const Finish& finish, double amount, double cosine);

/// p max(0, R.V)^size (B. T. Phong, "Illumination for Computer Generated Pictures", 1975), times
/// (size + 1) / 2 if the amount is an albedo. `cosine` is R.V.
double phong_term(const Finish& finish, double cosine);

/// s max(0, N.H)^(1/roughness) (J. F. Blinn, "Models of Light Reflection for Computer Synthesized
/// Pictures", 1977), times (1/roughness + 2) / 8 if the amount is an albedo. `cosine` is N.H.
double specular_term(const Finish& finish, double cosine);

/// What metals tint their highlights and mirrors with: the pigment, turning white at grazing
/// angles; `cosine` is that of the angle to the normal, `amount` the finish's `metallic`.
Color metallic_tint(Color pigment, double amount, double cosine);

}  // namespace dioptre
