#include "loosefit/garment/surface_check.h"

#include <fmt/format.h>

#include <map>

#include "loosefit/base/error.h"

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
  std::map<std::pair<int, int>, int> directed;  // edge → triangle
  for (int t = 0; t < static_cast<int>(g.triangles.size()); ++t) {
    const Triangle& c = g.triangles[t];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      fail(g, t, "a triangle whose corners are sewn together", "seams that leave it open");
    for (int i = 0; i < 3; ++i)
      if (const auto [it, added] = directed.try_emplace({c[i], c[(i + 1) % 3]}, t); !added)
        fail(g, t,
             fmt::format("an edge it shares with two others, one in panel {}",
                         g.panel_names[g.triangle_panel[it->second]]),
             "at most two triangles at an edge");
  }
  // Around each vertex walk from one triangle to the next; all must be reached.
  std::vector<int> corners(g.vertex_count, 0), some(g.vertex_count, -1);
  for (int t = 0; t < static_cast<int>(g.triangles.size()); ++t)
    for (const int v : g.triangles[t]) ++corners[v], some[v] = t;
  const auto other = [&](int t, int v, int step) {  // corner after (1) or before (2) v in t
    const Triangle& c = g.triangles[t];
    const int i = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    return c[(i + step) % 3];
  };
  for (int v = 0; v < g.vertex_count; ++v) {
    if (some[v] < 0) continue;
    int reached = 1;
    bool closed = false;
    for (int t = some[v];;) {  // counter-clockwise
      const auto next = directed.find({v, other(t, v, 2)});
      if (next == directed.end()) break;
      t = next->second;
      if ((closed = t == some[v])) break;
      ++reached;
    }
    if (!closed)
      for (int t = some[v];;) {  // clockwise
        const auto next = directed.find({other(t, v, 1), v});
        if (next == directed.end()) break;
        t = next->second;
        ++reached;
      }
    if (reached != corners[v])
      fail(g, some[v], "two sheets that touch in one point", "sheets joined along edges");
  }
}

}  // namespace loosefit::garment
