#include "loosefit/study/wear_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "loosefit/base/resources.h"
#include "loosefit/base/side_by_side.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"

namespace loosefit {

CaseWear plan_wear(const Scenario& scenario) {
  CaseWear wear;
  if (scenario.postures.size() < 2 && scenario.donning.repeats < 2) return wear;
  wear.postures = scenario.postures;
  if (wear.postures.empty()) wear.postures = {"reference"};
  std::mt19937_64 rng(scenario.donning.seed);
  std::uniform_real_distribution<double> even(-1, 1);
  std::normal_distribution<double> normal;
  wear.donnings.resize(1);
  for (int k = 1; k < scenario.donning.repeats; ++k) {
    CaseDonning& how = wear.donnings.emplace_back();
    for (double& s : how.shift) s = scenario.donning.shift * even(rng);
    how.twist = scenario.donning.twist * even(rng);
    how.friction = std::exp(scenario.donning.friction_spread * std::clamp(normal(rng), -2.0, 2.0));
  }
  return wear;
}

void pose_wearers(const CaseBody& body, CaseWear& wear, Progress& progress) {
  wear.bodies.resize(wear.postures.size());
  wear.wearers.resize(wear.postures.size());
  std::vector<SideJob> jobs;
  for (std::size_t p = 1; p < wear.postures.size(); ++p)
    jobs.push_back({wear.postures[p], [&, p](Progress& own) {
                      own.check_cancelled();
                      const auto anew = std::make_shared<SoftBody>(body.person->anew());
                      wear.bodies[p] = std::make_shared<const Body>(
                          anew->in(named_posture(wear.postures[p]), &own));
                      wear.wearers[p] = anew;
                    }});
  side_by_side(jobs, usable_threads(), progress);
  if (!wear.bodies.empty()) wear.bodies[0] = std::make_shared<const Body>(body.body);
}

std::vector<WornState> worn_states(const CaseResult& result) {
  std::vector<WornState> all = {
      {0, 0, result.drape.positions, result.body.body, result.maps.worn,
       result.maps.pressure.field.empty() ? nullptr : &result.maps.pressure.field}};
  for (const CaseState& s : result.wear.states)
    if (s.counts())
      all.push_back({s.posture, s.donning, s.drape.positions,
                     s.posture == 0 ? result.body.body : *result.wear.bodies[s.posture], s.worn,
                     s.pressure.empty() ? nullptr : &s.pressure});
  return all;
}

std::vector<std::string> wear_warnings(const CaseResult& result) {
  std::vector<std::string> all;
  const CaseWear& wear = result.wear;
  if (!wear.postures.empty() && wear.states.empty())
    all.push_back(
        "postures: none taken and nothing put on again: the first drape is not settled and worn");
  for (const CaseState& s : wear.states) {
    if (s.counts()) continue;
    const std::string where =
        wear.donnings.size() > 1 ? fmt::format("{} of donning {}", s.name, s.donning + 1) : s.name;
    const Certificate& c = s.drape.certificate;
    all.push_back(fmt::format("postures: {} is left out of all statistics: {}", where,
                              s.left_out.empty() ? fmt::format("not settled ({}), residual {:.2e}",
                                                               c.stop_reason, c.residual)
                                                 : s.left_out));
  }
  return all;
}

std::filesystem::path state_folder(const CaseState& state) {
  if (state.donning == 0) return std::filesystem::path("postures") / state.name;
  return std::filesystem::path("donnings") / std::to_string(state.donning + 1) / state.name;
}

}  // namespace loosefit
