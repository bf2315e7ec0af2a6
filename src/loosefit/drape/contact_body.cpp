#include "loosefit/drape/contact_body.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "loosefit/body/floor_under.h"
#include "loosefit/drape/cleft_cover.h"
#include "loosefit/geometry/convex_hull.h"

namespace loosefit::drape {
namespace {

constexpr double kSole = 0.02;  ///< height of the lower edge of a foot [m]

/// The hull of each hand: cloth does not go between fingers, and a sleeve that is drawn over a hand
/// is not caught on the thumb. Somebody may lack a hand.
std::vector<geometry::TriangleMesh> hand_hulls(const body::Body& body) {
  std::vector<Vec3> hand[2];
  for (std::size_t v = 0; v < body.segment.size(); ++v)
    if (body.segment[v] == body::Segment::hand && v < body.side.size() && body.side[v] != 0)
      hand[body.side[v] > 0].push_back(body.surface.vertices[v]);
  std::vector<geometry::TriangleMesh> hulls;
  for (const std::vector<Vec3>& points : hand)
    if (points.size() > 3) hulls.push_back(geometry::convex_hull(points));
  return hulls;
}

/// The lower edge of each foot down to the floor, all round: cloth that lies on the floor does not
/// go under the rounded edge of a sole, where there is no room for it.
std::vector<geometry::TriangleMesh> sole_hulls(const body::Body& body, double floor) {
  std::vector<Vec3> sole[2];
  for (std::size_t v = 0; v < body.segment.size(); ++v) {
    const Vec3& p = body.surface.vertices[v];
    if (body.segment[v] != body::Segment::foot || p.z() > floor + kSole) continue;
    std::vector<Vec3>& of = sole[v < body.side.size() && body.side[v] > 0];
    of.push_back(p);
    of.emplace_back(p.x(), p.y(), floor);
  }
  std::vector<geometry::TriangleMesh> hulls;
  for (const std::vector<Vec3>& points : sole)
    if (points.size() > 3) hulls.push_back(geometry::convex_hull(points));
  return hulls;
}

Eigen::Affine3d affine(const Eigen::Matrix<double, 3, 4>& m) {
  Eigen::Affine3d a;
  a.matrix().topRows<3>() = m;
  a.matrix().row(3) << 0, 0, 0, 1;
  return a;
}
}  // namespace

geometry::Box3 bounds(const std::vector<Vec3>& x) {
  geometry::Box3 box;
  for (const Vec3& p : x) box.extend(p);
  return box;
}

std::shared_ptr<const ContactBody> with_field(body::PosedBody body, const geometry::Box3& cloth,
                                              double spacing, const CarryTuning& tuning,
                                              bool arms_go_up) {
  const Vec3 margin = Vec3::Constant(tuning.field_margin);
  std::vector<geometry::TriangleMesh> covers = hand_hulls(body);
  if (geometry::TriangleMesh cleft = cleft_cover(body); !cleft.triangles.empty())
    covers.push_back(std::move(cleft));
  for (geometry::TriangleMesh& fold : armpit_covers(body, arms_go_up))
    covers.push_back(std::move(fold));
  for (geometry::TriangleMesh& ear : ear_covers(body)) covers.push_back(std::move(ear));
  const std::optional<double> height = body::floor_under(body.body());
  if (height)
    for (geometry::TriangleMesh& sole : sole_hulls(body.body(), *height))
      covers.push_back(std::move(sole));
  auto field = std::make_shared<const contact::DistanceField>(
      body.tree(),
      geometry::Box3(cloth.min() - margin - tuning.field_margin_below * Vec3::UnitZ(),
                     cloth.max() + margin),
      spacing, covers);
  std::shared_ptr<const contact::Floor> floor;
  if (height) floor = std::make_shared<const contact::Floor>(*height);
  return std::make_shared<const ContactBody>(
      ContactBody{std::move(body), std::move(field), std::move(floor)});
}

std::vector<MotionMap> skin_motion(const body::PosedBody& from, const body::Body& to,
                                   const std::vector<Vec3>& x) {
  std::vector<MotionMap> motion(x.size(), MotionMap::Identity());
  const auto &old_pose = from->pose_from_rest, &new_pose = to.pose_from_rest;
  if (old_pose.empty() || old_pose.size() != new_pose.size()) return motion;
  tbb::parallel_for(std::size_t{0}, x.size(), [&](std::size_t i) {
    const geometry::ClosestPoint hit = from.tree().query(x[i]);
    const Triangle& t = from->surface.triangles[hit.triangle];
    motion[i].setZero();
    for (int k = 0; k < 3; ++k)
      motion[i] +=
          hit.barycentric[k] *
          (affine(new_pose[t[k]]) * affine(old_pose[t[k]]).inverse()).matrix().topRows<3>();
  });
  return motion;
}

std::vector<MotionMap> smoothed_over(const std::vector<Triangle>& triangles,
                                     const std::vector<Vec3>& x, std::vector<MotionMap> motion,
                                     const CarryTuning& tuning) {
  double edge = 0;  // a pass reaches so far; n passes √n times
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k)
      edge += (x[t[k]] - x[t[(k + 1) % 3]]).norm() / (3.0 * static_cast<double>(triangles.size()));
  const int passes =
      std::clamp(static_cast<int>(std::ceil(std::pow(tuning.smoothing_length / edge, 2))), 1,
                 tuning.smoothing_passes);
  std::vector<MotionMap> sum(x.size());
  std::vector<int> count(x.size());
  for (int pass = 0; pass < passes; ++pass) {
    std::fill(sum.begin(), sum.end(), MotionMap::Zero());
    std::fill(count.begin(), count.end(), 0);
    for (const Triangle& t : triangles)
      for (int k = 0; k < 3; ++k) {
        sum[t[k]] += motion[t[(k + 1) % 3]] + motion[t[(k + 2) % 3]];
        count[t[k]] += 2;
      }
    for (std::size_t i = 0; i < x.size(); ++i)
      if (count[i] > 0) motion[i] = sum[i] / count[i];
  }
  return motion;
}

std::vector<Vec3> displacements(const std::vector<MotionMap>& motion, const std::vector<Vec3>& x) {
  std::vector<Vec3> displacement(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    displacement[i] = motion[i] * x[i].homogeneous() - x[i];
  return displacement;
}

}  // namespace loosefit::drape
