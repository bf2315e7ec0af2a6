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

// Nearest positive semi-definite matrix of (uu, vv, uv).
void drop_negative_part(double& uu, double& vv, double& uv) {
  const double mean = 0.5 * (uu + vv), half = 0.5 * (uu - vv);
  const double radius = std::hypot(half, uv);
  if (mean - radius >= 0) return;
  const double high = std::max(0.0, mean + radius);  // the eigenvalue that stays
  const double share = radius > 0 ? half / radius : 0;
  uu = 0.5 * high * (1 + share);
  vv = 0.5 * high * (1 - share);
  uv = radius > 0 ? 0.5 * high * uv / radius : 0;
}

// The same of a tangent whose shear does not couple.
void drop_negative_part(PlaneTangent& c, int i) {
  drop_negative_part(c[0][i], c[1][i], c[2][i]);
  c[3][i] = std::max(0.0, c[3][i]);
}

}  // namespace

MembraneEnergy::MembraneEnergy(const std::vector<Triangle>& triangles,
                               const std::vector<std::array<Vec2, 3>>& triangle_uv,
                               const std::vector<double>& factor, const Material& material,
                               bool viscous, double triangle_share)
    : patch_share_(1 - triangle_share), damping_(viscous ? material.damping : 0) {
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
  // Patches, and which of them act on each triangle.
  yarn_share_.resize(tiles_.size());
  for (particles::TileRow& row : yarn_share_) row.fill(1);
  if (patch_share_ > 0) {
    std::vector<double> weight;
    for (std::size_t i = 0; i < count_; ++i)
      weight.push_back(tiles_[i / particles::kTile].weight[i % particles::kTile]);
    patches_ = strain_patches(triangles, triangle_uv, factor_, weight);
    const int none = static_cast<int>(patches_.patches.size());
    patch_at_.resize(tiles_.size());
    for (auto& tile : patch_at_)
      for (particles::TileIndex& row : tile) row.fill(none);
    for (std::size_t i = 0; i < count_; ++i)
      for (int k = 0; k < 3; ++k)
        if (const int patch = patches_.at_corner[i][k]; patch >= 0) {
          patch_at_[i / particles::kTile][k][i % particles::kTile] = patch;
          yarn_share_[i / particles::kTile][i % particles::kTile] -= patch_share_ / 3;
        }
    strain_.resize(tiles_.size());
    patch_energy_.resize(none);
    patch_strain_.assign(none, Vec2::Zero());
    patch_stress_.assign(none + 1, Vec2::Zero());
  }
  set_active_set(nullptr);
  strain_start_.assign(tiles_.size(), kZeroRows);
  if (!plain_) tangent_start_.assign(tiles_.size(), PlaneTangent{});
  energy_.resize(tiles_.size());
  force_.resize(3 * particles::kTile * tiles_.size());
}

MembraneEnergy::YarnResponse MembraneEnergy::respond_yarns(double uu, double vv) const {
  if (plain_) {
    const double cu = linear_[0][0], cv = linear_[1][0], cuv = linear_[2][0];
    const double su = cu * uu + cuv * vv, sv = cuv * uu + cv * vv;
    return {0.5 * (su * uu + sv * vv), su, sv, {cu, cv, cuv}};
  }
  const auto u = law_u_.at(uu), v = law_v_.at(vv);
  return {u.energy + v.energy + coupling_ * uu * vv,
          u.stress + coupling_ * vv,
          v.stress + coupling_ * uu,
          {u.tangent, v.tangent, coupling_}};
}

void MembraneEnergy::respond(const PlaneRows& strain, const particles::TileRow& share,
                             PlaneResponse& out, PlaneTangent* tangent) const {
  if (plain_) {
    PlaneTangent c = linear_;
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < particles::kTile; ++i) c[k][i] *= share[i];
    out = PlaneResponse{};
    add_quadratic(c, strain, kZeroRows, 1, out);
    if (tangent) *tangent = c;
    return;
  }
  for (int i = 0; i < particles::kTile; ++i) {
    const YarnResponse yarns = respond_yarns(strain[0][i], strain[1][i]);
    const auto shear = law_s_.at(strain[2][i]);
    out.energy[i] = share[i] * yarns.energy + shear.energy;
    out.stress[0][i] = share[i] * yarns.stress_u;
    out.stress[1][i] = share[i] * yarns.stress_v;
    out.stress[2][i] = shear.stress;
    if (!tangent) continue;
    for (int k = 0; k < 3; ++k) (*tangent)[k][i] = share[i] * yarns.tangent[k];
    (*tangent)[3][i] = shear.tangent;
  }
}

