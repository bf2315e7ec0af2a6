#include "loosefit/drape/cloth_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/drape/certify.h"
#include "loosefit/drape/explain_unsettled.h"
#include "loosefit/drape/worn_detail.h"
#include "loosefit/solver/implicit_euler.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/solver/semi_implicit_euler.h"

namespace loosefit {
namespace {

constexpr int kNearer = 3;             ///< attempts to meet the certificate's residual
constexpr double kWorthKeeping = 0.7;  ///< fall of the residual that makes a state worth keeping
constexpr double kCoarseLayer = 2.0;   ///< coarse levels keep layers this much farther apart

std::unique_ptr<Integrator> make_integrator(IntegratorKind kind, const ParticleSystem& system) {
  switch (kind) {
    case IntegratorKind::semi_implicit_euler:
      return make_semi_implicit_euler(system);
    case IntegratorKind::implicit_euler:
      return make_implicit_euler(system);
    case IntegratorKind::quasi_static:
      break;
  }
  return make_quasi_static(system);
}

/// Without cuts before with cuts, then by the residual.
bool better(const Certificate& a, const Certificate& b) {
  const bool a_cuts = a.intersections_body + a.intersections_self > 0;
  const bool b_cuts = b.intersections_body + b.intersections_self > 0;
  return a_cuts == b_cuts ? a.residual < b.residual : b_cuts;
}

}  // namespace

ClothRun::ClothRun(const std::vector<ClothLayer>& layers, const DrapeOptions& options,
                   Progress& progress)
    : layers_(layers), options_(options), progress_(progress) {
  if (layers.empty()) throw InvalidInput("a drape needs at least one garment");
  for (const ClothLayer& layer : layers)
    if (layer.garment->levels.size() != layers.front().garment->levels.size())
      throw InvalidInput("garments worn over each other need meshes of the same levels");
}

ClothRun::ClothRun(const std::vector<ClothLayer>& layers, const DrapeOptions& options,
                   std::shared_ptr<const WornCloth> start, Progress& progress)
    : ClothRun(layers, options, progress) {
  worn_ = std::move(start);
}

void ClothRun::make_model(double stiffness_share, bool with_friction) {
  std::vector<ModelLayer> parts;
  for (int l = 0; l < layers(); ++l) {
    Material material = layers_[l].material;
    if (!with_friction) material.friction_body = material.friction_self = 0;
    scale_membrane(material, stiffness_share);
    const double thickness = material.thickness * (is_finest() ? 1.0 : kCoarseLayer);
    parts.push_back({&level_garment(l), std::move(material), thickness});
  }
  const double share = with_friction ? 1 : 0;
  integrator_.reset();
  model_ = std::make_unique<ClothModel>(parts, share * layer_friction(layers_), options_);
  model_->set_field(body_->field);
  std::vector<const Garment*> garments;
  for (int l = 0; l < layers(); ++l) garments.push_back(&level_garment(l));
  free_fall_ = std::make_unique<FreeFall>(garments);
}

void ClothRun::keep_cloth_in_field() {
  if (body_->field->covers(bounds(x_))) return;
  outgrown_.push_back(body_);
  body_ = with_field(body_->body, bounds(x_), body_->field->spacing());
  model_->set_field(body_->field);
}

bool ClothRun::settle(double tolerance, int iterations, double first_dt, bool preparing) {
  // The dynamic integrators are asked for by name for the final level; before it, quasi-static
  // steps bring the cloth near.
  const auto kind = is_finest() && !preparing ? options_.integrator : IntegratorKind::quasi_static;
  SettleOptions settle;
  settle.tolerance = tolerance;
  settle.tangent = BendingTangent::hinge;  // half the cost of an iteration, as many of them
  settle.max_iterations =
      kind == IntegratorKind::semi_implicit_euler ? 1000 * iterations : iterations;
  settle.first_dt = kind == IntegratorKind::implicit_euler ? 0.02 : first_dt;
  const Box3 body_box = bounds(body_->body->surface.vertices);
  settle.watch = [&](int iteration, double residual) {
    progress_.check_cancelled();
    report_.history.push_back({seconds(), level_, iterations_ + iteration, residual});
    const double done = std::log10(std::max(residual, tolerance) / 10) /
                        std::log10(options_.residual_tolerance / 10);
    progress_.update(std::clamp(done, 0.0, 1.0), "level " + std::to_string(level_ + 1) + " of " +
                                                     std::to_string(levels()) + ", residual " +
                                                     std::to_string(residual));
    if (is_finest() && !preparing && (!lowest_ || residual < kWorthKeeping * lowest_->residual))
      keep(lowest_, residual);
    if (falling_.empty()) falling_ = free_fall_->falling(x_, body_box);
    return over(iteration);
  };
  keep_cloth_in_field();
  const long searches_before = model_->self().searches();
  if (!integrator_ || integrator_kind_ != kind) {
    integrator_ = make_integrator(kind, model_->system());
    integrator_kind_ = kind;
  }
  last_ = integrator_->settle(x_, settle);
  if (report_.parts.empty() || report_.parts.back().part != part_ ||
      report_.parts.back().level != level_)
    report_.parts.push_back({part_, level_, static_cast<int>(x_.size()), {}});
  report_.parts.back().work += last_.work;
  iterations_ += last_.work.iterations;
  report_.ccd_queries += static_cast<int>(model_->self().searches() - searches_before);
  return last_.reason == SettleOutcome::Reason::converged;
}

void ClothRun::keep(std::optional<Kept>& kept, double residual) {
  kept.emplace(Kept{x_, model_->memory(), residual, report_.held_off_triangles});
}

void ClothRun::perturb() {
  if (!(options_.start_perturbation > 0)) return;
  std::mt19937_64 rng(options_.seed);
  std::normal_distribution<double> normal(0, options_.start_perturbation);
  const Vec3 shift(normal(rng), normal(rng), normal(rng));
  const double phase = 2 * kPi * std::uniform_real_distribution<double>(0, 1)(rng);
  for (Vec3& p : x_) p += shift * (1 + 0.5 * std::sin(20 * p[2] + 12 * p[0] + phase));
}

std::vector<std::array<int, 2>> ClothRun::parents_of_next() const {
  std::vector<std::array<int, 2>> all;
  for (int l = 0, shift = 0; l < layers(); shift += level_garment(l++).vertex_count)
    for (const auto& [a, b] : layers_[l].garment->parents[level_ + 1])
      all.push_back({a + shift, b + shift});
  return all;
}

void ClothRun::refine() {
  const auto parents = parents_of_next();
  const auto normal = vertex_normals(x_, triangles());
  std::vector<Vec3> bulge(parents.size());
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const auto [a, b] = parents[i];
    const Vec3 edge = x_[b] - x_[a];
    bulge[i] = (normal[b] * normal[b].dot(edge) - normal[a] * normal[a].dot(edge)) / 8;
  }
  x_ = on_coarse_surface(parents, x_);
  ++level_;
  make_model();
  model_->system().begin_step(x_, std::numeric_limits<double>::infinity());
  const double allowed = model_->self().max_step(x_, bulge);
  for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += allowed * bulge[i];
}

