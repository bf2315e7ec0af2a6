#include "loosefit/drape/phases/follow_posture.h"

#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/drape/carry_layers.h"
#include "loosefit/drape/impact_zones.h"

namespace loosefit::drape {
namespace {

/// A step of the body, and where the cloth would be after it.
struct Move {
  body::PosedBody body;
  std::vector<MotionMap> skin_motion;  ///< of the skin next to each particle
  std::vector<Vec3> x;
  bool blocked = false;  ///< the cloth cannot go along
};

/// Whether a place lies in the skin by more than a part of the way to the middle of the limb: from
/// there on some of the cloth would be pushed out on the other side. `depth` receives how deep [m].
bool is_far_in_limb(const geometry::ClosestPointTree& skin, const Vec3& p,
                    const FollowTuning& tuning, double& depth) {
  geometry::ClosestPoint hit;
  depth = -skin.signed_distance(p, &hit);
  if (depth < tuning.shallow) return false;
  // Towards the middle the depth grows as fast as one goes in, and from there on falls.
  const Vec3 inward = p + tuning.limb_share * (p - hit.point);
  return -skin.signed_distance(inward) < (1 + 0.75 * tuning.limb_share) * depth;
}

/// Whether the move would press a vertex or the middle of an edge so deep into a limb that it might
/// come out on the other side, deeper than it lies now.
bool presses_through(const ClothState& state, const Move& move) {
  const FollowTuning& tuning = state.tuning.follow;
  const geometry::ClosestPointTree &skin = move.body.tree(), &now = state.body->body.tree();
  const auto far_in = [&](const Vec3& after, const Vec3& before) {
    double depth = 0;
    return is_far_in_limb(skin, after, tuning, depth) &&
           depth > -now.signed_distance(before) + tuning.deeper;
  };
  const auto any = [&](std::size_t count, const auto& is_one) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, count), false,
        [&](const auto& range, bool found) {
          for (std::size_t i = range.begin(); i < range.end() && !found; ++i) found = is_one(i);
          return found;
        },
        [](bool a, bool b) { return a || b; });
  };
  const std::vector<Triangle>& triangles = state.triangles();
  return any(state.x.size(), [&](std::size_t i) { return far_in(move.x[i], state.x[i]); }) ||
         any(triangles.size(), [&](std::size_t t) {
           for (int k = 0; k < 3; ++k) {
             const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
             if (a > b && far_in(0.5 * (move.x[a] + move.x[b]), 0.5 * (state.x[a] + state.x[b])))
               return true;
           }
           return false;
         });
}

Move plan_move(const ClothState& state, const body::PosedBody& to) {
  const FollowTuning& tuning = state.tuning.follow;
  ClothModel& model = *state.model;
  const std::vector<Vec3>& x = state.x;
  Move move;
  move.body = to;
  move.skin_motion = skin_motion(state.body->body, to, x);
  // The cloth is carried by the skin; parts of it that would meet on the way move as rigid zones.
  const std::vector<Vec3> carried =
      displacements(carried_layers(model.mesh(), x, move.skin_motion, state.tuning.carry), x);
  const std::vector<Vec3> free = without_impacts(model.self().candidates().features(), x, carried,
                                                 state.tuning.carry.impact_rounds);
  model.system().begin_step(x, std::numeric_limits<double>::infinity());
  const double share = model.self().max_step(x, free);
  move.x = x;
  for (std::size_t i = 0; i < x.size(); ++i) move.x[i] += share * free[i];
  // A body that goes where the cloth cannot follow would pass through it. Settling makes room anew:
  // the skin pushes the layer on it, and that the next.
  const double least = state.is_single() ? tuning.free_share : tuning.layers_free_share;
  move.blocked = !(share >= least && depth_in_skin(move.x, move.body) <= tuning.deepest &&
                   !presses_through(state, move));
  return move;
}

/// `end`: of the path, if the move leads there.
void make_move(ClothState& state, Move move, const PathEnd* end) {
  const bool rough = !(end && end->stays) && state.level == 0;
  state.carry_anchors(displacements(move.skin_motion, state.x));
  state.x = std::move(move.x);
  if (end && end->known && end->known->field->covers(bounds(state.x)))
    state.body = end->known;
  else
    state.body = with_field(move.body, bounds(state.x),
                            rough ? state.tuning.carry.rough_field_spacing : contact::kFieldSpacing,
                            state.tuning.carry, state.arms_go_up);
  state.model->set_body(*state.body);
}

/// A body without maps does not turn, and may move all the same.
int usual_steps(double turn, const StepPlan& plan) {
  return std::max(1, static_cast<int>(std::ceil(turn / plan.turn)));
}

}  // namespace

double largest_turn(const body::Body& from, const body::Body& to, const FollowTuning& tuning) {
  const auto &a = from.pose_from_rest, &b = to.pose_from_rest;
  double turn = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); i += tuning.sampled_skin) {
    const Mat3 change = b[i].leftCols<3>() - a[i].leftCols<3>();
    // ‖R − 1‖ = 2√2 sin(angle/2); blended maps are no rotations, but nearly.
    turn = std::max(turn, 2 * std::asin(std::min(1.0, change.norm() / std::sqrt(8.0))));
  }
  return turn;
}

double depth_in_skin(const std::vector<Vec3>& x, const body::PosedBody& body) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, x.size()), 0.0,
      [&](const auto& range, double deepest) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          deepest = std::max(deepest, -body.tree().signed_distance(x[i]));
        return deepest;
      },
      [](double a, double b) { return std::max(a, b); });
}

void follow_path(ClothState& state, const body::BodyPath& path, const PathEnd& path_end) {
  const FollowTuning& tuning = state.tuning.follow;
  const StepPlan& plan = tuning.plan;
  const double turn = largest_turn(state.body->body, path(1.0), tuning);
  const double usual = 1.0 / usual_steps(turn, plan);
  PostureStep& step = state.step;
  step = {.done = 0, .length = usual, .least = usual / tuning.shortest};
  while (step.done < 1) {
    if (state.must_stop()) step.length = 1;  // end on the wanted body, settled or not
    // What would be left for a last step shorter than half the least one is taken along.
    const double end = step.done + step.length;
    const double to = end > 1 - tuning.taken_along * step.least ? 1 : end;
    const PathEnd* last = to == 1 ? &path_end : nullptr;
    Move move = plan_move(state, last && last->known ? last->known->body : path(to));
    step.blocked = move.blocked;
    if (state.recover(RecoveryPoint::before_step)) continue;
    make_move(state, std::move(move), last);
    step.done = to;
    step.length = std::min(usual, 2 * step.length);
    if (state.must_stop()) continue;
    state.settle({.tolerance = plan.tolerance,
                  .max_iterations = plan.iterations,
                  .first_dt = tuning.first_dt,
                  .preparing = true});
    state.recover(RecoveryPoint::after_step);
  }
}

void follow_posture(ClothState& state) {
  const double turn = largest_turn(state.body->body, state.path(1.0), state.tuning.follow);
  if (turn < state.tuning.follow.no_turn) return;
  follow_path(state, state.path, {});
}

}  // namespace loosefit::drape
