#include "loosefit/render/form_extent.h"

#include <algorithm>
#include <limits>

#include "loosefit/render/garment_lines.h"

namespace loosefit::render {
namespace {

constexpr double kLeastLength = 0.1;   // of a garment, from its top to a hem [m]
constexpr double kCrotchDepth = 0.09;  // below the joints of the hips, where no landmark says [m]
constexpr double kBelowCrotch = 0.04;  // what reaches farther needs legs [m]
constexpr double kAboveHead = 0.03;    // above the joint of the head a hood reaches [m]
constexpr double kFewVertices = 0.01;  // of the cloth, which do not count
constexpr double kOnlyBelow = 0.55;    // of the trunk: trousers and skirts end below

std::optional<Vec3> joint(const body::Body& body, const std::string& name) {
  const auto found = body.joints.find(name);
  return found == body.joints.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

bool on_leg(body::Segment s) {
  return s == body::Segment::thigh || s == body::Segment::shank || s == body::Segment::foot;
}

/// What part of the body is nearest.
class NearestPart {
 public:
  NearestPart(const body::Body& body, const geometry::ClosestPointTree& skin)
      : body_(body), tree_(skin) {}
  int vertex(const Vec3& p) const {
    const geometry::ClosestPoint at = tree_.query(p);
    Eigen::Index corner = 0;
    at.barycentric.maxCoeff(&corner);
    return body_.surface.triangles[at.triangle][corner];
  }
  body::Segment segment(const Vec3& p) const { return body_.segment[vertex(p)]; }

 private:
  const body::Body& body_;
  const geometry::ClosestPointTree& tree_;
};

/// A thigh from the joint of the hip on.
struct Thigh {
  Vec3 hip, along;
  double crotch;  ///< how far along it the legs part [m]
};

std::optional<Thigh> thigh_of(const body::Body& body, const char* suffix) {
  const auto hip = joint(body, std::string("hip") + suffix);
  const auto knee = joint(body, std::string("knee") + suffix);
  if (!hip || !knee || *hip == *knee) return {};
  Thigh thigh{*hip, (*knee - *hip).normalized(), kCrotchDepth};
  if (const auto found = body.landmarks.find("crotch"); found != body.landmarks.end())
    thigh.crotch = std::max(thigh.crotch, (found->second - *hip).dot(thigh.along));
  return thigh;
}

/// Which parts of the body cloth covers more than a little of.
void find_parts(const body::Body& body, const NearestPart& nearest, const std::vector<Vec3>& cloth,
                FormExtent& extent) {
  const auto neck = joint(body, "neck"), head = joint(body, "head");
  const std::optional<Thigh> left = thigh_of(body, "_L"), right = thigh_of(body, "_R");
  int on_legs = 0, on_head = 0;
  for (const Vec3& p : cloth) {
    const int v = nearest.vertex(p);
    const body::Segment segment = body.segment[v];
    if (segment == body::Segment::head && neck && head && *neck != *head)
      on_head += (p - *head).dot((*head - *neck).normalized()) > kAboveHead;
    else if (segment == body::Segment::shank || segment == body::Segment::foot)
      ++on_legs;
    else if (const auto& thigh = body.side[v] >= 0 ? left : right;
             segment == body::Segment::thigh && thigh)
      on_legs += (p - thigh->hip).dot(thigh->along) > thigh->crotch + kBelowCrotch;
  }
  const double few = kFewVertices * static_cast<double>(cloth.size());
  extent.legs |= on_legs > few;
  extent.head |= on_head > few;
}

double highest(const std::vector<Vec3>& cloth, const Vec3& axis) {
  double top = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : cloth) top = std::max(top, p.dot(axis));
  return top;
}

/// `below`: where edges are no waist or neck. Nothing for a garment without such edges.
std::optional<Hem> find_hem(const NearestPart& nearest, const garment::Garment& garment,
                            const std::vector<Vec3>& positions, const Vec3& axis, double below) {
  Hem hem{0, std::numeric_limits<double>::infinity()};
  int count = 0;
  for (const auto& edge : garment_lines(garment).boundary) {
    const Vec3& p = positions[edge[0]];
    if (p.dot(axis) >= below) continue;
    const body::Segment segment = nearest.segment(p);
    if (segment != body::Segment::torso && !on_leg(segment)) continue;
    hem.mean += p.dot(axis);
    hem.lowest = std::min(hem.lowest, p.dot(axis));
    ++count;
  }
  if (count == 0) return {};
  hem.mean /= count;
  return hem;
}

}  // namespace

FormExtent form_extent(const body::Body& body, const geometry::ClosestPointTree& skin,
                       const garment::Garment& garment, const std::vector<Vec3>& positions,
                       const std::vector<Vec3>& under) {
  FormExtent extent;
  double top = 0;
  for (const Vec3& p : body.surface.vertices) top = std::max(top, p.z());
  const auto left = joint(body, "hip_L"), right = joint(body, "hip_R");
  extent.hips = left && right ? Vec3(0.5 * (*left + *right)) : Vec3(0, 0, 0.5 * top);
  extent.nape = joint(body, "neck").value_or(Vec3(0, 0, 0.85 * top));
  extent.axis = (extent.nape - extent.hips).normalized();

  const NearestPart nearest(body, skin);
  find_parts(body, nearest, positions, extent);
  find_parts(body, nearest, under, extent);
  const auto level = [&](double share) {
    return (extent.hips + share * (extent.nape - extent.hips)).dot(extent.axis);
  };
  const double cloth_top = highest(positions, extent.axis);
  extent.arms = std::max(cloth_top, highest(under, extent.axis)) >= level(kOnlyBelow);
  extent.hem = find_hem(nearest, garment, positions, extent.axis,
                        std::min(level(0.5), cloth_top - kLeastLength));
  return extent;
}

}  // namespace loosefit::render
