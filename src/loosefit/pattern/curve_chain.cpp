#include "loosefit/pattern/curve_chain.h"

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

CurveChain CurveChain::reversed() const {
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

}  // namespace loosefit::pattern
