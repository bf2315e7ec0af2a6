#pragma once
#include <memory>
#include <vector>

#include "loosefit/contact/contact_surface.h"
#include "loosefit/contact/friction.h"

namespace loosefit::contact {

/// A point of the cloth that may touch the body: Σ weight · particle.
struct ContactPoint {
  std::array<int, 3> particle{};
  std::array<double, 3> weight{};
  int count = 1;
  double area = 0;    ///< cloth area it stands for [m²]
  double offset = 0;  ///< rest distance of the mid-surface from the skin [m]
  /// By how much the field reads too far where the point last lay [m]; taken off what it reads.
  double field_error = 0;

  /// Whether all its particles are corners of the triangle.
  bool within(const Triangle& t) const;
  Vec3 position(const particles::VectorField& x) const;
};

/// Pressure law of the compressed layer, its integral and its slope.
struct LayerResponse {
  double energy = 0;     ///< per area [J/m²]
  double pressure = 0;   ///< [Pa]
  double stiffness = 0;  ///< [Pa/m]
};
/// hardening: share of the part that hardens [–].
LayerResponse compress_layer(double stiffness, double offset, double compression,
                             double hardening = 1);

/// Vertices and edge midpoints of a triangle mesh as contact points; areas from the flat triangles,
/// a quarter to the vertices and three quarters to the midpoints.
std::vector<ContactPoint> contact_points(const std::vector<Triangle>& triangles,
                                         const std::vector<double>& triangle_area, int particles,
                                         double offset);

/// Unilateral contact of the cloth with a surface that is not cloth, the skin or the floor: a
/// penalty on the signed distance to it. The cloth is a layer of finite thickness o (the offset)
/// that can be compressed and hardens: with d the distance of its mid-surface to the skin and the
/// compression δ = (o − d)₊ the pressure is
///
///   p = k δ + (20 k/o) u²/(1 − u/(0.4 o))³,  u = (δ − 0.6 o)₊               [Pa], k [Pa/m]
///
/// up to δ = 0.85 o, linear beyond,
///
/// and Π_n = Σ A ∫ p dδ [J]. The gap error is at most o. Friction per point, see Friction.
///
/// One caller at a time: what touches at the last place is remembered, by the const members too.
class BodyContact : public particles::Energy,
                    public particles::LaggedState,
                    public particles::ActiveSetUser {
 public:
  BodyContact(std::vector<ContactPoint> points, double stiffness, double friction,
              double stick_reach);

  /// The body moved or changed: contacts keep their anchors unless `forget_anchors`. Without a
  /// field nothing touches.
  void set_field(std::shared_ptr<const ContactSurface> field) {
    field_ = std::move(field);
    forget_touches();
  }
  /// What a state of this cloth needs to be taken up again: all but what only saves work.
  struct Memory {
    std::vector<ContactPoint> points;
    std::shared_ptr<const ContactSurface> field;
    double stiffness;
    Friction friction;
  };
  Memory memory() const { return {points_, field_, stiffness_, friction_}; }
  void recall(const Memory& memory) {
    change_points() = memory.points;
    field_ = memory.field;
    stiffness_ = memory.stiffness;
    friction_.recall(memory.friction);
  }
  void forget_anchors() { friction_.forget(); }
  /// As Friction::set_share.
  void set_friction_share(double share) { friction_.set_share(share); }
  /// The skin under each particle has moved so far [m]: the anchors of friction move with it.
  void carry_anchors(const particles::VectorField& motion) { friction_.carry(motion); }
  const std::vector<ContactPoint>& points() const { return points_; }
  /// To be changed: what is remembered of them is void.
  std::vector<ContactPoint>& change_points() {
    forget_touches();
    return points_;
  }
  /// The layer of every point: rest distance [m] and stiffness [Pa/m]. Anchors of friction stay.
  void set_layer(double offset, double stiffness) {
    for (ContactPoint& p : change_points()) p.offset = offset;
    stiffness_ = stiffness;
  }
  /// Thickness of what lies between cloth and skin at each particle [m]; a point has the least of
  /// its particles, so that what is beside a board is as near as ever. Empty: nothing.
  void set_padding(std::vector<double> padding) {
    padding_ = std::move(padding);
    forget_touches();
  }
  /// With less than the whole of its hardening the layer gives way where cloth starts from within
  /// the skin, and Newton's steps stay long. At rest it has all of it.
  void set_hardening(double share) {
    if (share != hardening_) forget_touches();
    hardening_ = share;
  }
  /// Distance of a point to the skin as the field sees it [m]; reach or more if it is far.
  double field_distance(const ContactPoint& point, const particles::VectorField& x,
                        double reach) const;

  void set_active_set(const particles::ActiveSet* active_set) override;
  void begin_step(const particles::VectorField& x, double dt) override;
  double lagged_friction_force() const override { return friction_.lagged_friction_force(); }
  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  double value_and_gradient(const particles::VectorField& x,
                            particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x,
                   particles::BlockPattern& pattern) const override;
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;

  /// The part of add_gradient that is friction.
  void add_friction(const particles::VectorField& x, particles::VectorField& g) const {
    friction_.add_gradient(x, g);
  }

  int active(const particles::VectorField& x) const;
  /// Indices of the points that bear a force.
  std::vector<int> bearing(const particles::VectorField& x) const;
  /// f_i += Σ weight · A p ‖∇d‖ over the contact points: magnitudes of the normal force, friction
  /// left out, shared among the particles [N]. Their sum is the total normal force exactly.
  void add_normal_force(const particles::VectorField& x, std::vector<double>& f) const;

 private:
  /// Number of points that the active set touches (all without one), and the index of the k-th.
  int point_count() const {
    return restricted_ ? active_.size() : static_cast<int>(points_.size());
  }
  int point_index(int k) const { return restricted_ ? active_[k] : k; }
  struct Touch {
    bool active = false;
    ContactSurface::Sample sample;
  };
  /// Position of a point at which it was found clear of the skin, and how far it may move from
  /// there before its distance is sampled again [m].
  struct Clear {
    Vec3 position = Vec3::Zero();
    double slack = -1;
  };
  void forget_touches() {
    evaluated_at_.clear();
    clear_.clear();
  }
  Touch ask(std::size_t point, const particles::VectorField& x, bool with_hessian) const;
  const std::vector<Touch>& touches(const particles::VectorField& x, bool with_hessian) const;
  LayerResponse layer(const ContactPoint& point, const Touch& touch) const {
    return compress_layer(stiffness_, point.offset, point.offset - touch.sample.distance,
                          hardening_);
  }
  double padding_of(const ContactPoint& point) const;
  std::vector<ContactPoint> points_;
  std::vector<double> padding_;
  std::shared_ptr<const ContactSurface> field_;
  double stiffness_;
  double hardening_ = 1;
  Friction friction_;
  bool restricted_ = false;
  particles::IndexSubset active_;     ///< points, while an active set is given
  mutable std::vector<Touch> touch_;  ///< at evaluated_at_
  mutable particles::VectorField evaluated_at_;
  mutable std::vector<Clear> clear_;
  mutable bool with_hessian_ = false;
};

}  // namespace loosefit::contact
