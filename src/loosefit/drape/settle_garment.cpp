#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "loosefit/drape/cloth_run.h"
#include "loosefit/drape/hold_off_cuts.h"
#include "loosefit/dress/dress_layers.h"
#include "loosefit/kinds/registry.h"

namespace loosefit {
namespace {

constexpr double kDressTolerance = 5.0;  ///< residual at which the dressed coarse level may move on
constexpr double kContractTolerance = 30;  ///< residual while the softened start contracts
constexpr int kContractIterations = 60;
constexpr int kCutRounds = 30;  ///< attempts to free the last cuts into the body
/// Residuals on the way down at which cuts are looked for, and first pseudo-steps on each part [s].
constexpr std::pair<double, double> kCutTolerances[] = {{30.0, 0.1}, {5.0, 0.5}, {1.0, 2.5}};
constexpr int kCutIterations = 15;     ///< at most, before each of these looks
constexpr double kCutTolerance = 1.0;  ///< residual at which the last cuts are looked for
constexpr double kFirstDt = 0.5;       ///< first pseudo-step on the way to rest [s]

}  // namespace

Drape ClothRun::put_on(const BodyPath& body_at) {
  progress_.stage("dress");
  dress(body_at(0.0));
  progress_.stage("settle");
  part_ = "posture";
  walk(body_at);
  part_ = "settle";
  model_->pad_body(0);
  settle_levels();
  Drape drape = finish();
  if (may_try_again(drape.certificate)) {
    settle_from_pad();
    drape = finish();
    first_try_.reset();
  }
  handed_on_.push_back({x_, model_->memory()});
  int iterations = 0;
  for (const PartWork& p : report_.parts)
    if (p.level == level_ && (p.part == "settle" || p.part == "retry"))
      iterations += p.work.iterations;
  worn_ = std::make_shared<const WornCloth>(WornCloth{std::move(handed_on_), body_, iterations});
  return drape;
}

void ClothRun::dress(const PosedBody& body) {
  std::vector<LayerToDress> to_dress;
  for (int l = 0; l < layers(); ++l) {
    const Pattern& pattern = layers_[l].garment->pattern;
    to_dress.push_back({&level_garment(l), &pattern, garment_kind(pattern.kind).lay});
  }
  x_ = dress_layers(to_dress, body);
  perturb();
  body_ = with_field(body, bounds(x_), kFieldSpacing);
  // The strained start contracts as if it were soft at first, and without friction, so
  // that it comes to lie on the limbs and is not pulled through them. It has no weight until it is
  // as stiff and as rough as it is: a waistband that stretches over the hips would fall.
  for (double share : {0.01, 0.1}) {
    make_model(share, false);
    model_->take_weight();
    if (layers() == 1) model_->pad_body(kPad);
    if (!is_late()) settle(kContractTolerance, kContractIterations, 0.01, true);
  }
  make_model();
  if (layers() == 1) model_->pad_body(kPad);
  if (!is_late()) displace();
  if (!is_late()) settle(kDressTolerance, options_.max_iterations, 0.01, true);
}

void ClothRun::settle_levels() {
  while (!is_finest()) {
    if (!is_late()) settle(kCoarseTolerance, options_.max_iterations, 0.02);
    handed_on_.push_back({x_, model_->memory()});
    refine();
  }
  settle_finest();
}

bool ClothRun::may_try_again(const Certificate& c) const {
  const double allowed = std::max(options_.residual_tolerance, Certificate::kAllowedResidual);
  const bool failed = c.intersections_body > 0 || c.residual > allowed;
  // The pad frees cloth from the skin, not from other cloth.
  return failed && c.intersections_self == 0 && layers() == 1 && !over() &&
         options_.integrator == IntegratorKind::quasi_static;
}

void ClothRun::settle_from_pad() {
  keep(first_try_, last_.residual);
  first_try_->ended = how_it_ended();
  lowest_.reset(), clear_.reset();
  report_.held_off_triangles = 0;
  part_ = "retry";
  progress_.update(0, kOnceMore);
  make_model();
  model_->pad_body(kPad);
  settle(kDressTolerance, options_.max_iterations, 0.01, true);
  model_->pad_body(0);
  if (!over()) settle_finest();
}

void ClothRun::settle_finest() {
  // Cuts into the skin are looked for long before the last digits of the balance are sought.
  std::map<int, int> times_cut;
  std::vector<double> half_thickness;
  for (const ClothLayer& layer : layers_) half_thickness.push_back(0.5 * layer.material.thickness);
  lowest_.reset(), clear_.reset();
  const auto hold_off = [&](bool look_ahead) {
    const bool low = !clear_ || last_.residual < clear_->residual;
    std::optional<Kept> here;
    if (low) keep(here, last_.residual);
    const CutRound round =
        hold_off_cuts(*model_, *body_, x_, half_thickness, look_ahead, times_cut);
    if (low && !round.cuts) clear_ = std::move(here);
    report_.held_off_triangles = static_cast<int>(times_cut.size());
    return round.cuts && round.held;
  };
  for (const auto& [tolerance, first_dt] : kCutTolerances) {
    settle(std::max(tolerance, options_.residual_tolerance),
           std::min(kCutIterations, options_.max_iterations), first_dt);
    if (over()) return;
    hold_off(true);
  }
  // A round for the last digits, while there are still cuts, would be thrown away.
  const double fine = options_.residual_tolerance, rough = std::max(kCutTolerance, fine);
  for (int round = 0; round <= kCutRounds; ++round) {
    settle(rough, options_.max_iterations, round == 0 ? kFirstDt : kStaticDt);
    if (over()) break;
    if (round < kCutRounds && hold_off(false)) continue;
    if (fine < last_.residual) settle(fine, options_.max_iterations, kStaticDt);
    if (over() || round == kCutRounds || !hold_off(false)) break;
  }
}

}  // namespace loosefit
