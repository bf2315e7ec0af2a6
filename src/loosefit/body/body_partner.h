#pragma once
#include <vector>

#include "loosefit/base/lazy.h"
#include "loosefit/body/body.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::body {

/// Where a point of the garment meets the body.
struct BodyPartner {
  geometry::ClosestPoint exact;  ///< closest surface point [m]
  Vec3 normal = Vec3::Zero();    ///< smooth body normal there, interpolated over the triangle
  double particle_distance = 0;  ///< to the nearest body vertex of the same faces [m]
};

/// Part of the body a garment panel belongs to: one of it, or several where one panel covers them:
/// the front of a skirt both legs, that of a kimono trunk and arms.
enum class BodyPart { trunk, arm_left, arm_right, leg_left, leg_right, both_legs, trunk_and_arms };

inline bool covers_trunk(BodyPart part) {
  return part == BodyPart::trunk || part == BodyPart::trunk_and_arms;
}

/// Finds the body partner of garment points. A partner lies on the panel's own part of the body or
/// on a neighbouring one (trunk panels: trunk, upper arms, legs; sleeves: that arm and the torso;
/// trouser legs: that leg, the torso and the other thigh), and its surface faces the same way as
/// the garment, else an armpit point would jump between arm and chest. Where facing alike would
/// push the partner more than kFoldReach further away, the garment is folded over and the plainly
/// nearest point counts.
class PartnerFinder {
 public:
  static constexpr double kFoldReach = 0.06;  ///< [m]

  /// Keeps references to both; `surface`: of the body's surface. \throws InvalidInput for a body
  /// without a segment, side or normal for every vertex.
  PartnerFinder(const Body& body, const geometry::ClosestPointTree& surface);
  /// The part of a panel: that which most of its `points` lie nearest to; both legs where more than
  /// a fifth of them lies nearest to the other leg, trunk and arms where more than a tenth lies
  /// nearest to a forearm or hand that faces the way of their unit `normals`, round which the cloth
  /// goes and not beside it.
  BodyPart part_of(const std::vector<Vec3>& points, const std::vector<Vec3>& normals) const;
  BodyPartner find(const Vec3& point, const Vec3& garment_normal, BodyPart part) const;
  /// The same but for particle_distance, which stays zero and takes half of the time.
  BodyPartner find_on_surface(const Vec3& point, const Vec3& garment_normal, BodyPart part) const;
  const Body& body() const { return body_; }

 private:
  /// The body's vertices alone.
  struct Particles {
    explicit Particles(const std::vector<Vec3>& vertices);
    geometry::TriangleMesh mesh;  ///< one degenerate triangle per vertex
    geometry::ClosestPointTree tree;
  };
  bool faces_alike(int triangle, const Vec3& garment_normal, BodyPart part) const;
  bool belongs(int vertex, BodyPart part) const;
  const geometry::ClosestPointTree& particle_tree() const;
  const Body& body_;
  const geometry::ClosestPointTree& tree_;
  std::vector<Vec3> face_normals_;
  std::vector<std::vector<int>> faces_of_vertex_;
  Lazy<Particles> particles_;
};

/// Partner of every garment vertex. `normals` are the garment's unit vertex normals.
std::vector<BodyPartner> find_partners(const PartnerFinder& finder,
                                       const std::vector<Vec3>& positions,
                                       const std::vector<Vec3>& normals,
                                       const std::vector<BodyPart>& part);

}  // namespace loosefit::body
