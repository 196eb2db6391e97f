// SPDX-License-Identifier: Apache-2.0
#include "progress.h"

#include <unistd.h>

#include <cstdio>

namespace dioptre::app {

ProgressLine::ProgressLine(const std::string& kind) {
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

double ProgressLine::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void ProgressLine::update(double done, std::uint64_t rays) {
  if (kind_ == Kind::kNone) return;
  const double now = seconds();
  if (now - last_ < (kind_ == Kind::kPlain ? 5.0 : 0.2)) return;
  last_ = now;
  print(done, rays);
}

void ProgressLine::print(double done, std::uint64_t rays) {
  const double took = seconds();
  const double left = done > 0 ? took / done * (1 - done) : 0;
  const double rate = took > 0 ? static_cast<double>(rays) / took : 0;
  if (kind_ == Kind::kJson) {
    std::fprintf(stderr, "{\"done\":%.4f,\"rays\":%llu,\"seconds\":%.3f,\"seconds_left\":%.3f}\n",
                 done, static_cast<unsigned long long>(rays), took, left);
  } else {
    const bool terminal = kind_ == Kind::kTerminal;
    std::fprintf(stderr, "%s%5.1f %%  %.2f million rays/s  %.0f s left%s", terminal ? "\r" : "",
                 100 * done, rate / 1e6, left, terminal ? "   " : "\n");
  }
  std::fflush(stderr);
}

void ProgressLine::finish(std::uint64_t rays) {
  if (kind_ == Kind::kNone) return;
  if (kind_ == Kind::kJson) return print(1, rays);
  const double took = seconds();
  std::fprintf(stderr, "%s%llu rays in %.2f s%s\n", kind_ == Kind::kTerminal ? "\r" : "",
               static_cast<unsigned long long>(rays), took,
               kind_ == Kind::kTerminal ? "                              " : "");
}

}  // namespace dioptre::app
