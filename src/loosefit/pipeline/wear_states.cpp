#include "loosefit/pipeline/wear_states.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "loosefit/base/resources.h"
#include "loosefit/base/side_by_side.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/flesh/soft_body.h"

namespace loosefit::pipeline {

std::vector<CaseDonning> planned_donnings(const scenario::ScenarioDonning& donning) {
  std::vector<CaseDonning> all;
  std::mt19937_64 rng(donning.seed);
  std::uniform_real_distribution<double> even(-1, 1);
  std::normal_distribution<double> normal;
  for (int k = 0; k < donning.repeats; ++k) {
    CaseDonning& how = all.emplace_back();
    how.movements = usual_movements(donning);
    if (k == 0 && !donning.first_drawn) continue;
    for (double& s : how.shift) s = donning.shift * even(rng);
    how.twist = donning.twist * even(rng);
    how.friction = std::exp(donning.friction_spread * std::clamp(normal(rng), -2.0, 2.0));
    // The seed itself has drawn the shifts.
    const int own = k > 0 ? k : scenario::kMostDonnings;
    how.movements = drawn_movements(donning, donning.seed + std::uint64_t(own));
  }
  return all;
}

CaseWear plan_wear(const scenario::Scenario& scenario) {
  CaseWear wear;
  if (scenario.postures.size() < 2 && scenario.donning.repeats < 2) return wear;
  wear.postures = scenario.postures;
  if (wear.postures.empty()) wear.postures = {"reference"};
  wear.donnings = planned_donnings(scenario.donning);
  return wear;
}

std::vector<StateId> planned_states(const CaseWear& wear) {
  std::vector<StateId> ids;
  for (int d = 0; d < static_cast<int>(wear.donnings.size()); ++d)
    for (int p = 0; p < static_cast<int>(wear.postures.size()); ++p)
      if (const StateId id{p, d}; id != StateId{}) ids.push_back(id);
  return ids;
}

std::vector<PosedWearer> pose_wearers(const CaseBody& body,
                                      const std::vector<std::string>& postures,
                                      Progress& progress) {
  std::vector<PosedWearer> wearers(postures.size());
  std::vector<SideJob> jobs;
  for (int p = 0; p < static_cast<int>(postures.size()); ++p) {
    if (p == StateId::kReferencePosture) continue;
    jobs.push_back({postures[p], [&, p](Progress& own) {
                      own.check_cancelled();
                      const auto person =
                          std::make_shared<flesh::SoftBody>(body.person->without_cache());
                      wearers[p].body = person->in(body::named_posture(postures[p]), &own);
                      wearers[p].person = person;
                    }});
  }
  side_by_side(jobs, usable_threads(), progress);
  return wearers;
}

std::vector<body::PosedBody> bodies_of(const std::vector<PosedWearer>& wearers) {
  std::vector<body::PosedBody> bodies;
  for (const PosedWearer& wearer : wearers) bodies.push_back(wearer.body);
  return bodies;
}

std::vector<placement::WornState> worn_states(const CaseResult& result) {
  const auto known = [](const maps::PressureField& field) {
    return field.empty() ? nullptr : &field;
  };
  const StateId reference;
  const CaseGarment& garment = result.studied();
  std::vector<placement::WornState> all = {{reference.posture, reference.donning,
                                            garment.drape.positions, result.body.body,
                                            garment.maps.worn, known(garment.maps.pressure.field)}};
  for (const CaseState& s : result.wear.states)
    if (s.counts())
      all.push_back({s.id.posture, s.id.donning, s.drape().positions, result.body_in(s.id.posture),
                     s.maps.worn, known(s.maps.pressure)});
  return all;
}

}  // namespace loosefit::pipeline
