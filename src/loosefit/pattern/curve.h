#pragma once
#include <utility>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// Point of the curve from `a` to `b` at parameter t in [0, 1] (Bernstein form; circles by angle,
/// W3C SVG 1.1 appendix F.6 in y-up axes).
Vec2 curve_point(const EdgeCurve& curve, const Vec2& a, const Vec2& b, double t);
/// Derivative with respect to t [m].
Vec2 curve_derivative(const EdgeCurve& curve, const Vec2& a, const Vec2& b, double t);
/// Arc length between two parameters [m]; five-point Gauss-Legendre on `pieces` equal parts.
double curve_length(const EdgeCurve& curve, const Vec2& a, const Vec2& b, double t0 = 0,
                    double t1 = 1, int pieces = 64);
/// The same curve as two, cut at t (de Casteljau); the knot is curve_point(t).
std::pair<EdgeCurve, EdgeCurve> split_curve(const EdgeCurve& curve, const Vec2& a, const Vec2& b,
                                            double t);
/// Mirror image under x → -x.
EdgeCurve mirrored_curve(EdgeCurve curve);
/// The curve travelled from `b` to `a`.
EdgeCurve reversed_curve(EdgeCurve curve);

}  // namespace loosefit::pattern
