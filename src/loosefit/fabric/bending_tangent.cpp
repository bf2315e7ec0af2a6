#include <cmath>

#include "loosefit/fabric/bending_energy.h"
#include "loosefit/fabric/hinge_blocks.h"

namespace loosefit {

void BendingEnergy::add_pattern(const VectorField&, BlockPattern& pattern) const {
  if (tangent_ == BendingTangent::hinge)
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
  friction_stiffness_.resize(3 * kTile * patch_tiles_.size() + 1);
  for_tiles(bending_, [&](int t) {
    PlaneRows curvature;
    patch_curvature(patch_tiles_[t], angle_.data(), curvature);
    for (int i = 0; i < kTile && t * kTile + i < static_cast<int>(mesh_.patches.size()); ++i) {
      const Mat3 inner = friction_tangent(curvature, t, i);
      const Mat3& fit = mesh_.patches[t * kTile + i].fit;
      for (int k = 0; k < 3; ++k)
        friction_stiffness_[(3 * t + k) * kTile + i] = fit.col(k).dot(inner * fit.col(k));
    }
  });
}

TileRow BendingEnergy::hinge_stiffness(const HingeTile& tile) const {
  TileRow sum = tile.stiffness;
  for (double& k : sum) k *= 1 + viscous_ratio_;
  if (friction_.active())
    for (const TileIndex& from : tile.own)
      for (int i = 0; i < kTile; ++i) sum[i] += friction_stiffness_[from[i]];
  return sum;
}

void BendingEnergy::add_patches(BlockMatrix& h) const {
  for_tiles(bent_, [&](int t) {
    TileRow one;
    one.fill(1);
    std::array<TileRow, 12> row;
    hinge_forces(gradient_[t], one, row);
    spread(row, force_[4 * kTile * t].data());
  });
  PatchTangent& tangent = patch_tangent();
  for_tiles(bending_, [&](int t) {
    const PatchTile& tile = patch_tiles_[t];
    PlaneRows curvature;
    if (friction_.active()) patch_curvature(tile, angle_.data(), curvature);
    for (int i = 0; i < kTile && t * kTile + i < static_cast<int>(mesh_.patches.size()); ++i) {
      const PlaneTangent& d = tile.rigidity;
      Mat3 k;
      k << d[0][i], d[2][i], 0, d[2][i], d[1][i], 0, 0, 0, d[3][i];
      k *= 1 + viscous_ratio_;
      if (friction_.active()) k += friction_tangent(curvature, t, i);
      tangent.set(t * kTile + i, mesh_.patches[t * kTile + i], k, force_);
    }
  });
  tangent.add(h);
}

void BendingEnergy::add_hessian(const VectorField& x, BlockMatrix& h, HessianKind kind) const {
  const bool exact = kind == HessianKind::exact;
  constexpr double kFlat = 0.25;  // [rad]; below it the moment part of a hinge may be left out
  // The plate tangent has the stiffness of the angles from the patches (definite in itself);
  // otherwise each hinge has its own.
  const bool patches = tangent_ == BendingTangent::plate;
  find_angles(x, true);
  bend(true);
  if (!patches && friction_.active()) find_friction_stiffness();

  block_.resize(10 * kTile * hinge_tiles_.size());
  for_tiles(turning_, [&](int t) {
    const HingeTile& tile = hinge_tiles_[t];
    HingePoints point;
    gather_points(x, tile.corner, point);
    const TileRow stiffness = patches ? TileRow{} : hinge_stiffness(tile);
    TileRow moment = moments_about(tile);
    HingeBlocks row;
    if (exact) {
      hinge_blocks(point, stiffness, moment, row);
    } else {
      for (int i = 0; i < kTile; ++i)
        if (std::abs(angle_[kTile * t + i]) <= kFlat) moment[i] = 0;
      hinge_definite_blocks(point, stiffness, moment, row);
    }
    spread(row, block_[10 * kTile * t].data());
  });
  to_blocks_.add(block_, h, active_set_);
  if (patches) add_patches(h);
}

}  // namespace loosefit
