#include <fmt/format.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/drape/carry_layers.h"
#include "loosefit/drape/cloth_run.h"
#include "loosefit/drape/impact_zones.h"
#include "loosefit/drape/worn_detail.h"

namespace loosefit {
namespace {

/// How a way is gone: the largest turn of any skin in one step [rad], the residual between two
/// steps (no more than a way through), and the iterations for it.
struct Gait {
  double step, tolerance;
  int iterations;
};
constexpr Gait kGait{0.4, 100, 25};
/// Of several layers: what the body pushes out has to push the next one.
constexpr Gait kLayeredGait{0.04, 5, 100};
constexpr double kTooFar = 5;       ///< times the tolerance, beyond which a step is worked on
constexpr int kPatience = 8;        ///< times as long
constexpr double kWhole = 0.999;    ///< share of its way that the cloth has to go along a step
constexpr double kTooDeep = 0.012;  ///< in the skin after a step, for which it is halved [m]
constexpr int kShortest = 16;       ///< a step may be so many times shorter than usual
constexpr double kCaught = 0.005;   ///< in the skin near rest: lost [m]
/// Iterations on the finest level after which a posture is given up: so many times those of putting
/// on, and not before so many.
constexpr int kFarMore = 3, kManyIterations = 500;
constexpr double kRoughField = 0.010;  ///< spacing of the distance field on the way [m]
constexpr int kDisplaceSteps = 4;      ///< in which the start is shifted and twisted
constexpr double kWholeWay = 0.9;      ///< share of the way of layers that must be free
constexpr double kStray = 0.002;       ///< that impact zones may lead them off it [m]
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

/// How deep the deepest point lies in the skin [m].
double depth(const std::vector<Vec3>& x, const PosedBody& body) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, x.size()), 0.0,
      [&](const auto& range, double deepest) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          deepest = std::max(deepest, -body.tree().signed_distance(x[i]));
        return deepest;
      },
      [](double a, double b) { return std::max(a, b); });
}

std::string caught_text(double depth) {
  return fmt::format("given up: the cloth is caught {:.0f} mm deep in a fold of the skin",
                     1e3 * depth);
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
  most_iterations_ = std::numeric_limits<int>::max();
  lowest_.reset(), clear_.reset();
  body_ = worn_->body;
  // The way is gone on the coarsest level, where an iteration costs a fraction.
  level_ = 0;
  if (layers() > 1 || largest_turn(body_->body, body_at(1.0)) < kNoTurn)
    level_ = static_cast<int>(worn_->levels.size()) - 1;
  x_ = worn_->levels[level_].x;
  make_model();
  model_->recall(worn_->levels[level_].memory);
  model_->set_field(body_->field);  // the level may remember one that its cloth left later on
  part_ = "posture";
  // On the finest level a pad would undo what holds triangles off the skin.
  const bool padded = layers() == 1 && !is_finest();
  if (padded) model_->pad_body(kPad);
  walk(body_at);
  if (padded) model_->pad_body(0);
  double caught = 0;
  while (!is_finest()) {
    settle(kCoarseTolerance, kPatience * kGait.iterations, 0.02);
    caught = std::max(caught, depth(x_, body_->body));
    refine_as_worn();
  }
  part_ = "settle";
  // Skin that folds over itself does not let go of cloth between its layers: no use in trying.
  if (caught < kCaught) {
    settle(kGait.tolerance, kPatience * kGait.iterations, 0.1, true);
    caught = depth(x_, body_->body);
  }
  if (caught > kCaught) return finish(caught_text(caught));
  const int most = std::max(kManyIterations, kFarMore * worn_->iterations);
  most_iterations_ = iterations_ + most;
  settle_finest();
  if (iterations_ > most_iterations_)
    return finish(fmt::format("given up after {} iterations on the finest level", most));
  return finish();
}

void ClothRun::refine_as_worn() {
  const auto parents = parents_of_next();
  const std::vector<Vec3> before = on_coarse_surface(parents, worn_->levels[level_].x);
  const WornCloth::Level& worn = worn_->levels[++level_];
  x_ = on_coarse_surface(parents, x_);
  make_model();
  const std::vector<Vec3> detail = without_impacts(model_->self().candidates().features(), x_,
                                                   turned_detail(triangles(), before, worn.x, x_));
  const double allowed = model_->self().max_step(x_, detail);
  for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += allowed * detail[i];
  model_->recall(worn.memory);
  model_->set_field(body_->field);
  const std::vector<Vec3> way = way_of(skin_motion(worn_->body->body, body_->body, worn.x), worn.x);
  for (int l = 0; l < layers(); ++l) model_->body(l).carry_anchors(way);
}

