// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/compare/ray_sample.h"
#include "dioptre/core/result.h"
#include "dioptre/film/image.h"
#include "dioptre/integrators/render_image.h"

namespace dioptre {

/// What a ray costs, in the mean over a sample.
struct RayCost {
  double steps = 0;  ///< inner nodes, cells or bounding volumes looked at
  double boxes = 0;  ///< boxes of single items tested
  double items = 0;  ///< items tested; a whole CSG solid or mesh is one
  double nanoseconds = 0;
};

/// What one accelerator did.
struct StructureResult {
  std::string name;
  double build_seconds = 0;
  AcceleratorStatistics size;
  std::array<RayCost, kRaySorts> cost;
  double trace_seconds = 0;   ///< of one thread, for all rays of the picture, by `cost`
  double render_seconds = 0;  ///< of all threads, with the shading
  /// The share of the render that went into finding what rays meet; nothing if not measured.
  std::optional<double> intersection_share;
  bool same_image = true;    ///< as the first structure's, bit by bit
  bool same_answers = true;  ///< to every ray of the sample
};

/// All of them on one scene.
struct Comparison {
  std::string title;
  std::size_t items = 0;                         ///< that the structures stand over
  RayCounts rays;                                ///< of the picture
  std::array<std::size_t, kRaySorts> sampled{};  ///< how many of each sort were measured
  std::vector<StructureResult> structures;
  Image image;

  /// How many rays of a sort the picture took.
  std::uint64_t traced(RaySort sort) const { return count_of(rays, sort); }
  bool has(RaySort sort) const { return sampled[static_cast<std::size_t>(sort)] > 0; }
  /// True if all structures gave the same image and the same answers.
  bool all_equal() const;
  /// How many times as fast as `none` a structure traced the rays; nothing without `none`.
  std::optional<double> speed(const StructureResult& structure) const;
};

/// What to compare.
struct CompareOptions {
  std::vector<std::string> accelerators;  ///< empty: all
  std::size_t sample = 100'000;           ///< about how many rays of each sort are measured
  double measured_seconds = 0.005;        ///< the least that one measurement of time lasts
};

/// An error that lists the names if one of them is not known.
Result<void> check_accelerators(const std::vector<std::string>& names);

/// Renders the scene with each accelerator, collects rays of each sort from the picture and walks
/// them through each of the structures: once to count, then by turns to measure the time, of which
/// the median is taken. Beside `none` in a scene of many items the sample is smaller, as its time
/// grows with their product.
Result<Comparison> compare_accelerators(const Scene& scene, const CompileOptions& compile_options,
                                        const RenderOptions& render_options,
                                        const CompareOptions& options,
                                        const RenderContext& context);

}  // namespace dioptre
