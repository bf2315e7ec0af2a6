#pragma once
#include "loosefit/base/types.h"

namespace loosefit::contact {

/// Narrow phase: nearest points of two mesh features: Σ weight_k x_k with weights summing to 0 is
/// the vector from the second feature to the first; its length is the distance [m].
struct PairDistance {
  double distance = 0;
  std::array<double, 4> weight{};
  Vec3 normal = Vec3::Zero();  ///< unit vector from the second to the first; zero when they touch
};

/// Point x0 against triangle x1 x2 x3 (all regions: face, edges, corners).
PairDistance point_triangle_distance(const Vec3& x0, const Vec3& x1, const Vec3& x2,
                                     const Vec3& x3);
/// Segment x0 x1 against segment x2 x3 (Ericson 2005, 5.1.9), parallel ones included.
PairDistance edge_edge_distance(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3);

enum class PairKind { point_triangle, edge_edge };
using PairPoints = std::array<Vec3, 4>;  ///< point and triangle, or two edges

PairDistance pair_distance(PairKind kind, const PairPoints& x);

/// Second derivatives of the distance with respect to the four points [1/m]; the nearest points may
/// slide within the part of the features (face, edge, corner) on which they lie now.
/// \pre d = pair_distance(kind, x), d.distance > 0
using PairMatrix = Eigen::Matrix<double, 12, 12>;
PairMatrix distance_hessian(PairKind kind, const PairPoints& x, const PairDistance& d);

/// Quick lower bound of the distance: the gap of the projections on the line through the centres.
double separation(PairKind kind, const PairPoints& x);

/// Upper bound of the loss of distance while the points move along dx. Common motion is free.
double motion_bound(PairKind kind, const PairPoints& dx);

/// First contact of two features moving linearly from x to x + dx, as a share of dx in [0, 1];
/// 1 when they stay apart. Conservative: the features keep at least a tenth of their distance.
/// Additive continuous collision detection, Li, Kaufman and Jiang 2021 (C-IPC), alg. 1, which
/// advances by the distance over the closing speed along its direction (conservative advancement
/// with directed motion bounds, Mirtich 1996): features that slide along each other are not taken
/// for ones that meet.
double time_of_impact(PairKind kind, const PairPoints& x, const PairPoints& dx, double upper = 1.0);

}  // namespace loosefit::contact
