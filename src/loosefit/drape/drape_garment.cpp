#include "loosefit/drape/drape_garment.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/drape/cloth_run.h"
#include "loosefit/drape/hold_off_cuts.h"
#include "loosefit/dress/dress.h"

namespace loosefit {
namespace {

constexpr double kDressTolerance = 5.0;  ///< residual at which the dressed coarse level may move on
constexpr double kContractTolerance = 30;  ///< residual while the softened start contracts
constexpr int kContractIterations = 60;
constexpr double kCoarseTolerance = 1.0;  ///< residual before a level is handed to the finer one
constexpr double kPoseTolerance = 0.5;    ///< residual between two steps of a posture path
constexpr double kPoseStep = 0.07;        ///< largest joint angle of one step of the path [rad]
constexpr int kCutRounds = 8;             ///< attempts to free the last cuts into the body
/// Residuals on the way down at which cuts are looked for, and first pseudo-steps on each part [s].
constexpr std::pair<double, double> kCutTolerances[] = {{30.0, 0.1}, {5.0, 0.5}, {1.0, 2.5}};
constexpr double kCutTolerance = 1.0;  ///< residual at which the last cuts are looked for
/// Pseudo-steps on the way to rest [s]: the first, and after contacts were changed near rest.
constexpr double kFirstDt = 0.5, kStaticDt = 10;

}  // namespace

Drape ClothRun::drape() {
  progress_.stage("dress");
  put_on();
  progress_.stage("settle");
  part_ = "posture";
  assume_posture();
  part_ = "settle";
  settle_levels();
  return finish();
}

void ClothRun::put_on() {
  Body body = body_at_(0.0);
  x_ = is_shirt(level_garment()) ? dress_shirt(level_garment(), body)
                                 : dress_as_placed(level_garment(), garment_.pattern);
  perturb();
  body_ = pose_for_contact(std::move(body), bounds(x_), kFieldSpacing);
  // The strained start contracts as if it were soft at first, and without friction, so
  // that it comes to lie on the limbs and is not pulled through them.
  for (double share : {0.01, 0.1}) {
    make_model(share, false);
    settle(kContractTolerance, kContractIterations, 0.01, true);
  }
  make_model();
  settle(kDressTolerance, options_.max_iterations, 0.01, true);
}

void ClothRun::assume_posture() {
  int steps = 1;
  {
    const Body end = body_at_(1.0);
    double turn = 0;  // largest rotation that any skin undergoes on the way
    const auto &a = body_->body.pose_from_rest, &b = end.pose_from_rest;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); i += 7) {
      const Mat3 relative = b[i].leftCols<3>() * a[i].leftCols<3>().transpose();
      turn = std::max(turn, std::acos(std::clamp((relative.trace() - 1) / 2, -1.0, 1.0)));
    }
    if (turn < 1e-6) return;
    steps = static_cast<int>(std::ceil(turn / kPoseStep));
  }
  for (int k = 1; k <= steps; ++k) {
    if (seconds() > options_.time_budget) k = steps;  // end on the wanted body, settled or not
    const double share = double(k) / steps;
    auto next = pose_for_contact(body_at_(share), bounds(x_), kFieldSpacing);
    const auto carried = carry_along(*body_, next->body, x_, level_garment().triangles);
    model_->system().begin_step(x_, std::numeric_limits<double>::infinity());
    const double allowed = model_->self().begin_search(x_, carried);
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += allowed * carried[i];
    body_ = std::move(next);
    model_->body().set_field(body_->field);
    settle(kPoseTolerance, 40, 0.02, true);
  }
}

void ClothRun::settle_levels() {
  while (!is_finest()) {
    settle(kCoarseTolerance, options_.max_iterations, 0.02);
    refine();
  }
  // Cuts into the skin are looked for long before the last digits of the balance are sought.
  std::map<int, int> times_cut;
  const auto hold_off = [&](bool look_ahead) {
    return hold_off_cuts(*model_, level_garment(), *body_, x_, 0.5 * material_.thickness,
                         look_ahead, times_cut);
  };
  for (const auto& [tolerance, first_dt] : kCutTolerances) {
    settle(std::max(tolerance, options_.residual_tolerance), options_.max_iterations, first_dt);
    if (seconds() > options_.time_budget) return;
    hold_off(true);
  }
  // A round for the last digits, while there are still cuts, would be thrown away.
  const double fine = options_.residual_tolerance, rough = std::max(kCutTolerance, fine);
  for (int round = 0; round <= kCutRounds; ++round) {
    settle(rough, options_.max_iterations, round == 0 ? kFirstDt : kStaticDt);
    if (seconds() > options_.time_budget) break;
    if (round < kCutRounds && hold_off(false)) continue;
    if (fine < last_.residual) settle(fine, options_.max_iterations, kStaticDt);
    if (seconds() > options_.time_budget || round == kCutRounds || !hold_off(false)) break;
  }
  report_.held_off_triangles = static_cast<int>(times_cut.size());
}

Drape drape_garment(const GarmentHierarchy& garment, const Material& material,
                    const BodyPath& body_at, const DrapeOptions& options, Progress& progress) {
  std::optional<tbb::global_control> threads;
  if (options.threads > 0)
    threads.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
  return ClothRun(garment, material, body_at, options, progress).drape();
}

}  // namespace loosefit
