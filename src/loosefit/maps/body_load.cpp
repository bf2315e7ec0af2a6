#include "loosefit/maps/body_load.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/body/facing_skin.h"
#include "loosefit/geometry/triangle_mesh.h"
#include "loosefit/maps/gap.h"

namespace loosefit::maps {
namespace {

/// Cosine of the angle between two skins below which they face each other [–]: 107°.
constexpr double kFacing = -0.3;

bool is_arm(body::Segment s) {
  return s == body::Segment::upper_arm || s == body::Segment::forearm || s == body::Segment::hand;
}

bool is_on_arm(const body::Body& body, int triangle) {
  return is_arm(body.segment[body.surface.triangles[triangle][0]]);
}

/// Whether a point of the cloth has skin of an arm on one side and other skin on the other.
bool lies_between(const Vec3& x, const body::BodyPartner& partner, const body::PosedBody& body,
                  double reach) {
  const geometry::TriangleMesh& skin = body->surface;
  const bool on_arm = is_on_arm(body, partner.exact.triangle);
  const auto faces = [&](int t) {
    if (is_on_arm(body, t) == on_arm) return false;
    const auto& [a, b, c] = skin.triangles[t];
    const Vec3 normal =
        geometry::triangle_normal(skin.vertices[a], skin.vertices[b], skin.vertices[c]);
    return normal.dot(partner.normal) < kFacing;
  };
  return body.tree().query(x, reach, faces).triangle >= 0;
}

/// Edge of the equilateral triangle of the mean area [m]; 0 without triangles.
double mean_edge(const garment::Garment& garment, const std::vector<double>& vertex_area) {
  if (garment.triangles.empty()) return 0;
  const double area = std::accumulate(vertex_area.begin(), vertex_area.end(), 0.0);
  return std::sqrt(4 / std::sqrt(3.0) * area / static_cast<double>(garment.triangles.size()));
}

}  // namespace

double BodyLoad::force_over_weight() const {
  return weight > 0 ? normal_force / weight : std::numeric_limits<double>::quiet_NaN();
}

const std::vector<std::string>& limb_names() {
  static const std::vector<std::string> kNames = {
      "trunk", "neck", "legs", "upper_arm_L", "upper_arm_R", "forearm_L", "forearm_R"};
  return kNames;
}

std::string limb_of(body::Region region) {
  using body::Region;
  switch (region) {
    case Region::neck:
      return "neck";
    case Region::thigh_left:
    case Region::thigh_right:
    case Region::shank_left:
    case Region::shank_right:
    case Region::foot_left:
    case Region::foot_right:
      return "legs";
    case Region::upper_arm_left:
      return "upper_arm_L";
    case Region::upper_arm_right:
      return "upper_arm_R";
    case Region::forearm_left:
      return "forearm_L";
    case Region::forearm_right:
      return "forearm_R";
    default:
      return "trunk";
  }
}

BodyLoad body_load(const garment::Garment& garment, const drape::Drape& drape,
                   const WornGarment& worn, const body::PosedBody& body,
                   const fabric::Material& material, double gravity, double least_edge) {
  const auto n = static_cast<std::size_t>(garment.vertex_count);
  if (drape.body_normal_force.size() != n || drape.positions.size() != n ||
      worn.partners.size() != n)
    throw InvalidInput("load on the body: " + std::to_string(drape.body_normal_force.size()) +
                       " normal forces for " + std::to_string(n) + " garment vertices");
  BodyLoad load;
  load.weight = garment.mass * gravity;
  for (const std::string& limb : limb_names()) load.of_limb[limb] = load.free_of_limb[limb] = 0;
  const double reach = 2 * material.thickness +
                       std::max({body::kSkinGap, mean_edge(garment, worn.areas), least_edge});
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const body::BodyPartner& partner = worn.partners[i];
    const double gap = gap_of(worn.distances[i], material);
    area += worn.areas[i];
    for (std::size_t k = 0; k < kNearGaps.size(); ++k)
      if (gap <= kNearGaps[k]) load.near_share[k] += worn.areas[i];
    const double force = drape.body_normal_force[i];
    if (!(force > 0)) continue;
    load.normal_force += force;
    const std::string limb = limb_of(worn.regions[i]);
    load.of_limb[limb] += force;
    if (partner.exact.triangle >= 0 && lies_between(drape.positions[i], partner, body, reach))
      load.between_arm_and_trunk += force;
    else
      load.free_of_limb[limb] += force;
  }
  for (double& share : load.near_share) share = area > 0 ? share / area : 0;
  return load;
}

}  // namespace loosefit::maps
