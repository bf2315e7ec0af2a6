#include "loosefit/fabric/bending_energy.h"

#include <cmath>

#include "loosefit/fabric/dihedral.h"
#include "loosefit/fabric/hinge_blocks.h"

namespace loosefit::fabric {

Mat3 plate_rigidity(const Material& m, double added) {
  const double root = std::sqrt(m.bending_weft * m.bending_warp), nu = m.bending_poisson;
  Mat3 d = Mat3::Zero();
  d(0, 0) = m.bending_weft + added;
  d(1, 1) = m.bending_warp + added;
  d(0, 1) = d(1, 0) = nu * (root + added);
  d(2, 2) = 0.5 * (1 - nu) * (root + added);
  return d;
}

BendingEnergy::BendingEnergy(const std::vector<Triangle>& triangles,
                             const std::vector<std::array<Vec2, 3>>& triangle_uv,
                             const std::vector<double>& added_rigidity, const Material& material,
                             bool viscous, const std::vector<char>& built_in)
    : friction_({material.bending_hysteresis_weft, material.bending_hysteresis_warp},
                {material.bending_weft, material.bending_warp}),
      damping_(viscous ? material.damping : 0) {
  std::vector<Mat3> rigidity;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    rigidity.push_back(plate_rigidity(material, added_rigidity.empty() ? 0.0 : added_rigidity[t]));
  mesh_ = curvature_patches(triangles, triangle_uv, rigidity, built_in);
  build_tiles(rigidity);
}

void BendingEnergy::build_tiles(const std::vector<Mat3>& rigidity) {
  const std::size_t hinges = mesh_.hinges.size(), patches = mesh_.patches.size();
  hinge_tiles_.assign(particles::tiles_for(hinges), HingeTile{});
  patch_tiles_.assign(particles::tiles_for(patches), PatchTile{});
  // Places behind the last one stand for what a hinge or patch lacks; they hold 0.
  const int no_angle = particles::kTile * static_cast<int>(hinge_tiles_.size());
  const int no_moment = 9 * particles::kTile * static_cast<int>(patch_tiles_.size());
  const int no_stiffness = 3 * particles::kTile * static_cast<int>(patch_tiles_.size());

  // Hinges: their particles, and where their forces and blocks go.
  std::vector<int> particle(4 * particles::kTile * hinge_tiles_.size(), -1);
  std::vector<std::array<int, 2>> pairs(10 * particles::kTile * hinge_tiles_.size(), {-1, -1});
  for (std::size_t t = 0; t < hinge_tiles_.size(); ++t) {
    for (particles::TileIndex& row : hinge_tiles_[t].moment) row.fill(no_moment);
    for (particles::TileIndex& row : hinge_tiles_[t].own) row.fill(no_stiffness);
    for (int i = 0; i < particles::kTile; ++i) {
      const std::size_t hinge = t * particles::kTile + i;
      const auto& v = mesh_.hinges[hinge < hinges ? hinge : 0];
      for (int a = 0; a < 4; ++a) hinge_tiles_[t].corner[a][i] = v[a];
      if (hinge >= hinges) continue;
      int slot = 0;
      for (int a = 0; a < 4; ++a) {
        particle[4 * hinge + a] = v[a];
        for (int b = 0; b <= a; ++b) pairs[10 * hinge + slot++] = {v[a], v[b]};
      }
    }
  }
  to_particles_ = particles::ParticleGather(particle);
  to_blocks_ = particles::BlockGather(pairs);

  // Patches: area, rigidity and fit, and in each hinge the places of the moments about it.
  for (PatchTile& tile : patch_tiles_)
    for (particles::TileIndex& row : tile.hinge) row.fill(no_angle);
  std::vector<int> acting(hinges, 0), owned(hinges, 0);
  for (std::size_t t = 0; t < patches; ++t) {
    const CurvaturePatch& p = mesh_.patches[t];
    const int block = static_cast<int>(t) / particles::kTile,
              i = static_cast<int>(t) % particles::kTile;
    PatchTile& tile = patch_tiles_[block];
    tile.area[i] = p.area;
    const Mat3 d = p.area * rigidity[t];
    const double entry[] = {d(0, 0), d(1, 1), d(0, 1), d(2, 2)};
    for (int k = 0; k < 4; ++k) tile.rigidity[k][i] = entry[k];
    for (int k = 0; k < p.hinges; ++k) {
      const int hinge = p.hinge[k];
      if (hinge < 0) continue;
      HingeTile& about = hinge_tiles_[hinge / particles::kTile];
      const int place = hinge % particles::kTile;
      tile.hinge[k][i] = hinge;
      for (int c = 0; c < 3; ++c) tile.s[k][c][i] = p.s(c, k);
      about.moment[acting[hinge]++][place] = (9 * block + k) * particles::kTile + i;
      // The first three hinges are the triangle's own: they carry the tangent of single hinges.
      if (k >= 3) continue;
      about.own[owned[hinge]++][place] = (3 * block + k) * particles::kTile + i;
      about.stiffness[place] += p.fit.col(k).dot(d * p.fit.col(k));
    }
  }
  // Working memory.
  set_active_set(nullptr);
  curvature_start_.assign(patch_tiles_.size(), kZeroRows);
  anchor_.assign(patch_tiles_.size(), kZeroRows);
  angle_.assign(no_angle + 1, 0.0);
  moment_.assign(no_moment + 1, 0.0);
  gradient_.resize(hinge_tiles_.size());
  energy_.resize(patch_tiles_.size());
  force_.resize(4 * particles::kTile * hinge_tiles_.size());
}

Vec3 BendingEnergy::curvature(int triangle, const particles::VectorField& x) const {
  const CurvaturePatch& p = mesh_.patches[triangle];
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < p.hinges; ++k)
    if (p.hinge[k] >= 0) {
      const auto& v = mesh_.hinges[p.hinge[k]];
      sum += dihedral_angle(x[v[0]], x[v[1]], x[v[2]], x[v[3]]) * p.s.col(k);
    }
  return sum;
}

