// SPDX-License-Identifier: Apache-2.0
// Feeds any bytes to the reader of scenes: it must come back with a scene or with messages.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "dioptre/io/load_scene.h"
#include "tight_limits.h"

namespace dioptre {
namespace {

/// A renderer that knows nothing: rays miss, functions are zero.
class NoAnswers : public SceneQueries {
 public:
  std::optional<Hit> trace(const Scene&, ObjectId, const Ray&) override { return std::nullopt; }
  bool inside(const Scene&, ObjectId, Vec3) override { return false; }
  Bounds extent(const Scene&, ObjectId) override { return {}; }
  double call(const Scene&, FunctionId, std::span<const double>) override { return 0; }
  PigmentColor pigment(const Scene&, PigmentId, Vec3) override { return {}; }
};

}  // namespace
}  // namespace dioptre

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const dioptre::LoadOptions options = dioptre::tight_limits();
  dioptre::NoAnswers queries;
  dioptre::Diagnostics diagnostics;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto scene = dioptre::load_pov_text("fuzz/input.pov", text, options, queries, diagnostics);
  if (!scene && !diagnostics.has_errors()) std::abort();  // refused in silence
  return 0;
}
