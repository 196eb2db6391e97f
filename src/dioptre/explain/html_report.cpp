// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string_view>

#include "dioptre/core/page.h"
#include "dioptre/explain/reports.h"

namespace dioptre {

namespace embedded {
/// The page, with places marked for the data and for the library that draws in three dimensions.
std::string_view explain_page_html();
/// three.js (MIT licence).
std::string_view three_min_js();
}  // namespace embedded

std::string html_report(const ExplainedScene& scene, const RayTree& tree) {
  const std::array fills{PageFill{"{{DATA}}", within_script(json_report(scene, tree))},
                         PageFill{"{{THREE}}", std::string(embedded::three_min_js())}};
  return fill_page(embedded::explain_page_html(), fills);
}

}  // namespace dioptre
