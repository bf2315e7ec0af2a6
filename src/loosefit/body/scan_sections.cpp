#include "loosefit/body/scan_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/section.h"

namespace loosefit::body {
namespace {

// Shares of the stature between which folds of standing people lie.
constexpr double kLowestArmpit = 0.60, kHighestArmpit = 0.88;
constexpr double kLowestCrotch = 0.38, kHighestCrotch = 0.56;

std::pair<double, double> x_range(const SectionLoop& loop) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& p : loop.points) low = std::min(low, p.x()), high = std::max(high, p.x());
  return {low, high};
}

std::size_t index_of_side(ScanLimb limb) {
  return limb == ScanLimb::left_arm || limb == ScanLimb::left_leg ? 0 : 1;
}
bool is_arm(ScanLimb limb) { return limb == ScanLimb::left_arm || limb == ScanLimb::right_arm; }
bool is_leg(ScanLimb limb) { return limb == ScanLimb::left_leg || limb == ScanLimb::right_leg; }

/// What most of the loop's vertices belong to.
ScanLimb limb_of(const SectionLoop& loop, const std::vector<ScanLimb>& limbs) {
  std::array<int, 5> votes{};
  for (const auto& e : loop.edges) {
    for (const int v : e) ++votes[std::size_t(limbs[std::size_t(v)])];
  }
  return ScanLimb(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

/// Arms may be several loops each, fingers; legs are one, below them toes are left out. At the top
/// of the thighs most vertices still count as trunk, so legs there go by the crotch.
BodySlice slice_at(const geometry::TriangleMesh& mesh, double z, const ScanLimbs& limbs,
                   const Vec3& crotch, bool near_armpit) {
  BodySlice slice;
  slice.z = z;
  // Sums over the loops of each arm, weighted by length.
  std::array<Vec3, 2> sum = {Vec3::Zero(), Vec3::Zero()};
  std::array<double, 2> length = {0, 0}, leg_length = {0, 0};
  slice.arm_inner.fill(std::numeric_limits<double>::infinity());
  const auto loops = plane_section(mesh, Vec3(0, 0, z), Vec3::UnitZ());
  // Sort the loops: arms, legs below the crotch, and the longest of the rest as trunk.
  const SectionLoop* trunk = nullptr;
  for (const auto& loop : loops) {
    const ScanLimb limb = limb_of(loop, limbs.limb);
    const Vec3 middle = centroid(loop);
    if (is_arm(limb)) {
      const std::size_t side = index_of_side(limb);
      const auto [low, high] = x_range(loop);
      sum[side] += loop.length * middle;
      length[side] += loop.length;
      slice.arm_inner[side] =
          std::min(slice.arm_inner[side], std::min(std::abs(low), std::abs(high)));
    } else if (z < crotch.z()) {
      const auto [low, high] = x_range(loop);
      if (!is_leg(limb) && low < crotch.x() && high > crotch.x() &&
          (!trunk || loop.length > trunk->length))
        trunk = &loop;
      const std::size_t side =
          is_leg(limb) ? index_of_side(limb) : std::size_t(middle.x() > crotch.x() ? 0 : 1);
      if (loop.length <= leg_length[side]) continue;
      leg_length[side] = loop.length;
      slice.leg[side] = middle;
    } else if (!trunk || loop.length > trunk->length) {
      trunk = &loop;
    }
  }
  // At the armpit most vertices of an arm's loop still count as trunk.
  for (const auto& loop : loops) {
    if (!trunk || &loop == trunk || !near_armpit || limb_of(loop, limbs.limb) != ScanLimb::core)
      continue;
    const Vec3 middle = centroid(loop);
    const auto [trunk_low, trunk_high] = x_range(*trunk);
    if (middle.x() > 0.6 * trunk_low && middle.x() < 0.6 * trunk_high) continue;
    const auto [low, high] = x_range(loop);
    const std::size_t side = middle.x() > 0 ? 0 : 1;
    sum[side] += loop.length * middle;
    length[side] += loop.length;
    slice.arm_inner[side] =
        std::min(slice.arm_inner[side], std::min(std::abs(low), std::abs(high)));
  }
  // The slice: middles of the arms, middle, girth and sides of the trunk.
  for (const std::size_t side : {std::size_t(0), std::size_t(1)})
    if (length[side] > 0) slice.arm[side] = sum[side] / length[side];
  if (trunk) {
    slice.trunk = centroid(*trunk);
    slice.girth = hull_perimeter(trunk->points, Vec3::UnitZ());
    const auto [low, high] = x_range(*trunk);
    slice.trunk_side = {std::abs(high), std::abs(low)};
  }
  return slice;
}

bool arms_apart(const BodySlice& slice) { return slice.trunk && slice.arm[0] && slice.arm[1]; }

constexpr char kHowToStand[] =
    "scan the person standing with the arms 15 to 60 degrees away from the trunk and the hands "
    "free, or cut arm and trunk apart in the program that the scan came from, or make a body from "
    "measures instead";

constexpr double kHanging = 60;  // arms raised less are apart from the trunk in level cuts [°]

constexpr double kLeastArm = 0.27;  // from the armpit to the end: to the wrist it is 0.28
constexpr double kLeastLeg = 0.05;  // height at which a leg may end above the floor

/// From the armpit along the skin to the end.
double length_of(const LimbChain& arm) {
  return arm.rings.back().reach - arm.rings.front().reach + (arm.fold - arm.parted).norm();
}

/// A scan with arms to the hands and legs to the floor, as far as they are told apart.
void require_ends(const ScanLimbs& limbs, double height) {
  for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
    const char* name = side == 0 ? "left" : "right";
    const LimbChain &arm = limbs.arm[side], &leg = limbs.leg[side];
    if (!arm.touches && length_of(arm) < kLeastArm * height)
      throw GeometryError(
          fmt::format("found no {} hand: that arm ends {:.2f} m from the armpit, expected at least "
                      "{:.2f} m",
                      name, length_of(arm), kLeastArm * height),
          kHowToStand);
    if (leg.found() && leg.tip.z() > kLeastLeg * height)
      throw GeometryError(fmt::format("found no {} foot: that leg ends {:.2f} m above the floor",
                                      name, leg.tip.z()),
                          kHowToStand);
  }
}

/// A scan whose arms are told from the trunk.
void require_arms(const ScanLimbs& limbs, double height) {
  const auto found = [](const LimbChain& limb) { return limb.found(); };
  if (std::none_of(limbs.arm.begin(), limbs.arm.end(), found) &&
      std::none_of(limbs.leg.begin(), limbs.leg.end(), found))
    throw GeometryError(
        "found a surface without arms and legs, as of a dress form or another thing, expected a "
        "whole standing person",
        "make a body from the measures of the form instead (loosefit body --chest ... --waist "
        "...)");
  if (!limbs.arm[0].found() && !limbs.arm[1].found())
    throw GeometryError(
        "found no arms that are free of the trunk (a trunk alone, or limbs that have grown "
        "together with it)",
        kHowToStand);
  for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
    const LimbChain& arm = limbs.arm[side];
    const char* name = side == 0 ? "left" : "right";
    if (!arm.found()) {
      throw GeometryError(
          fmt::format("found no {} arm that is free of the trunk (one that is hidden, cut off, or "
                      "grown together with the trunk all along)",
                      name),
          kHowToStand);
    }
    if (arm.parted.z() < kLowestArmpit * height || arm.parted.z() > kHighestArmpit * height) {
      throw GeometryError(
          fmt::format("found the {0} arm parting from the body {1:.2f} m above the floor, expected "
                      "the armpit at {2:.2f} to {3:.2f} m: {4}",
                      name, arm.parted.z(), kLowestArmpit * height, kHighestArmpit * height,
                      arm.parted.z() < kLowestArmpit * height
                          ? "above that, arm and trunk are one surface"
                          : "this is hardly a standing person with the arms lowered"),
          kHowToStand);
    }
  }
}

