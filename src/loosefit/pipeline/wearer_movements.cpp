#include "loosefit/pipeline/wearer_movements.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/body/breath.h"
#include "loosefit/flesh/soft_way.h"

namespace loosefit::pipeline {
namespace {

constexpr double kHemPull = 5;             ///< weights of the garment
constexpr double kArmRaise = radians(45);  ///< forward of where the arms are
/// Raised arms are at least so far aside: it opens the armpits, so that the cloth between arm and
/// trunk comes free and can go along.
constexpr double kArmsAside = radians(25);
constexpr double kStraightUp = radians(180);
constexpr double kRaised = radians(60);  ///< arms that are up already
constexpr double kBreath = 0.02;         ///< of the girth of the chest
constexpr double kFidget = 0.2;          ///< share of friction that is left

drape::Movement arm_raise(const std::shared_ptr<flesh::SoftBody>& person,
                          const body::Posture& stands, double size) {
  if (!person) return {};
  body::Posture up = stands;
  const bool hang = stands.arm_flexion < kRaised;
  if (hang) {
    up.arm_flexion = std::min(up.arm_flexion + size * kArmRaise, kStraightUp);
    up.arm_abduction = std::max(up.arm_abduction, kArmsAside);
  } else {
    up.arm_flexion -= std::min(size, 1.0) * kRaised;
  }
  const auto way = std::make_shared<flesh::SoftWay>(person, stands, up);
  return {.way = [way](double share) { return way->at(share); }, .hem_pull = hang ? kHemPull : 0};
}

drape::Movement breath(const body::PosedBody& at_rest, double size) try {
  const double growth = size * kBreath;
  body::inhaled(at_rest, growth);  // whether it can
  return {.way = [at_rest, growth](double share) {
    return share == 0 ? at_rest : body::PosedBody(body::inhaled(at_rest, share * growth));
  }};
} catch (const InvalidInput&) {
  return {};
}

}  // namespace

std::vector<CaseMovement> usual_movements(const scenario::ScenarioDonning& donning) {
  std::vector<CaseMovement> movements;
  for (const std::string& name : donning.movements) movements.push_back({name});
  return movements;
}

std::vector<CaseMovement> drawn_movements(const scenario::ScenarioDonning& donning,
                                          std::uint64_t seed) {
  std::vector<CaseMovement> movements = usual_movements(donning);
  if (donning.movement_spread == 0) return movements;
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> normal;
  // Fidgeting ends them all: it lasts until the cloth lies still.
  const auto last = std::stable_partition(movements.begin(), movements.end(),
                                          [](const CaseMovement& m) { return m.name != "fidget"; });
  std::shuffle(movements.begin(), last, rng);
  for (CaseMovement& movement : movements)
    movement.size = std::exp(donning.movement_spread * std::clamp(normal(rng), -2.0, 2.0));
  return movements;
}

drape::Movements movements_of(const body::PosedBody& at_rest,
                              const std::shared_ptr<flesh::SoftBody>& person,
                              const body::Posture& stands,
                              const std::vector<CaseMovement>& movements) {
  drape::Movements made;
  for (const auto& [name, size] : movements) {
    drape::Movement movement;
    if (name == "hem-pull") movement.hem_pull = size * kHemPull;
    if (name == "arm-raise") movement = arm_raise(person, stands, size);
    if (name == "breath") movement = breath(at_rest, size);
    if (name == "fidget") movement.friction_share = std::pow(kFidget, size);
    if (!movement.way && movement.friction_share == 1 && movement.hem_pull == 0) continue;
    movement.name = name;
    made.push_back(std::move(movement));
  }
  return made;
}

}  // namespace loosefit::pipeline
