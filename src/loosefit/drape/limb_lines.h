#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::drape {

/// The ends of a person, and the order in which limbs are counted.
enum Limb { kHead, kLeftArm, kRightArm, kLeftLeg, kRightLeg, kLimbs };

/// The middle of each limb, from the chest to beyond its end [m], or to 2 cm beyond where it ends
/// of a person who lacks the rest (body/stumps.h). Empty lines for a body without joints.
using LimbLines = std::array<std::vector<Vec3>, kLimbs>;
LimbLines limb_lines(const body::Body& body);
/// The same of joints alone.
LimbLines limb_lines(const std::map<std::string, Vec3>& joints);

/// Whether a limb ends early (body/stumps.h), so that the sleeve or leg of a garment may be empty.
bool lacks_end(Limb limb, const body::Body& body);

/// How often each limb goes through a closed curve: signed crossings of its line with the disc
/// between the curve and its middle, less the number that most limbs have, the first that is not
/// zero positive. All lines begin in the chest, so the numbers do not depend on the side on which
/// the chest lies: a curve round the trunk has both legs, one round the neck the head alone, one
/// below both shoulders the same as one round the trunk, one round nothing zeros.
using LimbNumbers = std::array<int, kLimbs>;
LimbNumbers limbs_through_openings(const std::vector<int>& loop, const std::vector<Vec3>& x,
                                   const LimbLines& lines);

inline constexpr LimbNumbers kRoundNothing = {0, 0, 0, 0, 0};
inline constexpr LimbNumbers kRoundNeck = {1, 0, 0, 0, 0};
inline constexpr LimbNumbers kRoundTrunk = {0, 0, 0, 1, 1};
LimbNumbers round_limb(Limb limb);

/// "the left arm"
const char* limb_name(Limb limb);
/// What a curve with these numbers goes round: "the trunk", "the head and the left arm", "no part
/// of the body".
std::string round_what(const LimbNumbers& numbers);

}  // namespace loosefit::drape
