#include "loosefit/drape/phases/disturb_start.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "loosefit/drape/carry_layers.h"

namespace loosefit::drape {

void disturb_start(ClothState& state) {
  const DrapeOptions& options = state.options;
  const DisturbTuning& tuning = state.tuning.disturb;
  if (options.start_shift.isZero() && options.start_twist == 0) return;
  // What lies on the trunk turns about the axis through its middle; sleeves only shift.
  const body::PosedBody& body = state.body->body;
  std::vector<char> on_trunk(state.x.size());
  Vec3 centre = Vec3::Zero();
  int count = 0;
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    const int skin = body.tree().query(state.x[i]).triangle;
    const body::Segment part = body->segment[body->surface.triangles[skin][0]];
    on_trunk[i] =
        part == body::Segment::torso || part == body::Segment::neck || part == body::Segment::thigh;
    if (on_trunk[i]) centre += state.x[i], ++count;
  }
  centre /= std::max(count, 1);
  for (int k = 0; k < tuning.steps && !state.must_stop(); ++k) {
    const Mat3 turn =
        Eigen::AngleAxisd(options.start_twist / tuning.steps, Vec3::UnitZ()).toRotationMatrix();
    std::vector<MotionMap> maps(state.x.size());
    for (std::size_t i = 0; i < state.x.size(); ++i) {
      const Mat3 own = on_trunk[i] ? turn : Mat3::Identity();
      maps[i] << own, centre - own * centre + options.start_shift / tuning.steps;
    }
    // The seam between both is smoothed over the cloth, then nothing may run into anything.
    const std::vector<Vec3> displacement = displacements(
        carried_layers(state.model->mesh(), state.x, std::move(maps), state.tuning.carry), state.x);
    state.model->system().begin_step(state.x, std::numeric_limits<double>::infinity());
    state.move_without_collision(displacement);
    state.settle({.tolerance = tuning.tolerance,
                  .max_iterations = tuning.iterations,
                  .first_dt = tuning.first_dt,
                  .preparing = true});
  }
}

}  // namespace loosefit::drape
