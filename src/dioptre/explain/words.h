// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dioptre/explain/reports.h"

namespace dioptre {

/// A larger RayTree::gap() is a mistake of the program.
inline constexpr double kLargestGap = 1e-6;

const char* kind_name(RayKind kind);
const char* term_name(LightTerm term);

/// A primitive or operator among the stretches of a meeting.
std::string node_name(const ExplainedScene& scene, const Meeting& meeting, std::size_t node);
/// As "1.5 to 2, 3 to 4"; "nowhere".
std::string stretches_text(const std::vector<Interval>& stretches);
/// What became of one end of a primitive's stretch, as a sentence without its full stop.
std::string fate_text(const ExplainedScene& scene, const Meeting& meeting,
                      const csg::EventFate& event);

}  // namespace dioptre
