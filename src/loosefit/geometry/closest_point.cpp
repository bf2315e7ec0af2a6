#include "loosefit/geometry/closest_point.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <compare>
#include <numeric>
#include <stdexcept>

namespace loosefit {
namespace {
constexpr int kLeafSize = 4;
constexpr int kTask = 4096;  ///< triangles of a subtree from which on a task of its own pays

double distance_squared_to_box(const Vec3& p, const Vec3& lower, const Vec3& upper) {
  return (lower - p).cwiseMax(p - upper).cwiseMax(0.0).squaredNorm();
}

/// Nearest of the three edges: all there is of a triangle without area.
Vec3 on_edges(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3* corner[3] = {&a, &b, &c};
  Vec3 best = Vec3::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Vec3 edge = *corner[next] - *corner[k];
    const double length2 = edge.squaredNorm();
    const double s = length2 > 0 ? std::clamp(edge.dot(p - *corner[k]) / length2, 0.0, 1.0) : 0.0;
    const double d2 = (*corner[k] + s * edge - p).squaredNorm();
    if (d2 >= least) continue;
    least = d2;
    best.setZero();
    best[k] = 1 - s;
    best[next] = s;
  }
  return best;
}

/// Edge low–high of a triangle, from corner `corner` on.
struct HalfEdge {
  int low, high, triangle, corner;
  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
  auto operator<=>(const HalfEdge&) const = default;
};

ClosestPoint on_triangle(const TriangleMesh& mesh, int triangle, const Vec3& p) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  ClosestPoint hit;
  hit.triangle = triangle;
  hit.barycentric = closest_barycentric(p, a, b, c);
  hit.point = hit.barycentric[0] * a + hit.barycentric[1] * b + hit.barycentric[2] * c;
  hit.distance = (p - hit.point).norm();
  return hit;
}
}  // namespace

Vec3 closest_barycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double denominator = va + vb + vc;
  constexpr double kFlat = 1e-20;  // sin² of the corner below which the face is only round-off
  if (denominator <= 0 || ab.cross(ac).squaredNorm() <= kFlat * ab.squaredNorm() * ac.squaredNorm())
    return on_edges(p, a, b, c);
  return {va / denominator, vb / denominator, vc / denominator};
}

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh, Sides sides) : mesh_(&mesh) {
  const int n = static_cast<int>(mesh.triangles.size());
  std::vector<Vec3> centroids(n);
  for (int i = 0; i < n; ++i) {
    const Triangle& t = mesh.triangles[i];
    centroids[i] = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
  }
  if (sides == Sides::told) find_pseudonormals();
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0);
  if (n == 0) return;
  nodes_.resize(nodes_of(n));
  build({0, 1, 0, n}, centroids);
}

void ClosestPointTree::find_pseudonormals() {
  const TriangleMesh& mesh = *mesh_;
  const std::size_t n = mesh.triangles.size();
  vertex_pseudonormals_.assign(mesh.vertices.size(), Vec3::Zero());
  edge_pseudonormals_.resize(n);
  // Half edges with their triangle's normal, brought together by sorting; an edge's normals are
  // added in the order of its triangles.
  std::vector<HalfEdge> half_edges(3 * n);
  std::vector<Vec3> normals(n);
  std::vector<std::array<double, 3>> angles(n);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Triangle& t = mesh.triangles[i];
      const Vec3 p[3] = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
      normals[i] = triangle_normal(p[0], p[1], p[2]);
      for (int k = 0; k < 3; ++k) {
        const Vec3 e1 = p[(k + 1) % 3] - p[k], e2 = p[(k + 2) % 3] - p[k];
        angles[i][k] = std::atan2(e1.cross(e2).norm(), e1.dot(e2));
        const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
        half_edges[3 * i + k] = {low, high, static_cast<int>(i), k};
      }
    }
  });
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k)
      vertex_pseudonormals_[mesh.triangles[i][k]] += angles[i][k] * normals[i];
  tbb::parallel_sort(half_edges.begin(), half_edges.end());
  for (std::size_t first = 0, last = 0; first < half_edges.size(); first = last) {
    Vec3 sum = Vec3::Zero();
    for (; last < half_edges.size() && half_edges[last].same_edge(half_edges[first]); ++last)
      sum += normals[half_edges[last].triangle];
    for (std::size_t e = first; e < last; ++e)
      edge_pseudonormals_[half_edges[e].triangle][half_edges[e].corner] = sum;
  }
}

/// Of a tree over n triangles.
std::size_t ClosestPointTree::nodes_of(int n) {
  return n <= kLeafSize ? 1 : 1 + nodes_of(n / 2) + nodes_of(n - n / 2);
}

