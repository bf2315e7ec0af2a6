#include "loosefit/pipeline/carry_with_scan.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace loosefit::pipeline {
namespace {

struct Box {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;
  void take(const Vec3& p) { lower = lower.cwiseMin(p), upper = upper.cwiseMax(p); }
};

/// Smallest share, over the axes, of the shorter of two extents that both have in common.
double common_share(const Box& pattern, const Box& body) {
  double least = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double common = std::min(pattern.upper[axis], body.upper[axis]) -
                          std::max(pattern.lower[axis], body.lower[axis]);
    const double shorter =
        std::min(pattern.upper[axis] - pattern.lower[axis], body.upper[axis] - body.lower[axis]);
    least = std::min(least, shorter > 0 ? common / shorter : 0);
  }
  return least;
}

Box box_of_panels(const pattern::Pattern& pattern, const body::RigidMotion& motion) {
  Box box;
  for (const pattern::Panel& panel : pattern.panels)
    for (const Vec2& v : panel.vertices)
      box.take(motion * (panel.rotation * Vec3(v.x(), v.y(), 0) + panel.translation));
  return box;
}

/// How far panels lie beside the middle of the person, in whose frame all is, or are turned against
/// her [m].
double misfit(const pattern::Pattern& pattern, const body::RigidMotion& motion, const Box& person) {
  const Box panels = box_of_panels(pattern, motion);
  const double aside = 0.5 * (panels.lower + panels.upper - person.lower - person.upper).x();
  // Panels lie before, behind and beside a person: four directions that count as one.
  std::complex<double> sum = 0;
  for (const pattern::Panel& panel : pattern.panels) {
    const Vec3 n = motion.linear() * panel.rotation.col(2);
    sum += std::pow(std::complex<double>(n.x(), n.y()), 4);
  }
  constexpr double kArm = 0.3;  // at which a turn counts as a shift [m]
  const double turn = std::abs(sum) > 1e-9 ? std::arg(sum) / 4 : 0;
  return std::abs(aside) + kArm * std::abs(turn);
}

}  // namespace

void carry_with_scan(pattern::Pattern& pattern, const body::Body& body,
                     std::vector<std::string>& warnings) {
  constexpr double kRound = 0.5;
  constexpr double kTurn = 1, kShift = 0.02;  // what shows in a placement [°], [m]
  const body::RigidMotion& motion = body.from_world;
  if (motion.isApprox(body::RigidMotion::Identity(), 1e-12)) return;
  Box person;
  for (const Vec3& p : body.surface.vertices) person.take(p);
  const double moved = common_share(box_of_panels(pattern, motion), person);
  const double unmoved =
      common_share(box_of_panels(pattern, body::RigidMotion::Identity()), person);
  const bool either = moved >= kRound && unmoved >= kRound;
  const bool lies_better =
      either && misfit(pattern, body::RigidMotion::Identity(), person) + kShift <
                    misfit(pattern, motion, person);
  if ((moved < kRound && unmoved >= kRound) || lies_better) {
    warnings.push_back(fmt::format(
        "the panels are not {} the scan in the coordinates of its file: they are taken as placed "
        "for a person who stands over the origin",
        lies_better ? "straight before and behind" : "round"));
    return;
  }
  const double turned = degrees(Eigen::AngleAxisd(motion.linear()).angle());
  const double shift = motion.translation().head<2>().norm();
  if (either && (turned > kTurn || shift > kShift))
    warnings.push_back(fmt::format(
        "the panels are carried with the scan (turned by {:.0f} degrees, moved by {:.2f} m "
        "over the floor), but are round a person over the origin too: if they lie back to front "
        "or beside their place, turn the scan in its file to face -y (with y up: +z) over the "
        "origin",
        turned, shift));
  for (pattern::Panel& panel : pattern.panels) {
    panel.translation = motion * panel.translation;
    panel.rotation = motion.linear() * panel.rotation;
  }
}

}  // namespace loosefit::pipeline
