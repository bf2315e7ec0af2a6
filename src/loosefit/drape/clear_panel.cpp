#include "loosefit/drape/clear_panel.h"

#include <algorithm>
#include <limits>

#include "loosefit/geometry/box.h"

namespace loosefit::drape {

void clear_panel(const garment::OpenSeams& open, int panel, const Mat3& frame, double clear,
                 const body::PosedBody& body, const std::function<bool(std::size_t)>& counts,
                 std::vector<Vec3>& x) {
  const garment::Garment& g = open.garment;
  const Vec3 u = frame.col(0), w = frame.col(1), n = frame.col(2);
  Eigen::AlignedBox2d box;
  double plane = 0;
  for (int v = 0; v < g.vertex_count; ++v)
    if (g.vertex_panel[v] == panel) box.extend(Vec2(x[v].dot(u), x[v].dot(w))), plane = x[v].dot(n);
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < body->surface.vertices.size(); ++i) {
    if (!counts(i)) continue;
    const Vec3& p = body->surface.vertices[i];
    if (box.contains(Vec2(p.dot(u), p.dot(w)))) farthest = std::max(farthest, p.dot(n));
  }
  const double out = farthest + clear - plane;
  if (!(out > 0)) return;
  for (int v = 0; v < g.vertex_count; ++v)
    if (g.vertex_panel[v] == panel) x[v] += out * n;
}

}  // namespace loosefit::drape
