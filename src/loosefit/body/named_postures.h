#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::body {

/// Postures by name, in the order in which they are offered:
///
/// | name            | arms from the trunk          | trunk                       | legs          |
/// |-----------------|------------------------------|-----------------------------|---------------|
/// | standing        | 25° aside                    | upright                     | standing      |
/// | a-pose          | 40° aside                    | upright                     | standing      |
/// | arms-forward    | 90° forward, 10° aside       | upright                     | standing      |
/// | arms-overhead   | 160° forward, 20° aside      | upright                     | standing      |
/// | forward-bend    | 25° aside                    | back leans by 30°           | standing      |
/// | forward-bend-15 | 25° aside, hanging down      | back leans by 15°           | standing      |
/// | forward-bend-30 | 25° aside, hanging down      | back leans by 30°           | standing      |
/// | forward-bend-45 | 25° aside, hanging down      | back leans by 45°           | standing      |
/// | sitting         | 25° aside                    | upright                     | hip, knee 90° |
/// | slouch          | 25° aside, hanging down      | slumped (skeleton_pose.h)   | standing      |
///
/// Raised arms are straight at the elbow. 160° is what healthy adults reach forward without the
/// trunk leaning back (Soucie et al. 2011: about 170° in all, passive; recalled).
const std::vector<std::pair<std::string, Posture>>& named_postures();

/// Names of the table.
std::vector<std::string> posture_names();

/// \throws InvalidInput for an unknown name, with a did-you-mean.
Posture named_posture(const std::string& name);

}  // namespace loosefit::body
