#include "loosefit/drape/cloth_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/drape/openings.h"
#include "loosefit/solver/implicit_euler.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/solver/semi_implicit_euler.h"

namespace loosefit::drape {
namespace {

std::unique_ptr<solver::Integrator> make_integrator(IntegratorKind kind,
                                                    const solver::ParticleSystem& system) {
  switch (kind) {
    case IntegratorKind::semi_implicit_euler:
      return solver::make_semi_implicit_euler(system);
    case IntegratorKind::implicit_euler:
      return solver::make_implicit_euler(system);
    case IntegratorKind::quasi_static:
      break;
  }
  return solver::make_quasi_static(system);
}

}  // namespace

ClothState::ClothState(const std::vector<ClothLayer>& cloth, const DrapeOptions& asked,
                       const Recoveries& table, Progress& told)
    : layers(cloth),
      options(asked),
      tuning(asked.tuning),
      recoveries(table),
      progress(told),
      budget(asked) {
  if (layers.empty()) throw InvalidInput("a drape needs at least one garment");
  for (const ClothLayer& layer : layers)
    if (layer.garment->levels.size() != layers.front().garment->levels.size())
      throw InvalidInput("garments worn over each other need meshes of the same levels");
  tuning.validate();
}

std::vector<const garment::Garment*> ClothState::garments() const {
  std::vector<const garment::Garment*> all;
  for (int l = 0; l < layer_count(); ++l) all.push_back(&garment(l));
  return all;
}

bool ClothState::must_stop() const {
  return falling || budget.time_is_up() || budget.iterations_left() == 0;
}

Stop ClothState::how_it_ended() const {
  if (given_up) return *given_up;
  if (went_back) return *went_back;
  if (stalled) return *stalled;
  if (falling) return *falling;
  // A loose tolerance may have been met when time or iterations were used up: that is not why it
  // stopped.
  if (last.residual > options.residual_tolerance) {
    if (budget.time_is_up()) return {StopReason::time_budget};
    if (budget.iterations_left() == 0) return {StopReason::iteration_limit};
    if (budget.phase_is_over())
      return {.reason = StopReason::posture_too_long, .iterations = budget.phase_length()};
  }
  return {stop_reason(last.reason)};
}

void ClothState::make_model(double stiffness_share, bool with_friction) {
  std::vector<ModelLayer> parts;
  for (int l = 0; l < layer_count(); ++l) {
    ModelLayer one{&garment(l), layers[l].material, 0, layers[l].friction_over};
    if (!with_friction) {
      one.material.friction_body = one.material.friction_self = 0;
      one.friction_over = 0;
    }
    fabric::scale_membrane(one.material, stiffness_share);
    const garment::GarmentHierarchy& cloth = *layers[l].garment;
    const garment::Garment& coarsest = cloth.levels.front();
    one.under_soles = goes_under_soles(coarsest, cloth.pattern,
                                       garment_openings(coarsest, cloth.pattern, body->body));
    one.self_thickness =
        one.material.thickness * (is_finest() ? 1.0 : tuning.cloth.coarse_thickness);
    parts.push_back(std::move(one));
  }
  integrator_.reset();
  model = std::make_unique<ClothModel>(parts, options);
  model->set_body(*body);
  free_fall_.emplace(garments(), tuning.free_fall);
}

void ClothState::soften_contact(bool soft) {
  if (soft && !is_single()) return;
  model->soften_body_contact(soft ? tuning.contract.pad_thickness : 0);
}

void ClothState::loosen_friction() { model->set_friction_share(friction_share); }

void ClothState::stick() {
  if (friction_share == 1) return;
  model->forget_anchors();
  model->set_friction_share(1);
}

void ClothState::move_without_collision(const std::vector<Vec3>& displacement) {
  const double allowed = model->self().max_step(x, displacement);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += allowed * displacement[i];
}

void ClothState::carry_anchors(const std::vector<Vec3>& displacement) {
  for (int l = 0; l < layer_count(); ++l) model->body(l).carry_anchors(displacement);
}

bool ClothState::is_stalled(int iteration, double residual) {
  const auto height = [this] {
    double sum = 0;
    for (const Vec3& p : x) sum += p.z();
    return sum / static_cast<double>(x.size());
  };
  const int since = iteration - progress_at_;
  if (residual < tuning.stall.progress * progress_to_) {
    progress_to_ = residual, progress_at_ = iteration, progress_height_ = height();
    return false;
  }
  if (since < tuning.stall.iterations) return false;
  if (const double sunk = progress_height_ - height(); sunk > tuning.stall.slides)
    falling = Stop{.reason = StopReason::slides_down, .iterations = since, .sunk = sunk};
  else
    stalled =
        Stop{.reason = StopReason::no_progress, .iterations = since, .residual = progress_to_};
  return true;
}

void ClothState::settle(const SettleGoal& goal) {
  // The dynamic integrators are asked for by name for the final level; before it, quasi-static
  // steps bring the cloth near.
  const bool counts = is_finest() && !goal.preparing;
  const auto kind = counts ? options.integrator : IntegratorKind::quasi_static;
  const bool explicit_steps = kind == IntegratorKind::semi_implicit_euler;
  const int iterations = std::min(goal.max_iterations, budget.iterations_left());
  solver::SettleOptions settle;
  settle.tolerance = goal.tolerance;
  // Only at rest is a single particle looked at.
  if (const double rest = std::max(options.residual_tolerance, solver::kRestTolerance);
      counts && goal.tolerance <= rest)
    settle.largest = solver::kRestLargest * (rest / solver::kRestTolerance);
  settle.tangent =
      particles::BendingTangent::hinge;  // half the cost of an iteration, as many of them
  settle.max_iterations =
      explicit_steps ? tuning.integrators.explicit_steps * iterations : iterations;
  settle.first_dt =
      kind == IntegratorKind::implicit_euler ? tuning.integrators.implicit_dt : goal.first_dt;
  const geometry::Box3 body_box = bounds(body->body->surface.vertices);
  // Reports each iteration, keeps good states, and sees what ends the settling from outside.
  int done_iterations = 0;
  settle.watch = [&](int iteration, double residual) {
    done_iterations = iteration;
    progress.check_cancelled();
    report.history.push_back({budget.seconds(), level, budget.iterations() + iteration, residual});
    const double done = std::log10(std::max(residual, goal.tolerance) / 10) /
                        std::log10(options.residual_tolerance / 10);
    fraction_ = std::clamp(done, 0.0, 1.0);
    progress.update(fraction_, "level " + std::to_string(level + 1) + " of " +
                                   std::to_string(level_count()) + ", residual " +
                                   std::to_string(residual));
    if (counts && (!lowest || residual < tuning.certify.worth_keeping * lowest->residual))
      keep(lowest, residual);
    if (!falling) falling = free_fall_->falling(x, body_box);
    return falling || budget.time_is_up() || budget.phase_is_over(iteration) ||
           (counts && kind == IntegratorKind::quasi_static && is_stalled(iteration, residual));
  };
  went_back.reset();
  stalled.reset();
  progress_to_ = std::numeric_limits<double>::infinity(), progress_at_ = 0;
  recover(RecoveryPoint::before_settle);
  const long searches_before = model->self().searches();
  if (!integrator_ || integrator_kind_ != kind) {
    integrator_ = make_integrator(kind, model->system());
    integrator_kind_ = kind;
  }
  last = integrator_->settle(x, settle);
  // Work is told apart by part and level.
  if (report.parts.empty() || report.parts.back().part != part ||
      report.parts.back().level != level || report.parts.back().start != start)
    report.parts.push_back({part, level, static_cast<int>(x.size()), start, {}});
  report.parts.back().work += last.work;
  // Implicit Euler is limited and counted by its time steps, each of a few Newton iterations.
  const bool implicit_steps = kind == IntegratorKind::implicit_euler;
  budget.count(implicit_steps ? done_iterations : last.work.iterations, explicit_steps);
  report.ccd_queries += static_cast<int>(model->self().searches() - searches_before);
}

void ClothState::keep(std::optional<Kept>& kept, double residual) const {
  kept.emplace(
      Kept{x, model->memory(), residual, report.held_off_triangles, body, start, times_cut});
}

bool ClothState::recover(RecoveryPoint point) {
  for (const Recovery& recovery : recoveries) {
    if (recovery.point != point) continue;
    int& tried = attempts[recovery.kind];
    if (tried >= recovery.most_attempts(tuning) || !recovery.has_failed(*this)) continue;
    ++tried;
    report.count(recovery.kind, recovery.name);
    progress.update(fraction_, recovery.name);
    recovery.act(*this);
    return true;
  }
  return false;
}

}  // namespace loosefit::drape
