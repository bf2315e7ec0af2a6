#include "loosefit/geometry/closest_point_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace loosefit::geometry {
namespace {

constexpr int kWidth = 8;    ///< parts of a node
constexpr int kTask = 4096;  ///< triangles from which on a task of their own pays
constexpr int kStack = 96;   ///< seven left behind on each of the eleven levels of 2³¹
/// By how much single precision may put a box too far, along one axis and in units of the largest
/// coordinate M: 2⁻²⁴ M for the rounded point and 2⁻²³ M for the difference, since the boxes are
/// rounded outwards. The squares and their sum are rounded five times, by 2⁻²⁴ of themselves each.
constexpr float kSlack = 0x1p-22f, kLess = 1 - 0x1p-20f;

/// Triangles in each part of n but the last: the least power of the width that makes no more parts
/// than that.
int part_size(int n) {
  long size = 1;
  while (size * kWidth < n) size *= kWidth;
  return static_cast<int>(size);
}
int parts_of(int n, int size) { return (n - 1) / size + 1; }

}  // namespace

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh) : mesh_(&mesh) {
  const int n = static_cast<int>(mesh.triangles.size());
  for (const Vec3& v : mesh.vertices) reach_ = std::max(reach_, v.cwiseAbs().maxCoeff());
  std::vector<Centroid> centroids(n);
  for (int i = 0; i < n; ++i) {
    const Triangle& t = mesh.triangles[i];
    centroids[i] = {(mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0, i};
  }
  leaves_.resize(n);
  nodes_.resize(nodes_of(n));
  if (n == 1) leaves_[0] = leaf(0);
  if (n > 1) build(0, centroids, 0, n);
}

/// A single triangle needs no node of its own.
int ClosestPointTree::nodes_of(int n) {
  if (n <= 1) return 0;
  const int size = part_size(n), whole = parts_of(n, size) - 1;
  return 1 + whole * nodes_of(size) + nodes_of(n - whole * size);
}

void ClosestPointTree::split(std::vector<Centroid>& centroids, int first, int last, int size) {
  const int parts = parts_of(last - first, size);
  if (parts == 1) return;
  Box3 spread;
  for (int i = first; i < last; ++i) spread.extend(centroids[i].place);
  int axis = 0;
  spread.sizes().maxCoeff(&axis);
  const int middle = first + parts / 2 * size;
  std::nth_element(centroids.begin() + first, centroids.begin() + middle, centroids.begin() + last,
                   [axis](const Centroid& a, const Centroid& b) {
                     return std::pair(a.place[axis], a.triangle) <
                            std::pair(b.place[axis], b.triangle);
                   });
  const auto below = [&] { split(centroids, first, middle, size); };
  const auto above = [&] { split(centroids, middle, last, size); };
  if (last - first > kTask)
    tbb::parallel_invoke(below, above);
  else
    below(), above();
}

ClosestPointTree::Leaf ClosestPointTree::leaf(int triangle) const {
  const Triangle& t = mesh_->triangles[triangle];
  return {mesh_->vertices[t[0]], mesh_->vertices[t[1]], mesh_->vertices[t[2]], triangle};
}

Box3 ClosestPointTree::build(int index, std::vector<Centroid>& centroids, int first, int last) {
  const int size = part_size(last - first), parts = parts_of(last - first, size);
  split(centroids, first, last, size);
  Node& node = nodes_[index];
  node.parts = parts;
  std::array<Box3, kWidth> boxes;
  const int nodes_below = nodes_of(size);
  const auto build_part = [&](int k) {
    const int from = first + k * size, to = std::min(last, from + size);
    if (to - from > 1) {
      node.content[k] = index + 1 + k * nodes_below;
      boxes[k] = build(node.content[k], centroids, from, to);
    } else {
      node.content[k] = ~from;
      const Leaf& l = leaves_[from] = leaf(centroids[from].triangle);
      for (const Vec3* corner : {&l.a, &l.b, &l.c}) boxes[k].extend(*corner);
    }
  };
  if (last - first > kTask)
    tbb::parallel_for(0, parts, build_part);
  else
    for (int k = 0; k < parts; ++k) build_part(k);
  Box3 all;
  for (int k = 0; k < parts; ++k) {
    for (int c = 0; c < 3; ++c) {
      node.lower[c][k] = round_down(boxes[k].min()[c]);
      node.upper[c][k] = round_up(boxes[k].max()[c]);
    }
    all.extend(boxes[k]);
  }
  return all;
}

ClosestPoint ClosestPointTree::query(const Vec3& p, double max_distance) const {
  return query(p, max_distance, nullptr);
}

ClosestPoint ClosestPointTree::query(const Vec3& p, double max_distance,
                                     const std::function<bool(int)>& accept) const {
  ClosestPoint best;
  if (leaves_.empty()) return best;
  double limit = max_distance * max_distance;
  const auto look_at = [&](const Leaf& l) {
    if (accept && !accept(l.triangle)) return;  // before the distance, which as a rule costs more
    const Vec3 weights = closest_barycentric(p, l.a, l.b, l.c);
    const Vec3 point = weights[0] * l.a + weights[1] * l.b + weights[2] * l.c;
    const double d2 = (p - point).squaredNorm();
    if (!(d2 < limit || (d2 == limit && (best.triangle < 0 || l.triangle < best.triangle)))) return;
    limit = d2;
    best = {l.triangle, weights, point, 0};
  };
  struct Waiting {
    float box_distance2;
    int content;
  };
  std::array<Waiting, kStack> stack;
  stack[0] = {0, nodes_.empty() ? ~0 : 0};
  const Eigen::Array3f q = p.cast<float>();
  const float slack = kSlack * round_up(std::max(reach_, p.cwiseAbs().maxCoeff()));
  for (int top = 1; top > 0;) {
    const auto [box_distance2, content] = stack[--top];
    if (box_distance2 > limit) continue;
    if (content < 0) {
      look_at(leaves_[~content]);
      continue;
    }
    const Node& node = nodes_[content];
    Node::Lanes d2 = Node::Lanes::Zero();
    for (int k = 0; k < 3; ++k)
      d2 += ((node.lower[k] - q[k]).max(q[k] - node.upper[k]) - slack).max(0.0f).square();
    // Squares that overflow are still no nearer than this.
    d2 = (kLess * d2).min(std::numeric_limits<float>::max());
    int nearest = top;
    for (int k = 0; k < node.parts; ++k) {
      if (d2[k] > limit) continue;
      if (nearest == top || d2[k] < stack[nearest].box_distance2) nearest = top;
      stack[top++] = {d2[k], node.content[k]};
    }
    if (nearest < top) std::swap(stack[nearest], stack[top - 1]);  // it comes first
  }
  if (best.triangle >= 0) best.distance = std::sqrt(limit);
  return best;
}

std::vector<int> ClosestPointTree::overlapping(const Box3& box) const {
  std::vector<int> found;
  const auto look_at = [&](const Leaf& l) {
    Box3 own;
    for (const Vec3* corner : {&l.a, &l.b, &l.c}) own.extend(*corner);
    if (own.intersects(box)) found.push_back(l.triangle);
  };
  if (nodes_.empty()) {
    for (const Leaf& l : leaves_) look_at(l);
    return found;
  }
  std::array<float, 3> low, high;
  for (int k = 0; k < 3; ++k) {
    low[k] = round_down(box.min()[k]);
    high[k] = round_up(box.max()[k]);
  }
  std::array<int, kStack> stack{0};
  for (int top = 1; top > 0;) {
    const Node& node = nodes_[stack[--top]];
    Eigen::Array<bool, kWidth, 1> meets = Eigen::Array<bool, kWidth, 1>::Constant(true);
    for (int k = 0; k < 3; ++k)
      meets = meets && node.lower[k] <= high[k] && node.upper[k] >= low[k];
    for (int k = 0; k < node.parts; ++k) {
      if (!meets[k]) continue;
      if (node.content[k] < 0)
        look_at(leaves_[~node.content[k]]);
      else
        stack[top++] = node.content[k];
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

double ClosestPointTree::signed_distance(const Vec3& p, ClosestPoint* closest, double bound) const {
  const ClosestPoint hit = query(p, bound);
  if (closest) *closest = hit;
  if (hit.triangle < 0) return std::numeric_limits<double>::infinity();
  const Pseudonormals& sides = sides_.get([&] { return Pseudonormals(*mesh_); });
  return sides.at(*mesh_, hit).dot(p - hit.point) < 0 ? -hit.distance : hit.distance;
}

}  // namespace loosefit::geometry
