#include "loosefit/garment/surface_check.h"

#include <fmt/format.h>

#include "loosefit/base/error.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::garment {
namespace {

constexpr const char* kHint =
    "check the seams there, or use a smaller edge length if the piece is narrow";

[[noreturn]] void fail(const Garment& g, int t, const std::string& found,
                       const std::string& expected) {
  const Vec2& at = g.triangle_uv[t][0];
  throw GeometryError(InputPlace{{}, 0, "panel " + g.panel_names[g.triangle_panel[t]]},
                      fmt::format("{} near ({:.3f}, {:.3f}) m", found, at.x(), at.y()), expected,
                      kHint);
}

}  // namespace

void check_surface(const Garment& g) {
  const geometry::MeshTopology topology(g.triangles);
  for (int t = 0; t < static_cast<int>(g.triangles.size()); ++t) {
    const Triangle& c = g.triangles[t];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      fail(g, t, "a triangle whose corners are sewn together", "seams that leave it open");
    for (int i = 0; i < 3; ++i)
      for (const auto& [before, corner] : topology.sides(topology.edge(t, i)))
        if (before < t && g.triangles[before][corner] == c[i])
          fail(g, t,
               fmt::format("an edge it shares with two others, one in panel {}",
                           g.panel_names[g.triangle_panel[before]]),
               "at most two triangles at an edge");
  }
  // Around each vertex walk from one triangle to the next; all must be reached.
  std::vector<int> corners(g.vertex_count, 0), some(g.vertex_count, -1);
  for (int t = 0; t < static_cast<int>(g.triangles.size()); ++t)
    for (const int v : g.triangles[t]) ++corners[v], some[v] = t;
  // Beyond the edge of t after (0) or before (2) v; −1 at the border.
  const auto beyond = [&](int t, int v, int step) {
    const Triangle& c = g.triangles[t];
    const int i = ((c[0] == v ? 0 : c[1] == v ? 1 : 2) + step) % 3;
    for (const auto& [next, corner] : topology.sides(topology.edge(t, i)))
      if (g.triangles[next][corner] != c[i]) return next;
    return -1;
  };
  for (int v = 0; v < g.vertex_count; ++v) {
    if (some[v] < 0) continue;
    int reached = 1;
    bool closed = false;
    for (int t = beyond(some[v], v, 2); t >= 0; t = beyond(t, v, 2)) {  // counter-clockwise
      if ((closed = t == some[v])) break;
      ++reached;
    }
    if (!closed)
      for (int t = beyond(some[v], v, 0); t >= 0; t = beyond(t, v, 0)) ++reached;  // clockwise
    if (reached != corners[v])
      fail(g, some[v], "two sheets that touch in one point", "sheets joined along edges");
  }
}

}  // namespace loosefit::garment