void MembraneEnergy::find_patches(const particles::VectorField& x) const {
  if (patches_.patches.empty()) return;
  particles::for_tiles(strained_tiles_, [&](int t) {
    TrianglePoints points;
    particles::gather_points(x, tiles_[t].corner, points);
    membrane_strain(tiles_[t], points, strain_[t]);
  });
  particles::for_ranges(active_patches_.size(), 256, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const int p = active_patches_[k];
      const StrainPatch& patch = patches_.patches[p];
      Vec2 mean = Vec2::Zero();
      for (int j = patch.first; j < patch.first + patch.count; ++j) {
        const int t = patches_.triangle[j] / particles::kTile,
                  i = patches_.triangle[j] % particles::kTile;
        const double w = tiles_[t].weight[i] / (3 * patch.weight);
        mean += w * Vec2(strain_[t].strain[0][i], strain_[t].strain[1][i]);
      }
      const YarnResponse yarns = respond_yarns(mean[0], mean[1]);
      patch_strain_[p] = mean;
      patch_energy_[p] = patch_share_ * patch.weight * yarns.energy;
      patch_stress_[p] = patch_share_ / 3 * Vec2(yarns.stress_u, yarns.stress_v);
    }
  });
}

void MembraneEnergy::tile_state(int t, const particles::VectorField& x, bool with_tangent,
                                TileState& state) const {
  const bool patched = !patches_.patches.empty();
  if (patched) {
    state.s = strain_[t];
  } else {
    TrianglePoints points;
    particles::gather_points(x, tiles_[t].corner, points);
    membrane_strain(tiles_[t], points, state.s);
  }
  respond(state.s.strain, yarn_share_[t], state.response, with_tangent ? &state.tangent : nullptr);
  if (patched)
    for (const particles::TileIndex& from : patch_at_[t])
      for (int i = 0; i < particles::kTile; ++i) {
        state.response.stress[0][i] += patch_stress_[from[i]][0];
        state.response.stress[1][i] += patch_stress_[from[i]][1];
      }
  if (viscous_ratio_ > 0)
    add_quadratic(plain_ ? linear_ : tangent_start_[t], state.s.strain, strain_start_[t],
                  viscous_ratio_, state.response);
}

void MembraneEnergy::begin_step(const particles::VectorField& x, double dt) {
  viscous_ratio_ = std::isfinite(dt) && dt > 0 ? damping_ / dt : 0;
  if (!(viscous_ratio_ > 0)) return;
  particles::for_tiles(static_cast<int>(tiles_.size()), [&](int t) {
    TrianglePoints points;
    MembraneStrain s;
    particles::gather_points(x, tiles_[t].corner, points);
    membrane_strain(tiles_[t], points, s);
    strain_start_[t] = s.strain;
    if (plain_) return;
    particles::TileRow whole;
    whole.fill(1);
    PlaneResponse response;
    respond(s.strain, whole, response, &tangent_start_[t]);
    for (int i = 0; i < particles::kTile; ++i) drop_negative_part(tangent_start_[t], i);
  });
}

void MembraneEnergy::set_active_set(const particles::ActiveSet* active_set) {
  active_set_ = active_set;
  active_tiles_ = particles::tiles_in(active_set, tiles_);
  active_patches_ = particles::IndexSubset(patches_.patches.size());
  strained_tiles_ = particles::IndexSubset(tiles_.size());
  if (!active_set || patches_.patches.empty()) return;
  // Patches of every triangle whose forces are wanted, and all that these are made of.
  std::vector<char> patch(patches_.patches.size() + 1, 0), tile(tiles_.size(), 0);
  for (int k = 0; k < active_tiles_.size(); ++k) {
    tile[active_tiles_[k]] = 1;
    for (const particles::TileIndex& at : patch_at_[active_tiles_[k]])
      for (int p : at) patch[p] = 1;
  }
  active_patches_ =
      particles::IndexSubset(patches_.patches.size(), [&](int p) { return patch[p] != 0; });
  for (int k = 0; k < active_patches_.size(); ++k) {
    const StrainPatch& p = patches_.patches[active_patches_[k]];
    for (int j = p.first; j < p.first + p.count; ++j)
      tile[patches_.triangle[j] / particles::kTile] = 1;
  }
  strained_tiles_ = particles::IndexSubset(tiles_.size(), [&](int t) { return tile[t] != 0; });
}

