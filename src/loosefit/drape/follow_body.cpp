#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/drape/carry_layers.h"
#include "loosefit/drape/cloth_run.h"
#include "loosefit/drape/impact_zones.h"

namespace loosefit {
namespace {

constexpr double kStep = 0.2;       ///< largest turn of any skin in one step of the way [rad]
constexpr double kTolerance = 100;  ///< residual between two steps: no more than a way through
constexpr int kIterations = 25;     ///< between two steps
/// The same of several layers: what the body pushes out has to push the next one.
constexpr double kLayeredStep = 0.04, kLayeredTolerance = 5;
constexpr int kLayeredIterations = 100;
constexpr double kWholeWay = 0.9;  ///< share of the way of layers that must be free
constexpr double kStray = 0.002;   ///< that impact zones may lead them off it [m]
constexpr int kTicks = 8;          ///< parts of a step, the shortest way where it is not
constexpr double kTooFar = 5;      ///< times the tolerance, beyond which a step is worked on
constexpr int kPatience = 8;       ///< times as long
/// Of the wanted residual: the certificate looks anew, when contacts may have come or gone.
constexpr double kFine = 0.8;
constexpr int kDisplaceSteps = 4;  ///< in which the start is shifted and twisted
constexpr double kDisplaceTolerance = 5.0;
constexpr double kNoTurn = 1e-6;  // [rad]

/// Largest rotation that any skin undergoes from one posture to another [rad].
double largest_turn(const Body& from, const Body& to) {
  const auto &a = from.pose_from_rest, &b = to.pose_from_rest;
  double turn = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); i += 7) {
    const Mat3 change = b[i].leftCols<3>() - a[i].leftCols<3>();
    // ‖R − 1‖ = 2√2 sin(angle/2); blended maps are no rotations, but nearly.
    turn = std::max(turn, 2 * std::asin(std::min(1.0, change.norm() / std::sqrt(8.0))));
  }
  return turn;
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).squaredNorm());
  return std::sqrt(most);
}

}  // namespace

Drape ClothRun::follow(const BodyPath& body_at) {
  start_ = Clock::now();
  report_ = {};
  iterations_ = 0;
  x_ = worn_->x;
  body_ = worn_->body;
  model_->recall(worn_->memory);
  part_ = "posture";
  if (layers() == 1)
    walk(body_at, kStep, kTolerance, kIterations);
  else
    walk(body_at, kLayeredStep, kLayeredTolerance, kLayeredIterations);
  part_ = "settle";
  settle_finest(kFine * options_.residual_tolerance);
  return finish();
}

void ClothRun::walk(const BodyPath& body_at, double step, double tolerance, int iterations) {
  const double turn = largest_turn(body_->body, body_at(1.0));
  if (turn < kNoTurn) return;
  const int ticks = kTicks * static_cast<int>(std::ceil(turn / step));
  for (int gone = 0, stride = kTicks; gone < ticks;) {
    // At the end of the budget on the wanted body, settled or not.
    const int target = seconds() > options_.time_budget ? ticks : std::min(gone + stride, ticks);
    std::shared_ptr<const PosedBody> next =
        pose_for_contact(body_at(double(target) / ticks), bounds(x_), kFieldSpacing);
    const std::vector<MotionMap> motion = skin_motion(*body_, next->body, x_);
    const std::vector<Vec3> wanted = way_of(carried_layers(model_->mesh(), x_, motion), x_);
    const std::vector<Vec3> carried =
        without_impacts(model_->self().candidates().features(), x_, wanted);
    model_->system().begin_step(x_, std::numeric_limits<double>::infinity());
    const double allowed = model_->self().begin_search(x_, carried);
    // Layers that lie on each other have little room, and would be taken along like one rigid
    // piece: shorter ways, and settling makes room anew.
    const bool clear = allowed >= kWholeWay && farthest(wanted, carried) <= kStray;
    if (layers() > 1 && !clear && stride > 1 && seconds() < options_.time_budget) {
      stride /= 2;
      continue;
    }
    const std::vector<Vec3> way = way_of(motion, x_);
    for (int l = 0; l < layers(); ++l) model_->body(l).carry_anchors(way);
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += allowed * carried[i];
    body_ = std::move(next);
    model_->set_field(body_->field);
    settle(tolerance, iterations, 0.02, true);
    // Pressed deep into the skin it would be pulled through it on the next step.
    if (last_.residual > kTooFar * tolerance)
      settle(kTooFar * tolerance, kPatience * iterations, 0.02, true);
    gone = target;
    stride = std::min(2 * stride, kTicks);
  }
}

void ClothRun::displace() {
  const Vec3& shift = options_.start_shift;
  if (shift.isZero() && options_.start_twist == 0) return;
  const auto& skin = body_->body.surface.triangles;
  std::vector<char> on_trunk(x_.size());
  Vec3 centre = Vec3::Zero();
  int count = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const Segment part = body_->body.segment[skin[body_->tree->query(x_[i]).triangle][0]];
    on_trunk[i] = part == Segment::torso || part == Segment::neck || part == Segment::thigh;
    if (on_trunk[i]) centre += x_[i], ++count;
  }
  centre /= std::max(count, 1);
  for (int k = 0; k < kDisplaceSteps; ++k) {
    const Mat3 turn =
        Eigen::AngleAxisd(options_.start_twist / kDisplaceSteps, Vec3::UnitZ()).toRotationMatrix();
    std::vector<MotionMap> maps(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const Mat3 own = on_trunk[i] ? turn : Mat3::Identity();
      maps[i] << own, centre - own * centre + shift / kDisplaceSteps;
    }
    const std::vector<Vec3> move = way_of(carried_layers(model_->mesh(), x_, std::move(maps)), x_);
    model_->system().begin_step(x_, std::numeric_limits<double>::infinity());
    const double allowed = model_->self().begin_search(x_, move);
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += allowed * move[i];
    settle(kDisplaceTolerance, kIterations, 0.01, true);
  }
}

}  // namespace loosefit
