#include <algorithm>
#include <cmath>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/dress/body_outline.h"
#include "loosefit/dress/dress.h"
#include "loosefit/dress/flat_layout.h"
#include "loosefit/dress/lay_shirt.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/dress/shirt_frame.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit {
namespace {

/// Tries, between body and sheets [m]: wide ones help coarse triangles, narrow ones thick arms.
constexpr double kClearances[] = {0.02, 0.026, 0.034, 0.044, 0.057, 0.014, 0.010};

/// Puts the vertices of a chain evenly along a polyline that starts at `from`'s end of the chain.
void lay_chain(const Garment::EdgeChain& chain, bool reversed, const std::vector<Vec2>& line,
               std::map<int, Vec2>& outline) {
  double total = 0;
  for (std::size_t i = 1; i < line.size(); ++i) total += (line[i] - line[i - 1]).norm();
  const std::size_t n = chain.vertices.size();
  for (std::size_t k = 0; k < n; ++k) {
    double s = total * double(k) / double(n - 1);
    std::size_t i = 1;
    while (i + 1 < line.size() && s > (line[i] - line[i - 1]).norm()) {
      s -= (line[i] - line[i - 1]).norm();
      ++i;
    }
    const Vec2 direction = (line[i] - line[i - 1]).normalized();
    const int v = chain.vertices[reversed ? n - 1 - k : k];
    outline[v] = line[i - 1] + s * direction;
  }
}

/// Lays the chain between the places of its two ends; `towards` tells which end comes last: the
/// vertex that the chain shares with it.
class Panel2d {
 public:
  Panel2d(const Garment& g, const std::string& part) : g_(g), part_(part) {}
  void lay(const std::string& edge, const std::string& first_neighbour,
           const std::vector<Vec2>& line) {
    const auto* chain = chain_of(edge);
    const auto* first = chain_of(first_neighbour);
    const int head = chain->vertices.front();
    const bool starts = head == first->vertices.front() || head == first->vertices.back();
    lay_chain(*chain, !starts, line, outline);
  }
  std::map<int, Vec2> outline;

 private:
  const Garment::EdgeChain* chain_of(const std::string& edge) const {
    const auto* chain = g_.find_part(part_, edge);
    if (!chain || chain->vertices.size() < 2)
      throw GeometryError("pattern: the " + part_ + " of the shirt has no edge " + edge);
    return chain;
  }
  const Garment& g_;
  std::string part_;
};

}  // namespace

bool is_shirt(const Garment& garment) {
  for (const char* panel : {"front", "back"})
    for (const char* edge :
         {"hem", "side_L", "side_R", "armhole_L", "armhole_R", "shoulder_L", "shoulder_R", "neck"})
      if (!garment.find_part(panel, edge)) return false;
  for (const char* panel : {"sleeve_L_front", "sleeve_L_back", "sleeve_R_front", "sleeve_R_back"})
    for (const char* edge : {"top", "cuff", "under", "cap"})
      if (!garment.find_part(panel, edge)) return false;
  return garment.panel_names.size() == 6;
}

std::vector<Vec3> lay_shirt(const Garment& g, const Body& body, const ShirtRoom& room) {
  const BodyOutline depth(body, room.clearance);
  const ShirtFrame frame = shirt_frame(g, body, depth, room.clearance);

  // A vertex on a seam between front and back lies on the middle surface, others before or behind.
  std::vector<int> sheets(g.vertex_count, 0);  // bit 0: front, bit 1: back
  std::vector<Vec2> place(g.vertex_count, Vec2::Zero());
  for (int p = 0; p < static_cast<int>(g.panel_names.size()); ++p) {
    const std::string& name = g.panel_parts[p];
    Panel2d panel(g, name);
    const bool is_back = name.find("back") != std::string::npos;
    if (name == "front" || name == "back") {
      const auto &l = frame.left, &r = frame.right;
      panel.lay("hem", "side_L", {l.hem, r.hem});
      panel.lay("side_L", "hem", {l.hem, l.armpit});
      panel.lay("side_R", "hem", {r.hem, r.armpit});
      panel.lay("armhole_L", "side_L", l.armhole);
      panel.lay("armhole_R", "side_R", r.armhole);
      panel.lay("shoulder_L", "armhole_L", {l.shoulder, l.neck});
      panel.lay("shoulder_R", "armhole_R", {r.shoulder, r.neck});
      panel.lay(
          "neck", "shoulder_L",
          is_back || room.straight_neck ? std::vector<Vec2>{l.neck, r.neck} : frame.front_neck);
    } else {
      const auto& half = name.find("_L_") != std::string::npos ? frame.left : frame.right;
      panel.lay("cap", "under", half.armhole);
      panel.lay("top", "cap", half.sleeve_top);
      panel.lay("under", "cap", half.sleeve_under);
      panel.lay("cuff", "top", {half.sleeve_top.back(), half.sleeve_under.back()});
    }
    const auto layout = lay_flat(g, p, panel.outline);
    // Seen from the front the outside of a front panel faces us: counter-clockwise in (x, z).
    if (count_turned_over(g, p, layout, is_back ? -1 : 1) > 0)
      throw NoRoom("panel " + g.panel_names[p] +
                   " cannot be laid over the body without folding over");
    for (const auto& [v, q] : layout) {
      place[v] = q;
      sheets[v] |= is_back ? 2 : 1;
    }
  }
  std::vector<Vec3> x(g.vertex_count);
  for (int v = 0; v < g.vertex_count; ++v) {
    const double u = place[v][0], z = place[v][1], middle = depth.middle(u, z);
    double y = middle;
    if (sheets[v] == 1)
      y = std::min(middle + room.depth_share * (depth.front(u, z) - middle),
                   middle - room.least_depth);
    if (sheets[v] == 2)
      y = std::max(middle + room.depth_share * (depth.back(u, z) - middle),
                   middle + room.least_depth);
    x[v] = Vec3(u, y, z);
  }
  return x;
}

std::vector<Vec3> dress_shirt(const Garment& shirt, const Body& body) {
  NoRoom last("");
  for (const double clearance : kClearances) try {
      std::vector<Vec3> x = lay_shirt(shirt, body, {clearance});
      const auto hits = self_intersections(x, shirt.triangles);
      if (hits.empty()) return x;
      last = NoRoom("the shirt cannot be laid round this body: " + std::to_string(hits.size()) +
                    " pairs of its triangles cut each other at the start");
    } catch (const NoRoom& error) {
      last = error;
    }
  throw last;
}

}  // namespace loosefit
