#include "loosefit/flesh/soft_body.h"

#include <algorithm>
#include <cmath>

#include "loosefit/flesh/soft_skin.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit {
namespace {

constexpr double kStep = 0.2;     ///< largest joint angle of one step on the way [rad]
constexpr double kMargin = 0.05;  ///< of skin round what overlaps that may give way [m]

/// Largest angle by which a joint turns from one posture to the other [rad].
double turn_between(const Posture& a, const Posture& b) {
  return std::max(
      {std::abs(a.arm_abduction - b.arm_abduction), std::abs(a.forward_bend - b.forward_bend),
       std::abs(a.sitting - b.sitting) * kPi / 2, std::abs(a.arm_flexion - b.arm_flexion),
       std::abs(a.elbow_extension - b.elbow_extension), std::abs(a.slouch - b.slouch)});
}

/// What a garment can get between.
bool is_dressed(Segment s) {
  return s == Segment::torso || s == Segment::neck || s == Segment::upper_arm ||
         s == Segment::forearm || s == Segment::thigh;
}

std::vector<std::pair<int, int>> overlaps_of(const Body& body) {
  const auto& triangles = body.surface.triangles;
  auto overlaps = self_intersections(body.surface.vertices, triangles);
  std::erase_if(overlaps, [&](const auto& pair) {
    return !is_dressed(body.segment[triangles[pair.first][0]]) ||
           !is_dressed(body.segment[triangles[pair.second][0]]);
  });
  return overlaps;
}

}  // namespace

std::vector<Vec3> SoftBody::built(const Posture& posture) const {
  return model_.build(parameters_, posture).surface.vertices;
}

const SoftBody::Known& SoftBody::nearest(const Posture& posture) {
  if (known_.empty()) {
    known_.push_back({model_.rest_posture(parameters_), {}, {}});
    rest_ = built(known_.front().posture);
  }
  const auto turn = [&](const Known& known) { return turn_between(known.posture, posture); };
  return *std::min_element(known_.begin(), known_.end(),
                           [&](const Known& a, const Known& b) { return turn(a) < turn(b); });
}

Body SoftBody::in(const Posture& posture) {
  Body body = model_.build(parameters_, posture);
  const auto overlaps = overlaps_of(body);
  if (overlaps.empty()) return body;

  const Known start = nearest(posture);
  const SkinPatch patch = patch_round(body.surface, overlaps, kMargin);
  std::vector<Vec3> surface = built(start.posture);
  const std::vector<Vec3> target = patch.of(surface);
  for (std::size_t i = 0; i < start.vertex.size(); ++i) surface[start.vertex[i]] += start.moved[i];
  SoftSkin skin(patch, patch.of(rest_), patch.of(surface), target);
  const double turn = turn_between(start.posture, posture);
  const int steps = static_cast<int>(std::ceil(turn / kStep));
  std::vector<Vec3> moved(patch.vertex.size());
  const auto go = [&](const Posture& to, const std::vector<Vec3>& to_surface) {
    skin.follow(patch.of(to_surface));
    for (std::size_t i = 0; i < moved.size(); ++i)
      moved[i] = skin.positions()[i] - skin.target()[i];
    known_.push_back({to, patch.vertex, moved});
  };
  for (int k = 1; k < steps; ++k) {
    const Posture between = blend(start.posture, posture, double(k) / steps);
    go(between, built(between));
  }
  if (steps > 0)
    go(posture, body.surface.vertices);
  else
    moved = start.moved;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const int v = patch.vertex[i];
    body.surface.vertices[v] += moved[i];
    body.pose_from_rest[v].col(3) += moved[i];
  }
  body.normals = vertex_normals(body.surface.vertices, body.surface.triangles);
  for (const auto& [name, v] : body.landmark_vertex)
    body.landmarks[name] = body.surface.vertices[static_cast<std::size_t>(v)];
  return body;
}

}  // namespace loosefit
