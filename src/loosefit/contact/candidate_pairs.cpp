#include "loosefit/contact/candidate_pairs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <cmath>

#include "loosefit/particles/vector_sums.h"

namespace loosefit {
namespace {

/// Margin in mean edge lengths: wide enough to last for many calls, narrow enough to leave out the
/// next but one neighbours in an unfolded sheet.
constexpr double kMargin = 0.25;

double longest(const std::vector<Vec3>& v) {
  double largest = 0;
  for (const Vec3& a : v) largest = std::max(largest, a.squaredNorm());
  return std::sqrt(largest);
}

/// Whether along one of thirteen fixed axes the features are farther apart than `limit`, on the
/// same side, at both ends of the move. In between they are so too: the gap of the projections of
/// two moving hulls is a concave function of time.
bool kept_apart(PairKind kind, const PairPoints& x, const PairPoints& dx, double limit) {
  constexpr double k2 = 0.70710678118654752, k3 = 0.57735026918962576;
  static const std::array<Vec3, 13> kAxes{
      Vec3(1, 0, 0),     Vec3(0, 1, 0),     Vec3(0, 0, 1),    Vec3(k2, k2, 0),  Vec3(k2, -k2, 0),
      Vec3(k2, 0, k2),   Vec3(k2, 0, -k2),  Vec3(0, k2, k2),  Vec3(0, k2, -k2), Vec3(k3, k3, k3),
      Vec3(k3, k3, -k3), Vec3(k3, -k3, k3), Vec3(-k3, k3, k3)};
  const int split = kind == PairKind::point_triangle ? 1 : 2;
  const auto gaps = [&](const Vec3& axis, const PairPoints& p) {
    double a0 = axis.dot(p[0]), a1 = a0, b0 = axis.dot(p[3]), b1 = b0;
    for (int k = 1; k < 3; ++k) {
      const double at = axis.dot(p[k]);
      double &low = k < split ? a0 : b0, &high = k < split ? a1 : b1;
      low = std::min(low, at);
      high = std::max(high, at);
    }
    return std::array<double, 2>{a0 - b1, b0 - a1};
  };
  PairPoints y;
  for (int k = 0; k < 4; ++k) y[k] = x[k] + dx[k];
  for (const Vec3& axis : kAxes) {
    const auto before = gaps(axis, x);
    if (!(before[0] > limit) && !(before[1] > limit)) continue;
    const auto after = gaps(axis, y);
    if ((before[0] > limit && after[0] > limit) || (before[1] > limit && after[1] > limit))
      return true;
  }
  return false;
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

bool CandidatePairs::covers(const List& list, const std::vector<Vec3>& x, Move dx) {
  if (list.start.size() != x.size() || list.margin < 0) return false;
  // A list for a long way is long itself: when the moves have become short, make a shorter one.
  if (dx && list.longest_way > 2 * list.margin && longest(*dx) < 0.25 * list.longest_way)
    return false;
  // The share of the way that has been gone, and that dx is about to go.
  double gone = 0, next = 0;
  if (const double length2 = dot(list.way, list.way); length2 > 0) {
    for (std::size_t i = 0; i < x.size(); ++i) gone += (x[i] - list.start[i]).dot(list.way[i]);
    gone = std::clamp(gone / length2, 0.0, 1.0);
    if (dx) next = std::clamp(dot(*dx, list.way) / length2, 0.0, 1 - gone);
  }
  const double margin = (1 - 1e-9) * list.margin;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double off = (x[i] - list.start[i] - gone * list.way[i]).norm();
    if (dx) off += ((*dx)[i] - next * list.way[i]).norm();
    if (!(off <= margin)) return false;
  }
  return true;
}

/// Whether the pair is to be returned, were its reach longer by `extra`. motion: an upper bound of
/// motion_bound, to save work.
bool CandidatePairs::is_near(const FeaturePair& pair, const std::vector<Vec3>& x, Move dx,
                             double motion, double extra, double* distance) {
  const PairPoints p = pair.points(x);
  const double reach = pair.reach + extra, gap = separation(pair.kind, p);
  if (gap >= reach + motion) return false;
  double limit = reach;
  if (dx) {
    const PairPoints d = pair.points(*dx);
    limit += motion_bound(pair.kind, d);
    if (gap >= limit || kept_apart(pair.kind, p, d, reach)) return false;
  }
  *distance = pair_distance(pair.kind, p).distance;
  return *distance < limit;
}

void CandidatePairs::add_pairs(int a, int b, double margin, const std::vector<Vec3>& x, Move dx,
                               std::vector<Candidate>& found) const {
  const ContactFeatures& f = features_;
  const Triangle &ta = f.triangles[a], &tb = f.triangles[b];
  bool neighbours = false;  // these are never apart
  for (int v : ta) neighbours |= v == tb[0] || v == tb[1] || v == tb[2];
  const std::array<Vec3, 6> corners{x[ta[0]], x[ta[1]], x[ta[2]], x[tb[0]], x[tb[1]], x[tb[2]]};
  const double limit = f.max_thickness + 2 * margin, motion = travel_[a] + travel_[b];
  if (!neighbours && far_apart(corners, limit + motion)) return;
  if (!neighbours && motion > margin) {
    const auto& d = *dx;
    if (far_apart(corners, limit + motion_of_triangles({d[ta[0]], d[ta[1]], d[ta[2]], d[tb[0]],
                                                        d[tb[1]], d[tb[2]]})))
      return;
  }
  const auto add = [&](const FeaturePair& pair) {
    Candidate candidate{pair};
    if (is_near(pair, x, dx, motion, 2 * margin, &candidate.spare)) {
      candidate.spare -= pair.reach;
      found.push_back(candidate);
    }
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

/// Fills found_ with the pairs of all boxes that meet. Parts of a fixed size, so that no result
/// depends on threads.
void CandidatePairs::find_all(const std::vector<Vec3>& x, Move dx) {
  constexpr std::size_t kPart = 16;  // of cells
  const std::size_t cells = grid_.busy_cells();
  found_.resize((cells + kPart - 1) / kPart);
  tbb::parallel_for(std::size_t{0}, found_.size(), [&](std::size_t part) {
    found_[part].clear();
    grid_.visit_pairs(part * kPart, std::min(cells, (part + 1) * kPart),
                      [&](int a, int b) { add_pairs(a, b, whole_.margin, x, dx, found_[part]); });
  });
}

/// The same of boxes one of which is of a triangle in the focus.
void CandidatePairs::find_in_focus(const std::vector<Vec3>& x, Move dx) {
  constexpr std::size_t kPart = 64;  // of triangles
  const std::size_t triangles = focused_triangles_.size();
  found_.resize((triangles + kPart - 1) / kPart);
  tbb::parallel_for(std::size_t{0}, found_.size(), [&](std::size_t part) {
    found_[part].clear();
    for (std::size_t k = part * kPart; k < std::min(triangles, (part + 1) * kPart); ++k) {
      const int a = focused_triangles_[k];
      grid_.query(boxes_[a], [&](int b) {
        if (b > a || (b < a && !is_focused_[b]))
          add_pairs(std::min(a, b), std::max(a, b), focused_.margin, x, dx, found_[part]);
      });
    }
  });
}

void CandidatePairs::build(const std::vector<Vec3>& x, Move dx) {
  ++builds_;
  List& to = list();
  double sum = 0;
  for (const auto& e : features_.edges) sum += (x[e[1]] - x[e[0]]).norm();
  to.start = x;
  if (dx)
    to.way = *dx;
  else
    to.way.assign(x.size(), Vec3::Zero());
  to.longest_way = longest(to.way);
  to.margin = kMargin * sum / std::max<double>(1, static_cast<double>(features_.edges.size()));
  // After a long way the next one will not be like it, whatever the margin. In a focus the list is
  // short anyway.
  if (to.longest_way > 2 * to.margin && !focus_) to.margin *= 0.1;

  const std::size_t triangles = features_.triangles.size();
  const Vec3 around = Vec3::Constant(0.5 * features_.max_thickness + to.margin);
  boxes_.resize(triangles);
  travel_.assign(triangles, 0.0);
  tbb::parallel_for(std::size_t{0}, triangles, [&](std::size_t t) {
    Box3 box;
    for (int v : features_.triangles[t]) {
      box.extend(x[v]);
      if (!dx) continue;
      box.extend(Vec3(x[v] + (*dx)[v]));
      travel_[t] = std::max(travel_[t], (*dx)[v].norm());
    }
    boxes_[t] = Box3(box.min() - around, box.max() + around);
  });
  grid_.build(boxes_);

  if (focus_)
    find_in_focus(x, dx);
  else
    find_all(x, dx);
  unsorted_.clear();
  for (const auto& found : found_) unsorted_.insert(unsorted_.end(), found.begin(), found.end());
  order_.resize(unsorted_.size());
  for (std::size_t i = 0; i < unsorted_.size(); ++i)
    order_[i] = {unsorted_[i].key(), static_cast<int>(i)};
  tbb::parallel_sort(order_.begin(), order_.end());
  to.candidates.clear();
  for (const auto& [key, i] : order_)
    if (!focus_ || focus_->touches(unsorted_[i].particle, 4)) to.candidates.push_back(unsorted_[i]);
  to.spare.resize(to.candidates.size());
  for (std::size_t i = 0; i < to.candidates.size(); ++i)
    to.spare[i] = std::nextafter(static_cast<float>(to.candidates[i].spare), -1e30f);
}

void CandidatePairs::set_focus(const Focus* focus) {
  focus_ = focus;
  focused_.margin = -1;
  if (!focus) return;
  is_focused_.assign(features_.triangles.size(), 0);
  focused_triangles_.clear();
  for (std::size_t t = 0; t < is_focused_.size(); ++t) {
    for (int v : features_.triangles[t]) is_focused_[t] |= focus->inside[v];
    if (is_focused_[t]) focused_triangles_.push_back(static_cast<int>(t));
  }
}

/// Fills motion_ and returns its largest number.
double CandidatePairs::measure_motion(const std::vector<Vec3>& x, Move dx) {
  motion_.resize(x.size());
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    motion_[i] = (x[i] - list().start[i]).norm() + (dx ? (*dx)[i].norm() : 0.0);
    largest = std::max(largest, motion_[i]);
  }
  return largest;
}

const std::vector<FeaturePair>& CandidatePairs::select(const std::vector<Vec3>& x, Move dx) {
  if (!covers(list(), x, dx)) build(x, dx);
  const auto& [candidates, spare, start, way, margin, longest_way] = list();
  const double largest = measure_motion(x, dx);
  chosen_.resize(candidates.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, candidates.size(), 512), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      chosen_[i] = 0;
      // What has moved too little since the list was made needs no new distance.
      if (spare[i] >= 2 * largest) continue;
      const FeaturePair& pair = candidates[i];
      const auto& p = pair.particle;
      const bool point = pair.kind == PairKind::point_triangle;
      const double m0 = motion_[p[0]], m1 = motion_[p[1]], m2 = motion_[p[2]], m3 = motion_[p[3]];
      if (spare[i] >= (point ? m0 + std::max({m1, m2, m3}) : std::max(m0, m1) + std::max(m2, m3)))
        continue;
      double distance = 0;
      chosen_[i] = is_near(pair, x, dx, 2 * largest, 0, &distance);
    }
  });
  near_.clear();
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (chosen_[i]) near_.push_back(candidates[i]);
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
