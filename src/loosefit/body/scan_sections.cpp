#include "loosefit/body/scan_sections.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/section.h"

namespace loosefit {
namespace {

Vec3 centroid(const SectionLoop& loop) {
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Vec3& a = loop.points[i];
    const Vec3& b = loop.points[(i + 1) % loop.points.size()];
    sum += (b - a).norm() * 0.5 * (a + b);
    length += (b - a).norm();
  }
  return length > 0 ? Vec3(sum / length) : loop.points[0];
}

std::pair<double, double> x_range(const SectionLoop& loop) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& p : loop.points) low = std::min(low, p.x()), high = std::max(high, p.x());
  return {low, high};
}

// Loops beside the trunk are arms (a hand may be several loops). Where there is no trunk, the
// longest loop of a side is the leg and those further out are the arm.
void add_side(const std::vector<SectionLoop>& loops, const SectionLoop* trunk, int side,
              bool with_arms, BodySlice& slice) {
  const double sign = side == 0 ? 1 : -1;
  std::vector<const SectionLoop*> beside;
  for (const auto& loop : loops) {
    if (&loop != trunk && sign * centroid(loop).x() > 0) beside.push_back(&loop);
  }
  const SectionLoop* leg = nullptr;
  if (!trunk) {
    for (const auto* loop : beside) {
      if (!leg || loop->length > leg->length) leg = loop;
    }
    if (leg) slice.leg[std::size_t(side)] = centroid(*leg);
  }
  if (!with_arms) return;
  double reach = trunk ? slice.trunk_side[std::size_t(side)] * 0.6 : 0;
  if (leg) {
    const auto [low, high] = x_range(*leg);
    reach = std::max(std::abs(low), std::abs(high)) * 0.9;
  }
  Vec3 sum = Vec3::Zero();
  double length = 0;
  double inner = std::numeric_limits<double>::infinity();
  for (const auto* loop : beside) {
    const Vec3 middle = centroid(*loop);
    if (loop == leg || std::abs(middle.x()) < reach) continue;
    sum += loop->length * middle;
    length += loop->length;
    const auto [low, high] = x_range(*loop);
    inner = std::min(inner, std::min(std::abs(low), std::abs(high)));
  }
  if (length > 0) {
    slice.arm[std::size_t(side)] = sum / length;
    slice.arm_inner[std::size_t(side)] = inner;
  }
}

BodySlice slice_at(const TriangleMesh& mesh, double z, bool with_arms) {
  BodySlice slice;
  slice.z = z;
  const auto loops = plane_section(mesh, Vec3(0, 0, z), Vec3::UnitZ());
  const SectionLoop* trunk = trunk_loop(loops);
  if (trunk) {
    slice.trunk = centroid(*trunk);
    slice.girth = hull_perimeter(trunk->points, Vec3::UnitZ());
    const auto [low, high] = x_range(*trunk);
    slice.trunk_side = {std::abs(high), std::abs(low)};
  }
  for (const int side : {0, 1}) add_side(loops, trunk, side, with_arms, slice);
  return slice;
}

bool arms_apart(const BodySlice& slice) { return slice.trunk && slice.arm[0] && slice.arm[1]; }

// The slice between two heights with the largest (sign 1) or smallest (-1) girth.
double extreme_girth(const std::vector<BodySlice>& slices, double low, double high, double sign) {
  const BodySlice* best = nullptr;
  for (const auto& slice : slices) {
    if (slice.z < low || slice.z > high || !slice.trunk) continue;
    if (!best || sign * slice.girth > sign * best->girth) best = &slice;
  }
  return best ? best->z : 0.5 * (low + high);
}

}  // namespace

ScanSections slice_scan(const TriangleMesh& mesh) {
  ScanSections found;
  for (const auto& p : mesh.vertices) found.height = std::max(found.height, p.z());
  const double h = found.height;
  for (int i = 0; i < kSliceCount; ++i) {
    const double level = (i + 0.5) / kSliceCount;
    found.slices.push_back(slice_at(mesh, level * h, level > 0.25));  // below, toes are loops too
  }

  found.crotch = 0.47 * h;  // adults 0.47, children less: only used when the legs touch
  found.legs_apart = false;
  for (int i = int(0.65 * kSliceCount); i > int(0.3 * kSliceCount); --i) {
    if (found.slices[std::size_t(i)].trunk) continue;
    found.crotch = found.slices[std::size_t(i)].z;
    found.legs_apart = true;
    break;
  }
  for (int i = int(0.88 * kSliceCount); i > int(0.6 * kSliceCount); --i) {
    if (!arms_apart(found.slices[std::size_t(i)])) continue;
    found.armpit = found.slices[std::size_t(i)].z;
    break;
  }
  if (found.armpit == 0) {
    throw GeometryError(
        "found no level with both arms apart from the trunk, expected "
        "arms hanging 15 to 65 degrees away from it",
        "scan in an A-pose, or make a body from measures instead");
  }
  found.chest = extreme_girth(found.slices, found.armpit - 0.07 * h, found.armpit - 0.02 * h, 1);
  found.hip = extreme_girth(found.slices, found.crotch + 0.01 * h, found.crotch + 0.10 * h, 1);
  found.waist = extreme_girth(found.slices, found.hip + 0.05 * h, found.chest - 0.05 * h, -1);
  found.neck = extreme_girth(found.slices, found.armpit + 0.08 * h, found.armpit + 0.13 * h, -1);
  return found;
}

}  // namespace loosefit
