// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/film/layers.h"
#include "dioptre/geometry/polygon/polygon.h"
#include "dioptre/lights/light_shape.h"

namespace dioptre::app {

/// Everything that a command line and INI files can say. Defaults are POV-Ray's.
struct AppSettings {
  std::string input;
  std::string include_header;
  std::vector<std::string> search_folders;
  std::map<std::string, double> declares;
  double version = 0;  ///< of the scene language; 0: the scene says

  std::uint32_t width = 320, height = 240;
  /// Rows and columns from 1; under 1 a share of the size. 0: the edge.
  double start_column = 0, start_row = 0, end_column = 0, end_row = 0;

  std::string output;  ///< empty: the scene's name
  bool output_to_file = true;
  char file_type = 'N';
  std::uint32_t bits = 8;
  bool alpha = false;
  bool dither = false;
  double file_gamma = 0;  ///< 0: the sRGB curve
  std::uint32_t compression = 0;
  LayerSet layers;           ///< in the picture's file
  LayerSet heat_maps;        ///< beside the picture
  bool term_images = false;  ///< beside the picture

  bool antialias = false;
  std::uint32_t sampling_method = 1;
  double antialias_threshold = 0.3;
  std::uint32_t antialias_depth = 3;
  double antialias_gamma = 2.5;
  bool jitter = true;
  double jitter_amount = 1;

  std::uint32_t quality = 9;
  std::uint32_t threads = 0;
  std::string accelerator = "bvh";        ///< for compare several, with commas in between
  std::uint32_t compared_rays = 100'000;  ///< of each sort, about
  bool accelerator_is_named = false;      ///< not the default
  std::string integrator = "whitted";
  std::optional<PolygonTest> polygon_test;            ///< the scene's own, if not given
  std::optional<std::array<std::uint32_t, 2>> pixel;  ///< to explain: column and row, from 0
  LightShape penumbra = LightShape::kGrid;
  std::uint32_t light_samples = 64;
  bool shadows = false;  ///< of the integrators that cast none unless asked
  double reflected_attenuation = 0, transmitted_attenuation = 0;  ///< see LengthAttenuation

  double clock = 0;
  bool clock_given = false;
  std::int32_t initial_frame = 1;
  std::int32_t final_frame = -1;  ///< 0: no animation; -1: none unless it begins after frame 1
  double initial_clock = 0, final_clock = 1;
  double subset_start = 0;           ///< under 1 a share of the frames
  std::optional<double> subset_end;  ///< likewise; none: the last
  std::int32_t frame_step = 1;
  bool cyclic = false;

  bool verbose = true;
  bool warnings = true;
  bool strict = false;                      ///< see LoadOptions
  bool debug_messages = true;               ///< what scenes print by #debug and the like
  std::vector<std::string> without_effect;  ///< options that ask for what does not happen
  std::string progress = "auto";            ///< auto, plain, json, none

  /// Limits on what a scene may ask for; see LoadBudgets.
  std::uint64_t max_steps = 4'000'000'000, max_objects = 50'000'000;
  std::uint32_t max_nesting = 4000;
  std::uint64_t max_string_bytes = 64u << 20, max_array_elements = 64u << 20;
  std::uint64_t max_written_bytes = 1u << 30;
  std::uint64_t max_scene_bytes = 0;  ///< 0: half of the machine's memory, at most 8 GiB
  double max_read_seconds = 3600;     ///< 0: no limit
  std::uint64_t max_pixels = std::uint64_t{1} << 28;  ///< of the picture

  /// Where the commands that report about a scene write; empty: nowhere.
  std::string csv_report, html_report, json_report;

  std::uint32_t ini_depth = 0;  ///< how many INI files are being read, one within the other
  bool operator==(const AppSettings&) const = default;
};

/// Sets one option by its INI name, in any case: set(s, "Width", "640"). The error of an unknown
/// name says which known one is nearest. Options of POV-Ray that have no meaning here go into
/// `without_effect` if their value asks for something.
Result<void> set_option(AppSettings& settings, std::string_view key, const std::string& value);

/// All INI names, in alphabetical order.
std::vector<std::string_view> option_names();

/// The one of `names` with the fewest edits to `name`.
std::string nearest(std::string_view name, const std::vector<std::string_view>& names);

/// ASCII upper case letters as lower case ones.
std::string to_lower(std::string_view text);

}  // namespace dioptre::app
