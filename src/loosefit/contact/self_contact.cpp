#include "loosefit/contact/self_contact.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>

#include "loosefit/geometry/box_pairs.h"

namespace loosefit {
namespace {

std::array<Vec3, 4> gather(const std::array<int, 4>& p, const VectorField& x) {
  return {x[p[0]], x[p[1]], x[p[2]], x[p[3]]};
}

/// Mollifier of nearly parallel edges and its slope: r (2 − r) for r = c/threshold < 1, else 1.
struct Mollifier {
  double value = 1, slope = 0;
};
Mollifier mollify(double c, double threshold) {
  if (c >= threshold) return {};
  const double r = c / threshold;
  return {r * (2 - r), (2 - 2 * r) / threshold};
}

/// c = |e₁ × e₂|² and its gradient with respect to the four edge ends.
double parallel_measure(const std::array<Vec3, 4>& x, std::array<Vec3, 4>* gradient) {
  const Vec3 u = x[1] - x[0], v = x[3] - x[2];
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  if (gradient) {
    const Vec3 du = 2 * (vv * u - uv * v), dv = 2 * (uu * v - uv * u);
    *gradient = {-du, du, -dv, dv};
  }
  return std::max(0.0, uu * vv - uv * uv);
}

}  // namespace

SelfContact::SelfContact(const std::vector<Triangle>& triangles,
                         const std::vector<double>& triangle_area, int particles,
                         const Options& options)
    : triangles_(triangles),
      vertex_area_(particles, 0.0),
      options_(options),
      friction_(options.friction, options.stick_reach) {
  std::map<std::pair<int, int>, double> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      vertex_area_[triangles[t][k]] += triangle_area[t] / 3;
      edges[std::minmax(triangles[t][k], triangles[t][(k + 1) % 3])] += triangle_area[t] / 3;
    }
  for (const auto& [edge, area] : edges) {
    edges_.push_back({edge.first, edge.second});
    edge_area_.push_back(area);
  }
  for (int v = 0; v < particles; ++v)
    if (vertex_area_[v] > 0) used_vertices_.push_back(v);
}

void SelfContact::find_pairs(const VectorField& x, const VectorField* dx) {
  const double reach = options_.thickness;
  const Vec3 margin = Vec3::Constant(0.5 * reach);
  const auto box_of = [&](auto first, auto last) {
    Box3 box;
    for (auto it = first; it != last; ++it) {
      box.extend(x[*it]);
      if (dx) box.extend(x[*it] + (*dx)[*it]);
    }
    return Box3(box.min() - margin, box.max() + margin);
  };
  std::vector<Box3> vertex_box, triangle_box, edge_box;
  for (int v : used_vertices_) vertex_box.push_back(box_of(&v, &v + 1));
  for (const Triangle& t : triangles_) triangle_box.push_back(box_of(t.begin(), t.end()));
  for (const auto& e : edges_) edge_box.push_back(box_of(e.begin(), e.end()));

  pairs_.clear();
  const auto keep = [&](Pair& pair) {
    // Boxes are loose; a static search can discard by the true distance at once.
    if (!dx) {
      const auto p = gather(pair.particle, x);
      const double d = pair.kind == PairKind::point_triangle
                           ? point_triangle_distance(p[0], p[1], p[2], p[3]).distance
                           : edge_edge_distance(p[0], p[1], p[2], p[3]).distance;
      if (d >= reach) return;
    }
    pairs_.push_back(pair);
  };
  for (const auto& [i, t] : overlapping_boxes(vertex_box, triangle_box)) {
    const int v = used_vertices_[i];
    const Triangle& tri = triangles_[t];
    if (v == tri[0] || v == tri[1] || v == tri[2]) continue;
    Pair pair{PairKind::point_triangle, v, t, {v, tri[0], tri[1], tri[2]}, vertex_area_[v], 0};
    keep(pair);
  }
  for (const auto& [i, j] : overlapping_boxes(edge_box)) {
    const auto &a = edges_[i], &b = edges_[j];
    if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) continue;
    const double la = (x[a[1]] - x[a[0]]).squaredNorm(), lb = (x[b[1]] - x[b[0]]).squaredNorm();
    Pair pair{
        PairKind::edge_edge, i, j, {a[0], a[1], b[0], b[1]}, 0.5 * (edge_area_[i] + edge_area_[j]),
        1e-3 * la * lb};
    keep(pair);
  }
}

double SelfContact::begin_search(const VectorField& x, const VectorField& dx) {
  find_pairs(x, &dx);
  ++searches_;
  std::vector<double> share(pairs_.size(), 1.0);
  tbb::parallel_for(std::size_t{0}, pairs_.size(), [&](std::size_t i) {
    share[i] = time_of_impact(pairs_[i].kind, gather(pairs_[i].particle, x),
                              gather(pairs_[i].particle, dx));
  });
  double largest = 1.0;
  for (double s : share) largest = std::min(largest, s);
  return largest;
}

