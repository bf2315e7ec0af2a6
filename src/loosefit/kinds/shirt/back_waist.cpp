#include "loosefit/kinds/shirt/back_waist.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

constexpr double kLeastBackIntake = 0.005;  // less nobody sews [m]
constexpr double kMouthShare = 0.2, kLeastMouth = 0.008;
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

pattern::CurveChain draft_back_dart(const BackDart& d, bool outer) {
  const double side = outer ? 1 : -1;
  const Vec2 hem(d.middle + side * d.at_hem, d.hem_y),
      waist(d.middle + side * d.at_waist, d.waist_y), tip(d.middle, d.tip_y);
  const Vec2 below(0, kHandle * (waist.y() - hem.y())), above(0, kHandle * (tip.y() - waist.y()));
  pattern::CurveChain leg;
  leg.start = hem;
  leg.cubic_to(hem + below, waist - below, waist).cubic_to(waist + above, tip - above, tip);
  return leg;
}

double back_darts_take(const pattern::Panel& back, double y) {
  double taken = 0;
  for (const std::string dart : {"back_dart_L", "back_dart_R"}) {
    const int inner = pattern::find_edge_part(back, dart + "_inner"),
              outer = pattern::find_edge_part(back, dart + "_outer");
    if (inner < 0 || outer < 0) continue;
    const pattern::EdgePath a(back, inner), b(back, outer);
    const auto [low, high] = std::minmax(a.at(0).y(), a.at(1).y());
    if (y > low && y < high) taken += std::abs(leg_at(a, y) - leg_at(b, y));
  }
  return taken;
}

std::optional<BodyHem> body_hem(const pattern::Panel& piece) {
  const int e = pattern::find_edge_part(piece, "hem");
  if (e < 0) return std::nullopt;
  const pattern::EdgePath hem(piece, e);
  Vec2 start = hem.at(0), end = hem.at(1);
  BodyHem found{0, std::max({start.y(), hem.at(0.5).y(), end.y()})};
  double mouths = 0;
  // Parts beyond darts, of which one begins or ends at a side: each moves an end of the hem there.
  for (const char* part : {"hem_L", "hem_R"}) {
    const int beyond = pattern::find_edge_part(piece, part);
    if (beyond < 0) continue;
    const pattern::EdgePath path(piece, beyond);
    const double after = (path.at(0) - end).norm(), before = (path.at(1) - start).norm();
    mouths += std::min(after, before);
    (after < before ? end : start) = path.at(after < before ? 1 : 0);
    found.highest = std::max({found.highest, path.at(0).y(), path.at(1).y()});
  }
  found.girth = (end - start).norm() - mouths;
  return found;
}

}  // namespace loosefit::kinds
