#include "loosefit/body/body_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/body/hanging_arms.h"
#include "loosefit/body/landmarks.h"
#include "loosefit/body/skeleton_pose.h"
#include "loosefit/body/stumps.h"
#include "loosefit/body/tape_paths.h"

namespace loosefit::body {
namespace {

constexpr double kHangingArm = radians(25);  // as people stand

Segment segment_of_bone(const std::string& bone) {
  static const std::vector<std::pair<std::string, Segment>> kPrefixes = {
      {"spine", Segment::torso},      {"clavicle", Segment::torso},
      {"shoulder", Segment::torso},   {"breast", Segment::torso},
      {"root", Segment::torso},       {"pelvis", Segment::torso},
      {"neck", Segment::neck},        {"upperarm", Segment::upper_arm},
      {"lowerarm", Segment::forearm}, {"wrist", Segment::hand},
      {"metacarpal", Segment::hand},  {"finger", Segment::hand},
      {"upperleg", Segment::thigh},   {"lowerleg", Segment::shank},
      {"foot", Segment::foot},        {"toe", Segment::foot}};
  for (const auto& [prefix, segment] : kPrefixes) {
    if (bone.starts_with(prefix)) return segment;
  }
  return Segment::head;
}

bool is_limb(Segment s) { return s != Segment::head && s != Segment::neck && s != Segment::torso; }

void check_posture(const Posture& posture) {
  const auto check = [](const char* key, double value, double low, double high, const char* unit) {
    if (!(value >= low && value <= high)) {
      throw InvalidInput({"", 0, key}, fmt::format("{:g}{}", value, unit),
                         fmt::format("{:g} to {:g}{}", low, high, unit));
    }
  };
  check("arm_abduction", degrees(posture.arm_abduction), -10, 120, "°");
  check("forward_bend", degrees(posture.forward_bend), -30, 90, "°");
  check("sitting", posture.sitting, 0, 1, "");
  check("arm_flexion", degrees(posture.arm_flexion), -40, 180, "°");
  check("elbow_extension", posture.elbow_extension, 0, 1, "");
  check("slouch", posture.slouch, 0, 1, "");
  check("relaxed_arms", posture.relaxed_arms, 0, 1, "");
  check("elbow_flexion", degrees(posture.elbow_flexion), 0, 150, "°");
  check("wrist_flexion", degrees(posture.wrist_flexion), -90, 90, "°");
  for (const double one : {posture.left_hip_flexion, posture.right_hip_flexion})
    check("hip_flexion", degrees(posture.hip_flexion + one), -30, 120, "°");
  for (const double one : {posture.left_knee_flexion, posture.right_knee_flexion})
    check("knee_flexion", degrees(posture.knee_flexion + one), 0, 140, "°");
  check("trunk_rotation", degrees(posture.trunk_rotation), -60, 60, "°");
  check("side_bend", degrees(posture.side_bend), -45, 45, "°");
}

std::vector<Vec3> carried(const std::vector<Eigen::Matrix<double, 3, 4>>& maps,
                          const std::vector<Vec3>& points) {
  std::vector<Vec3> moved;
  moved.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    moved.push_back(maps[v] * points[v].homogeneous());
  return moved;
}

double lowest(const std::vector<Vec3>& points) {
  double low = std::numeric_limits<double>::infinity();
  for (const auto& p : points) low = std::min(low, p.z());
  return low;
}

}  // namespace

BodyModel::BodyModel(BodyData data)
    : data_(std::make_shared<const BodyData>(std::move(data))),
      morph_(*data_),
      subdivision_(data_->body_vertices, data_->quads),
      coarse_triangles_(triangulate(data_->quads)) {
  for (int v = 0; v < subdivision_.fine_vertex_count(); ++v) {
    std::map<int, double> sum;
    double x = 0;
    for (const auto& [coarse, share] : subdivision_.stencil(v)) {
      x += share * data_->base[std::size_t(coarse)].x();
      for (const auto& [bone, weight] : data_->skin[std::size_t(coarse)])
        sum[bone] += share * weight;
    }
    const auto strongest = std::max_element(
        sum.begin(), sum.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    segment_.push_back(segment_of_bone(data_->bones[std::size_t(strongest->first)].name));
    side_.push_back(!is_limb(segment_.back()) ? 0 : x > 0 ? 1 : -1);
    fine_skin_.emplace_back(sum.begin(), sum.end());
  }
}

BodyModel BodyModel::load(const std::string& path) { return BodyModel(read_body_data(path)); }

RestBody BodyModel::rest(const BodyParameters& parameters, BodyDetail detail) const {
  std::vector<Vec3> rows = morph_.rows(parameters);
  RestBody rest;
  rest.joints = joint_positions(*data_, rows);
  if (detail == BodyDetail::subdivided) {
    rest.surface = {subdivision_.refine(rows), subdivision_.fine_triangles()};
  } else {
    rows.resize(std::size_t(data_->body_vertices));
    rest.surface = {std::move(rows), coarse_triangles_};
  }
  return rest;
}

Posture BodyModel::rest_posture(const BodyParameters& parameters) const {
  check_parameters(parameters);
  const auto joints = joint_positions(*data_, morph_.rows(parameters));
  return {rest_arm_abduction(*data_, joints), 0, 0};
}

// The underarm of a shirt lies where the fold is when the arms hang, not where it is in an A-pose.
double BodyModel::scye_depth(const RestBody& rest) const {
  const Posture hanging{kHangingArm, 0, 0};
  const auto bones =
      pose_bones(*data_, rest.joints, posture_rotations(*data_, rest.joints, hanging));
  const geometry::TriangleMesh surface{
      carried(blend_bones(bones, fine_skin_), rest.surface.vertices), rest.surface.triangles};
  const auto arm = std::size_t(data_->bone("upperarm01.L"));
  const Vec3 joint = bones[arm] * rest.joints[std::size_t(data_->bones[arm].head)];
  const auto marks = landmark_vertices(*data_, rest);
  const Vec3& acromion = surface.vertices[std::size_t(marks.at("acromion_L"))];
  const Vec3& hps = surface.vertices[std::size_t(marks.at("hps_L"))];
  const Vec3 shoulder = top_at(surface, acromion.x(), hps.z());
  return shoulder.z() - armscye_round(surface, joint).fold;
}

// Measures belong to the shape, not to the posture.
BodyShape BodyModel::measured(RestBody rest) const {
  BodyShape shape;
  shape.measured = BodyTape(*data_, rest).all();
  shape.measured["scye_depth"] = scye_depth(rest);
  shape.landmark_vertex = landmark_vertices(*data_, rest);
  shape.rest = std::move(rest);
  return shape;
}

BodyShape BodyModel::shape(const BodyParameters& parameters) const {
  check_parameters(parameters);
  BodyShape shape = measured(rest(parameters));
  shape.stumps = parameters.stumps;
  if (shape.stumps)
    shape.measured = shape.stumps->without(std::move(shape.measured), shape.rest.surface.vertices);
  return shape;
}

std::vector<Eigen::Affine3d> BodyModel::bones(const RestBody& rest, const Posture& posture) const {
  const Posture clear = with_clear_arms(*data_, rest, {fine_skin_, segment_, side_}, posture);
  return pose_bones(*data_, rest.joints, posture_rotations(*data_, rest.joints, clear));
}

Body BodyModel::build(const BodyParameters& parameters, const Posture& posture) const {
  check_parameters(parameters);
  check_posture(posture);
  return posed(shape(parameters), posture);
}

Body BodyModel::posed(const BodyShape& shape, const Posture& posture) const {
  check_posture(posture);
  return carry(shape, bones(shape.rest, posture), Floor::under_the_feet);
}

std::vector<Vec3> BodyModel::vertices(const BodyShape& shape, const Posture& posture) const {
  check_posture(posture);
  const auto maps = blend_bones(bones(shape.rest, posture), fine_skin_);
  std::vector<Vec3> placed = carried(maps, shape.rest.surface.vertices);
  const Vec3 drop(0, 0, lowest(placed));
  if (shape.stumps) placed = shape.stumps->without(placed, maps);
  for (Vec3& p : placed) p -= drop;
  return placed;
}

Body BodyModel::build(const PosedPerson& person) const {
  check_parameters(person.parameters);
  const BodyShape shape = this->shape(person.parameters);
  auto bones = pose_bones(*data_, shape.rest.joints, person.rotations);
  for (Eigen::Affine3d& bone : bones) bone = Eigen::Affine3d(person.place.matrix()) * bone;
  return carry(shape, bones, Floor::as_placed);
}

Body BodyModel::carry(const BodyShape& shape, const std::vector<Eigen::Affine3d>& bones,
                      Floor floor) const {
  const RestBody& rest = shape.rest;
  Body body;
  body.segment = segment_;
  body.side = side_;
  body.measured = shape.measured;
  body.pose_from_rest = blend_bones(bones, fine_skin_);
  body.surface.triangles = rest.surface.triangles;
  body.surface.vertices = carried(body.pose_from_rest, rest.surface.vertices);

  // Both ends of the map stand on the floor.
  const Vec3 drop(0, 0, floor == Floor::as_placed ? 0 : lowest(body.surface.vertices));
  const Vec3 rest_drop(0, 0, lowest(rest.surface.vertices));
  for (auto& p : body.surface.vertices) p -= drop;
  for (auto& map : body.pose_from_rest) map.col(3) += map.leftCols<3>() * rest_drop - drop;

  // Landmarks are vertices of the skin.
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  body.landmark_vertex = shape.landmark_vertex;
  for (const auto& [name, v] : body.landmark_vertex) {
    body.landmarks[name] = body.surface.vertices[std::size_t(v)];
  }
  // A joint moves with the bone that starts there; both bones of a joint agree on it.
  for (const auto& [name, joint] : joint_indices(*data_)) {
    const auto bone = std::find_if(data_->bones.begin(), data_->bones.end(), [&](const Bone& b) {
      return b.head == joint || b.tail == joint;
    });
    const auto index = std::size_t(bone - data_->bones.begin());
    body.joints[name] = bones[index] * rest.joints[std::size_t(joint)] - drop;
  }
  return shape.stumps ? shape.stumps->without(body, rest_drop.z()) : body;
}

}  // namespace loosefit::body
