#include "loosefit/drape/left_to_go.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/solver/stability.h"

namespace loosefit::drape {

std::optional<LeftToGo> left_to_go(const solver::ParticleSystem& system,
                                   const std::vector<Triangle>& triangles,
                                   const std::vector<Vec3>& x) {
  const auto step = solver::step_to_rest(system, x);
  if (!step) return std::nullopt;
  LeftToGo left;
  std::vector<Vec3> there(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    there[i] += (*step)[i];
    left.move = std::max(left.move, (*step)[i].norm());
  }
  const auto now = geometry::vertex_normals(x, triangles),
             then = geometry::vertex_normals(there, triangles);
  std::vector<double> turns;
  for (std::size_t i = 0; i < now.size(); ++i)
    turns.push_back(std::atan2(now[i].cross(then[i]).norm(), now[i].dot(then[i])));
  if (turns.empty()) return left;
  const auto at = turns.begin() + static_cast<std::ptrdiff_t>(0.99 * double(turns.size() - 1));
  std::nth_element(turns.begin(), at, turns.end());
  left.turn = *at;
  return left;
}

}  // namespace loosefit::drape
