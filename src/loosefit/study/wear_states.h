#pragma once
#include <filesystem>

#include "loosefit/base/progress.h"
#include "loosefit/placement/site_state.h"
#include "loosefit/study/case_result.h"

namespace loosefit {

/// Postures and the drawn donnings of a case; no bodies and no states yet. Donnings are drawn from
/// the seed of [donning]: shifts and twist evenly within their limits, ln of the friction share
/// normally, kept within two deviations.
CaseWear plan_wear(const Scenario& scenario);

/// The bodies of the postures of `wear`: the first is `body` as it is, each other one is led there
/// from rest, whatever the person has been asked. Neither what else is listed nor whether the
/// garment was put on before makes a difference, so a run that is read again finds the same bodies.
/// Side by side, a thread each. \throws Cancelled
void pose_wearers(const CaseBody& body, CaseWear& wear, Progress& progress);

/// Worn garment, pressure and slip of every state that counts. \pre result.maps
void map_states(CaseResult& result);

/// All states that count, with those of `result` itself first, to measure sensors in.
std::vector<WornState> worn_states(const CaseResult& result);

/// What does not count and why, one line each.
std::vector<std::string> wear_warnings(const CaseResult& result);

/// Where the files of a state lie in the folder of its run: "postures/NAME" for the first donning,
/// "donnings/2/NAME" for the second.
std::filesystem::path state_folder(const CaseState& state);

}  // namespace loosefit
