#include "loosefit/kinds/hoodie/hood_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "loosefit/base/check.h"
#include "loosefit/base/error.h"
#include "loosefit/kinds/shirt/shirt_bands.h"
#include "loosefit/kinds/told_limit.h"
#include "loosefit/pattern/drafting.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

constexpr double kRise = radians(12);  ///< of the hood's neck edge, down to its middle and up again
constexpr double kFullest = 0.55;      ///< of the height, where the hood is deepest
constexpr double kBehindNeck = 0.01;   ///< the hood, over the end of its neck edge [m]
constexpr double kBeside = 0.14;       ///< a piece, from the middle of the body [m]
constexpr double kBeforeMiddle = 0.08;  ///< the front edge [m]

double length_of(const pattern::Pattern& shirt, const std::string& panel, const std::string& edge) {
  const pattern::Panel& piece = shirt.panels[shirt.find_part(panel)];
  return pattern::EdgePath(piece, pattern::find_edge_part(piece, edge)).length();
}

/// Parts the neck edge of a piece, from `first` to `second` side, at its joint in the middle.
void part_neck(pattern::Pattern& shirt, const std::string& part, const std::string& first,
               const std::string& second) {
  const int index = shirt.find_part(part);
  pattern::Panel& panel = shirt.panels[index];
  const int at = pattern::find_edge_part(panel, "neck");
  const pattern::PanelEdge whole = panel.edges[at];
  const auto half = static_cast<long>(whole.curves.size() / 2);
  LOOSEFIT_ASSERT(whole.curves.size() % 2 == 0 && std::abs(whole.knots[half - 1].x()) < 1e-9);
  const int middle = static_cast<int>(panel.vertices.size());
  panel.vertices.push_back(whole.knots[half - 1]);
  pattern::PanelEdge before = whole, after = whole;
  before.end = after.start = middle;
  before.curves.assign(whole.curves.begin(), whole.curves.begin() + half);
  before.knots.assign(whole.knots.begin(), whole.knots.begin() + half - 1);
  after.curves.assign(whole.curves.begin() + half, whole.curves.end());
  after.knots.assign(whole.knots.begin() + half, whole.knots.end());
  before.name = before.part = "neck_" + first;
  after.name = after.part = "neck_" + second;
  panel.edges[at] = before;
  panel.edges.insert(panel.edges.begin() + at + 1, after);
  for (pattern::Stitch& seam : shirt.stitches)
    for (pattern::Stitch::Side* side : {&seam.first, &seam.second})
      if (side->panel == index && side->edge > at) ++side->edge;
}

/// Sews a piece to an edge that was free, and so was hemmed.
void sew_on(pattern::Pattern& shirt, const std::string& name, const std::string& panel,
            const std::string& edge, const std::string& piece, const std::string& own) {
  pattern::Panel& of = shirt.panels[shirt.find_panel(panel)];
  of.edges[pattern::find_edge(of, edge)].finish = 0;
  pattern::sew_edges(shirt, name, panel, edge, piece, own);
}

/// Depth that reaches over the back of the neckline, by its halves in front and behind [m].
double least_depth(double front, double back) {
  return (front + back) * std::cos(kRise) + kBehindNeck;
}

/// The wearer's left half seen from outside: x to the back, y up, from the middle of the neckline
/// in front.
std::vector<std::pair<std::string, pattern::CurveChain>> hood_half(const HoodShape& shape,
                                                                   double front, double back) {
  const Vec2 start(0, 0), shoulder(front * std::cos(kRise), -front * std::sin(kRise)),
      nape = shoulder + back * Vec2(std::cos(kRise), std::sin(kRise));
  if (const double least = least_depth(front, back); shape.depth < least)
    throw InvalidInput(
        {{}, 0, "fit.hood_depth"}, fmt::format("{:.3f} m", shape.depth),
        fmt::format("at least {:.3f} m, over the back of the neckline", told_least(least)));
  const double h = shape.height, d = shape.depth;
  const Vec2 top(0, h), fullest(d, kFullest * h);
  pattern::CurveChain to_shoulder, on_back, over, face;
  to_shoulder.start = start;
  to_shoulder.line_to(shoulder);
  on_back.start = shoulder;
  on_back.line_to(nape);
  over.start = nape;
  over.cubic_to(nape + Vec2(0.2 * (d - nape.x()), 0.15 * h), fullest - Vec2(0, 0.2 * h), fullest)
      .cubic_to(fullest + Vec2(0, 0.25 * h), top + Vec2(0.55 * d, 0.01 * h), top);
  face.start = top;
  face.line_to(start);
  return {{"neck_front", to_shoulder}, {"neck_back", on_back}, {"back", over}, {"face", face}};
}

}  // namespace

