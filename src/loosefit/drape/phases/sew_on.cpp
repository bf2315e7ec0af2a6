#include "loosefit/drape/phases/sew_on.h"

#include <fmt/format.h>

#include <optional>

#include "loosefit/drape/arrange_panels.h"
#include "loosefit/drape/phases/close_seams.h"
#include "loosefit/dress/no_room.h"

namespace loosefit::drape {
namespace {

/// Pulls along the outsides of panels that are tried in turn [Pa]: the first leaves narrow seams
/// nearest to where they belong, stronger ones part more.
constexpr double kPulls[] = {3, 10, 30};

}  // namespace

std::vector<Vec3> sew_on(const garment::Garment& garment, const pattern::Pattern& pattern,
                         const body::PosedBody& body, bool has_wider) {
  const garment::OpenSeams open = garment::open_seams(garment);
  const ArrangedPanels panels = arrange_panels(garment, open, pattern, body);
  ClosedSeams closed;
  std::optional<ClosedSeams> through;
  for (const double pull : kPulls) {
    closed = close_seams(garment, open, panels, body, pull);
    if (closed.cuts > 0) continue;
    if (!closed.in_limb) return std::move(closed.x);
    if (!through) through = std::move(closed);
  }
  if (through) {
    if (!has_wider) return std::move(through->x);
    throw dress::NoRoom(fmt::format(
        "pattern: sewn round this body, a seam of panel {} would go through a limb, {:.0f} mm of "
        "it "
        "stay open",
        garment.panel_names[garment.vertex_panel[*through->in_limb]], 1e3 * through->gap));
  }
  const auto name = [&](int triangle) {
    return garment.panel_names[garment.triangle_panel[triangle]];
  };
  throw dress::NoRoom(fmt::format(
      "pattern: sewn round this body, panels {} and {} pass through each other ({} pairs of "
      "triangles)",
      name(closed.first_cut.first), name(closed.first_cut.second), closed.cuts));
}

}  // namespace loosefit::drape
