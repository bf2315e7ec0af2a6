#include "loosefit/fabric/membrane_energy.h"

#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::fabric {

namespace {

StressCurve tension_law(const std::vector<CurvePoint>& curve, double stiffness,
                        double compression) {
  return curve.empty() ? StressCurve::linear(stiffness, compression)
                       : StressCurve::tension(curve, compression);
}

// Nearest positive semi-definite matrix of a tangent whose shear does not couple.
void drop_negative_part(PlaneTangent& c, int i) {
  const double mean = 0.5 * (c[0][i] + c[1][i]), half = 0.5 * (c[0][i] - c[1][i]);
  const double radius = std::hypot(half, c[2][i]);
  if (mean - radius < 0) {
    const double high = std::max(0.0, mean + radius);  // the eigenvalue that stays
    const double share = radius > 0 ? half / radius : 0;
    c[0][i] = 0.5 * high * (1 + share);
    c[1][i] = 0.5 * high * (1 - share);
    c[2][i] = radius > 0 ? 0.5 * high * c[2][i] / radius : 0;
  }
  c[3][i] = std::max(0.0, c[3][i]);
}

}  // namespace

MembraneEnergy::MembraneEnergy(const std::vector<Triangle>& triangles,
                               const std::vector<std::array<Vec2, 3>>& triangle_uv,
                               const std::vector<double>& factor, const Material& material,
                               bool viscous)
    : damping_(viscous ? material.damping : 0) {
  // Stiffness of an orthotropic sheet; `plain_` has constant coefficients and a faster kernel.
  const Material& m = material;
  const double ku = m.stiffness_weft, kv = m.stiffness_warp, nu = m.poisson;
  const double squeeze = m.compression_factor;
  plain_ = m.curve_warp.empty() && m.curve_weft.empty() && m.curve_shear.empty() && squeeze == 1;
  const double plate = 1 - nu * nu * squeeze;
  linear_[0].fill(ku / plate);
  linear_[1].fill(kv / plate);
  linear_[2].fill(nu * std::sqrt(ku * kv) / plate);
  linear_[3].fill(m.stiffness_shear);
  // Measured curves in place of the constants; their smallest tangents bound the coupling.
  law_u_ = tension_law(m.curve_weft, ku / plate, squeeze);
  law_v_ = tension_law(m.curve_warp, kv / plate, squeeze);
  law_s_ = m.curve_shear.empty() ? StressCurve::linear(m.stiffness_shear)
                                 : StressCurve::shear(m.curve_shear);
  coupling_ = nu * std::sqrt(std::max(0.0, law_u_.smallest_tangent()) *
                             std::max(0.0, law_v_.smallest_tangent()));
  // One tile holds kTile triangles; missing ones at the end have no weight.
  count_ = triangles.size();
  factor_ = factor.empty() ? std::vector<double>(count_, 1.0) : factor;
  tiles_.assign(particles::tiles_for(count_), MembraneTile{});
  std::vector<int> particle;
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t i = 0; i < count_; ++i) {
    // Derivatives of the flat coordinates: the rows of the deformation gradient are Σ ru x, Σ rv x.
    const auto& [a, b, c] = triangle_uv[i];
    const double d = a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]);
    if (!(std::abs(d) > 0))
      throw GeometryError("pattern triangle " + std::to_string(i) + " has no area");
    const double ru[] = {(b[1] - c[1]) / d, (c[1] - a[1]) / d, (a[1] - b[1]) / d};
    const double rv[] = {(c[0] - b[0]) / d, (a[0] - c[0]) / d, (b[0] - a[0]) / d};
    MembraneTile& tile = tiles_[i / particles::kTile];
    for (int k = 0; k < 3; ++k) {
      tile.corner[k][i % particles::kTile] = triangles[i][k];
      tile.ru[k][i % particles::kTile] = ru[k];
      tile.rv[k][i % particles::kTile] = rv[k];
      particle.push_back(triangles[i][k]);
      for (int j = 0; j <= k; ++j) pairs.push_back({triangles[i][k], triangles[i][j]});
    }
    tile.weight[i % particles::kTile] = 0.5 * std::abs(d) * factor_[i];
  }
  // Where forces and blocks go, and working memory.
  to_particles_ = particles::ParticleGather(particle);
  to_blocks_ = particles::BlockGather(pairs);
  active_tiles_ = particles::IndexSubset(tiles_.size());
  strain_start_.assign(tiles_.size(), kZeroRows);
  if (!plain_) tangent_start_.assign(tiles_.size(), PlaneTangent{});
  energy_.resize(tiles_.size());
  force_.resize(3 * particles::kTile * tiles_.size());
}

void MembraneEnergy::respond(const MembraneStrain& s, PlaneResponse& out,
                             PlaneTangent* tangent) const {
  if (plain_) {
    out = PlaneResponse{};
    add_quadratic(linear_, s.strain, kZeroRows, 1, out);
    if (tangent) *tangent = linear_;
    return;
  }
  for (int i = 0; i < particles::kTile; ++i) {
    const double eu = s.strain[0][i], ev = s.strain[1][i];
    const auto u = law_u_.at(eu), v = law_v_.at(ev), shear = law_s_.at(s.strain[2][i]);
    out.energy[i] = u.energy + v.energy + shear.energy + coupling_ * eu * ev;
    out.stress[0][i] = u.stress + coupling_ * ev;
    out.stress[1][i] = v.stress + coupling_ * eu;
    out.stress[2][i] = shear.stress;
    if (!tangent) continue;
    (*tangent)[0][i] = u.tangent;
    (*tangent)[1][i] = v.tangent;
    (*tangent)[2][i] = coupling_;
    (*tangent)[3][i] = shear.tangent;
  }
}

