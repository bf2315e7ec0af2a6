#include "loosefit/render/fill_clefts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "loosefit/body/section.h"

namespace loosefit::render {
namespace {

constexpr double kStep = 0.01;         // between sections [m]
constexpr double kFadeBelow = 0.03;    // from the crotch upwards [m]
constexpr double kFadeAbove = 0.08;    // from where the arms join upwards [m]
constexpr double kThighOutside = 0.4;  // cosine to the trunk beyond which a thigh is not lifted
constexpr double kDeepest = 0.2;       // below the hips' joints there is no trunk [m]
constexpr int kAngles = 90;

/// Across the trunk: its axis and two directions square to it.
struct Frame {
  Vec3 axis, right, back;
};

/// The hull of a section as distances from a point inside.
struct HullRing {
  Vec3 centre;
  bool with_arms = false;  ///< the section goes through arms, too; the hull does not
  std::array<double, kAngles> radius;

  double at(double angle) const {
    const double place = (angle / (2 * kPi) + 1) * kAngles;
    const int i = static_cast<int>(std::floor(place));
    const double share = place - i;
    return (1 - share) * radius[i % kAngles] + share * radius[(i + 1) % kAngles];
  }
};

/// Where the ray from the origin leaves a convex polygon that has the origin inside.
double ray_length(const std::vector<Vec2>& hull, const Vec2& ray) {
  double length = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], edge = hull[(i + 1) % hull.size()] - a;
    const double across = edge.y() * ray.x() - edge.x() * ray.y();
    if (across <= 0) continue;
    const double share = (a.x() * ray.y() - a.y() * ray.x()) / across;
    if (share < 0 || share > 1) continue;
    length = std::max(length, (a + share * edge).dot(ray));
  }
  return length;
}

bool on_arm(body::Segment s) {
  return s == body::Segment::upper_arm || s == body::Segment::forearm || s == body::Segment::hand;
}

/// The loop round a point of the trunk's axis, without arms; none where there is too little of it.
std::optional<HullRing> hull_ring(const body::Body& body, const geometry::TriangleMesh& surface,
                                  const Frame& frame, const Vec3& centre) {
  const std::vector<body::SectionLoop> loops = body::plane_section(surface, centre, frame.axis);
  const auto found = std::ranges::find_if(
      loops, [&](const auto& loop) { return body::loop_contains(loop, frame.axis, centre); });
  if (found == loops.end()) return {};
  body::SectionLoop trunk;
  for (std::size_t i = 0; i < found->points.size(); ++i)
    if (std::ranges::none_of(found->edges[i], [&](int v) { return on_arm(body.segment[v]); }))
      trunk.points.push_back(found->points[i]);
  if (trunk.points.size() < 3) return {};
  HullRing ring{body::centroid(trunk), trunk.points.size() < found->points.size(), {}};
  std::vector<Vec2> flat;
  for (const Vec3& p : trunk.points)
    flat.emplace_back((p - ring.centre).dot(frame.right), (p - ring.centre).dot(frame.back));
  const std::vector<Vec2> hull = body::convex_hull(std::move(flat));
  for (int i = 0; i < kAngles; ++i) {
    const double angle = 2 * kPi * i / kAngles;
    ring.radius[i] = ray_length(hull, {std::cos(angle), std::sin(angle)});
  }
  return ring;
}

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

}  // namespace

std::vector<Vec3> fill_clefts(const body::Body& body, const geometry::TriangleMesh& surface) {
  std::vector<Vec3> places = surface.vertices;
  for (const char* name : {"hip_L", "hip_R", "neck"})
    if (!body.joints.contains(name)) return places;
  const Vec3 hips = 0.5 * (body.joints.at("hip_L") + body.joints.at("hip_R"));
  const Vec3 to_nape = body.joints.at("neck") - hips;
  if (to_nape.norm() < kFadeAbove) return places;
  Frame frame;
  frame.axis = to_nape.normalized();
  const Vec3 aside = body.joints.at("hip_R") - body.joints.at("hip_L");
  frame.right = (aside - aside.dot(frame.axis) * frame.axis).normalized();
  if (!(frame.right.norm() > 0.5)) return places;
  frame.back = frame.axis.cross(frame.right);

  // Sections from the hips' joints both ways, until the legs part or well above the armpits.
  std::vector<HullRing> rings;
  double lowest = 0, armpits = to_nape.norm();
  for (double level = 0; level < std::min(to_nape.norm(), armpits + kFadeAbove); level += kStep) {
    const auto ring = hull_ring(body, surface, frame, hips + level * frame.axis);
    if (!ring) break;
    if (ring->with_arms) armpits = std::min(armpits, level);
    rings.push_back(*ring);
  }
  for (int step = 1; step * kStep < kDeepest; ++step) {
    const auto ring = hull_ring(body, surface, frame, hips - step * kStep * frame.axis);
    if (!ring || ring->with_arms) break;
    rings.insert(rings.begin(), *ring);
    lowest = -step * kStep;
  }
  if (rings.size() < 3) return places;
  const double highest = lowest + kStep * static_cast<double>(rings.size() - 1);

  // Thighs that are lifted leave the trunk's sections as chairs do.
  std::array<bool, 2> thigh_hangs = {false, false};
  for (const bool left : {true, false}) {
    const auto knee = body.joints.find(left ? "knee_L" : "knee_R");
    if (knee == body.joints.end()) continue;
    const Vec3 along = (knee->second - body.joints.at(left ? "hip_L" : "hip_R")).normalized();
    thigh_hangs[left] = -along.dot(frame.axis) > kThighOutside;
  }
  for (std::size_t v = 0; v < places.size(); ++v) {
    const body::Segment segment = body.segment[v];
    const bool thigh = segment == body::Segment::thigh && thigh_hangs[body.side[v] >= 0];
    if (segment != body::Segment::torso && !thigh) continue;
    const double level = (places[v] - hips).dot(frame.axis);
    const double place = (level - lowest) / kStep;
    if (place <= 0 || place >= static_cast<double>(rings.size() - 1)) continue;
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    const Vec3 from = places[v] - ((1 - share) * rings[i].centre + share * rings[i + 1].centre);
    const Vec2 flat(from.dot(frame.right), from.dot(frame.back));
    const double angle = std::atan2(flat.y(), flat.x()), length = flat.norm();
    const double wanted = (1 - share) * rings[i].at(angle) + share * rings[i + 1].at(angle);
    if (length < 1e-3 || wanted <= length) continue;
    const double fade =
        smooth_step((level - lowest) / kFadeBelow) * smooth_step((highest - level) / kFadeAbove);
    places[v] +=
        fade * (wanted - length) / length * (flat.x() * frame.right + flat.y() * frame.back);
  }
  return places;
}

}  // namespace loosefit::render
