// SPDX-License-Identifier: Apache-2.0
// The parts of the grammar, as they call each other. Functions that read a block begin behind its
// keyword unless they say otherwise.
#pragma once

#include <optional>
#include <vector>

#include "dioptre/io/pov/parser.h"

namespace dioptre::pov {

/// The reserved word that is the next token, or kNotAKeyword.
Keyword keyword_at(Parser& parser);
/// The spelling of a reserved word.
std::string_view text_of(Keyword keyword);
/// Takes the next identifier if it stands for a T.
template <class T>
std::optional<T> take(Parser& parser) {
  const Described* described = parser.peek_described();
  if (!described || !std::holds_alternative<T>(*described)) return std::nullopt;
  return std::get<T>(*parser.take_described());
}
/// Appends a value unless it is the last one already: what a loop writes again and again is kept
/// once.
template <class T>
Id<T> append_once(std::vector<T>& values, T value) {
  if (!values.empty() && values.back() == value) {
    return {static_cast<std::uint32_t>(values.size() - 1)};
  }
  return append(values, std::move(value));
}
/// The next number as a whole one, cut to [low, high]; not a number counts as low.
std::int64_t parse_whole(Parser& parser, std::int64_t low, std::int64_t high);
/// A float without transparency.
Color parse_light_color(Parser& parser);

// --- transformations --------------------------------------------------------------------------
/// A run of translate, rotate, scale, matrix and transform, in order; nothing if none is next.
std::optional<Affine> parse_transforms(Parser& parser);
/// The block of `transform`.
Affine parse_transform_block(Parser& parser);

// --- objects ----------------------------------------------------------------------------------
/// What an object statement makes: a solid or sheet unless it is not drawn, and light sources.
struct Item {
  Object object;
  SourcePosition where;
  bool drawn = true;
  std::vector<Light> lights;
};
/// An object, light source or light group at its keyword or identifier; nothing if none is next.
std::optional<Item> parse_item(Parser& parser);
/// As parse_item, but fails if none is next.
Item parse_object(Parser& parser);
/// Moves an object with its textures and clips.
void transform_object(Parser& parser, Object& object, const Affine& by);
void transform_item(Parser& parser, Item& item, const Affine& by);
/// Modifiers up to the closing brace, which is taken.
void parse_object_modifiers(Parser& parser, Item& item);
/// A described value for a declaration.
Described to_described(Item item);
/// Puts an item into the world.
void add_root(Parser& parser, Item item);
/// Puts an object into the scene as a part of others.
ObjectId add_part(Parser& parser, Object object, SourcePosition where = {});
/// The container of isosurfaces and parametric surfaces, behind `contained_by`.
Container parse_container(Parser& parser);

/// The parameters of a shape, at the first one. False if the keyword is no shape.
bool parse_shape(Parser& parser, Keyword keyword, Item& item);
bool parse_composite_shape(Parser& parser, Keyword keyword, Item& item);
bool parse_curved_shape(Parser& parser, Keyword keyword, Item& item);
bool parse_function_shape(Parser& parser, Keyword keyword, Item& item);
bool parse_unrendered_shape(Parser& parser, Keyword keyword, Item& item);
/// The children of a union, merge, intersection or difference.
void parse_csg(Parser& parser, Keyword keyword, Item& item);
void parse_mesh(Parser& parser, Item& item);
void parse_mesh2(Parser& parser, Item& item);
void parse_blob(Parser& parser, Item& item);
/// linear_spline, quadratic_spline, cubic_spline or bezier_spline; nothing if none is next.
std::optional<OutlineSpline> parse_outline_spline(Parser& parser);
void parse_prism(Parser& parser, Item& item);
void parse_height_field(Parser& parser, Item& item);
BicubicPatch parse_bicubic_patch(Parser& parser);
JuliaFractal parse_julia_fractal(Parser& parser);

// --- lights, camera, surroundings ---------------------------------------------------------------
Item parse_light(Parser& parser);
Item parse_light_group(Parser& parser);
void transform_light(Light& light, const Affine& by);
Camera parse_camera(Parser& parser);
Fog parse_fog(Parser& parser);
Rainbow parse_rainbow(Parser& parser);
SkySphere parse_sky_sphere(Parser& parser);
void parse_background(Parser& parser);
void parse_global_settings(Parser& parser);

// --- textures -----------------------------------------------------------------------------------
/// The texture of objects without one, made if there is none yet.
TextureId default_texture(Parser& parser);
/// The block of `texture`.
TextureId parse_texture(Parser& parser);
TextureId parse_interior_texture(Parser& parser);
/// Blocks that begin as a copy of what is given.
PigmentId parse_pigment(Parser& parser, PigmentId base);
NormalId parse_normal(Parser& parser, NormalId base);
Finish parse_finish(Parser& parser, const Finish& base);
InteriorId parse_interior(Parser& parser, InteriorId base);
MaterialValue parse_material(Parser& parser, MaterialValue base);
/// `pigment`, `normal` or `finish` behind its keyword, changing one texture that has one layer.
TextureId change_texture(Parser& parser, Keyword keyword, TextureId texture);
/// The texture moved.
TextureId transformed(Parser& parser, TextureId texture, const Affine& by);
/// The layers of one texture over those of another.
TextureId layered(Parser& parser, TextureId below, TextureId above);

// --- unrendered blocks
// ----------------------------------------------------------------------------
void parse_media(Parser& parser);
void parse_density(Parser& parser);
void parse_density_map(Parser& parser);
void parse_photons(Parser& parser);
void parse_radiosity(Parser& parser);

}  // namespace dioptre::pov
