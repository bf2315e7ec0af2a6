#include "loosefit/drape/drape_garment.h"

#include <tbb/global_control.h>

#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/drape/certify.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/hold_off_cuts.h"
#include "loosefit/drape/posed_body.h"
#include "loosefit/dress/dress.h"
#include "loosefit/solver/integrator.h"

namespace loosefit {
namespace {

constexpr double kDressTolerance = 1.0;  ///< residual at which the dressed coarse level may move on
constexpr double kContractTolerance = 30;  ///< residual while the softened start contracts
constexpr int kContractIterations = 60;
constexpr double kCoarseTolerance = 0.1;  ///< residual before a level is handed to the finer one
constexpr double kPoseTolerance = 0.5;    ///< residual between two steps of a posture path
constexpr double kPoseStep = 0.07;        ///< largest joint angle of one step of the path [rad]
constexpr double kCoarseLayer = 2.0;      ///< coarse levels keep layers this much farther apart
constexpr int kCutRounds = 8;             ///< attempts to free the last cuts into the body
/// Residuals on the way down at which cuts are looked for, and first pseudo-steps on each part [s].
constexpr std::pair<double, double> kCutTolerances[] = {{30.0, 0.1}, {5.0, 0.5}, {1.0, 2.5}};
constexpr double kCutTolerance = 0.1;  ///< residual at which the last cuts are looked for
/// Pseudo-steps on the way to rest [s]: the first, and after contacts were changed near rest.
constexpr double kFirstDt = 0.5, kStaticDt = 100;
constexpr double kFieldSpacing = 0.005;  ///< [m]

using Clock = std::chrono::steady_clock;

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

/// One run of dress and settle: knows the clock, the report and whom to tell.
class Run {
 public:
  Run(const GarmentHierarchy& garment, const Material& material, const BodyPath& body_at,
      const DrapeOptions& options, Progress& progress)
      : garment_(garment),
        material_(material),
        body_at_(body_at),
        options_(options),
        progress_(progress) {}

  Drape drape() {
    progress_.stage("dress");
    put_on();
    progress_.stage("settle");
    part_ = "posture";
    assume_posture();
    part_ = "settle";
    settle_levels();
    return finish();
  }

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  const Garment& level_garment() const { return garment_.levels[level_]; }
  bool is_finest() const { return level_ + 1 == static_cast<int>(garment_.levels.size()); }

  void make_model(double stiffness_share = 1, bool with_friction = true) {
    Material material = material_;
    if (!with_friction) material.friction_body = material.friction_self = 0;
    scale_membrane(material, stiffness_share);
    const double thickness = material_.thickness * (is_finest() ? 1.0 : kCoarseLayer);
    model_ = std::make_unique<ClothModel>(level_garment(), material, options_, thickness);
    model_->body().set_field(body_->field);
  }

  /// Settles the current level; true when the tolerance was met.
  bool settle(double tolerance, int iterations, double first_dt, bool preparing = false) {
    // The dynamic integrators are asked for by name for the final level; before it, quasi-static
    // steps bring the cloth near.
    const auto kind =
        is_finest() && !preparing ? options_.integrator : IntegratorKind::quasi_static;
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
                                                       std::to_string(garment_.levels.size()) +
                                                       ", residual " + std::to_string(residual));
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

  void put_on() {
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

  /// Seeded smooth shift of the start, for repeats.
  void perturb() {
    if (!(options_.start_perturbation > 0)) return;
    std::mt19937_64 rng(options_.seed);
    std::normal_distribution<double> normal(0, options_.start_perturbation);
    const Vec3 shift(normal(rng), normal(rng), normal(rng));
    const double phase = 2 * kPi * std::uniform_real_distribution<double>(0, 1)(rng);
    for (Vec3& p : x_) p += shift * (1 + 0.5 * std::sin(20 * p[2] + 12 * p[0] + phase));
  }

  void assume_posture() {
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

  void settle_levels() {
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

  /// Carries positions to the next finer level. Midpoints on the coarse edges give the same
  /// surface, so no new intersections; then they move towards the smooth surface through the coarse
  /// normals (PN triangles, Vlachos et al. 2001) as far as they meet nothing.
  void refine() {
    const auto& parents = garment_.parents[level_ + 1];
    const auto normal = vertex_normals(x_, level_garment().triangles);
    std::vector<Vec3> fine(parents.size()), bulge(parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i) {
      const auto [a, b] = parents[i];
      const Vec3 edge = x_[b] - x_[a];
      fine[i] = 0.5 * (x_[a] + x_[b]);
      bulge[i] = (normal[b] * normal[b].dot(edge) - normal[a] * normal[a].dot(edge)) / 8;
    }
    x_ = std::move(fine);
    ++level_;
    make_model();
    model_->system().begin_step(x_, std::numeric_limits<double>::infinity());
    const double allowed = model_->self().begin_search(x_, bulge);
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += allowed * bulge[i];
  }

  Drape finish() {
    Drape drape;
    drape.certificate = certify(*model_, level_garment(), x_, *body_, last_.text());
    report_.contacts_body = model_->body().active(x_);
    report_.contacts_self = model_->self().active(x_);
    for (const ContactPoint& p : model_->body().points())
      report_.largest_contact_offset = std::max(report_.largest_contact_offset, p.offset);
    drape.body_contact_force.assign(x_.size(), Vec3::Zero());
    model_->body().add_gradient(x_, drape.body_contact_force);
    for (Vec3& f : drape.body_contact_force) f = -f;
    drape.body_normal_force.assign(x_.size(), 0.0);
    model_->body().add_normal_force(x_, drape.body_normal_force);
    drape.positions = x_;
    drape.report = report_;
    return drape;
  }

  const GarmentHierarchy& garment_;
  const Material& material_;
  const BodyPath& body_at_;
  const DrapeOptions& options_;
  Progress& progress_;
  Clock::time_point start_ = Clock::now();
  int level_ = 0, iterations_ = 0;
  std::string part_ = "dress";  ///< of the run, for the report
  std::vector<Vec3> x_;
  std::unique_ptr<PosedBody> body_;
  std::unique_ptr<ClothModel> model_;
  SettleOutcome last_;
  SettleReport report_;
};

}  // namespace

Drape drape_garment(const GarmentHierarchy& garment, const Material& material,
                    const BodyPath& body_at, const DrapeOptions& options, Progress& progress) {
  std::optional<tbb::global_control> threads;
  if (options.threads > 0)
    threads.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
  return Run(garment, material, body_at, options, progress).drape();
}

}  // namespace loosefit
