#include "loosefit/fabric/membrane_energy.h"

#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::fabric {

namespace {

// Nearest positive semi-definite tangent; the shear does not couple.
void drop_negative_part(PlaneTangent& c, int i) {
  double &uu = c[0][i], &vv = c[1][i], &uv = c[2][i];
  c[3][i] = std::max(0.0, c[3][i]);
  const double mean = 0.5 * (uu + vv), half = 0.5 * (uu - vv);
  const double radius = std::hypot(half, uv);
  if (mean - radius >= 0) return;
  const double high = std::max(0.0, mean + radius);  // the eigenvalue that stays
  const double share = radius > 0 ? half / radius : 0;
  uu = 0.5 * high * (1 + share);
  vv = 0.5 * high * (1 - share);
  uv = radius > 0 ? 0.5 * high * uv / radius : 0;
}

StressCurve tension_law(const std::vector<CurvePoint>& curve, double stiffness) {
  return curve.empty() ? StressCurve::linear(stiffness) : StressCurve::tension(curve);
}

CrimpLaw yarns_of(const Material& m) {
  CrimpLaw yarns;
  const double plate = 1 - m.poisson * m.poisson;
  yarns.u = tension_law(m.curve_weft, m.stiffness_weft / plate);
  yarns.v = tension_law(m.curve_warp, m.stiffness_warp / plate);
  // The smallest tangents bound the coupling of a convex energy.
  yarns.coupling = m.poisson * std::sqrt(std::max(0.0, yarns.u.smallest_tangent()) *
                                         std::max(0.0, yarns.v.smallest_tangent()));
  yarns.is_linear = m.curve_warp.empty() && m.curve_weft.empty();
  yarns.linear_u = m.stiffness_weft / plate;
  yarns.linear_v = m.stiffness_warp / plate;
  return yarns;
}

}  // namespace

MembraneEnergy::MembraneEnergy(const std::vector<Triangle>& triangles,
                               const std::vector<std::array<Vec2, 3>>& triangle_uv,
                               const std::vector<double>& factor, const Material& material,
                               bool viscous, const std::vector<double>& added_bending)
    : count_(triangles.size()),
      factor_(factor.empty() ? std::vector<double>(count_, 1.0) : factor),
      yarns_(yarns_of(material)),
      shear_(material.curve_shear.empty() ? StressCurve::linear(material.stiffness_shear)
                                          : StressCurve::shear(material.curve_shear)),
      damping_(viscous ? material.damping : 0) {
  // One tile holds kTile triangles; missing ones at the end have no weight.
  tiles_.assign(particles::tiles_for(count_), MembraneTile{});
  load_.resize(tiles_.size());
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
    const std::size_t t = i / particles::kTile, at = i % particles::kTile;
    MembraneTile& tile = tiles_[t];
    for (int k = 0; k < 3; ++k) {
      tile.corner[k][at] = triangles[i][k];
      tile.ru[k][at] = ru[k];
      tile.rv[k][at] = rv[k];
      particle.push_back(triangles[i][k]);
      for (int j = 0; j <= k; ++j) pairs.push_back({triangles[i][k], triangles[i][j]});
    }
    const double area = 0.5 * std::abs(d), added = added_bending.empty() ? 0 : added_bending[i];
    tile.weight[at] = area * factor_[i];
    // The weight multiplies the whole energy; what buckling costs does not grow with it.
    load_[t][0][at] = CrimpLaw::euler_load(material.bending_weft + added, area) / factor_[i];
    load_[t][1][at] = CrimpLaw::euler_load(material.bending_warp + added, area) / factor_[i];
  }
  // Where forces and blocks go, and working memory.
  to_particles_ = particles::ParticleGather(particle);
  to_blocks_ = particles::BlockGather(pairs);
  set_active_set(nullptr);
  strain_start_.assign(tiles_.size(), kZeroRows);
  tangent_start_.assign(damping_ > 0 ? tiles_.size() : 0, PlaneTangent{});
  energy_.resize(tiles_.size());
  force_.resize(3 * particles::kTile * tiles_.size());
}

void MembraneEnergy::tile_state(int t, const particles::VectorField& x, bool with_tangent,
                                TileState& state) const {
  TrianglePoints points;
  particles::gather_points(x, tiles_[t].corner, points);
  membrane_strain(tiles_[t], points, state.s);
  CrimpLaw::Rows yarns;
  yarns_.respond(state.s.strain, load_[t], yarns, with_tangent ? &state.tangent : nullptr);
  state.response.energy = yarns.energy;
  state.response.stress[0] = yarns.stress[0];
  state.response.stress[1] = yarns.stress[1];
  state.crimp = yarns.crimp;
  for (int i = 0; i < particles::kTile; ++i) {
    const StressCurve::Response shear = shear_.at(state.s.strain[2][i]);
    state.response.energy[i] += shear.energy;
    state.response.stress[2][i] = shear.stress;
    if (with_tangent) state.tangent[3][i] = shear.tangent;
  }
  if (viscous_ratio_ > 0)
    add_quadratic(tangent_start_[t], state.s.strain, strain_start_[t], viscous_ratio_,
                  state.response);
}

void MembraneEnergy::begin_step(const particles::VectorField& x, double dt) {
  viscous_ratio_ = 0;
  if (!(damping_ > 0) || !std::isfinite(dt) || !(dt > 0)) return;
  particles::for_tiles(static_cast<int>(tiles_.size()), [&](int t) {
    TileState state;
    tile_state(t, x, true, state);
    for (int i = 0; i < particles::kTile; ++i) drop_negative_part(state.tangent, i);
    strain_start_[t] = state.s.strain;
    tangent_start_[t] = state.tangent;
  });
  viscous_ratio_ = damping_ / dt;
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
    if (!exact)
      for (int i = 0; i < particles::kTile; ++i) drop_negative_part(c, i);
    if (viscous_ratio_ > 0)
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i < particles::kTile; ++i)
          c[k][i] += viscous_ratio_ * tangent_start_[t][k][i];
    std::array<particles::TileRow, 54> row;
    membrane_blocks(tiles_[t], state.s, state.response.stress, c, compression, row);
    particles::spread(row, block_[6 * particles::kTile * t].data());
  });
  to_blocks_.add(block_, h, active_set_);
}

std::vector<MembraneEnergy::State> MembraneEnergy::states(const particles::VectorField& x) const {
  std::vector<State> states;
  TileState tile;
  for (std::size_t triangle = 0; triangle < count_; ++triangle) {
    const std::size_t i = triangle % particles::kTile;
    if (i == 0) tile_state(static_cast<int>(triangle / particles::kTile), x, false, tile);
    const PlaneRows &e = tile.s.strain, &s = tile.response.stress;
    states.push_back({{e[0][i], e[1][i], e[2][i]},
                      factor_[triangle] * Vec3(s[0][i], s[1][i], s[2][i]),
                      {tile.crimp[0][i], tile.crimp[1][i]}});
  }
  return states;
}

}  // namespace loosefit::fabric
