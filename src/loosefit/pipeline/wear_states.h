#pragma once
#include <memory>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/site_state.h"

namespace loosefit::flesh {
class SoftBody;
}

namespace loosefit::pipeline {

/// How the garments are put on each time: once at least. Unless all are drawn the first is
/// undisturbed, its movements the usual ones. They are drawn from the seed of [donning]: shifts and
/// twist evenly within their limits, ln of the friction share normally, kept within two deviations;
/// movements as drawn_movements.
std::vector<CaseDonning> planned_donnings(const scenario::ScenarioDonning& donning);

/// Postures and donnings of a case; no bodies and no states yet. Empty for one of each.
CaseWear plan_wear(const scenario::Scenario& scenario);

/// All states of a plan but the reference state, in their order: the other postures of the first
/// donning, then all postures of each further donning, the reference posture first.
std::vector<StateId> planned_states(const CaseWear& wear);

/// A wearer who has taken a posture, led into it from rest and into no other before.
struct PosedWearer {
  body::PosedBody body;
  std::shared_ptr<const flesh::SoftBody> person;
};

/// The wearer in each posture, none for the reference posture. Neither what else is listed nor
/// whether the garment was put on before makes a difference, so a run that is read again finds the
/// same bodies. Side by side, a thread each. \throws Cancelled
std::vector<PosedWearer> pose_wearers(const CaseBody& body,
                                      const std::vector<std::string>& postures, Progress& progress);

/// CaseWear::bodies.
std::vector<body::PosedBody> bodies_of(const std::vector<PosedWearer>& wearers);

/// All states that count, with the reference state first, to measure sensors in.
std::vector<placement::WornState> worn_states(const CaseResult& result);

}  // namespace loosefit::pipeline
