#include "loosefit/pipeline/simulation_options.h"

#include "loosefit/base/error.h"

namespace loosefit::pipeline {
namespace {

drape::IntegratorKind integrator_kind(const std::string& word) {
  if (word == "semi-implicit-euler") return drape::IntegratorKind::semi_implicit_euler;
  if (word == "implicit-euler") return drape::IntegratorKind::implicit_euler;
  if (word == "quasi-static") return drape::IntegratorKind::quasi_static;
  throw InvalidInput({"", 0, "simulation.integrator"}, "\"" + word + "\"",
                     "semi-implicit-euler, implicit-euler or quasi-static");
}

}  // namespace

drape::DrapeOptions drape_options(const scenario::ScenarioSimulation& simulation, int repeat) {
  return {.integrator = integrator_kind(simulation.integrator),
          .residual_tolerance = simulation.residual_tolerance,
          .gravity = simulation.gravity,
          .time_budget = simulation.time_budget,
          .max_iterations = simulation.max_iterations,
          .seed = simulation.seed + static_cast<std::uint64_t>(repeat),
          .start_perturbation = simulation.start_perturbation};
}

}  // namespace loosefit::pipeline