void ClothRun::walk(const BodyPath& body_at) {
  const auto& [step, tolerance, iterations] = layers() == 1 ? kGait : kLayeredGait;
  const double turn = largest_turn(body_->body, body_at(1.0));
  if (turn < kNoTurn) return;
  const double usual = 1 / std::ceil(turn / step), least = usual / kShortest;
  double length = usual;
  for (double gone = 0; gone < 1;) {
    if (is_late()) length = 1;  // end on the wanted body, settled or not
    const double to = gone + length > 1 - 0.5 * least ? 1 : gone + length;
    const PosedBody next = body_at(to);
    const std::vector<MotionMap> motion = skin_motion(body_->body, next, x_);
    const std::vector<Vec3> wanted = way_of(carried_layers(model_->mesh(), x_, motion), x_);
    const std::vector<Vec3> carried =
        without_impacts(model_->self().candidates().features(), x_, wanted);
    model_->system().begin_step(x_, std::numeric_limits<double>::infinity());
    const double allowed = model_->self().max_step(x_, carried);
    std::vector<Vec3> there = x_;
    for (std::size_t i = 0; i < x_.size(); ++i) there[i] += allowed * carried[i];
    // A body that goes where the cloth cannot follow would pass through it. Layers that lie on each
    // other have little room, and would be taken along like one rigid piece: shorter ways, and
    // settling makes room anew.
    const bool clear = layers() == 1 ? allowed >= kWhole && depth(there, next) <= kTooDeep
                                     : allowed >= kWholeWay && farthest(wanted, carried) <= kStray;
    if (length > 1.5 * least && !is_late() && !clear) {
      length /= 2;
      continue;
    }
    const std::vector<Vec3> way = way_of(motion, x_);
    for (int l = 0; l < layers(); ++l) model_->body(l).carry_anchors(way);
    x_ = std::move(there);
    body_ = with_field(next, bounds(x_), to < 1 && level_ == 0 ? kRoughField : kFieldSpacing);
    model_->set_field(body_->field);
    gone = to;
    length = std::min(usual, 2 * length);
    if (is_late()) continue;
    settle(tolerance, iterations, 0.02, true);
    // Pressed deep into the skin it would be pulled through it on the next step.
    if (last_.residual > kTooFar * tolerance)
      settle(kTooFar * tolerance, kPatience * iterations, 0.02, true);
  }
}

void ClothRun::displace() {
  const Vec3& shift = options_.start_shift;
  if (shift.isZero() && options_.start_twist == 0) return;
  const auto& skin = body_->body->surface.triangles;
  std::vector<char> on_trunk(x_.size());
  Vec3 centre = Vec3::Zero();
  int count = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const Segment part = body_->body->segment[skin[body_->body.tree().query(x_[i]).triangle][0]];
    on_trunk[i] = part == Segment::torso || part == Segment::neck || part == Segment::thigh;
    if (on_trunk[i]) centre += x_[i], ++count;
  }
  centre /= std::max(count, 1);
  for (int k = 0; k < kDisplaceSteps && !is_late(); ++k) {
    const Mat3 turn =
        Eigen::AngleAxisd(options_.start_twist / kDisplaceSteps, Vec3::UnitZ()).toRotationMatrix();
    std::vector<MotionMap> maps(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const Mat3 own = on_trunk[i] ? turn : Mat3::Identity();
      maps[i] << own, centre - own * centre + shift / kDisplaceSteps;
    }
    const std::vector<Vec3> move = way_of(carried_layers(model_->mesh(), x_, std::move(maps)), x_);
    model_->system().begin_step(x_, std::numeric_limits<double>::infinity());
    const double allowed = model_->self().max_step(x_, move);
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += allowed * move[i];
    settle(kDisplaceTolerance, kGait.iterations, 0.01, true);
  }
}

}  // namespace loosefit
