#pragma once
#include "loosefit/body/body.h"
#include "support/shapes.h"

namespace loosefit::support {

/// A person of upright cylinders with everything an anatomical address needs: elliptic trunk (half
/// axes 0.16 and 0.10 m, z = 0.8 … 1.4 m), straight arms of radius 0.04 m on x = ±0.25 m and legs
/// of radius 0.06 m on x = ±0.09 m.
struct StickPerson {
  static constexpr double kTrunkX = 0.16, kTrunkY = 0.10, kArm = 0.04, kLeg = 0.06;
  static constexpr double kArmX = 0.25, kLegX = 0.09;
  static constexpr double kAcromion = 1.40, kShoulder = 1.35, kElbow = 1.10, kWrist = 0.85;
  static constexpr double kHip = 0.85, kKnee = 0.45, kAnkle = 0.05;
  static constexpr double kC7 = 1.35, kSternum = 1.20, kWaist = 0.95;
  body::Body body;

  StickPerson() {
    add(cylinder(1, 0.8, 1.4, 24, 96), 0, 0, Vec2(kTrunkX, kTrunkY),
        [](double) { return body::Segment::torso; });
    for (const int side : {1, -1}) {
      add(cylinder(1, 0.70, 1.40, 28, 32), side, side * kArmX, Vec2(kArm, kArm), [](double z) {
        return z > kElbow   ? body::Segment::upper_arm
               : z > kWrist ? body::Segment::forearm
                            : body::Segment::hand;
      });
      add(cylinder(1, 0, 0.75, 30, 32), side, side * kLegX, Vec2(kLeg, kLeg), [](double z) {
        return z > kKnee    ? body::Segment::thigh
               : z > kAnkle ? body::Segment::shank
                            : body::Segment::foot;
      });
      const std::string s = side > 0 ? "_L" : "_R";
      body.landmarks["acromion" + s] = Vec3(side * kArmX, 0, kAcromion);
      body.joints["shoulder" + s] = Vec3(side * kArmX, 0, kShoulder);
      body.joints["elbow" + s] = Vec3(side * kArmX, 0, kElbow);
      body.joints["wrist" + s] = Vec3(side * kArmX, 0, kWrist);
      body.joints["hip" + s] = Vec3(side * kLegX, 0, kHip);
      body.joints["knee" + s] = Vec3(side * kLegX, 0, kKnee);
      body.joints["ankle" + s] = Vec3(side * kLegX, 0, kAnkle);
    }
    body.landmarks["c7"] = Vec3(0, kTrunkY, kC7);
    body.landmarks["back_waist"] = Vec3(0, kTrunkY, kWaist);
    body.landmarks["front_waist"] = Vec3(0, -kTrunkY, kWaist);
    body.landmarks["sternum"] = Vec3(0, -kTrunkY, kSternum);
    body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  }

  /// The same person turned and moved as a rigid whole.
  body::Body moved(const Eigen::Isometry3d& motion) const {
    body::Body other = body;
    for (Vec3& p : other.surface.vertices) p = motion * p;
    for (Vec3& n : other.normals) n = motion.linear() * n;
    for (auto* points : {&other.landmarks, &other.joints})
      for (auto& entry : *points) entry.second = motion * entry.second;
    return other;
  }

 private:
  template <class Label>
  void add(geometry::TriangleMesh part, int side, double x, const Vec2& half, const Label& label) {
    const int first = static_cast<int>(body.surface.vertices.size());
    for (const Vec3& p : part.vertices) {
      body.surface.vertices.emplace_back(x + half.x() * p.x(), half.y() * p.y(), p.z());
      body.segment.push_back(label(p.z()));
      body.side.push_back(side);
    }
    for (const Triangle& t : part.triangles)
      body.surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
};

}  // namespace loosefit::support
