#pragma once
#include <vector>

#include "loosefit/contact/candidate_pairs.h"
#include "loosefit/contact/contact_tuning.h"
#include "loosefit/contact/friction.h"
#include "loosefit/contact/pair_barrier.h"
#include "loosefit/contact/sticky_pattern.h"

namespace loosefit::contact {

/// Contact of the cloth with itself, and of layers with each other, by point-triangle and edge-edge
/// pairs. A barrier (BarrierPair) keeps them apart, continuous detection limits every step, so
/// cloth that starts free of intersections stays so (Li et al. 2020; Li, Kaufman and Jiang 2021).
/// Features that share a vertex are no pairs. The reach of a pair is the mean thickness of its two
/// features, half a thickness on either side, or less (ContactFeatures::reach). Friction as in
/// Friction.
///
/// One caller at a time: working memory is kept between the calls, the const ones too.
class SelfContact : public particles::Energy,
                    public particles::LaggedState,
                    public particles::StepLimit,
                    public particles::ActiveSetUser {
 public:
  struct Options {
    double thickness = 5e-4;                      ///< d̂ [m]
    double pressure = kContact.barrier.pressure;  ///< p₀ [Pa]
    double friction = 0.4;                        ///< Coulomb [–]
    double stick_reach = 1e-4;                    ///< ε [m]
    /// Thickness of each triangle [m], for several materials in one mesh; empty: `thickness`.
    std::vector<double> triangle_thickness;
    /// As of CandidatePairs [–]: changes what a search costs, not what it finds.
    double list_margin = kContact.broad_phase.margin;
    /// Places of the particles at rest [m], as of ContactFeatures; empty: not known.
    std::vector<Vec3> rest;
    /// Layer of each triangle, 0, 1, …; empty: all in layer 0.
    std::vector<int> triangle_layer;
    /// μ between two layers [–], symmetric, a row for each layer; empty: `friction`.
    Eigen::MatrixXd layer_friction;
  };
  /// triangle_area: flat areas [m²], for the tributary areas. Throws InvalidInput when the numbers
  /// of triangles or layers do not match, and as ContactFeatures does.
  SelfContact(const std::vector<Triangle>& triangles, const std::vector<double>& triangle_area,
              int particles, const Options& options);

  void forget_anchors() { friction_.forget(); }
  /// As Friction::set_share.
  void set_friction_share(double share) { friction_.set_share(share); }
  void set_active_set(const particles::ActiveSet* active_set) override;
  void begin_step(const particles::VectorField& x, double dt) override;
  double max_step(const particles::VectorField& x, const particles::VectorField& dx) override;
  double lagged_friction_force() const override { return friction_.lagged_friction_force(); }
  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  double value_and_gradient(const particles::VectorField& x,
                            particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x,
                   particles::BlockPattern& pattern) const override;
  std::uint64_t pattern_version(const particles::VectorField& x) const override;
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;

  /// What a state of this cloth needs to be taken up again: all but lists that are made anew.
  struct Memory {
    std::vector<BarrierPair> pairs;
    Friction friction;
    StickyPattern blocks;
  };
  Memory memory() const { return {pairs_, friction_, blocks_}; }
  /// \pre memory is of a contact of the same mesh
  void recall(const Memory& memory);

  /// The part of add_gradient that is friction.
  void add_friction(const particles::VectorField& x, particles::VectorField& g) const {
    friction_.add_gradient(x, g);
  }

  int active(const particles::VectorField& x) const;
  long searches() const { return searches_; }  ///< continuous detections so far
  std::size_t pairs() const { return pairs_.size(); }
  const CandidatePairs& candidates() const { return candidates_; }

 private:
  double friction_between(const FeaturePair& pair) const;
  void take_pairs(const std::vector<FeaturePair>& near, const particles::VectorField& x);
  void evaluate(const particles::VectorField& x) const;
  void remember(const particles::VectorField& x) const;

  Options options_;
  CandidatePairs candidates_;
  std::vector<BarrierPair> pairs_;
  std::vector<BarrierPair> frozen_pairs_;  ///< those outside the active_set
  bool restricted_ = false;
  Friction friction_;
  long searches_ = 0;
  mutable StickyPattern blocks_;
  // Working memory.
  std::vector<double> share_;
  mutable std::vector<Barrier> barrier_;  ///< of pairs_, at the last `evaluate`
  mutable std::vector<PairPoints> force_;
  mutable std::vector<int> active_;
  mutable std::vector<PairMatrix> stiffness_;
};

}  // namespace loosefit::contact
