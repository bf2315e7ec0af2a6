#include "loosefit/fabric/stress_curve.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::fabric {
namespace {

std::string told(const CurvePoint& p) {
  return "force " + shortest(p.force) + " N/m at strain " + shortest(p.strain);
}

// The points with the origin in front, checked.
std::vector<CurvePoint> from_origin(const std::vector<CurvePoint>& points) {
  std::vector<CurvePoint> all{{0, 0}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint& p = points[i];
    if (i == 0 && p.strain == 0 && p.force == 0) continue;
    const InputPlace place{"", 0, "point " + std::to_string(i + 1)};
    if (!std::isfinite(p.strain) || !std::isfinite(p.force))
      throw InvalidInput(place, told(p), "finite numbers");
    const std::string after = told(p) + " after " + told(all.back());
    if (!(p.strain > all.back().strain))
      throw InvalidInput(place, after, "a strain that rises with every point",
                         "sort the points; give the loading branch only");
    if (!(p.force > all.back().force))
      throw InvalidInput(place, after, "a force that rises with every point",
                         "leave out falling points (noise, slack, unloading) or smooth the curve");
    all.push_back(p);
  }
  if (all.size() < 2)
    throw InvalidInput({}, "no point beside the origin", "at least one measured point");
  return all;
}

}  // namespace

MonotoneCubic::MonotoneCubic(const std::vector<CurvePoint>& points) {
  const std::vector<CurvePoint> p = from_origin(points);
  const std::size_t n = p.size() - 1;  // pieces
  std::vector<double> h(n), secant(n), slope(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = p[i + 1].strain - p[i].strain;
    secant[i] = (p[i + 1].force - p[i].force) / h[i];
  }
  slope[0] = secant[0];
  slope[n] = secant[n - 1];
  for (std::size_t i = 1; i < n; ++i) {
    const double parabola = (h[i] * secant[i - 1] + h[i - 1] * secant[i]) / (h[i - 1] + h[i]);
    slope[i] = std::min(parabola, 3 * std::min(secant[i - 1], secant[i]));
  }
  double integral = 0;
  for (std::size_t i = 0; i < n; ++i) {
    Piece piece{p[i].force, slope[i], (3 * secant[i] - 2 * slope[i] - slope[i + 1]) / h[i],
                (slope[i] + slope[i + 1] - 2 * secant[i]) / (h[i] * h[i]), integral};
    integral += h[i] * (piece.a + h[i] * (piece.b / 2 + h[i] * (piece.c / 3 + h[i] * piece.d / 4)));
    knots_.push_back(p[i].strain);
    pieces_.push_back(piece);
  }
  knots_.push_back(p[n].strain);
  pieces_.push_back({p[n].force, slope[n], 0, 0, integral});
}

MonotoneCubic::Value MonotoneCubic::at(double x) const {
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end(), x);
  const std::size_t i = static_cast<std::size_t>(above - knots_.begin()) - 1;
  const Piece& p = pieces_[i];
  const double s = x - knots_[i];
  return {p.integral + s * (p.a + s * (p.b / 2 + s * (p.c / 3 + s * p.d / 4))),
          p.a + s * (p.b + s * (p.c + s * p.d)), p.b + s * (2 * p.c + 3 * s * p.d)};
}

StressCurve StressCurve::linear(double stiffness) {
  StressCurve curve;
  curve.stiffness_ = stiffness;
  return curve;
}

StressCurve StressCurve::tension(const std::vector<CurvePoint>& points) {
  StressCurve curve;
  curve.kind_ = Kind::tension;
  curve.law_ = MonotoneCubic(points);
  curve.stiffness_ = curve.law_.initial_slope();
  return curve;
}

StressCurve StressCurve::shear(const std::vector<CurvePoint>& points) {
  StressCurve curve = tension(points);
  curve.kind_ = Kind::shear;
  return curve;
}

StressCurve::Response StressCurve::at(double strain) const {
  if (kind_ == Kind::shear) {
    const MonotoneCubic::Value v = law_.at(std::abs(strain));
    return {v.integral, std::copysign(v.value, strain), v.slope};
  }
  if (strain > 0 && kind_ == Kind::tension) {
    const double stretch = std::sqrt(1 + 2 * strain);
    // λ − 1 without cancellation at small strain.
    const MonotoneCubic::Value f = law_.at(2 * strain / (stretch + 1));
    return {f.integral, f.value / stretch,
            (f.slope * stretch - f.value) / (stretch * stretch * stretch)};
  }
  return {0.5 * stiffness_ * strain * strain, stiffness_ * strain, stiffness_};
}

double StressCurve::smallest_tangent() const {
  double least = stiffness_;
  if (kind_ == Kind::linear) return least;
  constexpr int kSteps = 32;
  const std::vector<double>& knots = law_.knots();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (int j = 0; j <= kSteps; ++j) {
      const double x = knots[i] + (knots[i + 1] - knots[i]) * j / kSteps;
      least = std::min(least, at(kind_ == Kind::shear ? x : x * (1 + 0.5 * x)).tangent);
    }
  return least;
}

CurvePoint force_of_green(double green_strain, double second_piola_kirchhoff) {
  const double stretch = std::sqrt(1 + 2 * green_strain);
  return {2 * green_strain / (stretch + 1), second_piola_kirchhoff * stretch};
}

}  // namespace loosefit::fabric
