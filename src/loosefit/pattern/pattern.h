#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::pattern {

/// Shape of one curve between two points, in panel coordinates [m].
struct EdgeCurve {
  enum class Kind { line, quadratic, cubic, circle } kind = Kind::line;
  std::vector<Vec2> control;  ///< absolute control points [m]: 1 (quadratic) or 2 (cubic)
  double radius = 0;          ///< circle [m]
  bool large_arc = false;     ///< circle: SVG flags in y-up axes
  bool sweep = false;         ///< circle: true runs counter-clockwise
};

/// Elastic tape that is stretched and sewn on within a panel, along one of its edges. It pulls, it
/// does not push.
struct EdgeElastic {
  double ratio = 1;               ///< its own length over that of the edge as cut
  double stiffness = 20;          ///< EA: force per elongation of its own length [N]
  double width = 0.03;            ///< [m]
  double linear_density = 0.015;  ///< of its own length, before it is stretched [kg/m]
  bool operator==(const EdgeElastic&) const = default;
};

/// One seam unit of a panel outline: a chain of curves from vertex `start` to vertex `end`.
struct PanelEdge {
  int start = 0, end = 0;             ///< indices into Panel::vertices
  std::vector<EdgeCurve> curves{{}};  ///< at least one
  std::vector<Vec2> knots;            ///< joints between the curves [m]: one fewer than curves
  std::string
      name;  ///< unique within the panel: "hem", "armhole_L", …; "edge_3" if the file has none
  std::string label;  ///< GarmentCode label, may be empty
  std::string part;   ///< what it is in the draft that made the pattern; empty without one
  double finish = 0;  ///< width of the hem turned under along it [m]; 0: cut and left
  std::optional<EdgeElastic> elastic = {};
};

/// What a piece is made of, against one layer of the garment's fabric. A folded strip is 2, 2, 2.
struct PanelCloth {
  double mass = 1;      ///< areal density
  double membrane = 1;  ///< stiffness in the plane
  double bending = 1;   ///< bending rigidity, at least 1

  bool operator==(const PanelCloth&) const = default;
};

/// A hole cut into a piece, whose rim is sewn to nothing: an opening of the garment where a hand
/// goes through it.
struct PanelHole {
  std::string name;          ///< "neck hole"
  std::vector<Vec2> points;  ///< its rim, counter-clockwise, the first point once [m]
};

/// A flat piece. x is weft, y is warp (grain). The outline runs counter-clockwise seen from the
/// outside of the cloth; z of the placed panel points to the outside.
struct Panel {
  std::string name;
  std::string label;                  ///< GarmentCode: body, arm, leg or empty
  std::string part;                   ///< as PanelEdge::part: "front", "sleeve_L_back", …
  std::vector<Vec2> vertices;         ///< [m]
  std::vector<PanelEdge> edges;       ///< one closed loop in order
  std::vector<PanelHole> holes = {};  ///< within the outline, apart from it and from each other
  PanelCloth cloth = {};              ///< of what
  Vec3 translation = Vec3::Zero();    ///< placement in our frame (z up, facing -y) [m]
  Mat3 rotation = Mat3::Identity();   ///< panel (x, y, 0) → our frame
};

/// One seam: edge `first` sewn to edge `second`. Both may lie in one panel (dart, tube).
struct Stitch {
  struct Side {
    int panel = 0, edge = 0;
  } first, second;
  bool right_wrong =
      false;         ///< start meets start (otherwise the end of one meets the start of the other)
  std::string name;  ///< "side_L", "armhole_front_L", …
};

/// A sewing pattern: flat panels and seams, SI units.
struct Pattern {
  std::string name;
  std::string kind = "pattern-file";  ///< GarmentKind::name (kinds/kind.h)
  std::vector<Panel> panels;
  std::vector<Stitch> stitches;
  std::vector<int> panel_order;

  /// Index of a panel by name, -1 if there is none.
  int find_panel(const std::string& panel_name) const;
  /// Index of the panel that is this part of a draft, -1 if there is none.
  int find_part(const std::string& part) const;
};

}  // namespace loosefit::pattern
