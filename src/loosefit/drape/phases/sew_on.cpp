#include "loosefit/drape/phases/sew_on.h"

#include <fmt/format.h>

#include "loosefit/drape/arrange_panels.h"
#include "loosefit/drape/phases/close_seams.h"
#include "loosefit/dress/no_room.h"

#include <cstdlib>
#include <cstdio>

namespace loosefit::drape {

std::vector<Vec3> sew_on(const garment::Garment& garment, const pattern::Pattern& pattern,
                         const body::PosedBody& body) {
  const garment::OpenSeams open = garment::open_seams(garment);
  const ArrangedPanels panels = arrange_panels(garment, open, pattern, body);
  ClosedSeams closed = close_seams(garment, open, panels.x, panels.outside, body);
  if (const char* d = std::getenv("SEWDBG")) {
    auto dump = [&](const std::string& f, const std::vector<Vec3>& x, const std::vector<Triangle>& tr) {
      FILE* o = std::fopen((std::string(d) + f).c_str(), "w");
      for (auto& p : x) std::fprintf(o, "v %g %g %g\n", p[0], p[1], p[2]);
      for (auto& t : tr) std::fprintf(o, "f %d %d %d\n", t[0]+1, t[1]+1, t[2]+1);
      std::fclose(o);
    };
    dump("_open.obj", panels.x, open.garment.triangles);
    dump("_closed.obj", closed.x, garment.triangles);
    dump("_body.obj", body->surface.vertices, body->surface.triangles);
    fmt::print(stderr, "closing: {} iterations, gap {:.4f}, cuts {} (before smoothing {})\n", closed.iterations, closed.gap, closed.cuts, closed.first_cuts);
  }
  if (closed.cuts > 0)
    throw dress::NoRoom(fmt::format(
        "pattern: sewn round this body, {} pairs of triangles of panels {} and {} cut each other",
        closed.cuts, garment.panel_names[garment.triangle_panel[closed.first_cut.first]],
        garment.panel_names[garment.triangle_panel[closed.first_cut.second]]));
  return std::move(closed.x);
}

}  // namespace loosefit::drape
