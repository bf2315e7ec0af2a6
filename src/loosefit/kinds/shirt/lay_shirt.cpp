#include "loosefit/kinds/shirt/lay_shirt.h"

#include "loosefit/base/error.h"
#include "loosefit/dress/body_outline.h"
#include "loosefit/dress/sheets.h"
#include "loosefit/kinds/shirt/shirt_frame.h"
#include "loosefit/kinds/shirt/shirt_values.h"

namespace loosefit::kinds {

std::vector<Vec3> lay_shirt(const garment::Garment& g, const body::Body& body,
                            const dress::LayingRoom& room) {
  const dress::BodyOutline depth(body, room.clearance);
  const ShirtFrame frame = shirt_frame(g, body, depth, room.clearance);
  dress::Sheets sheets(g);
  for (int p = 0; p < static_cast<int>(g.panel_names.size()); ++p) {
    const ShirtPart* part = find_shirt_part(g.panel_parts[p]);
    if (!part) throw GeometryError("pattern: panel " + g.panel_names[p] + " is no part of a shirt");
    dress::PanelOutline panel(g, part->name);
    if (!part->sleeve) {
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
          part->back || room.straight_neck ? std::vector<Vec2>{l.neck, r.neck} : frame.front_neck);
    } else {
      const auto& half = part->side > 0 ? frame.left : frame.right;
      panel.lay("cap", "under", half.armhole);
      panel.lay("top", "cap", half.sleeve_top);
      panel.lay("under", "cap", half.sleeve_under);
      panel.lay("cuff", "top", {half.sleeve_top.back(), half.sleeve_under.back()});
    }
    sheets.add(p, panel, part->back);
  }
  return sheets.positions(depth, room);
}

}  // namespace loosefit::kinds
