#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/movement.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::flesh {
class SoftBody;
}

namespace loosefit::pipeline {

/// A movement of the wearer once the garment is on.
struct CaseMovement {
  std::string name;  ///< of scenario::kMovementNames
  double size = 1;   ///< beside the usual one [–]
  bool operator==(const CaseMovement&) const = default;
};

/// What [donning] asks for, of the usual size.
std::vector<CaseMovement> usual_movements(const scenario::ScenarioDonning& donning);

/// The same in an order (fidgeting stays last) and of sizes that are drawn from the seed, ln of the
/// size normally with the spread of [donning], kept within two deviations: no wearer moves alike
/// twice. Without a spread they are the usual ones.
std::vector<CaseMovement> drawn_movements(const scenario::ScenarioDonning& donning,
                                          std::uint64_t seed);

/// How a wearer makes them who stands so: "hem-pull" pulls with five weights of each garment, a
/// light tug of two hands, so that it slides where friction holds it; "arm-raise" raises the arms
/// forward by 45° and to 25° aside, and draws the hem down by as much, whatever its size, while
/// they come down again, so that arms do not catch it against the trunk, or lowers them by 60°
/// where they are up; "breath" widens the chest by 2 % of its girth; "fidget" are small movements
/// in all directions, which leave a fifth of friction (to the power of their size): what rubs to
/// and fro resists a slow slide across hardly more than it lasts (Popov 2020). What a wearer cannot
/// do is left out: one without a person (a scan) keeps the arms. `person`: who is asked for other
/// postures than `stands`, in which the body is `at_rest`.
drape::Movements movements_of(const body::PosedBody& at_rest,
                              const std::shared_ptr<flesh::SoftBody>& person,
                              const body::Posture& stands,
                              const std::vector<CaseMovement>& movements);

}  // namespace loosefit::pipeline
