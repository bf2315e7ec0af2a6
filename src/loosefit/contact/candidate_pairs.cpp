#include "loosefit/contact/candidate_pairs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <cmath>

namespace loosefit {
namespace {

/// Margin in mean edge lengths: wide enough to last for many calls, narrow enough to leave out the
/// next but one neighbours in an unfolded sheet.
constexpr double kMargin = 0.25;

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

double longest(const std::vector<Vec3>& v) {
  double largest = 0;
  for (const Vec3& a : v) largest = std::max(largest, a.squaredNorm());
  return std::sqrt(largest);
}

/// Whether the boxes that the two features sweep on the way from x to y come within `reach`.
bool sweeps_meet(PairKind kind, const PairPoints& x, const PairPoints& dx, double reach) {
  const int split = kind == PairKind::point_triangle ? 1 : 2;
  Box3 a, b;
  for (int k = 0; k < 4; ++k) (k < split ? a : b).extend(x[k]).extend(Vec3(x[k] + dx[k]));
  return ((a.min() - b.max()).array() <= reach).all() &&
         ((b.min() - a.max()).array() <= reach).all();
}

/// Quick no for two triangles all of whose parts stay farther apart than `limit`.
bool far_apart(const std::array<Vec3, 6>& p, double limit) {
  const Vec3 axis = p[0] + p[1] + p[2] - p[3] - p[4] - p[5];
  const double gap = std::min({axis.dot(p[0]), axis.dot(p[1]), axis.dot(p[2])}) -
                     std::max({axis.dot(p[3]), axis.dot(p[4]), axis.dot(p[5])});
  return gap > limit * axis.norm();
}

double motion_of_triangles(const std::array<Vec3, 6>& d) {
  const Vec3 mean = (d[0] + d[1] + d[2] + d[3] + d[4] + d[5]) / 6;
  double a = 0, b = 0;
  for (int k = 0; k < 3; ++k) {
    a = std::max(a, (d[k] - mean).squaredNorm());
    b = std::max(b, (d[k + 3] - mean).squaredNorm());
  }
  return std::sqrt(a) + std::sqrt(b);
}

}  // namespace

bool CandidatePairs::covers(const std::vector<Vec3>& x, Move dx) const {
  if (start_.size() != x.size() || margin_ < 0) return false;
  // A list for a long way is long itself: when the moves have become short, make a shorter one.
  if (dx && longest_way_ > 2 * margin_ && longest(*dx) < 0.25 * longest_way_) return false;
  // The share of the way that has been gone, and that dx is about to go.
  double gone = 0, next = 0;
  if (const double length2 = dot(way_, way_); length2 > 0) {
    for (std::size_t i = 0; i < x.size(); ++i) gone += (x[i] - start_[i]).dot(way_[i]);
    gone = std::clamp(gone / length2, 0.0, 1.0);
    if (dx) next = std::clamp(dot(*dx, way_) / length2, 0.0, 1 - gone);
  }
  const double margin = (1 - 1e-9) * margin_;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double off = (x[i] - start_[i] - gone * way_[i]).norm();
    if (dx) off += ((*dx)[i] - next * way_[i]).norm();
    if (!(off <= margin)) return false;
  }
  return true;
}

