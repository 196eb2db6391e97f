// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>

#include "dioptre/integrators/integrator.h"
#include "dioptre/integrators/whitted.h"

namespace dioptre {
namespace {

constexpr std::array<std::string_view, 1> kNames = {"whitted"};

}  // namespace

std::span<const std::string_view> integrator_names() { return kNames; }

Result<std::unique_ptr<const RayIntegrator>> make_integrator(std::string_view name,
                                                             const RenderScene& scene,
                                                             const IntegratorOptions& options) {
  if (name == kNames[0]) return std::make_unique<Whitted>(scene, options);
  std::string known;
  for (const std::string_view each : kNames)
    known += (known.empty() ? "" : ", ") + std::string(each);
  return fail("unknown integrator '" + std::string(name) + "'; known: " + known);
}

}  // namespace dioptre