void ClosestPointTree::build(const Range& r, const std::vector<Vec3>& centroids) {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  Vec3 centre_lower = lower, centre_upper = upper;
  for (int i = r.first; i < r.last; ++i) {
    for (int v : mesh_->triangles[order_[i]]) {
      lower = lower.cwiseMin(mesh_->vertices[v]);
      upper = upper.cwiseMax(mesh_->vertices[v]);
    }
    centre_lower = centre_lower.cwiseMin(centroids[order_[i]]);
    centre_upper = centre_upper.cwiseMax(centroids[order_[i]]);
  }
  Node& node = nodes_[r.node];
  node.lower = lower;
  node.upper = upper;
  const int n = r.last - r.first;
  if (n <= kLeafSize) {
    node.first = r.first;
    node.count = n;
    return;
  }
  int axis = 0;
  (centre_upper - centre_lower).maxCoeff(&axis);
  const int middle = r.first + n / 2;
  std::nth_element(order_.begin() + r.first, order_.begin() + middle, order_.begin() + r.last,
                   [&](int i, int j) {
                     return std::pair(centroids[i][axis], i) < std::pair(centroids[j][axis], j);
                   });
  node.first = r.free;
  const int below_left = r.free + 2;
  const int below_right = below_left + static_cast<int>(nodes_of(middle - r.first)) - 1;
  const Range left{r.free, below_left, r.first, middle};
  const Range right{r.free + 1, below_right, middle, r.last};
  if (n > kTask)
    tbb::parallel_invoke([&] { build(left, centroids); }, [&] { build(right, centroids); });
  else
    build(left, centroids), build(right, centroids);
}

ClosestPoint ClosestPointTree::query(const Vec3& p, double max_distance) const {
  return query(p, max_distance, nullptr);
}

ClosestPoint ClosestPointTree::query(const Vec3& p, double max_distance,
                                     const std::function<bool(int)>& accept) const {
  ClosestPoint best;
  if (nodes_.empty()) return best;
  double limit = max_distance * max_distance;
  std::array<std::pair<int, double>, 64> stack;
  int top = 0;
  stack[top++] = {0, distance_squared_to_box(p, nodes_[0].lower, nodes_[0].upper)};
  while (top > 0) {
    const auto [index, box_distance] = stack[--top];
    if (box_distance > limit) continue;
    const Node& node = nodes_[index];
    if (node.count == 0) {
      const int l = node.first, r = node.first + 1;
      const double dl = distance_squared_to_box(p, nodes_[l].lower, nodes_[l].upper);
      const double dr = distance_squared_to_box(p, nodes_[r].lower, nodes_[r].upper);
      if (dl <= dr) {  // nearer child on top of the stack
        stack[top++] = {r, dr};
        stack[top++] = {l, dl};
      } else {
        stack[top++] = {l, dl};
        stack[top++] = {r, dr};
      }
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const ClosestPoint hit = on_triangle(*mesh_, order_[i], p);
      const double d2 = (p - hit.point).squaredNorm();
      if (d2 < limit || (d2 == limit && (best.triangle < 0 || hit.triangle < best.triangle))) {
        if (accept && !accept(hit.triangle)) continue;
        limit = d2;
        best = hit;
      }
    }
  }
  return best;
}

double ClosestPointTree::signed_distance(const Vec3& p, ClosestPoint* closest, double bound) const {
  if (vertex_pseudonormals_.size() != mesh_->vertices.size())
    throw std::logic_error("this tree was made without telling sides");
  const ClosestPoint hit = query(p, bound);
  if (closest) *closest = hit;
  if (hit.triangle < 0) return std::numeric_limits<double>::infinity();
  const Triangle& t = mesh_->triangles[hit.triangle];
  const Vec3& b = hit.barycentric;
  const int zeros = (b[0] <= 0) + (b[1] <= 0) + (b[2] <= 0);
  Vec3 normal;
  if (zeros == 2) {
    int corner = 0;
    b.maxCoeff(&corner);
    normal = vertex_pseudonormals_[t[corner]];
  } else if (zeros == 1) {
    int opposite = 0;
    b.minCoeff(&opposite);
    normal = edge_pseudonormals_[hit.triangle][(opposite + 1) % 3];
  } else {
    normal = triangle_normal(mesh_->vertices[t[0]], mesh_->vertices[t[1]], mesh_->vertices[t[2]]);
  }
  return normal.dot(p - hit.point) < 0 ? -hit.distance : hit.distance;
}

ClosestPoint closest_point_brute_force(const TriangleMesh& mesh, const Vec3& p) {
  ClosestPoint best;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const ClosestPoint hit = on_triangle(mesh, i, p);
    if (hit.distance < best.distance) best = hit;
  }
  return best;
}

}  // namespace loosefit