void CandidatePairs::add_pairs(int a, int b, const std::vector<Vec3>& x, Move dx,
                               std::vector<FeaturePair>& found) const {
  const ContactFeatures& f = features_;
  const Triangle &ta = f.triangles[a], &tb = f.triangles[b];
  double limit = f.max_thickness + 2 * margin_;
  if (dx) {
    const auto& d = *dx;
    limit += motion_of_triangles({d[ta[0]], d[ta[1]], d[ta[2]], d[tb[0]], d[tb[1]], d[tb[2]]});
  }
  if (far_apart({x[ta[0]], x[ta[1]], x[ta[2]], x[tb[0]], x[tb[1]], x[tb[2]]}, limit)) return;
  const auto add = [&](const FeaturePair& pair) {
    const PairPoints p = pair.points(x);
    double farthest = pair.reach + 2 * margin_;
    if (dx) farthest += motion_bound(pair.kind, pair.points(*dx));
    if (separation(pair.kind, p) < farthest && pair_distance(pair.kind, p).distance < farthest)
      found.push_back(pair);
  };
  const auto add_vertices = [&](int owner, int t) {
    const Triangle& tri = f.triangles[t];
    for (int v : f.owned_vertices[owner])
      if (v >= 0 && v != tri[0] && v != tri[1] && v != tri[2])
        add({PairKind::point_triangle,
             v,
             t,
             {v, tri[0], tri[1], tri[2]},
             0.5 * (f.of_vertex[v].thickness + f.of_triangle[t].thickness)});
  };
  add_vertices(a, b);
  add_vertices(b, a);
  for (int i : f.owned_edges[a])
    for (int j : f.owned_edges[b]) {
      if (i < 0 || j < 0) continue;
      const auto &p = f.edges[std::min(i, j)], &q = f.edges[std::max(i, j)];
      if (p[0] == q[0] || p[0] == q[1] || p[1] == q[0] || p[1] == q[1]) continue;
      add({PairKind::edge_edge,
           std::min(i, j),
           std::max(i, j),
           {p[0], p[1], q[0], q[1]},
           0.5 * (f.of_edge[i].thickness + f.of_edge[j].thickness)});
    }
}

void CandidatePairs::build(const std::vector<Vec3>& x, Move dx) {
  ++builds_;
  double sum = 0;
  for (const auto& e : features_.edges) sum += (x[e[1]] - x[e[0]]).norm();
  margin_ = kMargin * sum / std::max<double>(1, static_cast<double>(features_.edges.size()));
  start_ = x;
  if (dx)
    way_ = *dx;
  else
    way_.assign(x.size(), Vec3::Zero());
  longest_way_ = longest(way_);

  const std::size_t triangles = features_.triangles.size();
  const Vec3 around = Vec3::Constant(0.5 * features_.max_thickness + margin_);
  boxes_.resize(triangles);
  tbb::parallel_for(std::size_t{0}, triangles, [&](std::size_t t) {
    Box3 box;
    for (int v : features_.triangles[t]) {
      box.extend(x[v]);
      if (dx) box.extend(Vec3(x[v] + (*dx)[v]));
    }
    boxes_[t] = Box3(box.min() - around, box.max() + around);
  });
  grid_.build(boxes_);

  constexpr std::size_t kBlock = 64;  // of triangles; fixed, so that no result depends on threads
  found_.resize((triangles + kBlock - 1) / kBlock);
  tbb::parallel_for(std::size_t{0}, found_.size(), [&](std::size_t block) {
    auto& found = found_[block];
    found.clear();
    for (std::size_t a = block * kBlock; a < std::min(triangles, (block + 1) * kBlock); ++a)
      grid_.query(boxes_[a], [&](int b) {
        if (static_cast<int>(a) < b) add_pairs(static_cast<int>(a), b, x, dx, found);
      });
  });
  candidates_.clear();
  for (const auto& found : found_)
    candidates_.insert(candidates_.end(), found.begin(), found.end());
  tbb::parallel_sort(candidates_.begin(), candidates_.end(),
                     [](const FeaturePair& a, const FeaturePair& b) { return a.key() < b.key(); });
}

const std::vector<FeaturePair>& CandidatePairs::select(const std::vector<Vec3>& x, Move dx) {
  if (!covers(x, dx)) build(x, dx);
  chosen_.resize(candidates_.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, candidates_.size(), 512), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const FeaturePair& pair = candidates_[i];
      const PairPoints p = pair.points(x);
      double limit = pair.reach;
      PairPoints d;
      if (dx) limit += motion_bound(pair.kind, d = pair.points(*dx));
      chosen_[i] = separation(pair.kind, p) < limit &&
                   pair_distance(pair.kind, p).distance < limit &&
                   (!dx || sweeps_meet(pair.kind, p, d, pair.reach));
    }
  });
  near_.clear();
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    if (chosen_[i]) near_.push_back(candidates_[i]);
  return near_;
}

const std::vector<FeaturePair>& CandidatePairs::touching(const std::vector<Vec3>& x) {
  return select(x, nullptr);
}

const std::vector<FeaturePair>& CandidatePairs::approaching(const std::vector<Vec3>& x,
                                                            const std::vector<Vec3>& dx) {
  return select(x, &dx);
}

}  // namespace loosefit