SelfContact::Term SelfContact::evaluate(const Pair& pair, const VectorField& x) const {
  Term term;
  const auto p = gather(pair.particle, x);
  term.d = pair.kind == PairKind::point_triangle ? point_triangle_distance(p[0], p[1], p[2], p[3])
                                                 : edge_edge_distance(p[0], p[1], p[2], p[3]);
  const double reach = options_.thickness, s = term.d.distance / reach;
  if (s >= 1) return term;
  term.active = true;
  if (s <= 0) {
    term.energy = std::numeric_limits<double>::infinity();
    return term;
  }
  const double log_s = std::log(s), scale = options_.pressure * pair.area;
  term.energy = -scale * reach * (s - 1) * (s - 1) * log_s;
  term.slope = scale * (s - 1) * (-2 * log_s - (s - 1) / s);
  term.curvature = scale / reach * (-2 * log_s - 4 * (s - 1) / s + (s - 1) * (s - 1) / (s * s));
  return term;
}

double SelfContact::mollifier(const Pair& pair, const VectorField& x) const {
  if (pair.kind == PairKind::point_triangle) return 1;
  return mollify(parallel_measure(gather(pair.particle, x), nullptr), pair.parallel_threshold)
      .value;
}

void SelfContact::begin_step(const VectorField& x, double) {
  find_pairs(x, nullptr);
  if (friction_.coefficient() <= 0) return;
  std::vector<FrictionContact> contacts;
  for (const Pair& pair : pairs_) {
    const Term term = evaluate(pair, x);
    if (!term.active || !(term.d.distance > 0)) continue;
    FrictionContact c;
    const std::uint64_t kind = pair.kind == PairKind::edge_edge ? 1 : 0;
    c.key = (kind << 62) | (static_cast<std::uint64_t>(pair.first) << 31) |
            static_cast<std::uint64_t>(pair.second);
    c.particle = pair.particle;
    c.weight = term.d.weight;
    c.count = 4;
    c.normal = term.d.normal;
    c.normal_force = -term.slope * mollifier(pair, x);
    contacts.push_back(c);
  }
  std::sort(contacts.begin(), contacts.end(),
            [](const FrictionContact& a, const FrictionContact& b) { return a.key < b.key; });
  friction_.restart(std::move(contacts), x);
}

double SelfContact::value(const VectorField& x) const {
  double energy = 0;
  for (const Pair& pair : pairs_) {
    const Term term = evaluate(pair, x);
    if (!term.active) continue;
    energy += term.d.distance > 0 ? mollifier(pair, x) * term.energy : term.energy;
  }
  return energy + friction_.value(x);
}

void SelfContact::add_gradient(const VectorField& x, VectorField& g) const {
  for (const Pair& pair : pairs_) {
    const Term term = evaluate(pair, x);
    if (!term.active) continue;
    Mollifier m;
    if (pair.kind == PairKind::edge_edge) {
      std::array<Vec3, 4> dc;
      m = mollify(parallel_measure(gather(pair.particle, x), &dc), pair.parallel_threshold);
      if (m.slope > 0)
        for (int k = 0; k < 4; ++k) g[pair.particle[k]] += term.energy * m.slope * dc[k];
    }
    const Vec3 force = m.value * term.slope * term.d.normal;
    for (int k = 0; k < 4; ++k) g[pair.particle[k]] += term.d.weight[k] * force;
  }
  friction_.add_gradient(x, g);
}

void SelfContact::add_pattern(const VectorField& x, BlockPattern& pattern) const {
  for (const Pair& pair : pairs_)
    if (evaluate(pair, x).active) pattern.add_clique(pair.particle);
  friction_.add_pattern(pattern);
}

void SelfContact::add_hessian(const VectorField& x, BlockMatrix& h, HessianKind) const {
  // Only the part along the normal, which is definite: the rotation of the normal carries the
  // contact force over a feature size and is small against the membrane's stiffness.
  for (const Pair& pair : pairs_) {
    const Term term = evaluate(pair, x);
    if (!term.active) continue;
    const Mat3 block =
        mollifier(pair, x) * term.curvature * term.d.normal * term.d.normal.transpose();
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b)
        h.add(pair.particle[a], pair.particle[b], term.d.weight[a] * term.d.weight[b] * block);
  }
  friction_.add_hessian(x, h);
}

int SelfContact::active(const VectorField& x) const {
  int count = 0;
  for (const Pair& pair : pairs_) count += evaluate(pair, x).active;
  return count;
}

}  // namespace loosefit