// The slice between two heights with the smallest girth.
double narrowest_level(const std::vector<BodySlice>& slices, double low, double high) {
  const BodySlice* best = nullptr;
  for (const auto& slice : slices) {
    if (slice.z < low || slice.z > high || !slice.trunk) continue;
    if (!best || slice.girth < best->girth) best = &slice;
  }
  return best ? best->z : 0.5 * (low + high);
}

}  // namespace

ScanSections slice_scan(const geometry::TriangleMesh& mesh, const ScanLimbs& limbs) {
  ScanSections found;
  for (const auto& p : mesh.vertices) found.height = std::max(found.height, p.z());
  const double h = found.height;
  require_arms(limbs, h);
  require_ends(limbs, h);
  found.legs_apart = limbs.leg[0].found() && limbs.leg[0].fold.z() > kLowestCrotch * h &&
                     limbs.leg[0].fold.z() < kHighestCrotch * h;
  // Adults 0.47, children less: only used when the legs touch.
  const Vec3 crotch = found.legs_apart ? limbs.leg[0].fold : Vec3(0, 0, 0.47 * h);
  for (int i = 0; i < kSliceCount; ++i) {
    const double level = (i + 0.5) / kSliceCount;
    found.slices.push_back(
        slice_at(mesh, level * h, limbs, crotch, level > kLowestArmpit && level < kHighestArmpit));
  }
  found.crotch = crotch.z();
  found.crotch_x = crotch.x();

  const bool grown = limbs.arm[0].fold.z() > limbs.arm[0].parted.z() ||
                     limbs.arm[1].fold.z() > limbs.arm[1].parted.z();
  found.armpit = 0.5 * (limbs.arm[0].fold.z() + limbs.arm[1].fold.z());
  const double raised = std::max(raised_deg(limbs.arm[0]), raised_deg(limbs.arm[1]));
  if (raised > kHanging) {
    // The armpit rises with the arm; levels of the trunk are counted from where it would be.
    found.armpit -= 0.022 * h * (raised - kHanging) / (90 - kHanging);
  } else if (!grown) {
    for (int i = int(kHighestArmpit * kSliceCount); i > int(kLowestArmpit * kSliceCount); --i) {
      if (!arms_apart(found.slices[std::size_t(i)])) continue;
      const double level = found.slices[std::size_t(i)].z;
      if (std::abs(level - found.armpit) < 0.04 * h) found.armpit = level;
      break;
    }
  }
  found.neck = narrowest_level(found.slices, found.armpit + 0.08 * h, found.armpit + 0.13 * h);
  return found;
}

}  // namespace loosefit::body