std::string ClothRun::how_it_ended() const {
  if (!falling_.empty()) return falling_;
  // A loose tolerance may have been met when the time was up: that is not why it stopped.
  const bool cut_short = is_late() && last_.residual > options_.residual_tolerance;
  return cut_short ? "time budget" : last_.text();
}

Drape ClothRun::finish(const std::string& given_up) {
  const auto certified = [&] {
    return certify(*model_, x_, body_->body, given_up.empty() ? how_it_ended() : given_up);
  };
  const auto take = [&](const Kept& kept) {
    x_ = kept.x;
    model_->recall(kept.memory);
    report_.held_off_triangles = kept.held_off_triangles;
    return kept.ended.empty() ? certified() : certify(*model_, x_, body_->body, kept.ended);
  };
  Drape drape;
  drape.certificate = certified();
  // It looks anew, when contacts may have come or gone: then a little nearer to rest.
  double nearer = 0.8 * options_.residual_tolerance;
  for (int k = 0;
       k < kNearer && last_.reason == SettleOutcome::Reason::converged && given_up.empty() &&
       !is_late() && drape.certificate.residual > options_.residual_tolerance;
       ++k, nearer /= 2) {
    settle(nearer, options_.max_iterations, kStaticDt);
    drape.certificate = certified();
  }
  if (!drape.certificate.settled()) {
    const Kept now{x_, model_->memory(), drape.certificate.residual, report_.held_off_triangles};
    const Kept* best = &now;
    for (const auto* other : {&lowest_, &clear_, &first_try_}) {
      if (!other->has_value()) continue;
      const Certificate c = take(**other);
      if (!better(c, drape.certificate)) continue;
      drape.certificate = c;
      best = &**other;
    }
    drape.certificate = take(*best);
    std::vector<const Garment*> garments;
    for (int l = 0; l < layers(); ++l) garments.push_back(&level_garment(l));
    drape.unsettled = explain_unsettled(*model_, garments, x_, body_->body, drape.certificate);
    if (!falling_.empty()) drape.unsettled->why = falling_;
  }
  report_.contacts_self = model_->self().active(x_);
  report_.contacts_body = 0;
  report_.largest_contact_offset = 0;
  drape.body_contact_force.assign(x_.size(), Vec3::Zero());
  drape.body_normal_force.assign(x_.size(), 0.0);
  for (int l = 0; l < layers(); ++l) {
    const BodyContact& contact = model_->body(l);
    report_.contacts_body += contact.active(x_);
    for (const ContactPoint& p : contact.points())
      report_.largest_contact_offset = std::max(report_.largest_contact_offset, p.offset);
    contact.add_gradient(x_, drape.body_contact_force);
    contact.add_normal_force(x_, drape.body_normal_force);
  }
  for (Vec3& f : drape.body_contact_force) f = -f;
  drape.positions = x_;
  drape.report = report_;
  return drape;
}

}  // namespace loosefit
