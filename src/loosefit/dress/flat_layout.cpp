#include "loosefit/dress/flat_layout.h"

#include <Eigen/SparseCholesky>

#include "loosefit/base/error.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::dress {

std::map<int, Vec2> lay_flat(const garment::Garment& garment, int panel,
                             const std::map<int, Vec2>& outline) {
  std::vector<Triangle> piece;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    if (garment.triangle_panel[t] == panel) piece.push_back(garment.triangles[t]);
  const geometry::MeshTopology topology(std::move(piece));
  for (int e = 0; e < topology.edge_count(); ++e)
    for (int v : topology.edges()[e])
      if (topology.sides(e).size() == 1 && !outline.count(v))
        throw GeometryError("panel " + garment.panel_names[panel] +
                            ": its outline cannot be placed on the body");

  const std::vector<std::vector<int>> neighbours = topology.vertex_neighbours();
  std::map<int, int> unknown;
  std::map<int, Vec2> layout;
  for (int v = 0; v < static_cast<int>(neighbours.size()); ++v) {
    if (neighbours[v].empty()) continue;  // of another panel
    if (outline.count(v))
      layout[v] = outline.at(v);
    else
      unknown.emplace(v, static_cast<int>(unknown.size()));
  }
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

int count_turned_over(const garment::Garment& garment, int panel, const std::map<int, Vec2>& layout,
                      int sign) {
  int count = 0;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.triangle_panel[t] != panel) continue;
    const Triangle& tri = garment.triangles[t];
    const Vec2 a = layout.at(tri[0]), b = layout.at(tri[1]), c = layout.at(tri[2]);
    count += sign * geometry::cross(b - a, c - a) <= 0;
  }
  return count;
}

}  // namespace loosefit::dress
