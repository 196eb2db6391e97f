// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "dioptre/explain/ray_tree.h"
#include "dioptre/scene/source_map.h"

namespace dioptre {

/// What the reports name things by.
struct ExplainedScene {
  const RenderScene& compiled;
  const SourceMap& places;
  std::string title;  ///< as the user calls the scene

  /// An object as "sphere 'Ball' (scene.pov:12)".
  std::string name_of(ObjectId id) const;
};

/// The tree as indented text.
std::string text_report(const ExplainedScene& scene, const RayTree& tree);

/// All of the tree, and the boxes of the scene's items.
std::string json_report(const ExplainedScene& scene, const RayTree& tree);

/// One self-contained page: the tree, and its rays among the boxes of the scene.
std::string html_report(const ExplainedScene& scene, const RayTree& tree);

}  // namespace dioptre
