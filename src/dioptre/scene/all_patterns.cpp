// SPDX-License-Identifier: Apache-2.0
#include "dioptre/scene/all_patterns.h"

namespace dioptre {
namespace {

/// Appends the `pattern` member of whichever alternative has one.
template <class Variant>
void append_pattern(const Variant& data, std::vector<const Pattern*>& patterns) {
  std::visit(
      [&](const auto& alternative) {
        if constexpr (requires { alternative.pattern; }) {
          if constexpr (std::is_same_v<std::decay_t<decltype(alternative.pattern)>, Pattern>) {
            patterns.push_back(&alternative.pattern);
          }
        }
      },
      data);
}

}  // namespace

std::vector<const Pattern*> all_patterns(const Scene& scene) {
  std::vector<const Pattern*> patterns;
  for (const Pigment& pigment : scene.pigments) append_pattern(pigment.data, patterns);
  for (const Normal& normal : scene.normals) append_pattern(normal.data, patterns);
  for (const Texture& texture : scene.textures) append_pattern(texture.data, patterns);
  for (const Function& function : scene.functions) append_pattern(function.body, patterns);
  return patterns;
}

}  // namespace dioptre
