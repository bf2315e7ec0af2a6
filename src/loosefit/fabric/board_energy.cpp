#include "loosefit/fabric/board_energy.h"

#include <algorithm>
#include <cmath>

namespace loosefit::fabric {
namespace {

using particles::HessianKind;
using Shape = Eigen::Matrix<double, 3, 2>;  // row k: gradient of leader k's hat function [1/m]
using Image = Eigen::Matrix<double, 3, 2>;  // F: images of the unit vectors of the board

Shape hat_gradients(const RigidPlate& plate) {
  Mat2 edges;
  edges << plate.rest[1] - plate.rest[0], plate.rest[2] - plate.rest[0];
  const Mat2 inverse = edges.inverse();
  Shape shape;
  shape.row(1) = inverse.row(0);
  shape.row(2) = inverse.row(1);
  shape.row(0) = -inverse.row(0) - inverse.row(1);
  return shape;
}

Image image(const RigidPlate& plate, const Shape& shape, const particles::VectorField& x) {
  Image f = Image::Zero();
  for (int k = 0; k < 3; ++k) f += x[plate.leaders[k]] * shape.row(k);
  return f;
}

Mat2 strain(const Image& f) { return 0.5 * (f.transpose() * f - Mat2::Identity()); }

Mat3 skew(const Vec3& v) {
  Mat3 m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

/// Height of the unit normal and its derivatives by the (unnormalised) normal N of the leaders.
struct NormalHeight {
  std::array<Vec3, 3> opposite;  ///< edges: N changes by opposite_k × δp_k
  Vec3 normal;                   ///< unit
  double length;                 ///< |N| [m²]

  NormalHeight(const RigidPlate& plate, const particles::VectorField& x) {
    const Vec3 &a = x[plate.leaders[0]], &b = x[plate.leaders[1]], &c = x[plate.leaders[2]];
    opposite = {c - b, a - c, b - a};
    const Vec3 n = (b - a).cross(c - a);
    length = n.norm();
    normal = n / length;
  }
  Vec3 slope() const { return (Vec3::UnitZ() - normal.z() * normal) / length; }
  Mat3 curvature() const {
    const Vec3 up = Vec3::UnitZ();
    return (3 * normal.z() * normal * normal.transpose() - up * normal.transpose() -
            normal * up.transpose() - normal.z() * Mat3::Identity()) /
           (length * length);
  }
};

/// Stress for the part of the Hessian that compression makes negative: as it is, or with a share of
/// its negative part.
Mat2 geometric_stress(const Mat2& stress, HessianKind kind) {
  if (kind == HessianKind::exact) return stress;
  const double kept = kind == HessianKind::half_compression ? 0.5 : 0;
  const double mean = 0.5 * stress.trace();
  const double radius = std::hypot(0.5 * (stress(0, 0) - stress(1, 1)), stress(0, 1));
  const double high = mean + radius, low = mean - radius;
  if (low >= 0) return stress;
  if (high <= 0) return kept * stress;
  const Mat2 of_high = (stress - low * Mat2::Identity()) / (high - low);
  return high * of_high + kept * low * (Mat2::Identity() - of_high);
}

}  // namespace

double BoardEnergy::value(const particles::VectorField& x) const {
  double energy = 0;
  for (const RigidPlate& plate : plates_) {
    energy += 0.5 * kBoardStiffness * plate.area *
              strain(image(plate, hat_gradients(plate), x)).squaredNorm();
    energy += plate.mass * gravity_ * plate.offset * NormalHeight(plate, x).normal.z();
  }
  return energy;
}

void BoardEnergy::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  for (const RigidPlate& plate : plates_) {
    const Shape shape = hat_gradients(plate);
    const Image f = image(plate, shape, x);
    const Image force = kBoardStiffness * plate.area * f * strain(f);
    const NormalHeight height(plate, x);
    const Vec3 slope = plate.mass * gravity_ * plate.offset * height.slope();
    for (int k = 0; k < 3; ++k)
      g[plate.leaders[k]] += force * shape.row(k).transpose() + slope.cross(height.opposite[k]);
  }
}

void BoardEnergy::add_pattern(const particles::VectorField&,
                              particles::BlockPattern& pattern) const {
  for (const RigidPlate& plate : plates_)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < a; ++b) pattern.add(plate.leaders[a], plate.leaders[b]);
}

void BoardEnergy::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                              HessianKind kind) const {
  for (const RigidPlate& plate : plates_) {
    const Shape shape = hat_gradients(plate);
    const Image f = image(plate, shape, x);
    const double stiffness = kBoardStiffness * plate.area;
    const Mat2 stress = geometric_stress(stiffness * strain(f), kind);
    const NormalHeight height(plate, x);
    const double moment = plate.mass * gravity_ * plate.offset;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b <= a; ++b) {
        const Vec2 ga = shape.row(a), gb = shape.row(b);
        // δE = sym(Fᵀ δp gᵀ): the material part, then the geometric one.
        Mat3 block =
            0.5 * stiffness * (ga.dot(gb) * f * f.transpose() + (f * gb) * (f * ga).transpose());
        block += ga.dot(stress * gb) * Mat3::Identity();
        if (kind == HessianKind::exact && moment != 0) {
          block += moment * skew(height.opposite[a]).transpose() * height.curvature() *
                   skew(height.opposite[b]);
          // N is bilinear in the leaders: δ_a × δ_b for (0, 1), (1, 2), (2, 0).
          if (a != b) {
            const Mat3 turn = moment * skew(height.slope());
            block += (b + 1) % 3 == a ? turn : Mat3(-turn);
          }
        }
        h.add(plate.leaders[a], plate.leaders[b], block);
      }
  }
}

}  // namespace loosefit::fabric
