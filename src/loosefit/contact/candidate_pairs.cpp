#include "loosefit/contact/candidate_pairs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

#include "loosefit/contact/contact_tuning.h"
#include "loosefit/particles/vector_sums.h"

namespace loosefit::contact {
namespace {

constexpr BroadPhaseTuning kTuning = kContact.broad_phase;
/// What both features of a pair may lose of their distance when each particle is off by 1, as
/// motion_bound has it: 4/√3, rounded up.
constexpr double kTwoMargins = 2.3095;

double root_mean_square(const std::vector<Vec3>& v) {
  return std::sqrt(particles::dot(v, v) / std::max<double>(1, static_cast<double>(v.size())));
}

double longest_move(const Triangle& t, const std::vector<Vec3>& dx) {
  return std::sqrt(
      std::max({dx[t[0]].squaredNorm(), dx[t[1]].squaredNorm(), dx[t[2]].squaredNorm()}));
}

/// The swept triangle, enlarged by `around` on all sides.
geometry::Box3 box_of(const Triangle& t, const std::vector<Vec3>& x, const std::vector<Vec3>* dx,
                      double around) {
  geometry::Box3 box;
  for (int v : t) {
    box.extend(x[v]);
    if (dx) box.extend(Vec3(x[v] + (*dx)[v]));
  }
  const Vec3 rim = Vec3::Constant(around);
  return geometry::Box3(box.min() - rim, box.max() + rim);
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

/// No less than motion_bound of any pair of their parts. About the mean of all six corners the
/// triangles move by a and b at most; the mean of the four particles of a pair is off that by no
/// more than (a + b)/2, which counts on both sides.
double motion_of_triangles(const std::array<Vec3, 6>& d) {
  const Vec3 mean = (d[0] + d[1] + d[2] + d[3] + d[4] + d[5]) / 6;
  double a = 0, b = 0;
  for (int k = 0; k < 3; ++k) {
    a = std::max(a, (d[k] - mean).squaredNorm());
    b = std::max(b, (d[k + 3] - mean).squaredNorm());
  }
  return 2 * (std::sqrt(a) + std::sqrt(b));
}

}  // namespace

/// A list made for a long move is long itself: when moves have become short, a new one pays.
bool CandidatePairs::is_too_long(Move dx) const {
  return dx && list_.rms_displacement > kTuning.long_move * list_.margin &&
         root_mean_square(*dx) < kTuning.short_again * list_.rms_displacement;
}

/// Measures how far the particles are from the line of the list, and on dx will be. False when the
/// list is of no use: there is none, or too many are outliers.
bool CandidatePairs::find_outliers(const std::vector<Vec3>& x, Move dx) {
  const List& list = list_;
  for (int i : outliers_) is_outlier_[i] = 0;
  outliers_.clear();
  if (list.start.size() != x.size() || list.margin < 0) return false;
  // The share of the displacement that is done, and that dx is about to do.
  double done = 0, next = 0;
  if (const double length2 = particles::dot(list.displacement, list.displacement); length2 > 0) {
    for (std::size_t i = 0; i < x.size(); ++i)
      done += (x[i] - list.start[i]).dot(list.displacement[i]);
    done = std::clamp(done / length2, 0.0, 1.0);
    if (dx) next = std::clamp(particles::dot(*dx, list.displacement) / length2, 0.0, 1 - done);
  }
  const double margin = (1 - 1e-9) * list.margin;
  motion_.resize(x.size());
  is_outlier_.resize(x.size(), 0);
  longest_motion_ = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 moved = x[i] - list.start[i];
    double off = (moved - done * list.displacement[i]).norm();
    motion_[i] = moved.norm();
    if (dx) {
      off += ((*dx)[i] - next * list.displacement[i]).norm();
      motion_[i] += (*dx)[i].norm();
    }
    if (off <= margin) {
      longest_motion_ = std::max(longest_motion_, motion_[i]);
      continue;
    }
    outliers_.push_back(static_cast<int>(i));
    is_outlier_[i] = 1;
  }
  return static_cast<double>(outliers_.size()) <=
         kTuning.max_outliers * static_cast<double>(x.size());
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

/// Those of two triangles that, were their reach longer by kTwoMargins margin, would be returned.
/// motion: of both together, at most.
void CandidatePairs::add_pairs(int a, int b, double motion, double margin,
                               const std::vector<Vec3>& x, Move dx,
                               std::vector<Candidate>& found) const {
  const ContactFeatures& f = features_;
  const Triangle &ta = f.triangles[a], &tb = f.triangles[b];
  bool neighbours = false;  // these are never apart
  for (int v : ta) neighbours |= v == tb[0] || v == tb[1] || v == tb[2];
  const std::array<Vec3, 6> corners{x[ta[0]], x[ta[1]], x[ta[2]], x[tb[0]], x[tb[1]], x[tb[2]]};
  const double extra = kTwoMargins * margin, limit = f.max_thickness + extra + kTuning.rounding;
  if (!neighbours && far_apart(corners, limit + motion)) return;
  if (!neighbours && motion > margin) {
    const auto& d = *dx;
    if (far_apart(corners, limit + motion_of_triangles({d[ta[0]], d[ta[1]], d[ta[2]], d[tb[0]],
                                                        d[tb[1]], d[tb[2]]})))
      return;
  }
  const auto add = [&](const FeaturePair& pair) {
    Candidate candidate{pair};
    candidate.reach = f.reach(pair);
    if (!is_near(candidate, x, dx, motion, extra, &candidate.slack)) return;
    candidate.slack -= candidate.reach;
    found.push_back(candidate);
  };
  const auto add_vertices = [&](int owner, int t) {
    const Triangle& tri = f.triangles[t];
    for (int v : f.owned_vertices[owner])
      if (v >= 0 && v != tri[0] && v != tri[1] && v != tri[2])
        add({PairKind::point_triangle, v, t, {v, tri[0], tri[1], tri[2]}});
  };
  add_vertices(a, b);
  add_vertices(b, a);
  for (int i : f.owned_edges[a])
    for (int j : f.owned_edges[b]) {
      if (i < 0 || j < 0) continue;
      const auto &p = f.edges[std::min(i, j)], &q = f.edges[std::max(i, j)];
      if (p[0] == q[0] || p[0] == q[1] || p[1] == q[0] || p[1] == q[1]) continue;
      add({PairKind::edge_edge, std::min(i, j), std::max(i, j), {p[0], p[1], q[0], q[1]}});
    }
}

/// Fills found_ with the pairs of all boxes that meet. Parts of a fixed size, so that no result
/// depends on threads.
void CandidatePairs::find_all(const std::vector<Vec3>& x, Move dx) {
  constexpr std::size_t kPart = 16;  // of cells
  const std::size_t cells = list_.grid.busy_cells();
  found_.resize((cells + kPart - 1) / kPart);
  tbb::parallel_for(std::size_t{0}, found_.size(), [&](std::size_t part) {
    found_[part].clear();
    list_.grid.visit_pairs(part * kPart, std::min(cells, (part + 1) * kPart), [&](int a, int b) {
      add_pairs(a, b, travel_[a] + travel_[b], list_.margin, x, dx, found_[part]);
    });
  });
}

/// Brings the pairs that were found into the order of their keys, in sorted_.
void CandidatePairs::sort_found() {
  unsorted_.clear();
  for (const auto& found : found_) unsorted_.insert(unsorted_.end(), found.begin(), found.end());
  order_.resize(unsorted_.size());
  for (std::size_t i = 0; i < unsorted_.size(); ++i)
    order_[i] = {unsorted_[i].key(), static_cast<int>(i)};
  tbb::parallel_sort(order_.begin(), order_.end());
  sorted_.clear();
  for (const auto& [key, i] : order_) sorted_.push_back(unsorted_[i]);
}

void CandidatePairs::build(const std::vector<Vec3>& x, Move dx) {
  ++builds_;
  double sum = 0;
  for (const auto& e : features_.edges) sum += (x[e[1]] - x[e[0]]).norm();
  list_.start = x;
  if (dx)
    list_.displacement = *dx;
  else
    list_.displacement.assign(x.size(), Vec3::Zero());
  list_.rms_displacement = root_mean_square(list_.displacement);
  list_.margin = margin_ * sum / std::max<double>(1, static_cast<double>(features_.edges.size()));
  // After a long move the next one will not be like it, whatever the margin.
  if (list_.rms_displacement > kTuning.long_move * list_.margin)
    list_.margin *= kTuning.long_move_margin;

  const std::size_t triangles = features_.triangles.size();
  const double around = 0.5 * features_.max_thickness + list_.margin;
  boxes_.resize(triangles);
  travel_.resize(triangles);
  tbb::parallel_for(std::size_t{0}, triangles, [&](std::size_t t) {
    boxes_[t] = box_of(features_.triangles[t], x, dx, around);
    travel_[t] = dx ? longest_move(features_.triangles[t], *dx) : 0;
  });
  list_.grid.build(boxes_);
  find_all(x, dx);
  sort_found();
  list_.candidates.swap(sorted_);
  list_.slack.resize(list_.candidates.size());
  for (std::size_t i = 0; i < list_.slack.size(); ++i)
    list_.slack[i] = std::nextafter(static_cast<float>(list_.candidates[i].slack), -1e30f);
  set_active_set(active_set_);
}

void CandidatePairs::set_active_set(const particles::ActiveSet* active_set) {
  active_set_ = active_set;
  const std::size_t n = list_.candidates.size();
  active_ =
      active_set
          ? particles::IndexSubset(
                n, [&](int i) { return active_set->touches(list_.candidates[i].particle, 4); })
          : particles::IndexSubset(n);
}

/// Fills sorted_ with the pairs that have an outlier: their triangles now, against the
/// others where the list has them, and against each other.
void CandidatePairs::find_outlier_pairs(const std::vector<Vec3>& x, Move dx) {
  is_outlier_triangle_.assign(features_.triangles.size(), 0);
  outlier_triangles_.clear();
  boxes_.clear();
  for (std::size_t t = 0; t < features_.triangles.size(); ++t) {
    const Triangle& triangle = features_.triangles[t];
    is_outlier_triangle_[t] =
        is_outlier_[triangle[0]] | is_outlier_[triangle[1]] | is_outlier_[triangle[2]];
    if (!is_outlier_triangle_[t]) continue;
    outlier_triangles_.push_back(static_cast<int>(t));
    boxes_.push_back(box_of(triangle, x, dx, 0.5 * features_.max_thickness + kTuning.rounding));
  }
  outlier_grid_.build(boxes_);
  constexpr std::size_t kPart = 16;  // of triangles
  const std::size_t triangles = outlier_triangles_.size();
  found_.resize((triangles + kPart - 1) / kPart);
  tbb::parallel_for(std::size_t{0}, found_.size(), [&](std::size_t part) {
    auto& found = found_[part];
    found.clear();
    for (std::size_t k = part * kPart; k < std::min(triangles, (part + 1) * kPart); ++k) {
      const int a = outlier_triangles_[k];
      const auto meet = [&](int b) {
        const double motion = dx ? longest_move(features_.triangles[a], *dx) +
                                       longest_move(features_.triangles[b], *dx)
                                 : 0;
        add_pairs(std::min(a, b), std::max(a, b), motion, 0, x, dx, found);
      };
      list_.grid.query(boxes_[k], [&](int b) {
        if (!is_outlier_triangle_[b]) meet(b);
      });
      outlier_grid_.query(boxes_[k], [&](int other) {
        if (outlier_triangles_[other] > a) meet(outlier_triangles_[other]);
      });
    }
    const auto wanted = [&](const FeaturePair& pair) {
      const auto& p = pair.particle;
      return (is_outlier_[p[0]] | is_outlier_[p[1]] | is_outlier_[p[2]] | is_outlier_[p[3]]) &&
             (!active_set_ || active_set_->touches(p, 4));
    };
    std::erase_if(found, [&](const Candidate& c) { return !wanted(c); });
  });
  sort_found();
}

/// Tells in is_near_ which of the listed candidates are near now, but for those with an outlier.
void CandidatePairs::classify(const std::vector<Vec3>& x, Move dx) {
  const double longest = longest_motion_;
  const bool any_outlier = !outliers_.empty();
  is_near_.resize(active_.size());
  using Range = tbb::blocked_range<int>;
  tbb::parallel_for(Range(0, active_.size(), 512), [&](const Range& range) {
    for (int k = range.begin(); k < range.end(); ++k) {
      is_near_[k] = 0;
      const Candidate& pair = list_.candidates[active_[k]];
      const float slack = list_.slack[active_[k]];
      // What has moved too little since the list was made needs no new distance.
      if (slack >= 2 * longest) continue;
      const auto& p = pair.particle;
      if (any_outlier &&
          (is_outlier_[p[0]] | is_outlier_[p[1]] | is_outlier_[p[2]] | is_outlier_[p[3]]))
        continue;
      const bool point = pair.kind == PairKind::point_triangle;
      const double m0 = motion_[p[0]], m1 = motion_[p[1]], m2 = motion_[p[2]], m3 = motion_[p[3]];
      if (slack >= (point ? m0 + std::max({m1, m2, m3}) : std::max(m0, m1) + std::max(m2, m3)))
        continue;
      double distance = 0;
      is_near_[k] = is_near(pair, x, dx, 2 * longest, 0, &distance);
    }
  });
}

const std::vector<FeaturePair>& CandidatePairs::select(const std::vector<Vec3>& x, Move dx) {
  if (!find_outliers(x, dx) || (!active_set_ && is_too_long(dx))) {
    build(x, dx);
    find_outliers(x, dx);  // none but what is no number
  }
  classify(x, dx);
  near_.clear();
  for (int k = 0; k < active_.size(); ++k)
    if (is_near_[k]) near_.push_back(list_.candidates[active_[k]]);
  if (outliers_.empty()) return near_;
  find_outlier_pairs(x, dx);
  const auto middle = static_cast<long>(near_.size());
  near_.insert(near_.end(), sorted_.begin(), sorted_.end());
  std::inplace_merge(near_.begin(), near_.begin() + middle, near_.end(),
                     [](const FeaturePair& a, const FeaturePair& b) { return a.key() < b.key(); });
  return near_;
}

const std::vector<FeaturePair>& CandidatePairs::touching(const std::vector<Vec3>& x) {
  return select(x, nullptr);
}

const std::vector<FeaturePair>& CandidatePairs::approaching(const std::vector<Vec3>& x,
                                                            const std::vector<Vec3>& dx) {
  return select(x, &dx);
}

}  // namespace loosefit::contact
