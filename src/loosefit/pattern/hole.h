#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// The rim of a hole divided for a mesh.
struct DividedHole {
  std::vector<Vec2> points;   ///< counter-clockwise [m]
  std::vector<double> along;  ///< per point: its place along the rim as drawn [m]
};

/// Corners of the rim that turn by more than 40 degrees stay; the parts between them are divided
/// evenly, into segments of about `edge_length` [m], at least eight in all, more where the rim
/// would cross itself.
DividedHole divided_hole(const PanelHole& hole, double edge_length);

/// Point of the rim as drawn, `along` [m] from its first point; beyond the last one it goes on from
/// the first.
Vec2 point_on_rim(const PanelHole& hole, double along);
/// Length of the rim [m].
double rim_length(const PanelHole& hole);

/// Why a hole cannot be cut into an outline that has the others already: its area is below 4 cm²,
/// or hole_place_fault. Empty: it can.
std::string hole_fault(const PanelHole& hole, const std::vector<Vec2>& outline,
                       const std::vector<PanelHole>& others);
/// The same of a hole of any size: it is no simple line of three points or more, it does not lie in
/// the outline, or it comes nearer than 1 mm to the outline or to another hole.
std::string hole_place_fault(const PanelHole& hole, const std::vector<Vec2>& outline,
                             const std::vector<PanelHole>& others);

/// A name that none of the others has: the wished one ("hole" for an empty text), else with the
/// first free number behind it.
std::string free_hole_name(const std::string& wished, const std::vector<PanelHole>& others);

/// The holes under x → −x, counter-clockwise again.
std::vector<PanelHole> mirrored_holes(std::vector<PanelHole> holes);

/// Area of the cloth of a panel: of its outline without its holes [m²].
double cloth_area(const Panel& panel, int per_curve = 40);

/// Whether a point is on the cloth: in the outline and in no hole.
bool on_cloth(const Panel& panel, const std::vector<Vec2>& outline, const Vec2& p);

}  // namespace loosefit::pattern