double MembraneEnergy::evaluate(const particles::VectorField& x, bool forces) const {
  find_patches(x);
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
  for (int k = 0; k < active_patches_.size(); ++k) sum += patch_energy_[active_patches_[k]];
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
  if (patches_.patches.empty()) return;
  if (!patch_tangent_) patch_tangent_ = std::make_unique<StrainPatchTangent>(patches_.patches);
  patch_tangent_->add_pattern(pattern);
}

void MembraneEnergy::add_patches(particles::BlockMatrix& h, particles::HessianKind kind) const {
  if (patches_.patches.empty()) return;
  if (!patch_tangent_) patch_tangent_ = std::make_unique<StrainPatchTangent>(patches_.patches);
  particles::for_ranges(active_patches_.size(), 64, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const int at = active_patches_[k];
      const StrainPatch& patch = patches_.patches[at];
      // B, two rows of three a particle.
      std::array<StrainPatchTangent::Factor, StrainPatch::kMost> rows{};
      for (int j = patch.first; j < patch.first + patch.count; ++j) {
        const int t = patches_.triangle[j] / particles::kTile,
                  i = patches_.triangle[j] % particles::kTile;
        const MembraneTile& tile = tiles_[t];
        const MembraneStrain& s = strain_[t];
        const double w = tile.weight[i] / (3 * patch.weight);
        for (int c = 0; c < 3; ++c) {
          int place = 0;
          while (patch.particle[place] != tile.corner[c][i]) ++place;
          for (int d = 0; d < 3; ++d) {
            rows[place][d] += w * tile.ru[c][i] * s.u[d][i];
            rows[place][3 + d] += w * tile.rv[c][i] * s.v[d][i];
          }
        }
      }
      Vec3 c = patch_share_ * patch.weight *
               respond_yarns(patch_strain_[at][0], patch_strain_[at][1]).tangent;
      if (kind != particles::HessianKind::exact) drop_negative_part(c[0], c[1], c[2]);
      StrainPatchTangent::Factor* factor = patch_tangent_->factors(at);
      for (int a = 0; a < patch.particles; ++a)
        for (int d = 0; d < 3; ++d) {
          const double u = rows[a][d], v = rows[a][3 + d];
          factor[a][d] = u;
          factor[a][3 + d] = v;
          factor[a][6 + d] = c[0] * u + c[2] * v;
          factor[a][9 + d] = c[2] * u + c[1] * v;
        }
    }
  });
  patch_tangent_->add(h, active_set_);
}

void MembraneEnergy::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                                 particles::HessianKind kind) const {
  const bool exact = kind == particles::HessianKind::exact;
  const double compression = exact ? 1 : kind == particles::HessianKind::half_compression ? 0.5 : 0;
  find_patches(x);
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
  add_patches(h, kind);
}

std::vector<MembraneEnergy::State> MembraneEnergy::states(const particles::VectorField& x) const {
  find_patches(x);
  std::vector<State> states;
  for (std::size_t triangle = 0; triangle < count_; ++triangle) {
    const int t = static_cast<int>(triangle / particles::kTile);
    const std::size_t i = triangle % particles::kTile;
    const MembraneTile& tile = tiles_[t];
    Vec3 u = Vec3::Zero(), v = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      u += tile.ru[k][i] * x[tile.corner[k][i]];
      v += tile.rv[k][i] * x[tile.corner[k][i]];
    }
    const Vec3 e(0.5 * (u.squaredNorm() - 1), 0.5 * (v.squaredNorm() - 1), u.dot(v));
    const YarnResponse yarns = respond_yarns(e[0], e[1]);
    Vec3 stress(yarn_share_[t][i] * yarns.stress_u, yarn_share_[t][i] * yarns.stress_v,
                plain_ ? linear_[3][i] * e[2] : law_s_.at(e[2]).stress);
    if (!patches_.patches.empty())
      for (const particles::TileIndex& from : patch_at_[t])
        stress.head<2>() += patch_stress_[from[i]];
    states.push_back({e, factor_[triangle] * stress});
  }
  return states;
}

}  // namespace loosefit::fabric
