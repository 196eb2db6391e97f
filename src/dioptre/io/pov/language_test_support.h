// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dioptre/io/load_scene.h"

namespace dioptre::pov {

/// Answers of a renderer that knows nothing.
class NoQueries final : public SceneQueries {
 public:
  std::optional<Hit> trace(const Scene&, ObjectId, const Ray&) override { return std::nullopt; }
  bool inside(const Scene&, ObjectId, Vec3) override { return false; }
  Bounds extent(const Scene&, ObjectId) override { return {{-1, -1, -1}, {1, 1, 1}}; }
  double call(const Scene&, FunctionId, std::span<const double>) override { return 0.5; }
  PigmentColor pigment(const Scene&, PigmentId, Vec3) override { return {}; }
};

/// What a program says: the text of its #debug messages, then its warnings and errors as shown.
/// `#version 3.7;` stands in front of it, on the first line.
inline std::string said(const std::string& program, const LoadOptions& options = {}) {
  std::string text;
  Diagnostics diagnostics(
      [&](const Diagnostic& d) { text += d.severity == Severity::kNote ? d.message : to_text(d); });
  NoQueries queries;
  (void)load_pov_text("t.pov", "#version 3.7;\n" + program, options, queries, diagnostics);
  return text;
}

}  // namespace dioptre::pov
