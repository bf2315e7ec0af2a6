#include "loosefit/body/regions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace loosefit::body {
namespace {

struct Named {
  Region region;
  const char* name;
};

// In the order of the enum.
constexpr Named kNames[] = {
    {Region::upper_back, "upper_back"},
    {Region::mid_back, "mid_back"},
    {Region::lower_back, "lower_back"},
    {Region::scapula_left, "scapula_L"},
    {Region::scapula_right, "scapula_R"},
    {Region::chest, "chest"},
    {Region::abdomen, "abdomen"},
    {Region::side_left, "side_L"},
    {Region::side_right, "side_R"},
    {Region::shoulder_left, "shoulder_L"},
    {Region::shoulder_right, "shoulder_R"},
    {Region::hips, "hips"},
    {Region::thigh_left, "thigh_L"},
    {Region::thigh_right, "thigh_R"},
    {Region::shank_left, "shank_L"},
    {Region::shank_right, "shank_R"},
    {Region::foot_left, "foot_L"},
    {Region::foot_right, "foot_R"},
    {Region::upper_arm_left, "upper_sleeve_L"},
    {Region::upper_arm_right, "upper_sleeve_R"},
    {Region::forearm_left, "forearm_sleeve_L"},
    {Region::forearm_right, "forearm_sleeve_R"},
    {Region::neck, "neck"},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (static_cast<std::size_t>(kNames[i].region) != i) return false;
  return std::size(kNames) == static_cast<std::size_t>(Region::neck) + 1;
}
static_assert(in_order());

/// Levels and places that separate the regions of the trunk, in rest posture.
struct Anchors {
  double c7, waist, underbust, armpit, hip, crotch;  ///< heights [m]
  Vec3 scapula_left, scapula_right;
  double scapula_radius;
};

std::vector<Vec3> in_rest(const Body& body, const std::vector<Vec3>& posed) {
  if (body.pose_from_rest.size() != posed.size()) return posed;
  std::vector<Vec3> rest(posed.size());
  for (std::size_t v = 0; v < posed.size(); ++v) {
    const auto& pose = body.pose_from_rest[v];
    rest[v] = pose.leftCols<3>().inverse() * (posed[v] - pose.col(3));
  }
  return rest;
}

Anchors find_anchors(const Body& body, const std::vector<Vec3>& rest) {
  double floor = rest[0].z(), top = rest[0].z();
  for (const Vec3& p : rest) {
    floor = std::min(floor, p.z());
    top = std::max(top, p.z());
  }
  const double height = top - floor;
  const auto level = [&](const char* key, double share) {
    const auto found = body.measured.find(key);
    return floor + (found != body.measured.end() ? found->second : share * height);
  };
  const auto landmark = [&](const char* key, const Vec3& otherwise) -> Vec3 {
    const auto found = body.landmark_vertex.find(key);
    return found != body.landmark_vertex.end() ? rest[found->second] : otherwise;
  };
  // Shares of stature: Drillis and Contini 1966 and body-model means.
  Anchors a{};
  a.c7 = landmark("c7", {0, 0, floor + 0.85 * height}).z();
  a.waist = landmark("back_waist", {0, 0, level("waist_level", 0.62)}).z();
  a.underbust = level("underbust_level", 0.69);
  a.armpit = level("armpit_level", 0.75);
  a.hip = level("hip_level", 0.51);
  a.crotch = landmark("crotch", {0, 0, floor + 0.47 * height}).z();
  const double back = a.c7 - a.waist;
  const double behind = 0.06 * height, beside = 0.045 * height, blade = a.c7 - 0.25 * back;
  a.scapula_left = landmark("scapula_L", {beside, behind, blade});
  a.scapula_right = landmark("scapula_R", {-beside, behind, blade});
  a.scapula_radius = back / 6;
  return a;
}

Region trunk_region(const Vec3& p, const Vec3& normal, const Anchors& a) {
  if (p.z() < a.hip) return Region::hips;
  const bool left = p.x() >= 0, behind = normal.y() > 0;
  if (p.z() > a.armpit && normal.z() > 0.6)
    return left ? Region::shoulder_left : Region::shoulder_right;
  if (behind) {
    if ((p - a.scapula_left).norm() < a.scapula_radius) return Region::scapula_left;
    if ((p - a.scapula_right).norm() < a.scapula_radius) return Region::scapula_right;
  }
  if (p.z() < a.armpit && std::abs(normal.x()) > std::abs(normal.y()))
    return left ? Region::side_left : Region::side_right;
  if (!behind) return p.z() > a.underbust ? Region::chest : Region::abdomen;
  const double down = (a.c7 - p.z()) / (a.c7 - a.waist);
  return down < 1.0 / 3   ? Region::upper_back
         : down < 2.0 / 3 ? Region::mid_back
                          : Region::lower_back;
}

}  // namespace

const std::vector<Region>& all_regions() {
  static const std::vector<Region> regions = [] {
    std::vector<Region> all;
    for (const Named& named : kNames) all.push_back(named.region);
    return all;
  }();
  return regions;
}

std::string name(Region region) { return kNames[static_cast<std::size_t>(region)].name; }

std::vector<std::string> region_names() {
  std::vector<std::string> names;
  for (const Named& named : kNames) names.emplace_back(named.name);
  return names;
}

std::optional<Region> find_region(const std::string& name) {
  for (const Named& named : kNames)
    if (named.name == name) return named.region;
  return std::nullopt;
}

std::vector<Region> body_regions(const Body& body) {
  const std::vector<Vec3>& posed = body.surface.vertices;
  if (posed.empty()) return {};
  // Regions belong to the skin, so heights are taken in rest posture.
  const std::vector<Vec3> rest = in_rest(body, posed);
  const std::vector<Vec3> normals = geometry::vertex_normals(rest, body.surface.triangles);
  const Anchors anchors = find_anchors(body, rest);
  std::vector<Region> regions(posed.size());
  for (std::size_t v = 0; v < posed.size(); ++v) {
    const bool left = body.side[v] >= 0;
    // Limbs and head by segment; trunk and the top of the thighs by place.
    switch (body.segment[v]) {
      case Segment::head:
      case Segment::neck:
        regions[v] = Region::neck;
        break;
      case Segment::upper_arm:
        regions[v] = left ? Region::upper_arm_left : Region::upper_arm_right;
        break;
      case Segment::forearm:
      case Segment::hand:
        regions[v] = left ? Region::forearm_left : Region::forearm_right;
        break;
      case Segment::torso:
        regions[v] = trunk_region(rest[v], normals[v], anchors);
        break;
      case Segment::thigh:
        regions[v] = rest[v].z() >= anchors.crotch ? Region::hips
                     : left                        ? Region::thigh_left
                                                   : Region::thigh_right;
        break;
      case Segment::shank:
        regions[v] = left ? Region::shank_left : Region::shank_right;
        break;
      case Segment::foot:
        regions[v] = left ? Region::foot_left : Region::foot_right;
        break;
    }
  }
  return regions;
}

Region region_of(const std::vector<Region>& body_regions, const geometry::TriangleMesh& surface,
                 const geometry::ClosestPoint& partner) {
  int corner = 0;
  partner.barycentric.maxCoeff(&corner);
  return body_regions[surface.triangles[partner.triangle][corner]];
}

}  // namespace loosefit::body
