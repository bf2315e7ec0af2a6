#pragma once
#include <array>
#include <vector>

#include "loosefit/particles/energy.h"

namespace loosefit::fabric {

/// A rigid board as its energy sees it. Its particles are affine images of three of them, the
/// leaders (solver::Plate), so it cannot bend.
struct RigidPlate {
  std::array<int, 3> leaders{};
  std::array<Vec2, 3> rest;    ///< places of the leaders in the flat board [m], counter-clockwise
  double area = 0;             ///< of the board [m²]
  double mass = 0;             ///< [kg]; its weight at the cloth is that of the particles
  double offset = 0;           ///< of its centre of mass along the outside normal [m]
};

/// In-plane stiffness that keeps the affine image of a board a turned one [N/m]. Cloth pulls with up
/// to 50 N/m, so that sides change by 0.1 %, no more; a board itself has 10⁷, which would only make
/// the matrix worse (docs/theory/boards.md 1).
inline constexpr double kBoardStiffness = 5e4;

/// What rigid boards add to the energies of the cloth under them:
///
///   Π = ½ K A ‖(FᵀF − I)/2‖² + m g o n_z                                              [J]
///
/// F = [p1 − p0, p2 − p0] R⁻¹ from the leaders, R from their places at rest; n the unit normal of
/// the leaders, o the offset: the moment of a weight that is not in the cloth. z is up.
class BoardEnergy : public particles::Energy {
 public:
  BoardEnergy(std::vector<RigidPlate> plates, double gravity)
      : plates_(std::move(plates)), gravity_(gravity) {}
  void set_gravity(double gravity) { gravity_ = gravity; }
  bool empty() const { return plates_.empty(); }

  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x,
                   particles::BlockPattern& pattern) const override;
  /// half_compression keeps half of the part that compression makes negative, `projected` none; both
  /// leave out the second derivative of the weight, which is small and indefinite.
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;

 private:
  std::vector<RigidPlate> plates_;
  double gravity_;
};

}  // namespace loosefit::fabric
