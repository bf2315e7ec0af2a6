#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::body {

/// Postures by name, in the order in which they are offered:
///
/// | name            | arms from the trunk     | elbows   | trunk        | legs             |
/// |-----------------|-------------------------|----------|--------------|------------------|
/// | standing        | 8° aside, relaxed       | 15°      | upright      | standing         |
/// | model-standing  | 25° aside               | 46°      | upright      | standing         |
/// | a-pose          | 40° aside               | 46°      | upright      | standing         |
/// | arms-forward    | 90° forward, 10° aside  | straight | upright      | standing         |
/// | arms-overhead   | 160° forward, 20° aside | straight | upright      | standing         |
/// | forward-bend    | along the trunk         | 15°      | leans by 30° | standing         |
/// | forward-bend-15 | hanging down            | 15°      | leans by 15° | standing         |
/// | forward-bend-30 | hanging down            | 15°      | leans by 30° | standing         |
/// | forward-bend-45 | hanging down            | 15°      | leans by 45° | standing         |
/// | sitting         | 15° forward             | 46°      | upright      | hips, knees 90°  |
/// | slouch          | hanging down            | 15°      | slumped      | standing         |
/// | stride          | 8° aside, relaxed       | 15°      | upright      | heel strike      |
/// | stair-climb     | 8° aside, relaxed       | 15°      | upright      | left on the step |
/// | squat           | level, 10° aside        | straight | leans by 30° | thighs level     |
///
/// Where no angle aside is told, arms are 8° aside and relaxed as in `standing`.
/// Relaxed arms bend forward at the elbow, palms to the thighs; where trunk or thighs leave them no
/// room they hang farther aside (hanging_arms.h). The others are turned as the model has them, with
/// the palms back. 160° is what healthy adults reach forward without the trunk leaning back (Soucie
/// et al. 2011: about 170° in all, passive; recalled). A full slouch: skeleton_pose.h. Heel
/// strike: the left hip at 25°, the right at −10° with its knee at 15° (level walking, Winter 1991,
/// recalled). On the step: the left hip at 65°, its knee at 85° (Protopapadaki et al. 2007: 65° and
/// 94° at most; recalled). Squat: hips at 90°, knees at 100°.
const std::vector<std::pair<std::string, Posture>>& named_postures();

/// Names of the table.
std::vector<std::string> posture_names();

/// The posture of a name of the table, of joint angles (joint_postures.h) as in "elbow-flexion-90",
/// or of both, as in "sitting+elbow-flexion-90": the joints are turned to these angles, all else
/// stays as in the named posture. \throws InvalidInput for an unknown name, with a did-you-mean;
/// as joint_angles; for a joint that the named posture itself turns in another way (the hips of
/// a sitter).
Posture named_posture(const std::string& name);

}  // namespace loosefit::body