void BendingEnergy::set_active_set(const particles::ActiveSet* active_set) {
  active_set_ = active_set;
  turning_ = bent_ = particles::tiles_in(active_set, hinge_tiles_);
  bending_ = particles::IndexSubset(patch_tiles_.size());
  if (!active_set) return;
  const auto of_tile = [&](int tile, const auto& visit) {
    const auto end = std::min<std::size_t>(mesh_.patches.size(), particles::kTile * (tile + 1));
    for (std::size_t t = particles::kTile * tile; t < end; ++t) visit(mesh_.patches[t]);
  };
  std::vector<char> wanted(hinge_tiles_.size(), 0);
  bending_ = particles::IndexSubset(patch_tiles_.size(), [&](int tile) {
    bool touched = false;
    of_tile(tile, [&](const CurvaturePatch& p) {
      touched = touched || active_set->touches(p.particle, p.count);
    });
    if (touched)
      of_tile(tile, [&](const CurvaturePatch& p) {
        for (int k = 0; k < p.hinges; ++k)
          if (p.hinge[k] >= 0) wanted[p.hinge[k] / particles::kTile] = 1;
      });
    return touched;
  });
  for (int k = 0; k < turning_.size(); ++k) wanted[turning_[k]] = 1;
  bent_ = particles::IndexSubset(hinge_tiles_.size(), [&](int tile) { return wanted[tile] != 0; });
}

void BendingEnergy::find_angles(const particles::VectorField& x, bool with_gradient) const {
  particles::for_tiles(bent_, [&](int t) {
    HingePoints point;
    particles::gather_points(x, hinge_tiles_[t].corner, point);
    particles::TileRow angle;
    if (with_gradient)
      hinge_angles(point, angle, gradient_[t]);
    else
      hinge_angles(point, angle);
    std::copy(angle.begin(), angle.end(), angle_.begin() + particles::kTile * t);
  });
}

