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

/// Limb a garment panel belongs to.
enum class BodyPart { trunk, arm_left, arm_right, leg_left, leg_right };

/// Finds the body partner of garment points. A partner lies on the panel's own part of the body or
/// on a neighbouring one (trunk panels: trunk, upper arms, thighs; sleeves: that arm and the
/// torso), and its surface faces the same way as the garment, else an armpit point would jump
/// between arm and chest. Where facing alike would push the partner more than kFoldReach further
/// away, the garment is folded over and the plainly nearest point counts.
class PartnerFinder {
 public:
  static constexpr double kFoldReach = 0.06;  ///< [m]

  /// Keeps references to both; `surface`: of the body's surface. \throws InvalidInput for a body
  /// without a segment, side or normal for every vertex.
  PartnerFinder(const Body& body, const geometry::ClosestPointTree& surface);
  /// Part that most of `points` lie nearest to: the part of a panel.
  BodyPart part_of(const std::vector<Vec3>& points) const;
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
