// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace dioptre::app {
namespace {

using Count = unsigned long long;

/// For the standard error: `form` with the numbers of rays of each kind.
std::string by_kind(const char* form, const RayCounts& rays) {
  char text[256];
  std::snprintf(text, sizeof text, form, Count{rays.camera}, Count{rays.reflected},
                Count{rays.transmitted}, Count{rays.shadow});
  return text;
}

}  // namespace

ProgressLine::ProgressLine(const std::string& kind, std::int64_t frames) : frames_(frames) {
  if (kind == "none") {
    kind_ = Kind::kNone;
  } else if (kind == "json") {
    kind_ = Kind::kJson;
  } else if (kind == "auto" && ::isatty(STDERR_FILENO) == 1) {
    kind_ = Kind::kTerminal;
  } else {
    kind_ = Kind::kPlain;
  }
}

void ProgressLine::start() {
  if (!started_) start_ = std::chrono::steady_clock::now();
  started_ = true;
}

double ProgressLine::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void ProgressLine::update(double done, std::uint64_t rays) {
  if (kind_ == Kind::kNone) return;
  const double now = seconds();
  if (now - last_ < (kind_ == Kind::kPlain ? 5.0 : 0.2)) return;
  last_ = now;
  const auto finished = static_cast<double>(finished_);
  print((finished + done) / static_cast<double>(frames_), rays_.total() + rays);
}

void ProgressLine::print(double done, std::uint64_t rays) {
  if (kind_ == Kind::kJson) return print_json(done, rays);
  const double took = seconds();
  const double left = done > 0 ? took / done * (1 - done) : 0;
  const double rate = took > 0 ? static_cast<double>(rays) / took : 0;
  const bool terminal = kind_ == Kind::kTerminal;
  std::fprintf(stderr, "%s%5.1f %%%s  %.2f million rays/s  %.0f s left%s", terminal ? "\r" : "",
               100 * done, frame_text("  frame %lld of %lld").c_str(), rate / 1e6, left,
               terminal ? "   " : "\n");
  std::fflush(stderr);
}

void ProgressLine::print_json(double done, std::uint64_t rays, const std::string& more) const {
  const double took = seconds();
  const double left = done > 0 ? took / done * (1 - done) : 0;
  std::fprintf(stderr, "{\"done\":%.4f,\"rays\":%llu,\"seconds\":%.3f,\"seconds_left\":%.3f%s%s}\n",
               done, Count{rays}, took, left, frame_text(",\"frame\":%lld,\"frames\":%lld").c_str(),
               more.c_str());
}

std::string ProgressLine::frame_text(const char* form) const {
  if (frames_ == 1) return {};
  char text[64];
  const std::int64_t current = std::min(finished_ + 1, frames_);
  std::snprintf(text, sizeof text, form, static_cast<long long>(current),
                static_cast<long long>(frames_));
  return text;
}

void ProgressLine::clear() const {
  if (kind_ == Kind::kTerminal) std::fprintf(stderr, "\r%60s\r", "");
}

void ProgressLine::finish(const RenderResult& result) {
  rays_ += result.rays;
  if (kind_ == Kind::kNone || ++finished_ < frames_) return;
  const auto share = frames_ == 1 ? result.intersection_share() : std::nullopt;
  const Count rays = rays_.total();
  if (kind_ == Kind::kJson) {
    const char* const form =
        ",\"camera_rays\":%llu,\"reflected_rays\":%llu,\"transmitted_rays\":%llu,"
        "\"shadow_rays\":%llu";
    std::string more = by_kind(form, rays_);
    if (share) more += ",\"intersection_share\":" + std::to_string(*share);
    return print_json(1, rays, more);
  }
  const double took = seconds();
  const std::string kinds =
      by_kind("%llu camera, %llu reflected, %llu transmitted, %llu shadow", rays_);
  std::fprintf(stderr, "%s%llu rays in %.2f s: %s\n", kind_ == Kind::kTerminal ? "\r" : "", rays,
               took, kinds.c_str());
  if (!share) return;
  std::fprintf(stderr, "%.2f million rays/s, %.0f %% of the time in intersection\n",
               took > 0 ? static_cast<double>(rays) / took / 1e6 : 0.0, 100 * *share);
}

}  // namespace dioptre::app
