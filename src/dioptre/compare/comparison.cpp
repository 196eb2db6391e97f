// SPDX-License-Identifier: Apache-2.0
#include "dioptre/compare/comparison.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

#include "dioptre/compare/replay.h"

namespace dioptre {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kRounds = 5;
/// Beside `none`, the product of rays of a sort and items; and the fewest rays.
constexpr std::size_t kMostTests = 200'000'000, kFewestRays = 4000;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  static_assert(std::is_trivially_copyable_v<T>);
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_bits(const Image& a, const Image& b) {
  return same_bits(a.pixels, b.pixels) && same_bits(a.alpha, b.alpha);
}

bool has_none(const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), "none") != names.end();
}

/// One comparison in the making.
class Comparing {
 public:
  Comparing(const Scene& scene, const CompileOptions& compile_options,
            const RenderOptions& render_options, const CompareOptions& options,
            const RenderContext& context)
      : scene_(scene),
        compile_options_(compile_options),
        render_options_(render_options),
        options_(options),
        names_(options.accelerators),
        context_(context) {
    if (names_.empty()) names_.assign(accelerator_names().begin(), accelerator_names().end());
  }

  Result<Comparison> run() {
    for (const std::string& name : names_) {
      out_.structures.push_back({.name = name});
      if (auto compiled = compile(name); !compiled) {
        return tl::unexpected(compiled.error());
      } else {
        scenes_.push_back(std::move(*compiled));
      }
      if (auto built = build(out_.structures.back()); !built) return tl::unexpected(built.error());
    }
    out_.items = scenes_.front()->items().size();
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      if (auto done = render(i); !done) return tl::unexpected(done.error());
    }
    auto sample = sample_rays(*scenes_.front(), render_options_, out_.rays, most_rays());
    if (!sample) return tl::unexpected(sample.error());
    count(*sample);
    measure(*sample);
    return std::move(out_);
  }

 private:
  Result<std::unique_ptr<const RenderScene>> compile(const std::string& name) const {
    CompileOptions options = compile_options_;
    options.accelerator = name;
    return RenderScene::compile(scene_, options);
  }

  std::size_t most_rays() const {
    if (!has_none(names_)) return options_.sample;
    const std::size_t affordable = kMostTests / std::max<std::size_t>(out_.items, 1);
    return std::min(options_.sample, std::max(kFewestRays, affordable));
  }

  /// Builds a structure over the items again; quick ones several times, for the median of the time.
  Result<void> build(StructureResult& result) const {
    std::vector<Bounds> boxes;
    boxes.reserve(scenes_.back()->items().size());
    for (const Item& item : scenes_.back()->items()) boxes.push_back(item.shape->bounds());
    std::vector<double> times;
    double spent = 0;
    while (times.size() < kRounds && spent < 0.2) {
      const Clock::time_point begin = Clock::now();
      auto made = make_accelerator(result.name, boxes, {scene_.camera.location});
      times.push_back(seconds_since(begin));
      if (!made) return tl::unexpected(made.error());
      spent += times.back();
    }
    result.build_seconds = median(std::move(times));
    result.size = scenes_.back()->accelerator().statistics();
    return {};
  }

  /// Renders the picture with one structure; the first one's is what the others are held against.
  Result<void> render(std::size_t number) {
    StructureResult& result = out_.structures[number];
    const Clock::time_point begin = Clock::now();
    auto rendered = render_image(*scenes_[number], render_options_, part_of_all(number));
    result.render_seconds = seconds_since(begin);
    if (!rendered) return tl::unexpected(rendered.error());
    if (rendered->cancelled) return fail("the comparison was stopped");
    result.intersection_share = rendered->intersection_share();
    if (number == 0) {
      out_.image = std::move(rendered->image);
      out_.rays = rendered->rays;
    } else {
      result.same_image = same_bits(out_.image, rendered->image);
    }
    return {};
  }

  /// Tells of the progress of one render as that of all.
  RenderContext part_of_all(std::size_t number) const {
    const auto all = static_cast<double>(out_.structures.size());
    RenderContext part;
    part.cancel = context_.cancel;
    if (context_.progress) {
      part.progress = [this, number, all](const RenderProgress& p) {
        context_.progress({(static_cast<double>(number) + p.done) / all, p.rays});
      };
    }
    return part;
  }

  void count(const RaySample& sample) {
    for (std::size_t sort = 0; sort < kRaySorts; ++sort) {
      out_.sampled[sort] = sample[sort].size();
      const double rays = static_cast<double>(std::max<std::size_t>(sample[sort].size(), 1));
      std::uint64_t answers = 0;
      for (std::size_t i = 0; i < scenes_.size(); ++i) {
        const Walks walks = walk_all(*scenes_[i], sample[sort]);
        if (i == 0) answers = walks.answers;
        StructureResult& result = out_.structures[i];
        result.same_answers = result.same_answers && walks.answers == answers;
        result.cost[sort] = {static_cast<double>(walks.cost.nodes) / rays,
                             static_cast<double>(walks.cost.boxes) / rays,
                             static_cast<double>(walks.cost.items) / rays, 0};
      }
    }
  }

  /// The structures take turns, so that whatever else the machine does hits all alike.
  void measure(const RaySample& sample) {
    for (const RaySort sort : kAllRaySorts) {
      const auto index = static_cast<std::size_t>(sort);
      std::vector<std::vector<double>> times(scenes_.size());
      for (std::size_t round = 0; round < kRounds; ++round) {
        for (std::size_t i = 0; i < scenes_.size(); ++i) {
          times[i].push_back(time_walks(*scenes_[i], sample[index], options_.measured_seconds));
        }
      }
      for (std::size_t i = 0; i < scenes_.size(); ++i) {
        StructureResult& result = out_.structures[i];
        result.cost[index].nanoseconds = median(std::move(times[i]));
        result.trace_seconds +=
            result.cost[index].nanoseconds * 1e-9 * static_cast<double>(count_of(out_.rays, sort));
      }
    }
  }

  const Scene& scene_;
  const CompileOptions& compile_options_;
  const RenderOptions& render_options_;
  const CompareOptions& options_;
  std::vector<std::string> names_;
  const RenderContext& context_;
  std::vector<std::unique_ptr<const RenderScene>> scenes_;  ///< one for each structure
  Comparison out_;
};

}  // namespace

bool Comparison::all_equal() const {
  return std::all_of(structures.begin(), structures.end(), [](const StructureResult& each) {
    return each.same_image && each.same_answers;
  });
}

std::optional<double> Comparison::speed(const StructureResult& structure) const {
  for (const StructureResult& each : structures) {
    if (each.name != "none" || !(structure.trace_seconds > 0)) continue;
    return each.trace_seconds / structure.trace_seconds;
  }
  return std::nullopt;
}

Result<void> check_accelerators(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (auto made = make_accelerator(name, {}); !made) return tl::unexpected(made.error());
  }
  return {};
}

Result<Comparison> compare_accelerators(const Scene& scene, const CompileOptions& compile_options,
                                        const RenderOptions& render_options,
                                        const CompareOptions& options,
                                        const RenderContext& context) {
  if (auto known = check_accelerators(options.accelerators); !known) {
    return tl::unexpected(known.error());
  }
  return Comparing(scene, compile_options, render_options, options, context).run();
}

}  // namespace dioptre
