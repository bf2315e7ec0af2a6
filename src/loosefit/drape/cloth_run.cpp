#include "loosefit/drape/cloth_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/drape/certify.h"

namespace loosefit {
namespace {

constexpr double kCoarseLayer = 2.0;  ///< coarse levels keep layers this much farther apart

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

}  // namespace

ClothRun::ClothRun(const std::vector<ClothLayer>& layers, const DrapeOptions& options,
                   Progress& progress)
    : layers_(layers), options_(options), progress_(progress) {
  if (layers.empty()) throw InvalidInput("a drape needs at least one garment");
  for (const ClothLayer& layer : layers)
    if (layer.garment->levels.size() != layers.front().garment->levels.size())
      throw InvalidInput("garments worn over each other need meshes of the same levels");
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
  model_ = std::make_unique<ClothModel>(parts, share * layer_friction(layers_), options_);
  model_->set_field(body_->field);
}

bool ClothRun::settle(double tolerance, int iterations, double first_dt, bool preparing) {
  // The dynamic integrators are asked for by name for the final level; before it, quasi-static
  // steps bring the cloth near.
  const auto kind = is_finest() && !preparing ? options_.integrator : IntegratorKind::quasi_static;
  SettleOptions settle;
  settle.tolerance = tolerance;
  settle.tangent = TangentReach::near;  // half the cost of an iteration, as many of them
  settle.max_iterations =
      kind == IntegratorKind::semi_implicit_euler ? 1000 * iterations : iterations;
  settle.first_dt = kind == IntegratorKind::implicit_euler ? 0.02 : first_dt;
  settle.watch = [&](int iteration, double residual) {
    progress_.check_cancelled();
    report_.history.push_back({seconds(), level_, iterations_ + iteration, residual});
    const double done = std::log10(std::max(residual, tolerance) / 10) /
                        std::log10(options_.residual_tolerance / 10);
    progress_.update(std::clamp(done, 0.0, 1.0), "level " + std::to_string(level_ + 1) + " of " +
                                                     std::to_string(levels()) + ", residual " +
                                                     std::to_string(residual));
    return seconds() > options_.time_budget;
  };
  const long searches_before = model_->self().searches();
  last_ = make_integrator(kind, model_->system())->settle(x_, settle);
  if (report_.parts.empty() || report_.parts.back().part != part_ ||
      report_.parts.back().level != level_)
    report_.parts.push_back({part_, level_, static_cast<int>(x_.size()), {}});
  report_.parts.back().work += last_.work;
  iterations_ += last_.work.iterations;
  report_.ccd_queries += static_cast<int>(model_->self().searches() - searches_before);
  return last_.reason == SettleOutcome::Reason::converged;
}

void ClothRun::perturb() {
  if (!(options_.start_perturbation > 0)) return;
  std::mt19937_64 rng(options_.seed);
  std::normal_distribution<double> normal(0, options_.start_perturbation);
  const Vec3 shift(normal(rng), normal(rng), normal(rng));
  const double phase = 2 * kPi * std::uniform_real_distribution<double>(0, 1)(rng);
  for (Vec3& p : x_) p += shift * (1 + 0.5 * std::sin(20 * p[2] + 12 * p[0] + phase));
}

void ClothRun::refine() {
  const auto normal = vertex_normals(x_, triangles());
  std::vector<Vec3> fine, bulge;
  for (int l = 0, shift = 0; l < layers(); shift += level_garment(l++).vertex_count)
    for (const auto& [first, second] : layers_[l].garment->parents[level_ + 1]) {
      const int a = first + shift, b = second + shift;
      const Vec3 edge = x_[b] - x_[a];
      fine.push_back(0.5 * (x_[a] + x_[b]));
      bulge.push_back((normal[b] * normal[b].dot(edge) - normal[a] * normal[a].dot(edge)) / 8);
    }
  x_ = std::move(fine);
  ++level_;
  make_model();
  model_->system().begin_step(x_, std::numeric_limits<double>::infinity());
  const double allowed = model_->self().begin_search(x_, bulge);
  for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += allowed * bulge[i];
}

Drape ClothRun::finish() {
  Drape drape;
  drape.certificate = certify(*model_, x_, *body_, last_.text());
  report_.contacts_self = model_->self().active(x_);
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
