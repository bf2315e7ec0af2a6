#include "loosefit/contact/contact_lattice.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/check.h"

namespace loosefit::contact {
namespace {

/// Places of a cell nearer than this to each other are one [intervals of the lattice].
constexpr double kSamePlace = 0.2;

/// Corners of the cells as (i, j), weights in n-ths: pointing up, then down, row by row.
std::vector<std::array<std::array<int, 2>, 3>> cell_nodes(int n) {
  std::vector<std::array<std::array<int, 2>, 3>> cells;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      cells.push_back({{{i, j}, {i + 1, j}, {i, j + 1}}});
      if (i + j + 1 < n) cells.push_back({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
    }
  return cells;
}

}  // namespace

ContactLattice::ContactLattice(std::vector<Triangle> triangles, std::vector<double> area,
                               int first_vertex, int vertices, int intervals)
    : intervals_(intervals) {
  LOOSEFIT_ASSERT(intervals >= 2 && intervals % 2 == 0 && triangles.size() == area.size());
  geometry::MeshTopology topology(triangles);
  first_inner_.assign(triangles.size(), -1);
  first_on_.assign(topology.edge_count(), -1);
  mesh_ = std::make_shared<const Mesh>(
      Mesh{std::move(triangles), std::move(area), std::move(topology), first_vertex, vertices});
}

std::vector<ContactPoint> ContactLattice::first_points(double offset) const {
  std::vector<Triangle> own = mesh_->triangles;
  for (Triangle& t : own)
    for (int& v : t) v -= mesh_->first_vertex;
  std::vector<ContactPoint> points = contact_points(own, mesh_->area, mesh_->vertices, offset);
  for (ContactPoint& p : points)
    for (int k = 0; k < p.count; ++k) p.particle[k] += mesh_->first_vertex;
  return points;
}

int ContactLattice::node(int triangle, int i, int j) const {
  const int n = intervals_;
  const std::array<int, 3> weight = {i, j, n - i - j};
  const Triangle& corner = mesh_->triangles[triangle];
  for (int c = 0; c < 3; ++c)
    if (weight[c] == n) return corner[c] - mesh_->first_vertex;
  for (int c = 0; c < 3; ++c)
    if (weight[(c + 2) % 3] == 0) {
      const int edge = mesh_->topology.edge(triangle, c);
      const int of_low = corner[c] < corner[(c + 1) % 3] ? weight[c] : weight[(c + 1) % 3];
      if (2 * of_low == n) return midpoint(edge);
      return first_on_[edge] + of_low - 1 - (2 * of_low > n);
    }
  // Rows of n − 1 − i inner nodes, i from 1 on.
  const int before = (i - 1) * (n - 1) - (i - 1) * i / 2;
  return first_inner_[triangle] + before + j - 1;
}

void ContactLattice::refine(int triangle, std::vector<ContactPoint>& points) {
  if (is_refined(triangle)) return;
  const int n = intervals_;
  const double area = mesh_->area[triangle], cell = area / (n * n);
  const Triangle& corner = mesh_->triangles[triangle];
  const double offset = points[corner[0] - mesh_->first_vertex].offset;
  for (int c = 0; c < 3; ++c) {
    const int edge = mesh_->topology.edge(triangle, c);
    points[corner[c] - mesh_->first_vertex].area -= area / 12 - cell / 3;
    points[midpoint(edge)].area -= area / 4 - cell;
    const bool is_new = first_on_[edge] < 0;
    if (is_new) first_on_[edge] = static_cast<int>(points.size());
    const auto& [low, high] = mesh_->topology.edges()[edge];
    for (int s = 1, k = first_on_[edge]; s < n; ++s) {
      if (2 * s == n) continue;
      if (is_new) {
        ContactPoint p;
        p.particle = {low, high, 0};
        p.weight = {double(s) / n, 1 - double(s) / n, 0};
        p.count = 2;
        p.offset = offset;
        points.push_back(p);
      }
      points[k++].area += cell;
    }
  }
  first_inner_[triangle] = static_cast<int>(points.size());
  for (int i = 1; i < n; ++i)
    for (int j = 1; i + j < n; ++j) {
      ContactPoint p;
      p.particle = corner;
      p.weight = {double(i) / n, double(j) / n, double(n - i - j) / n};
      p.count = 3;
      p.area = 2 * cell;
      p.offset = offset;
      points.push_back(p);
    }
}

std::vector<std::array<ContactLattice::Weights, 3>> ContactLattice::cells(int n) {
  std::vector<std::array<Weights, 3>> cells;
  for (const auto& nodes : cell_nodes(n)) {
    cells.emplace_back();
    for (int c = 0; c < 3; ++c) {
      const auto [i, j] = nodes[c];
      cells.back()[c] = {double(i) / n, double(j) / n, double(n - i - j) / n};
    }
  }
  return cells;
}

void ContactLattice::add_nearest(int triangle, int cell, const Weights& at, bool beside,
                                 std::vector<ContactPoint>& points) {
  LOOSEFIT_ASSERT(is_refined(triangle));
  std::vector<int>& own = nearest_[{triangle, cell}];
  // The same corner of the skin keeps its point.
  for (int p : own) {
    double apart = 0;
    for (int k = 0; k < 3; ++k) apart = std::max(apart, std::abs(points[p].weight[k] - at[k]));
    if (apart < kSamePlace / intervals_) {
      points[p].weight = at;
      return;
    }
  }
  if (own.empty() || beside) {
    ContactPoint p;
    p.particle = mesh_->triangles[triangle];
    p.count = 3;
    p.offset = points[p.particle[0] - mesh_->first_vertex].offset;
    if (own.empty()) {
      const double area = mesh_->area[triangle] / (intervals_ * intervals_);
      const auto corners = cell_nodes(intervals_)[cell];
      for (const auto& [i, j] : corners) points[node(triangle, i, j)].area -= area / 4;
      p.area = 0.75 * area;
    } else {
      p.area = points[own.back()].area /= 2;
    }
    own.push_back(static_cast<int>(points.size()));
    points.push_back(p);
  }
  points[own.back()].weight = at;
}

std::vector<int> ContactLattice::points_of(int triangle) const {
  std::vector<int> indices;
  const int n = is_refined(triangle) ? intervals_ : 2;
  const Triangle& corner = mesh_->triangles[triangle];
  for (int v : corner) indices.push_back(v - mesh_->first_vertex);
  for (int c = 0; c < 3; ++c) indices.push_back(midpoint(mesh_->topology.edge(triangle, c)));
  if (n == 2) return indices;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const int zeros = (i == 0) + (j == 0) + (i + j == n);
      if (zeros == 2 || (zeros == 1 && (2 * i == n || 2 * j == n))) continue;
      indices.push_back(node(triangle, i, j));
    }
  for (auto p = nearest_.lower_bound({triangle, 0});
       p != nearest_.end() && p->first.first == triangle; ++p)
    indices.insert(indices.end(), p->second.begin(), p->second.end());
  return indices;
}

}  // namespace loosefit::contact
