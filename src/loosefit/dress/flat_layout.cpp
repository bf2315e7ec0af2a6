#include "loosefit/dress/flat_layout.h"

#include <Eigen/SparseCholesky>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/geometry/flat_triangle.h"

namespace loosefit {

std::map<int, Vec2> lay_flat(const Garment& garment, int panel,
                             const std::map<int, Vec2>& outline) {
  std::map<int, std::set<int>> neighbours;
  std::map<std::pair<int, int>, int> edge_use;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.triangle_panel[t] != panel) continue;
    const Triangle& tri = garment.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const int a = tri[k], b = tri[(k + 1) % 3];
      neighbours[a].insert(b);
      neighbours[b].insert(a);
      ++edge_use[std::minmax(a, b)];
    }
  }
  for (const auto& [edge, uses] : edge_use)
    for (int v : {edge.first, edge.second})
      if (uses == 1 && !outline.count(v))
        throw GeometryError("panel " + garment.panel_names[panel] +
                            ": its outline cannot be placed on the body");

  std::map<int, int> unknown;
  for (const auto& [v, list] : neighbours)
    if (!outline.count(v)) unknown.emplace(v, static_cast<int>(unknown.size()));
  std::map<int, Vec2> layout;
  for (const auto& [v, list] : neighbours)
    if (outline.count(v)) layout[v] = outline.at(v);
  if (unknown.empty()) return layout;

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d rhs = Eigen::MatrixX2d::Zero(static_cast<long>(unknown.size()), 2);
  for (const auto& [v, row] : unknown) {
    entries.emplace_back(row, row, double(neighbours[v].size()));
    for (int n : neighbours[v]) {
      const auto other = unknown.find(n);
      if (other == unknown.end())
        rhs.row(row) += outline.at(n).transpose();
      else
        entries.emplace_back(row, other->second, -1.0);
    }
  }
  Eigen::SparseMatrix<double> laplacian(static_cast<long>(unknown.size()),
                                        static_cast<long>(unknown.size()));
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian);
  if (solver.info() != Eigen::Success)
    throw GeometryError("panel " + garment.panel_names[panel] + ": is not one connected piece");
  const Eigen::MatrixX2d solution = solver.solve(rhs);
  for (const auto& [v, row] : unknown) layout[v] = solution.row(row).transpose();
  return layout;
}

int count_turned_over(const Garment& garment, int panel, const std::map<int, Vec2>& layout,
                      int sign) {
  int count = 0;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.triangle_panel[t] != panel) continue;
    const Triangle& tri = garment.triangles[t];
    const Vec2 a = layout.at(tri[0]), b = layout.at(tri[1]), c = layout.at(tri[2]);
    count += sign * cross(b - a, c - a) <= 0;
  }
  return count;
}

}  // namespace loosefit
