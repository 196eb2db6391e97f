// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "dioptre/io/pov/language_test_support.h"

namespace dioptre::pov {

/// The scene of a program, in version 3.7; an empty one, and a failed test, if there is none.
inline Scene scene_of(const std::string& program) {
  Diagnostics diagnostics;
  NoQueries queries;
  auto loaded = load_pov_text("t.pov", "#version 3.7;\n" + program, {}, queries, diagnostics);
  if (loaded) return std::move(loaded->scene);
  ADD_FAILURE() << said(program);
  return {};
}

/// The only object of a program that stands in the world.
inline Object root_of(const std::string& program) {
  const Scene scene = scene_of(program);
  EXPECT_EQ(scene.roots.size(), 1u) << program;
  return scene.roots.empty() ? Object{} : at(scene.objects, scene.roots[0]);
}

/// The shape of that object.
template <class Shape>
Shape shape_of(const std::string& program) {
  const Object object = root_of(program);
  const auto* data = std::get_if<ShapeData>(&object.geometry);
  const auto* shape = data ? std::get_if<Shape>(data) : nullptr;
  EXPECT_NE(shape, nullptr) << program;
  return shape ? *shape : Shape{};
}

}  // namespace dioptre::pov
