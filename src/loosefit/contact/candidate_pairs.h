#pragma once
#include <utility>

#include "loosefit/contact/contact_features.h"
#include "loosefit/contact/contact_tuning.h"
#include "loosefit/geometry/box_grid.h"
#include "loosefit/particles/active_set.h"

namespace loosefit::contact {

/// Broad phase: finds the pairs of features of one mesh that are, or on a straight move could come,
/// within their reach. A list of candidates with a margin m is kept between the calls. It was made
/// for the move from r to r + s, and holds every pair with
///
///   d(r) − motion_bound(s) < reach + 4/√3 m
///
/// so it is complete for all particles that remain within m of the common line r + λ s, since
/// motion_bound of a deviation by m is no more than that. The few beyond it, the outliers, are
/// looked for anew in each call; when they are many, a new list is made. Which pairs a call
/// returns, and in which order, does not depend on when the list was made.
class CandidatePairs {
 public:
  /// margin: m in mean edge lengths [–].
  explicit CandidatePairs(ContactFeatures features, double margin = kContact.broad_phase.margin)
      : features_(std::move(features)), margin_(margin) {}
  const ContactFeatures& features() const { return features_; }

  /// Pairs at x nearer than their reach, sorted by key.
  const std::vector<FeaturePair>& touching(const std::vector<Vec3>& x);
  /// Pairs that might come nearer than their reach between x and x + dx, sorted by key:
  /// distance at x less motion_bound below the reach, and no gap as wide as the reach between the
  /// projections on one of a few fixed axes at both ends of the move.
  const std::vector<FeaturePair>& approaching(const std::vector<Vec3>& x,
                                              const std::vector<Vec3>& dx);
  /// From now on only pairs with a particle in the active set are returned; null: all again.
  void set_active_set(const particles::ActiveSet* active_set);
  std::size_t candidates() const { return list_.candidates.size(); }
  long builds() const { return builds_; }  ///< how often the list has been made

 private:
  using Move = const std::vector<Vec3>*;  ///< null: no motion
  struct Candidate : FeaturePair {
    double slack = 0;  ///< distance at r less the reach [m]
  };
  struct List {
    std::vector<Candidate> candidates;
    std::vector<float> slack;               ///< of the candidates, rounded down
    std::vector<Vec3> start, displacement;  ///< r and s
    double margin = -1;                     ///< m [m]
    double rms_displacement = 0;            ///< root mean square of s [m]
    geometry::BoxGrid grid;  ///< of the swept triangles, enlarged by m and half a thickness
  };
  bool is_too_long(Move dx) const;
  bool find_outliers(const std::vector<Vec3>& x, Move dx);
  static bool is_near(const FeaturePair& pair, const std::vector<Vec3>& x, Move dx, double motion,
                      double extra, double* distance);
  void build(const std::vector<Vec3>& x, Move dx);
  void find_all(const std::vector<Vec3>& x, Move dx);
  void find_outlier_pairs(const std::vector<Vec3>& x, Move dx);
  void add_pairs(int a, int b, double motion, double margin, const std::vector<Vec3>& x, Move dx,
                 std::vector<Candidate>& found) const;
  void sort_found();
  void classify(const std::vector<Vec3>& x, Move dx);
  const std::vector<FeaturePair>& select(const std::vector<Vec3>& x, Move dx);

  ContactFeatures features_;
  double margin_;
  List list_;
  const particles::ActiveSet* active_set_ = nullptr;
  particles::IndexSubset active_;  ///< candidates that touch the active set, or all without one
  std::vector<FeaturePair> near_;
  long builds_ = 0;
  // Working memory, kept so that calls do not allocate.
  std::vector<geometry::Box3> boxes_;
  std::vector<std::vector<Candidate>> found_;
  std::vector<double> travel_;  ///< longest move of a corner of each triangle [m]
  std::vector<std::pair<std::uint64_t, int>> order_;
  std::vector<Candidate> unsorted_, sorted_;
  std::vector<char> is_near_;
  std::vector<double> motion_;  ///< of each particle since the list was made and on dx [m]
  double longest_motion_ = 0;   ///< of all but outliers [m]
  std::vector<int> outliers_;
  std::vector<char> is_outlier_;           ///< of every particle
  std::vector<int> outlier_triangles_;     ///< with an outlier at a corner
  std::vector<char> is_outlier_triangle_;  ///< of every triangle: whether it is one of them
  geometry::BoxGrid outlier_grid_;
};

}  // namespace loosefit::contact
