#include "loosefit/body/person_variables.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

namespace loosefit::body {
namespace {

struct Knob {
  const char* name;
  double BodyParameters::*value;
  double low, high, spread, difference;
};
constexpr Knob kKnobs[] = {{"sex", &BodyParameters::sex, 0, 1, 0.4, 0.02},
                           {"age", &BodyParameters::age, 3, 80, 12, 1},
                           {"muscle", &BodyParameters::muscle, 0, 1, 0.25, 0.02},
                           {"weight", &BodyParameters::weight, 0, 1.6, 0.3, 0.02},
                           {"height", &BodyParameters::height, 0, 1, 0.3, 0.02},
                           {"proportions", &BodyParameters::proportions, 0, 1, 0.25, 0.02},
                           {"cup", &BodyParameters::cup, 0, 1, 0.25, 0.02}};

constexpr double kLocalSpread = 0.35, kLocalDifference = 0.02;

// Rotation vectors of these bones; usual size of each component about x, y and z [rad].
struct Joint {
  const char* bone;
  bool paired;
  double x, y, z;
};
constexpr Joint kJoints[] = {
    {"spine04", false, 0.10, 0.06, 0.06},   {"spine02", false, 0.10, 0.06, 0.06},
    {"neck01", false, 0.15, 0.08, 0.08},    {"head", false, 0.15, 0.08, 0.10},
    {"clavicle", true, 0.03, 0.12, 0.12},   {"upperarm01", true, 0.25, 0.30, 0.25},
    {"upperarm02", true, 0.20, 0, 0.20},    {"lowerarm01", true, 0.25, 0.25, 0.25},
    {"lowerarm02", true, 0, 0, 0.25},       {"wrist", true, 0.25, 0.25, 0.25},
    {"upperleg01", true, 0.12, 0.12, 0.10}, {"lowerleg01", true, 0.10, 0.04, 0.06},
    {"foot", true, 0.15, 0.10, 0.20}};
constexpr double kMostTurn = 1.6;  // of one component of a joint [rad]

Mat3 turn(const Vec3& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

}  // namespace

PersonVariables::PersonVariables(const BodyData& data, PosedPerson start)
    : start_(std::move(start)) {
  for (const Knob& knob : kKnobs)
    variables_.push_back({Kind::shape, knob.name, 0, start_.parameters.*knob.value, knob.low,
                          knob.high, knob.spread, knob.difference});
  for (const DetailTarget& target : detail_targets()) {
    const auto found = start_.parameters.details.find(target.key);
    const double value = found == start_.parameters.details.end() ? 0 : found->second;
    variables_.push_back(
        {Kind::shape, target.key, 0, value, -1, 1, kLocalSpread, kLocalDifference});
  }
  for (const Joint& joint : kJoints) {
    const double spread[3] = {joint.x, joint.y, joint.z};
    for (const char* side : {".L", ".R"}) {
      if (!joint.paired && side[1] == 'R') continue;
      const std::string bone = std::string(joint.bone) + (joint.paired ? side : "");
      data.bone(bone);  // throws for a name that the rig does not have
      for (int axis = 0; axis < 3; ++axis)
        if (spread[axis] > 0)
          variables_.push_back(
              {Kind::bone, bone, axis, 0, -kMostTurn, kMostTurn, spread[axis], 0.01});
    }
  }
  for (int axis = 0; axis < 3; ++axis)
    variables_.push_back({Kind::turn, "", axis, 0, -1, 1, axis == 2 ? 0.3 : 0.1, 0.01});
  for (int axis = 0; axis < 3; ++axis)
    variables_.push_back({Kind::shift, "", axis, 0, -1, 1, 0.1, 0.005});
}

Eigen::VectorXd PersonVariables::clamped(Eigen::VectorXd x) const {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Variable& v = variables_[std::size_t(i)];
    x[i] = std::clamp(x[i], v.low - v.start, v.high - v.start);
  }
  return x;
}

PosedPerson PersonVariables::at(const Eigen::VectorXd& x) const {
  PosedPerson person = start_;
  std::map<std::string, Vec3> turns;
  Vec3 whole = Vec3::Zero(), shift = Vec3::Zero();
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const Variable& v = variables_[i];
    const double change = x[Eigen::Index(i)];
    if (v.kind == Kind::turn) whole[v.axis] = change;
    if (v.kind == Kind::shift) shift[v.axis] = change;
    if (v.kind == Kind::bone)
      turns.try_emplace(v.name, Vec3::Zero()).first->second[v.axis] = change;
    if (v.kind != Kind::shape) continue;
    const auto* knob =
        std::ranges::find_if(kKnobs, [&](const Knob& k) { return v.name == k.name; });
    if (knob != std::end(kKnobs))
      person.parameters.*(knob->value) = v.start + change;
    else
      person.parameters.details[v.name] = v.start + change;
  }
  for (const auto& [bone, vector] : turns) {
    Mat3& rotation = person.rotations.try_emplace(bone, Mat3::Identity()).first->second;
    rotation = turn(vector) * rotation;
  }
  RigidMotion moved = RigidMotion::Identity();
  moved.linear() = turn(whole);
  moved.translation() = shift;
  person.place = moved * start_.place;
  return person;
}

}  // namespace loosefit::body