void MembraneEnergy::tile_state(int t, const particles::VectorField& x, bool with_tangent,
                                TileState& state) const {
  particles::gather_points(x, tiles_[t].corner, state.x);
  membrane_strain(tiles_[t], state.x, state.s);
  respond(state.s, state.response, with_tangent ? &state.tangent : nullptr);
  if (viscous_ratio_ > 0)
    add_quadratic(plain_ ? linear_ : tangent_start_[t], state.s.strain, strain_start_[t],
                  viscous_ratio_, state.response);
}

void MembraneEnergy::begin_step(const particles::VectorField& x, double dt) {
  viscous_ratio_ = std::isfinite(dt) && dt > 0 ? damping_ / dt : 0;
  if (!(viscous_ratio_ > 0)) return;
  particles::for_tiles(static_cast<int>(tiles_.size()), [&](int t) {
    TileState state;
    particles::gather_points(x, tiles_[t].corner, state.x);
    membrane_strain(tiles_[t], state.x, state.s);
    strain_start_[t] = state.s.strain;
    if (plain_) return;
    respond(state.s, state.response, &tangent_start_[t]);
    for (int i = 0; i < particles::kTile; ++i) drop_negative_part(tangent_start_[t], i);
  });
}

void MembraneEnergy::set_active_set(const particles::ActiveSet* active_set) {
  active_set_ = active_set;
  active_tiles_ = particles::tiles_in(active_set, tiles_);
}

double MembraneEnergy::evaluate(const particles::VectorField& x, bool forces) const {
  particles::for_tiles(active_tiles_, [&](int t) {
    TileState state;
    tile_state(t, x, false, state);
    particles::TileRow& energy = state.response.energy;
    for (int i = 0; i < particles::kTile; ++i) energy[i] *= tiles_[t].weight[i];
    energy_[t] = particles::sum_of(energy);
    if (!forces) return;
    std::array<particles::TileRow, 9> row;
    membrane_gradient(tiles_[t], state.s, state.response.stress, row);
    particles::spread(row, force_[3 * particles::kTile * t].data());
  });
  double sum = 0;
  for (int k = 0; k < active_tiles_.size(); ++k) sum += energy_[active_tiles_[k]];
  return sum;
}

double MembraneEnergy::value(const particles::VectorField& x) const { return evaluate(x, false); }

void MembraneEnergy::add_gradient(const particles::VectorField& x,
                                  particles::VectorField& g) const {
  value_and_gradient(x, g);
}

double MembraneEnergy::value_and_gradient(const particles::VectorField& x,
                                          particles::VectorField& g) const {
  const double energy = evaluate(x, true);
  to_particles_.add(force_, g, active_set_);
  return energy;
}

void MembraneEnergy::add_pattern(const particles::VectorField&,
                                 particles::BlockPattern& pattern) const {
  to_blocks_.add_pattern(pattern);
}

void MembraneEnergy::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                                 particles::HessianKind kind) const {
  const bool exact = kind == particles::HessianKind::exact;
  const double compression = exact ? 1 : kind == particles::HessianKind::half_compression ? 0.5 : 0;
  block_.resize(6 * particles::kTile * tiles_.size());
  particles::for_tiles(active_tiles_, [&](int t) {
    TileState state;
    tile_state(t, x, true, state);
    PlaneTangent& c = state.tangent;
    if (!plain_ && !exact)
      for (int i = 0; i < particles::kTile; ++i) drop_negative_part(c, i);
    if (viscous_ratio_ > 0) {
      const PlaneTangent& viscosity = plain_ ? linear_ : tangent_start_[t];
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i < particles::kTile; ++i) c[k][i] += viscous_ratio_ * viscosity[k][i];
    }
    std::array<particles::TileRow, 54> row;
    membrane_blocks(tiles_[t], state.s, state.response.stress, c, compression, row);
    particles::spread(row, block_[6 * particles::kTile * t].data());
  });
  to_blocks_.add(block_, h, active_set_);
}

MembraneEnergy::State MembraneEnergy::state(int triangle, const particles::VectorField& x) const {
  const int t = triangle / particles::kTile, i = triangle % particles::kTile;
  const MembraneTile& tile = tiles_[t];
  Vec3 u = Vec3::Zero(), v = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    u += tile.ru[k][i] * x[tile.corner[k][i]];
    v += tile.rv[k][i] * x[tile.corner[k][i]];
  }
  const double factor = factor_[triangle];
  const Vec3 e(0.5 * (u.squaredNorm() - 1), 0.5 * (v.squaredNorm() - 1), u.dot(v));
  if (plain_)
    return {e, factor * Vec3(linear_[0][i] * e[0] + linear_[2][i] * e[1],
                             linear_[2][i] * e[0] + linear_[1][i] * e[1], linear_[3][i] * e[2])};
  return {e, factor * Vec3(law_u_.at(e[0]).stress + coupling_ * e[1],
                           law_v_.at(e[1]).stress + coupling_ * e[0], law_s_.at(e[2]).stress)};
}

}  // namespace loosefit::fabric
