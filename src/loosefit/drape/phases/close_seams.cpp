#include "loosefit/drape/phases/close_seams.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "loosefit/contact/body_contact.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/drape/seam_pull.h"
#include "loosefit/drape/smooth_cuts.h"
#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/membrane_energy.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/particles/dead_load.h"
#include "loosefit/solver/quasi_static.h"

namespace loosefit::drape {
namespace {

// Cloth that is being sewn: as soft as rubber foil, so that seams close where it is too narrow.
constexpr double kMembrane = 20;     ///< [N/m]
constexpr double kShear = 10;        ///< [N/m per rad]
constexpr double kBending = 2e-5;    ///< [N m]
constexpr double kThread = 5000;     ///< stiffness of threads per length of seam [N/m²]
constexpr double kReach = 0.005;     ///< gap from which they pull with all their force [m]
constexpr double kLift = 0.6;        ///< that holds shoulders up, per length of seam [N/m]
constexpr double kPad = 0.008;       ///< distance at which the skin begins to press [m]
constexpr double kSkin = 5e5;        ///< how hard [Pa/m]
constexpr double kGrip = 0.6;        ///< friction that keeps what is sewn round a limb there [–]
constexpr double kStick = 1e-4;      ///< that it gives before it slips [m]
constexpr double kField = 0.010;     ///< spacing of the field of distances [m]
constexpr double kStretched = 1.02;  ///< area over that as cut, from which a triangle is stretched
constexpr double kInLimb = 0.006;    ///< depth at which a closed seam goes through a limb [m]
constexpr double kTolerance = 20;    ///< residual ‖F‖/‖W‖ [–]
constexpr int kIterations = 250;
constexpr double kFirstDt = 0.01;      ///< [s]
constexpr double kLargestMove = 0.02;  ///< of a particle in one iteration [m]
constexpr int kSmoothings = 40;        ///< rounds, of what cuts

fabric::Material soft(double areal_density) {
  fabric::Material m;
  m.areal_density = areal_density;
  m.stiffness_warp = m.stiffness_weft = kMembrane;
  m.poisson = 0;
  m.stiffness_shear = kShear;
  m.bending_warp = m.bending_weft = kBending;
  return m;
}

double mean_edge(const garment::Garment& g) {
  double sum = 0;
  for (const auto& uv : g.triangle_uv)
    for (int k = 0; k < 3; ++k) sum += (uv[k] - uv[(k + 1) % 3]).norm();
  return sum / (3.0 * static_cast<double>(g.triangle_uv.size()));
}

/// Triangles in the plane [m], along the grain: those of the trunk that were stretched to go round
/// the body as arranged, a shape that they keep until the seams are closed; others as cut. What was
/// squeezed would be too narrow, and slide up to the waist.
std::vector<std::array<Vec2, 3>> sewn_shape(const garment::Garment& g,
                                            const ArrangedPanels& panels) {
  std::vector<std::array<Vec2, 3>> flat = g.triangle_uv;
  for (std::size_t t = 0; t < flat.size(); ++t) {
    if (!panels.of_trunk[g.triangle_panel[t]]) continue;
    const auto& [a, b, c] = g.triangles[t];
    Eigen::Matrix2d cut;
    cut << flat[t][1] - flat[t][0], flat[t][2] - flat[t][0];
    Eigen::Matrix<double, 3, 2> placed;
    placed << panels.x[b] - panels.x[a], panels.x[c] - panels.x[a];
    const Eigen::Matrix<double, 3, 2> f = placed * cut.inverse();
    // Right stretch tensor U of f = R U.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> stretch(f.transpose() * f);
    if (stretch.eigenvalues().prod() < kStretched * kStretched) continue;
    const Eigen::Matrix2d u = stretch.operatorSqrt();
    for (Vec2& corner : flat[t]) corner = u * corner;
  }
  return flat;
}

std::vector<Vec3> welded(const garment::Garment& sewn, const garment::OpenSeams& open,
                         const std::vector<Vec3>& x) {
  std::vector<Vec3> sum(sewn.vertex_count, Vec3::Zero());
  std::vector<int> count(sewn.vertex_count, 0);
  for (std::size_t v = 0; v < x.size(); ++v) sum[open.sewn[v]] += x[v], ++count[open.sewn[v]];
  for (int v = 0; v < sewn.vertex_count; ++v) sum[v] /= std::max(1, count[v]);
  return sum;
}

}  // namespace

ClosedSeams close_seams(const garment::Garment& sewn, const garment::OpenSeams& open,
                        const ArrangedPanels& panels, const body::PosedBody& body, double pull) {
  const garment::Garment& g = open.garment;
  std::vector<Vec3> x = panels.x;
  const fabric::Material material = soft(sewn.mass / sewn.area);
  const auto arranged = sewn_shape(g, panels);
  fabric::MembraneEnergy membrane(g.triangles, arranged,
                                  std::vector<double>(g.triangles.size(), 1.0), material);
  fabric::BendingEnergy bending(g.triangles, arranged, std::vector<double>(g.triangles.size(), 0.0),
                                material);
  std::vector<double> area;
  particles::VectorField forces(x.size(), Vec3::Zero());
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    area.push_back(geometry::flat_area(arranged[t]));
    const auto& [a, b, c] = g.triangles[t];
    Vec3 normal = panels.outside[g.triangle_panel[t]];
    if (normal.isZero()) normal = (x[b] - x[a]).cross(x[c] - x[a]).normalized();
    for (int v : g.triangles[t]) forces[v] += pull * area[t] / 3 * normal;
  }
  for (int v : panels.shoulders) forces[v].z() += kLift * mean_edge(g);
  particles::DeadLoad outwards;
  outwards.set_forces(forces);
  contact::BodyContact contact(contact::contact_points(g.triangles, area, g.vertex_count, kPad),
                               kSkin, panels.on_limbs ? kGrip : 0, kStick);
  const auto around = with_field(body, bounds(x), kField);
  contact.set_field(around->field);
  contact::BodyContact on_floor(contact::contact_points(g.triangles, area, g.vertex_count, kPad),
                                kSkin, 0, kStick);
  if (!panels.under_soles) on_floor.set_field(around->floor);
  const double thread = kThread * mean_edge(g);
  SeamPull seams(open.partners, thread, kReach);
  solver::ParticleSystem system;
  system.mass = g.vertex_mass;
  system.energies = {&membrane, &bending, &outwards, &seams, &contact, &on_floor};

  solver::SettleOptions options;
  options.tolerance = kTolerance;
  options.max_iterations = kIterations;
  options.max_move = kLargestMove;
  options.first_dt = kFirstDt;
  options.tangent = particles::BendingTangent::hinge;
  const auto outcome = solver::make_quasi_static(system)->settle(x, options);
  ClosedSeams closed;
  closed.iterations = outcome.work.iterations;
  closed.gap = widest_gap(open.partners, x);
  closed.x = welded(sewn, open, x);
  double deepest = kInLimb;
  for (int v = 0; v < sewn.vertex_count; ++v)
    if (const double depth = -body.tree().signed_distance(closed.x[v]); depth > deepest)
      deepest = depth, closed.in_limb = v;
  SmoothedCuts smoothed =
      smooth_cuts(std::move(closed.x), sewn.triangles, body.tree(), kPad / 2, kSmoothings);
  closed.x = std::move(smoothed.x);
  closed.first_cuts = smoothed.first_cuts, closed.cuts = smoothed.cuts;
  closed.first_cut = smoothed.first_cut;
  return closed;
}

}  // namespace loosefit::drape