void BendingEnergy::patch_response(int t, PlaneRows& curvature, PlaneResponse& response) const {
  const PatchTile& tile = patch_tiles_[t];
  patch_curvature(tile, angle_.data(), curvature);
  response = PlaneResponse{};
  add_quadratic(tile.rigidity, curvature, kZeroRows, 1, response);
  if (viscous_ratio_ > 0)
    add_quadratic(tile.rigidity, curvature, curvature_start_[t], viscous_ratio_, response);
  if (friction_.active()) friction_.add(curvature, anchor_[t], tile.area, response);
}

double BendingEnergy::bend(const particles::VectorField& x, bool with_moments) const {
  find_angles(x, with_moments);
  particles::for_tiles(bending_, [&](int t) {
    PlaneRows curvature;
    PlaneResponse response;
    patch_response(t, curvature, response);
    energy_[t] = particles::sum_of(response.energy);
    if (!with_moments) return;
    std::array<particles::TileRow, 9> moment;
    patch_moments(patch_tiles_[t], response.stress, moment);
    for (int k = 0; k < 9; ++k)
      std::copy(moment[k].begin(), moment[k].end(),
                moment_.begin() + (9 * t + k) * particles::kTile);
  });
  double sum = 0;
  for (int k = 0; k < bending_.size(); ++k) sum += energy_[bending_[k]];
  return sum;
}

particles::TileRow BendingEnergy::moments_about(const HingeTile& tile) const {
  particles::TileRow sum{};
  for (const particles::TileIndex& from : tile.moment)
    for (int i = 0; i < particles::kTile; ++i) sum[i] += moment_[from[i]];
  return sum;
}

void BendingEnergy::begin_step(const particles::VectorField& x, double dt) {
  viscous_ratio_ = std::isfinite(dt) && dt > 0 ? damping_ / dt : 0;
  if (viscous_ratio_ <= 0 && !friction_.active()) return;
  // The yarns slide from step to step; iterates of one balance leave no trace.
  const bool slide = friction_.active() && std::isfinite(dt);
  find_angles(x, false);
  particles::for_tiles(static_cast<int>(patch_tiles_.size()), [&](int t) {
    PlaneRows& now = curvature_start_[t];
    patch_curvature(patch_tiles_[t], angle_.data(), now);
    if (!slide) return;
    for (int i = 0; i < particles::kTile; ++i) {
      const Vec3 curvature(now[0][i], now[1][i], now[2][i]),
          before(anchor_[t][0][i], anchor_[t][1][i], anchor_[t][2][i]);
      const Vec3 after = friction_.carried(friction_.slide(curvature), before);
      for (int c = 0; c < 3; ++c) anchor_[t][c][i] = after[c];
    }
  });
}

double BendingEnergy::value(const particles::VectorField& x) const { return bend(x, false); }

void BendingEnergy::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  value_and_gradient(x, g);
}

double BendingEnergy::value_and_gradient(const particles::VectorField& x,
                                         particles::VectorField& g) const {
  const double energy = bend(x, true);
  particles::for_tiles(turning_, [&](int t) {
    std::array<particles::TileRow, 12> row;
    hinge_forces(gradient_[t], moments_about(hinge_tiles_[t]), row);
    particles::spread(row, force_[4 * particles::kTile * t].data());
  });
  to_particles_.add(force_, g, active_set_);
  return energy;
}

void BendingEnergy::add_pattern(const particles::VectorField&,
                                particles::BlockPattern& pattern) const {
  if (tangent_ == particles::BendingTangent::hinge)
    to_blocks_.add_pattern(pattern);
  else
    patch_tangent().add_pattern(pattern);
}

PatchTangent& BendingEnergy::patch_tangent() const {
  if (!patch_tangent_) patch_tangent_ = std::make_unique<PatchTangent>(mesh_.patches);
  return *patch_tangent_;
}

Mat3 BendingEnergy::friction_tangent(const PlaneRows& curvature, int t, int i) const {
  const PlaneRows& anchor = anchor_[t];
  return patch_tiles_[t].area[i] * friction_
                                       .respond({curvature[0][i], curvature[1][i], curvature[2][i]},
                                                {anchor[0][i], anchor[1][i], anchor[2][i]})
                                       .tangent;
}

