// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/functions/internal_function_table.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "dioptre/shading/functions/internal_function_families.h"

namespace dioptre {
namespace {

namespace family = internal_functions;

constexpr std::uint32_t kMaxArguments = 13;

struct Entry {
  std::uint32_t number = 0;
  std::string_view name;
  std::uint32_t parameter_count = 0;
  family::Function function = nullptr;
};

// In order of number.
constexpr auto kEntries = std::to_array<Entry>({
    {0, "f_algbr_cyl1", 8, family::algebraic_cylinder_1},
    {1, "f_algbr_cyl2", 8, family::algebraic_cylinder_2},
    {2, "f_algbr_cyl3", 8, family::algebraic_cylinder_3},
    {3, "f_algbr_cyl4", 8, family::algebraic_cylinder_4},
    {4, "f_bicorn", 5, family::bicorn},
    {5, "f_bifolia", 5, family::bifolia},
    {6, "f_blob", 8, family::blob},
    {7, "f_blob2", 7, family::blob2},
    {8, "f_boy_surface", 5, family::boy_surface},
    {9, "f_comma", 4, family::comma},
    {10, "f_cross_ellipsoids", 7, family::cross_ellipsoids},
    {11, "f_crossed_trough", 4, family::crossed_trough},
    {12, "f_cubic_saddle", 4, family::cubic_saddle},
    {13, "f_cushion", 4, family::cushion},
    {14, "f_devils_curve", 4, family::devils_curve},
    {15, "f_devils_curve_2d", 9, family::devils_curve_2d},
    {16, "f_dupin_cyclid", 9, family::dupin_cyclid},
    {17, "f_ellipsoid", 6, family::ellipsoid},
    {18, "f_enneper", 4, family::enneper},
    {19, "f_flange_cover", 7, family::flange_cover},
    {20, "f_folium_surface", 6, family::folium_surface},
    {21, "f_folium_surface_2d", 9, family::folium_surface_2d},
    {22, "f_glob", 4, family::glob},
    {23, "f_heart", 4, family::heart},
    {24, "f_helical_torus", 13, family::helical_torus},
    {25, "f_helix1", 10, family::helix_1},
    {26, "f_helix2", 10, family::helix_2},
    {27, "f_hex_x", 4, family::hexagonal_columns},
    {28, "f_hex_y", 4, family::hexagonal_lines},
    {29, "f_hetero_mf", 9, family::hetero_mf},
    {30, "f_hunt_surface", 4, family::hunt_surface},
    {31, "f_hyperbolic_torus", 6, family::hyperbolic_torus},
    {32, "f_isect_ellipsoids", 7, family::isect_ellipsoids},
    {33, "f_kampyle_of_eudoxus", 6, family::kampyle_of_eudoxus},
    {34, "f_kampyle_of_eudoxus_2d", 9, family::kampyle_of_eudoxus_2d},
    {35, "f_klein_bottle", 4, family::klein_bottle},
    {36, "f_kummer_surface_v1", 4, family::kummer_surface_v1},
    {37, "f_kummer_surface_v2", 7, family::kummer_surface_v2},
    {38, "f_lemniscate_of_gerono", 4, family::lemniscate_of_gerono},
    {39, "f_lemniscate_of_gerono_2d", 9, family::lemniscate_of_gerono_2d},
    {40, "f_mesh1", 8, family::woven_mesh},
    {41, "f_mitre", 4, family::mitre},
    {42, "f_nodal_cubic", 4, family::nodal_cubic},
    {43, "f_odd", 4, family::odd},
    {44, "f_ovals_of_cassini", 7, family::ovals_of_cassini},
    {45, "f_paraboloid", 4, family::paraboloid},
    {46, "f_parabolic_torus", 6, family::parabolic_torus},
    {47, "f_ph", 3, family::polar_angle},
    {48, "f_pillow", 4, family::pillow},
    {49, "f_piriform", 4, family::piriform},
    {50, "f_piriform_2d", 10, family::piriform_2d},
    {51, "f_poly4", 8, family::poly4},
    {52, "f_polytubes", 9, family::polytubes},
    {53, "f_quantum", 4, family::quantum},
    {54, "f_quartic_paraboloid", 4, family::quartic_paraboloid},
    {55, "f_quartic_saddle", 4, family::quartic_saddle},
    {56, "f_quartic_cylinder", 6, family::quartic_cylinder},
    {57, "f_r", 3, family::radius},
    {58, "f_ridge", 9, family::ridge},
    {59, "f_ridged_mf", 9, family::ridged_mf},
    {60, "f_rounded_box", 7, family::rounded_box},
    {61, "f_sphere", 4, family::sphere},
    {62, "f_spikes", 8, family::spikes},
    {63, "f_spikes_2d", 7, family::spikes_2d},
    {64, "f_spiral", 9, family::spiral},
    {65, "f_steiners_roman", 4, family::steiners_roman},
    {66, "f_strophoid", 7, family::strophoid},
    {67, "f_strophoid_2d", 10, family::strophoid_2d},
    {68, "f_superellipsoid", 5, family::superellipsoid},
    {69, "f_th", 3, family::azimuth},
    {70, "f_torus", 5, family::torus},
    {71, "f_torus2", 6, family::torus2},
    {72, "f_torus_gumdrop", 4, family::torus_gumdrop},
    {73, "f_umbrella", 4, family::umbrella},
    {74, "f_witch_of_agnesi", 5, family::witch_of_agnesi},
    {75, "f_witch_of_agnesi_2d", 9, family::witch_of_agnesi_2d},
    {76, "f_noise3d", 3, family::noise_3d},
    {78, "f_noise_generator", 4, family::noise_of_generator},
});

const Entry* find(std::uint32_t number) {
  const auto* entry =
      std::lower_bound(kEntries.begin(), kEntries.end(), number,
                       [](const Entry& e, std::uint32_t n) { return e.number < n; });
  return entry != kEntries.end() && entry->number == number ? entry : nullptr;
}

}  // namespace

double internal_function(std::uint32_t number, std::span<const double> arguments) {
  const Entry* entry = find(number);
  if (entry == nullptr) return 0;
  std::array<double, kMaxArguments> padded{};
  const std::size_t given = std::min<std::size_t>(arguments.size(), entry->parameter_count);
  std::copy_n(arguments.begin(), given, padded.begin());
  return entry->function(padded.data());
}

std::uint32_t internal_parameter_count(std::uint32_t number) {
  const Entry* entry = find(number);
  return entry == nullptr ? 0 : entry->parameter_count;
}

}  // namespace dioptre
