#pragma once
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
  /// distance at x less motion_bound below the reach, and boxes swept by the features no farther
  /// apart than the reach.
  const std::vector<FeaturePair>& approaching(const std::vector<Vec3>& x,
                                              const std::vector<Vec3>& dx);
  std::size_t candidates() const { return candidates_.size(); }
  long builds() const { return builds_; }  ///< how often the list has been made

 private:
  using Move = const std::vector<Vec3>*;  ///< null: no motion
  bool covers(const std::vector<Vec3>& x, Move dx) const;
  void build(const std::vector<Vec3>& x, Move dx);
  void add_pairs(int a, int b, const std::vector<Vec3>& x, Move dx,
                 std::vector<FeaturePair>& found) const;
  const std::vector<FeaturePair>& select(const std::vector<Vec3>& x, Move dx);

  ContactFeatures features_;
  std::vector<FeaturePair> candidates_, near_;
  std::vector<Vec3> start_, way_;  ///< r and s of the list
  double margin_ = -1;             ///< m [m]
  double longest_way_ = 0;         ///< max |s| [m]
  long builds_ = 0;
  // Working memory, kept so that calls do not allocate.
  std::vector<Box3> boxes_;
  BoxGrid grid_;
  std::vector<std::vector<FeaturePair>> found_;
  std::vector<char> chosen_;
};

}  // namespace loosefit
