#include "loosefit/study/simulation_options.h"

#include "loosefit/base/error.h"

namespace loosefit {
namespace {

IntegratorKind integrator_kind(const std::string& word) {
  if (word == "semi-implicit-euler") return IntegratorKind::semi_implicit_euler;
  if (word == "implicit-euler") return IntegratorKind::implicit_euler;
  if (word == "quasi-static") return IntegratorKind::quasi_static;
  throw InvalidInput({"", 0, "simulation.integrator"}, "\"" + word + "\"",
                     "semi-implicit-euler, implicit-euler or quasi-static");
}

}  // namespace

DrapeOptions drape_options(const ScenarioSimulation& simulation, int repeat) {
  return {.integrator = integrator_kind(simulation.integrator),
          .residual_tolerance = simulation.residual_tolerance,
          .gravity = simulation.gravity,
          .time_budget = simulation.time_budget,
          .max_iterations = simulation.max_iterations,
          .seed = simulation.seed + static_cast<std::uint64_t>(repeat),
          .start_perturbation = simulation.start_perturbation};
}

}  // namespace loosefit
