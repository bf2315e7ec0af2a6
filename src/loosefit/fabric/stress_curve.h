#pragma once
#include <vector>

#include "loosefit/fabric/material.h"

namespace loosefit::fabric {

/// C¹ piecewise cubic through measured points and the origin. Inner slopes are those of the
/// parabola through three neighbours, at most three times the smaller adjacent secant, so that a
/// rising law stays rising (Fritsch and Carlson 1980, in the box form of de Boor and Swartz); the
/// end slopes are the first and the last secant; beyond the last point it is straight.
class MonotoneCubic {
 public:
  MonotoneCubic() = default;
  /// \throws InvalidInput (its key names the point) unless strain and force rise from the origin
  /// with every point. A point (0, 0) in front is accepted.
  explicit MonotoneCubic(const std::vector<CurvePoint>& points);

  struct Value {
    double integral, value, slope;
  };
  /// x ≥ 0; the integral runs from 0 and is exact.
  Value at(double x) const;
  double initial_slope() const { return pieces_.front().b; }
  /// Abscissae of the points, with the origin.
  const std::vector<double>& knots() const { return knots_; }

 private:
  struct Piece {
    double a, b, c, d, integral;  ///< a + b s + c s² + d s³, s = x − knot
  };
  std::vector<double> knots_;
  std::vector<Piece> pieces_;  ///< one per knot; the last is the straight tail
};

/// Law of one strain component: energy w(E) per flat area, S = w′ (second Piola-Kirchhoff), w″.
///
/// A measured force f(λ) per reference width enters as S(E) = f(λ)/λ with E = (λ² − 1)/2, so that
/// every elongation is met by the measured force (docs/theory/validation.md 1.2). Because S dE = f
/// dλ, the energy is the integral of f over λ, and w″ = (f′ λ − f)/λ³. Compression (E < 0) is
/// linear in E with the initial slope. Shear is odd in γ.
class StressCurve {
 public:
  static StressCurve linear(double stiffness);
  /// \throws as MonotoneCubic.
  static StressCurve tension(const std::vector<CurvePoint>& points);
  static StressCurve shear(const std::vector<CurvePoint>& points);

  struct Response {
    double energy;   ///< w [J/m²]
    double stress;   ///< w′ [N/m]
    double tangent;  ///< w″ [N/m]
  };
  Response at(double strain) const;
  /// Least w″ over compression and the measured range [N/m]; may be ≤ 0 where a fabric yields.
  double smallest_tangent() const;

 private:
  enum class Kind { linear, tension, shear };
  Kind kind_ = Kind::linear;
  double stiffness_ = 0;
  MonotoneCubic law_;  ///< f(λ − 1), or S(γ)
};

/// Inverse of the conversion above: S at Green strain E > −1/2 as a point of the force curve.
CurvePoint force_of_green(double green_strain, double second_piola_kirchhoff);

}  // namespace loosefit::fabric