double least_hood_depth(const pattern::Pattern& shirt) {
  constexpr double kRounding = 1e-9;  // [m], of an edge and its halves
  return least_depth(length_of(shirt, "front", "neck") / 2, length_of(shirt, "back", "neck") / 2) +
         kRounding;
}

void add_hood(pattern::Pattern& shirt, const HoodShape& shape) {
  // Counter-clockwise, the neckline of the front runs to the wearer's right, that of the back to
  // the left.
  part_neck(shirt, "front", "L", "R");
  part_neck(shirt, "back", "R", "L");
  const auto half =
      hood_half(shape, length_of(shirt, "front", "neck_L"), length_of(shirt, "back", "neck_L"));
  const Vec3 neck = shirt.panels[shirt.find_part("front")].translation;
  for (const std::string s : {"L", "R"}) {
    const double side = s == "L" ? 1 : -1;
    auto loop = half;
    if (side < 0) {
      loop.assign(half.rbegin(), half.rend());
      for (auto& [edge, chain] : loop) chain = chain.reversed().mirrored();
    }
    pattern::Panel panel = pattern::draft_panel("hood_" + s, "body", loop);
    panel.edges[pattern::find_edge(panel, "face")].finish = shape.finish;
    panel.rotation.col(0) = Vec3(0, side, 0);
    panel.rotation.col(1) = Vec3(0, 0, 1);
    panel.rotation.col(2) = Vec3(side, 0, 0);
    panel.translation = Vec3(side * kBeside, -kBeforeMiddle, neck.z() + 0.02);
    shirt.panel_order.push_back(static_cast<int>(shirt.panels.size()));
    shirt.panels.push_back(std::move(panel));
    sew_on(shirt, "hood_front_" + s, "front", "neck_" + s, "hood_" + s, "neck_front");
    sew_on(shirt, "hood_back_" + s, "back", "neck_" + s, "hood_" + s, "neck_back");
  }
  pattern::sew_edges(shirt, "hood", "hood_L", "back", "hood_R", "back");
}

void add_hem_band(pattern::Pattern& shirt, const HemBand& band) {
  if (band.width <= 0) return;
  for (const std::string half : {"front", "back"}) {
    const bool front = half == "front";  // x > 0 is the wearer's left in front
    const pattern::Panel& body = shirt.panels[shirt.find_part(half)];
    const double length = (1 - band.stretch) * length_of(shirt, half, "hem"), low = [&] {
      double y = 0;
      for (const Vec2& v : body.vertices) y = std::min(y, v.y());
      return y;
    }();
    pattern::Panel strip = folded_strip(
        "hem_band_" + half, "body", {-length / 2, length, low - band.width, low},
        {"rim", front ? "end_L" : "end_R", "seam", front ? "end_R" : "end_L"}, band.stiffness);
    strip.rotation = body.rotation;
    strip.translation = body.translation - Vec3(0, 0, 0.01);
    shirt.panel_order.push_back(static_cast<int>(shirt.panels.size()));
    shirt.panels.push_back(std::move(strip));
    sew_on(shirt, "hem_band_" + half, half, "hem", "hem_band_" + half, "seam");
  }
  for (const std::string end : {"end_L", "end_R"})
    pattern::sew_edges(shirt, "hem_band_" + end, "hem_band_front", end, "hem_band_back", end);
}

}  // namespace loosefit::kinds
