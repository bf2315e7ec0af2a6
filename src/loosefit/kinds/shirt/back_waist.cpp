#include "loosefit/kinds/shirt/back_waist.h"

#include <algorithm>
#include <cmath>

#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

constexpr double kLeastBackIntake = 0.005;  // less nobody sews [m]
constexpr double kMouthShare = 0.2, kLeastMouth = 0.004;
constexpr double kHandle = 0.4;  // of a curve, of its height

/// x of a leg, which has no turning back, at a level that it crosses.
double leg_at(const pattern::EdgePath& leg, double y) {
  const bool upwards = leg.at(1).y() > leg.at(0).y();
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    ((leg.at(middle).y() < y) == upwards ? low : high) = middle;
  }
  return leg.at(0.5 * (low + high)).x();
}

}  // namespace

double back_waist_intake(const ShirtFit& fit) {
  return fit.back_waist < kLeastBackIntake ? 0.0 : fit.back_waist;
}

double back_hem_mouth(double intake) {
  return intake > 0 ? std::max(kMouthShare * intake, kLeastMouth) : 0.0;
}

pattern::CurveChain draft_back_seam(const BackSeam& s) {
  const Vec2 hem(s.at_hem, s.hem_y), waist(s.at_waist, s.waist_y),
      tip(0, s.underarm_y - kBackTipDrop);
  const Vec2 below(0, kHandle * (waist.y() - hem.y())), above(0, kHandle * (tip.y() - waist.y()));
  pattern::CurveChain seam;
  seam.start = hem;
  seam.cubic_to(hem + below, waist - below, waist).cubic_to(waist + above, tip - above, tip);
  return seam;
}

double back_seam_takes(const pattern::Panel& back, double y) {
  const int left = pattern::find_edge_part(back, "back_seam_L"),
            right = pattern::find_edge_part(back, "back_seam_R");
  if (left < 0 || right < 0) return 0;
  const pattern::EdgePath a(back, left), b(back, right);
  const auto [low, high] = std::minmax(a.at(0).y(), a.at(1).y());
  return y <= low || y >= high ? 0.0 : std::abs(leg_at(a, y) - leg_at(b, y));
}

std::optional<BodyHem> body_hem(const pattern::Panel& piece) {
  if (const int e = pattern::find_edge_part(piece, "hem"); e >= 0) {
    const pattern::EdgePath hem(piece, e);
    return BodyHem{(hem.at(1) - hem.at(0)).norm(),
                   std::max({hem.at(0).y(), hem.at(0.5).y(), hem.at(1).y()})};
  }
  const int left = pattern::find_edge_part(piece, "hem_L"),
            right = pattern::find_edge_part(piece, "hem_R");
  if (left < 0 || right < 0) return std::nullopt;
  const pattern::EdgePath a(piece, left), b(piece, right);
  // Each part has one end at a side, and one at the mouth, where they are nearest to each other.
  const bool mouth_ends_a = (a.at(1) - b.at(0)).norm() < (a.at(0) - b.at(1)).norm();
  const Vec2 side_a = a.at(mouth_ends_a ? 0 : 1), mouth_a = a.at(mouth_ends_a ? 1 : 0),
             side_b = b.at(mouth_ends_a ? 1 : 0), mouth_b = b.at(mouth_ends_a ? 0 : 1);
  return BodyHem{(side_a - side_b).norm() - (mouth_a - mouth_b).norm(),
                 std::max({side_a.y(), mouth_a.y(), side_b.y(), mouth_b.y()})};
}

}  // namespace loosefit::kinds
