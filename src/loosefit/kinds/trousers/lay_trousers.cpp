#include "loosefit/kinds/trousers/lay_trousers.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/dress/body_outline.h"
#include "loosefit/dress/front_neckline.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/dress/sheets.h"

namespace loosefit::kinds {
namespace {

constexpr double kSlice = 0.01;        ///< of the body that is looked at as one level [m]
constexpr double kNearMiddle = 0.003;  ///< half the gap between the inseams at the crotch [m]
constexpr double kUnderCrotch = 0.15;  ///< of the inseam, where the thighs may touch

double level_of(const body::Body& body, const char* name) {
  const auto found = body.measured.find(name);
  if (found == body.measured.end())
    throw GeometryError(std::string("body: trousers cannot be put on, the body has no ") + name,
                        "measures or a scan with legs apart give it");
  return found->second;
}

/// How far trunk and legs reach from the middle at each level, one side.
class LegOutline {
 public:
  LegOutline(const body::Body& body, int side) {
    for (std::size_t v = 0; v < body.segment.size(); ++v) {
      const body::Segment s = body.segment[v];
      const bool leg =
          s == body::Segment::thigh || s == body::Segment::shank || s == body::Segment::foot;
      if (!leg && s != body::Segment::torso) continue;
      const Vec3& p = body.surface.vertices[v];
      if (side * p.x() < 0) continue;
      const auto k = static_cast<std::size_t>(std::max(0.0, p.z() / kSlice));
      if (outer_.size() <= k) outer_.resize(k + 1, 0), inner_.resize(k + 1, kNone);
      outer_[k] = std::max(outer_[k], side * p.x());
      inner_[k] = std::min(inner_[k], side * p.x());
    }
  }
  double outer(double z) const { return at(outer_, z); }
  double inner(double z) const { return at(inner_, z); }

 private:
  static constexpr double kNone = 1e9;
  static double at(const std::vector<double>& field, double z) {
    const auto k = static_cast<std::size_t>(std::max(0.0, z / kSlice));
    return field.empty() ? 0 : field[std::min(k, field.size() - 1)];
  }
  std::vector<double> outer_, inner_;
};

/// One leg in the (x, z) plane, x > 0.
struct LegFrame {
  std::vector<Vec2> outseam;  ///< waist → hem
  std::vector<Vec2> inseam;   ///< crotch → hem
};

struct TrousersHeights {
  double waist, crotch, hem, rim;
};

LegFrame leg_frame(const LegOutline& leg, const TrousersHeights& z, double clearance) {
  LegFrame frame;
  // Outwards from the waist to where trunk and legs are widest, then straight down.
  double widest = 0, hips = z.crotch;
  for (double y = z.hem; y < z.waist; y += kSlice) widest = std::max(widest, leg.outer(y));
  for (double y = z.crotch; y < z.waist; y += kSlice)
    if (leg.outer(y) > leg.outer(hips)) hips = y;
  const double beside = widest + clearance;
  frame.outseam = {{leg.outer(z.waist) + clearance, z.waist}, {beside, hips}, {beside, z.hem}};
  // Straight down between the legs, as far from the middle as they leave room.
  double apart = 0.5 * leg.inner(z.hem);
  const double length = z.crotch - z.hem;
  for (double share = kUnderCrotch; share < 1; share += kSlice / length)
    apart = std::min(apart, 0.5 * leg.inner(z.crotch - share * length) / share);
  frame.inseam = {{0, z.crotch}, {std::max(kNearMiddle, apart), z.hem}};
  return frame;
}

std::vector<Vec2> to_side(std::vector<Vec2> line, int side) {
  for (Vec2& p : line) p.x() *= side;
  return line;
}

void lay_leg(dress::PanelOutline& panel, const LegFrame& frame, int side,
             const TrousersHeights& z) {
  const auto out = to_side(frame.outseam, side), in = to_side(frame.inseam, side);
  panel.lay("outseam", "waist", out);
  panel.lay("inseam", "centre", in);
  panel.lay("centre", "waist", {Vec2(0, z.waist), in.front()});
  panel.lay("waist", "outseam", {out.front(), Vec2(0, z.waist)});
  panel.lay("hem", "outseam", {out.back(), in.back()});
}

}  // namespace

std::vector<Vec3> lay_trousers(const garment::Garment& g, const body::Body& body,
                               const dress::LayingRoom& room) {
  const dress::BodyOutline depth(body, room.clearance);
  const auto* inseam = g.find_part("front_L", "inseam");
  if (!inseam) throw GeometryError("pattern: trousers without an inseam");
  const auto* end = g.find_part("waistband_front", "end_L");
  const double band = end ? dress::flat_length(g, *end) : 0;
  TrousersHeights z{};
  z.rim = level_of(body, "waist_level") + 0.5 * band;
  z.waist = z.rim - band;
  z.crotch = level_of(body, "crotch_height") - 0.5 * room.clearance;
  z.hem = std::max(0.03, z.crotch - dress::flat_length(g, *inseam));
  if (z.waist - z.crotch < 0.05)
    throw dress::NoRoom("the waist lies too near to the crotch to lay trousers round the body");
  const LegOutline left(body, 1), right(body, -1);
  const LegFrame frames[] = {leg_frame(left, z, room.clearance),
                             leg_frame(right, z, room.clearance)};
  dress::Sheets sheets(g);
  for (int p = 0; p < static_cast<int>(g.panel_names.size()); ++p) {
    const std::string& part = g.panel_parts[p];
    const bool back = part.find("back") != std::string::npos;
    dress::PanelOutline panel(g, part);
    if (part.starts_with("waistband")) {
      const Vec2 l = frames[0].outseam.front(), r = to_side(frames[1].outseam, -1).front(),
                 up(0, band), middle(0, z.waist);
      panel.lay("seam_L", "end_L", {l, middle});
      panel.lay("seam_R", "end_R", {r, middle});
      panel.lay("end_L", "seam_L", {l, l + up});
      panel.lay("end_R", "seam_R", {r, r + up});
      panel.lay("rim", "end_L", {l + up, r + up});
    } else {
      const int side = part.ends_with("_L") ? 1 : -1;
      lay_leg(panel, frames[side > 0 ? 0 : 1], side, z);
    }
    sheets.add(p, panel, back);
  }
  return sheets.positions(depth, room);
}

}  // namespace loosefit::kinds
