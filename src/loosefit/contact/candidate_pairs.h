#pragma once
#include <utility>

#include "loosefit/contact/contact_features.h"
#include "loosefit/geometry/box_grid.h"

namespace loosefit {

/// Finds the pairs of features of one mesh that are, or on a straight move could come, within their
/// reach. A list of candidates with a margin m is kept between the calls. It was made for the move
/// from r to r + s, and holds every pair with
///
///   d(r) − (bound of its loss of distance on s) < reach + 2 m
///
/// so it stays complete while all particles remain within m of the common way r + λ s. Which pairs
/// a call returns, and in which order, does not depend on when the list was made.
class CandidatePairs {
 public:
  explicit CandidatePairs(ContactFeatures features) : features_(std::move(features)) {}
  const ContactFeatures& features() const { return features_; }

  /// Pairs at x nearer than their reach, sorted by key.
  const std::vector<FeaturePair>& touching(const std::vector<Vec3>& x);
  /// Pairs that might come nearer than their reach on the way from x to x + dx, sorted by key:
  /// distance at x less motion_bound below the reach, and no gap as wide as the reach between the
  /// projections on one of a few fixed axes at both ends of the way.
  const std::vector<FeaturePair>& approaching(const std::vector<Vec3>& x,
                                              const std::vector<Vec3>& dx);
  std::size_t candidates() const { return candidates_.size(); }
  long builds() const { return builds_; }  ///< how often the list has been made

 private:
  using Move = const std::vector<Vec3>*;  ///< null: no motion
  struct Candidate : FeaturePair {
    double spare = 0;  ///< distance at r less the reach [m]
  };
  bool covers(const std::vector<Vec3>& x, Move dx) const;
  double measure_motion(const std::vector<Vec3>& x, Move dx);
  bool is_near(const FeaturePair& pair, const std::vector<Vec3>& x, Move dx, double motion,
               double extra, double* distance) const;
  void build(const std::vector<Vec3>& x, Move dx);
  void add_pairs(int a, int b, const std::vector<Vec3>& x, Move dx,
                 std::vector<Candidate>& found) const;
  const std::vector<FeaturePair>& select(const std::vector<Vec3>& x, Move dx);

  ContactFeatures features_;
  std::vector<Candidate> candidates_;
  std::vector<float> spare_;  ///< of the candidates, rounded down
  std::vector<FeaturePair> near_;
  std::vector<Vec3> start_, way_;  ///< r and s of the list
  double margin_ = -1;             ///< m [m]
  double longest_way_ = 0;         ///< max |s| [m]
  long builds_ = 0;
  // Working memory, kept so that calls do not allocate.
  std::vector<Box3> boxes_;
  BoxGrid grid_;
  std::vector<std::vector<Candidate>> found_;
  std::vector<double> travel_;  ///< longest move of a corner of each triangle [m]
  std::vector<std::pair<std::uint64_t, int>> order_;
  std::vector<Candidate> unsorted_;
  std::vector<char> chosen_;
  std::vector<double> motion_;  ///< of each particle since the list was made and on dx [m]
};

}  // namespace loosefit
