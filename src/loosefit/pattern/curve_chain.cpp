#include "loosefit/pattern/curve_chain.h"

#include <Eigen/Geometry>
#include <cmath>

#include "loosefit/pattern/curve.h"

namespace loosefit::pattern {

CurveChain& CurveChain::line_to(const Vec2& p) {
  curves.push_back({});
  knots.push_back(p);
  return *this;
}

CurveChain& CurveChain::cubic_to(const Vec2& c1, const Vec2& c2, const Vec2& p) {
  EdgeCurve curve;
  curve.kind = EdgeCurve::Kind::cubic;
  curve.control = {c1, c2};
  curves.push_back(curve);
  knots.push_back(p);
  return *this;
}

double CurveChain::length(int pieces) const {
  double sum = 0;
  for (std::size_t i = 0; i < curves.size(); ++i)
    sum += curve_length(curves[i], i == 0 ? start : knots[i - 1], knots[i], 0, 1, pieces);
  return sum;
}

double CurveChain::length_until(int axis, double level) const {
  double before = 0;
  Vec2 a = start;
  for (std::size_t i = 0; i < curves.size(); a = knots[i++]) {
    if (knots[i][axis] > level) {
      before += curve_length(curves[i], a, knots[i]);
      continue;
    }
    double low = 0, high = 1;
    for (int k = 0; k < 52; ++k) {
      const double t = 0.5 * (low + high);
      (curve_point(curves[i], a, knots[i], t)[axis] > level ? low : high) = t;
    }
    return before + curve_length(curves[i], a, knots[i], 0, high);
  }
  return before;
}

CurveChain CurveChain::reversed() const {
  if (curves.empty()) return *this;
  CurveChain back;
  back.start = end();
  for (std::size_t i = curves.size(); i-- > 0;) {
    back.curves.push_back(reversed_curve(curves[i]));
    back.knots.push_back(i == 0 ? start : knots[i - 1]);
  }
  return back;
}

CurveChain CurveChain::mirrored() const {
  CurveChain image = *this;
  image.start.x() = -image.start.x();
  for (Vec2& k : image.knots) k.x() = -k.x();
  for (EdgeCurve& c : image.curves) c = mirrored_curve(c);
  return image;
}

CurveChain CurveChain::turned(const Vec2& about, double angle) const {
  const Eigen::Rotation2Dd turn(angle);
  const auto place = [&](Vec2& p) { p = Vec2(about + turn * (p - about)); };
  CurveChain image = *this;
  place(image.start);
  for (Vec2& k : image.knots) place(k);
  for (EdgeCurve& curve : image.curves)
    for (Vec2& c : curve.control) place(c);
  return image;
}

std::pair<CurveChain, CurveChain> CurveChain::cut(double arc) const {
  constexpr double kAtJoint = 1e-7;  // a shorter rest is no curve [m]
  constexpr double kExact = 1e-14;   // [m]
  CurveChain before, after;
  before.start = start;
  std::size_t i = 0;
  double rest = arc;
  Vec2 a = start;
  const auto append = [](CurveChain& chain, const EdgeCurve& curve, const Vec2& end) {
    chain.curves.push_back(curve);
    chain.knots.push_back(end);
  };
  for (; i < curves.size(); a = knots[i++]) {
    const double whole = curve_length(curves[i], a, knots[i]);
    if (rest < whole - kAtJoint) break;
    append(before, curves[i], knots[i]);
    rest -= whole;
  }
  after.start = a;
  if (i < curves.size() && rest > kAtJoint) {
    // Newton's method, kept between bounds.
    double low = 0, high = 1, t = 0.5;
    for (int k = 0; k < 60 && low < high; ++k) {
      const double off = curve_length(curves[i], a, knots[i], 0, t) - rest;
      if (std::abs(off) < kExact) break;
      (off < 0 ? low : high) = t;
      const double newton = t - off / curve_derivative(curves[i], a, knots[i], t).norm();
      const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
      if (next == t) break;  // no number lies between
      t = next;
    }
    const auto [first, second] = split_curve(curves[i], a, knots[i], t);
    after.start = curve_point(curves[i], a, knots[i], t);
    append(before, first, after.start);
    append(after, second, knots[i++]);
  }
  for (; i < curves.size(); ++i) append(after, curves[i], knots[i]);
  return {before, after};
}

}  // namespace loosefit::pattern
