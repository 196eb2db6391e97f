// SPDX-License-Identifier: Apache-2.0
// How the interpreter keeps within its limits.
#include <algorithm>

#include "dioptre/io/pov/interpreter.h"
#include "dioptre/io/pov/memory_use.h"
#include "dioptre/scene/validate.h"

namespace dioptre::pov {
namespace {

constexpr std::uint64_t kStepsBetweenChecks = 1 << 14;
constexpr std::uint64_t kBytesBetweenChecks = 16u << 20;
constexpr std::uint64_t kBytesPerStep = 64;
constexpr std::uint64_t kBytesPerMessage = 1024;

}  // namespace

void Interpreter::over_budget(std::string what, std::string_view option) {
  const SourcePosition where = ready_ ? current_->position : cursor_->position;
  fail_at(where, "more than " + what, "raise the limit with --" + std::string(option));
}

void Interpreter::over_nesting() {
  over_budget(std::to_string(options_.budgets.nesting) + " levels of nesting", "max-nesting");
}

void Interpreter::enter() {
  if (++nesting_ + frames_.size() > options_.budgets.nesting) over_nesting();
}

void Interpreter::check_budgets() {
  const LoadBudgets& budgets = options_.budgets;
  if (steps_ > budgets.steps) over_budget(std::to_string(budgets.steps) + " steps", "max-steps");
  if (scene_.objects.size() > budgets.objects) {
    over_budget(std::to_string(budgets.objects) + " objects", "max-objects");
  }
  if (budgets.seconds > 0) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    if (spent.count() > budgets.seconds) {
      over_budget(shortest(budgets.seconds) + " seconds of reading", "max-read-seconds");
    }
  }
  check_memory();
  if (options_.cancel && *options_.cancel) fail("stopped here");
  next_check_ = std::min(budgets.steps, steps_ + kStepsBetweenChecks) + (steps_ == budgets.steps);
}

void Interpreter::check_memory() {
  charged_bytes_ = 0;
  const std::uint64_t now = resident_bytes();
  if (now > first_bytes_ && now - first_bytes_ > options_.budgets.memory_bytes) {
    over_budget(std::to_string(options_.budgets.memory_bytes) + " bytes of memory for the scene",
                "max-scene-bytes");
  }
}

Diagnostic Interpreter::out_of_memory() const {
  const SourcePosition where = cursor_ ? cursor_->position : SourcePosition{};
  return diagnostic(Severity::kError, where, "there is not enough memory for this scene");
}

void Interpreter::charge(std::uint64_t bytes) {
  const std::uint64_t left = options_.budgets.memory_bytes;
  if (bytes > left) {
    over_budget(std::to_string(left) + " bytes of memory for the scene", "max-scene-bytes");
  }
  steps_ += bytes / kBytesPerStep;
  charged_bytes_ += bytes;
  if (charged_bytes_ >= kBytesBetweenChecks) check_budgets();
}

/// The renderer prepares functions and pigments anew when there are more than at the last question:
/// that is work, too.
SceneQueries& Interpreter::queries() {
  const std::size_t size = scene_.functions.size() + scene_.pigments.size();
  if (size != asked_size_) {
    asked_size_ = size;
    charge(size * kBytesPerStep);
  }
  return queries_;
}

void Interpreter::check_levels() {
  append_levels(scene_, levels_);
  if (levels_.back() <= kDeepestSolid) return;
  fail("solids are nested more than " + std::to_string(kDeepestSolid) + " deep",
       "put the parts into one union instead of one union into the next");
}

void Interpreter::check_string(std::size_t size) {
  if (size > options_.budgets.string_bytes) {
    over_budget(std::to_string(options_.budgets.string_bytes) + " bytes in a string",
                "max-string-bytes");
  }
  charge(size);
}

void Interpreter::check_elements(std::uint64_t count) {
  if (count > options_.budgets.array_elements) {
    over_budget(std::to_string(options_.budgets.array_elements) + " elements in an array",
                "max-array-elements");
  }
  charge(count * sizeof(Value));
}

void Interpreter::count_written(std::uint64_t bytes) {
  written_ += bytes;
  if (written_ > options_.budgets.written_bytes) {
    over_budget(std::to_string(options_.budgets.written_bytes) + " bytes of messages and files",
                "max-written-bytes");
  }
}

/// Messages are kept, so that each takes memory: also the shortest counts.
void Interpreter::count_message(std::size_t size) { count_written(size + kBytesPerMessage); }

}  // namespace dioptre::pov
