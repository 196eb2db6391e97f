// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>

#include "dioptre/integrators/appel.h"
#include "dioptre/integrators/integrator.h"
#include "dioptre/integrators/whitted.h"

namespace dioptre {
namespace {

using Made = std::unique_ptr<const RayIntegrator>;

template <class Integrator>
Made make(const RenderScene& scene, const IntegratorOptions& options) {
  return std::make_unique<Integrator>(scene, options);
}

/// The one table of integrators.
struct Row {
  std::string_view name;
  Made (*make)(const RenderScene&, const IntegratorOptions&);
};
constexpr std::array kTable{Row{"whitted", make<Whitted>}, Row{"appel", make<Appel>}};

constexpr auto kNames = [] {
  std::array<std::string_view, kTable.size()> names;
  for (std::size_t i = 0; i < kTable.size(); ++i) names[i] = kTable[i].name;
  return names;
}();

}  // namespace

std::span<const std::string_view> integrator_names() { return kNames; }

Result<std::unique_ptr<const RayIntegrator>> make_integrator(std::string_view name,
                                                             const RenderScene& scene,
                                                             const IntegratorOptions& options) {
  for (const Row& row : kTable) {
    if (row.name == name) return row.make(scene, options);
  }
  std::string known;
  for (const std::string_view each : kNames)
    known += (known.empty() ? "" : ", ") + std::string(each);
  return fail("unknown integrator '" + std::string(name) + "'; known: " + known);
}

}  // namespace dioptre
