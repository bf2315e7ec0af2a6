#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/dress/body_outline.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/garment.h"

namespace loosefit::dress {

/// Outline of one panel in the (x, z) plane, seen from the front [m], laid edge by edge. Panel and
/// edges are named by their part of the draft (Panel::part). Keeps a reference to the garment.
class PanelOutline {
 public:
  PanelOutline(const garment::Garment& garment, const std::string& part)
      : garment_(garment), part_(part) {}
  /// Puts the vertices of an edge evenly along a polyline that begins at the vertex that the edge
  /// shares with `neighbour`. \throws GeometryError for a panel without these edges.
  void lay(const std::string& edge, const std::string& neighbour, const std::vector<Vec2>& line);
  const std::map<int, Vec2>& places() const { return places_; }

 private:
  const garment::Garment::EdgeChain* chain_of(const std::string& edge) const;
  const garment::Garment& garment_;
  std::string part_;
  std::map<int, Vec2> places_;
};

/// A garment as sheets before and behind the body: every panel flat in the (x, z) plane over the
/// limb that it will cover, then moved in depth; seams between front and back close at the
/// silhouette. Keeps a reference to the garment.
class Sheets {
 public:
  explicit Sheets(const garment::Garment& garment);
  /// Lays a panel flat within its outline. \throws NoRoom when it would fold over.
  void add(int panel, const PanelOutline& outline, bool back);
  /// Places in space; every panel must have been added. `depth` has room.clearance.
  std::vector<Vec3> positions(const BodyOutline& depth, const LayingRoom& room) const;

 private:
  const garment::Garment& garment_;
  std::vector<int> sheets_;  ///< per vertex, bit 0: front, bit 1: back
  std::vector<Vec2> place_;
};

}  // namespace loosefit::dress