void BendingEnergy::find_friction_stiffness() const {
  friction_stiffness_.resize(3 * particles::kTile * patch_tiles_.size() + 1);
  particles::for_tiles(bending_, [&](int t) {
    PlaneRows curvature;
    patch_curvature(patch_tiles_[t], angle_.data(), curvature);
    for (int i = 0;
         i < particles::kTile && t * particles::kTile + i < static_cast<int>(mesh_.patches.size());
         ++i) {
      const Mat3 inner = friction_tangent(curvature, t, i);
      const Mat3& fit = mesh_.patches[t * particles::kTile + i].fit;
      for (int k = 0; k < 3; ++k)
        friction_stiffness_[(3 * t + k) * particles::kTile + i] =
            fit.col(k).dot(inner * fit.col(k));
    }
  });
}

particles::TileRow BendingEnergy::hinge_stiffness(const HingeTile& tile) const {
  particles::TileRow sum = tile.stiffness;
  for (double& k : sum) k *= 1 + viscous_ratio_;
  if (friction_.active())
    for (const particles::TileIndex& from : tile.own)
      for (int i = 0; i < particles::kTile; ++i) sum[i] += friction_stiffness_[from[i]];
  return sum;
}

void BendingEnergy::add_patches(particles::BlockMatrix& h) const {
  particles::for_tiles(bent_, [&](int t) {
    particles::TileRow one;
    one.fill(1);
    std::array<particles::TileRow, 12> row;
    hinge_forces(gradient_[t], one, row);
    particles::spread(row, force_[4 * particles::kTile * t].data());
  });
  PatchTangent& tangent = patch_tangent();
  particles::for_tiles(bending_, [&](int t) {
    const PatchTile& tile = patch_tiles_[t];
    PlaneRows curvature;
    if (friction_.active()) patch_curvature(tile, angle_.data(), curvature);
    for (int i = 0;
         i < particles::kTile && t * particles::kTile + i < static_cast<int>(mesh_.patches.size());
         ++i) {
      const PlaneTangent& d = tile.rigidity;
      Mat3 k;
      k << d[0][i], d[2][i], 0, d[2][i], d[1][i], 0, 0, 0, d[3][i];
      k *= 1 + viscous_ratio_;
      if (friction_.active()) k += friction_tangent(curvature, t, i);
      tangent.set(t * particles::kTile + i, mesh_.patches[t * particles::kTile + i], k, force_);
    }
  });
  tangent.add(h);
}

void BendingEnergy::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                                particles::HessianKind kind) const {
  const bool exact = kind == particles::HessianKind::exact;
  constexpr double kFlat = 0.25;  // [rad]; below it the moment part of a hinge may be left out
  // The plate tangent has the stiffness of the angles from the patches (definite in itself);
  // otherwise each hinge has its own.
  const bool patches = tangent_ == particles::BendingTangent::plate;
  bend(x, true);
  if (!patches && friction_.active()) find_friction_stiffness();

  block_.resize(10 * particles::kTile * hinge_tiles_.size());
  particles::for_tiles(turning_, [&](int t) {
    const HingeTile& tile = hinge_tiles_[t];
    HingePoints point;
    particles::gather_points(x, tile.corner, point);
    const particles::TileRow stiffness = patches ? particles::TileRow{} : hinge_stiffness(tile);
    particles::TileRow moment = moments_about(tile);
    HingeBlocks row;
    if (exact) {
      hinge_blocks(point, stiffness, moment, row);
    } else {
      for (int i = 0; i < particles::kTile; ++i)
        if (std::abs(angle_[particles::kTile * t + i]) <= kFlat) moment[i] = 0;
      hinge_definite_blocks(point, stiffness, moment, row);
    }
    particles::spread(row, block_[10 * particles::kTile * t].data());
  });
  to_blocks_.add(block_, h, active_set_);
  if (patches) add_patches(h);
}

}  // namespace loosefit::fabric
