#include "loosefit/validate/worn_drapes.h"

#include <fmt/format.h>

#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/drape/worn.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/run_case.h"

namespace loosefit::validate {
namespace {

/// A figure must not depend on how busy the machine is; iterations are limited all the same [s].
constexpr double kNoBudget = 1e6;

/// Shown as one piece of work: the stages of a run are none of a benchmark.
class OneRun : public Progress {
 public:
  OneRun(Progress& whole, std::string who) : whole_(whole), who_(std::move(who)) {}
  void stage(const std::string& name) override { whole_.update(0, who_ + ": " + name); }
  void check_cancelled() const override { whole_.check_cancelled(); }

 private:
  Progress& whole_;
  std::string who_;
};

}  // namespace

double WornDrape::force_over_weight() const {
  return std::accumulate(drape.body_normal_force.begin(), drape.body_normal_force.end(), 0.0) /
         weight();
}

scenario::Scenario worn_scenario(const std::string& body, const std::string& garment, double edge,
                                 int donnings) {
  scenario::Scenario scenario = io::parse_scenario(
      fmt::format("[body]\n{}\n[garment]\n{}\n[donning]\nrepeats = {}\n[simulation]\n"
                  "edge_length = {}\n[output]\nmaps = [\"distance\"]\npreset_sites = false\n",
                  body, garment, donnings, edge),
      "");
  scenario.simulation.time_budget = kNoBudget;
  return scenario;
}

pipeline::CaseResult wear(const scenario::Scenario& scenario, const std::string& who,
                          Progress& progress) {
  OneRun run(progress, who);
  pipeline::CaseResult result = pipeline::run_case(scenario, run);
  if (const drape::Certificate& c = result.certificate(); !c.holds())
    throw SolverFailure(who + (c.settled() ? " is not worn: " + join(c.worn_reasons, "; ")
                                           : " did not settle: " + c.stop_reason));
  return result;
}

void require_worn(const garment::Garment& mesh, const pattern::Pattern& pattern,
                  const std::vector<Vec3>& positions, const body::PosedBody& body,
                  const std::string& who) {
  const std::vector<std::string> reasons =
      drape::why_not_worn(mesh, pattern, positions, body, false);
  if (!reasons.empty()) throw SolverFailure(who + ": not worn: " + join(reasons, "; "));
}

std::vector<WornDrape> worn_drapes(const pipeline::CaseResult& result) {
  const garment::Garment& mesh = result.studied().mesh();
  const fabric::Material& material = result.scenario.studied().material.material;
  std::vector<WornDrape> drapes = {{mesh, material, result.body.body, result.studied().drape,
                                    result.studied().maps.worn,
                                    result.studied().maps.pressure.field}};
  for (const pipeline::CaseState& state : result.wear.states)
    if (state.counts() && state.id.in_reference_posture())
      drapes.push_back(
          {mesh, material, result.body.body, state.drape(), state.maps.worn, state.maps.pressure});
  return drapes;
}

}  // namespace loosefit::validate
