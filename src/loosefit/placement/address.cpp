#include "loosefit/placement/address.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/body/stumps.h"
#include "loosefit/placement/ray.h"

namespace loosefit::placement {
namespace {

constexpr double kOnSkin = 5e-4;    // [m]
constexpr double kOnAxis = 1.0;     // nearer to the middle there is no direction [%]
constexpr double kShortest = 1e-3;  // least distance of the landmarks of an axis [m]

/// Landmarks at which the ratios of one axis are 0 and 100.
using Limits = std::array<std::pair<Vec3, Vec3>, 3>;

std::optional<SegmentAxes> make(const Mat3& axes, const Limits& limits) {
  SegmentAxes made;
  made.axes = axes;
  for (int k = 0; k < 3; ++k) {
    made.low[k] = axes.col(k).dot(limits[k].first);
    made.high[k] = axes.col(k).dot(limits[k].second);
    if (!(made.high[k] - made.low[k] > kShortest)) return std::nullopt;
  }
  return made;
}

Mat3 columns(const Vec3& x, const Vec3& y, const Vec3& z) {
  Mat3 m;
  m << x, y, z;
  return m;
}

std::string sided(const char* name, int side) {
  return std::string(name) + (side > 0 ? "_L" : "_R");
}

std::string place_text(const Vec3& percent) {
  const auto tenth = [](double x) { return std::round(10 * x) / 10 + 0.0; };
  return fmt::format("[{:g}, {:g}, {:g}]", tenth(percent.x()), tenth(percent.y()),
                     tenth(percent.z()));
}

}  // namespace

const std::vector<BodySegment>& all_body_segments() {
  static const std::vector<BodySegment> kAll = {BodySegment::chest,     BodySegment::abdomen,
                                                BodySegment::upper_arm, BodySegment::forearm,
                                                BodySegment::thigh,     BodySegment::lower_leg};
  return kAll;
}

std::string name(BodySegment segment) {
  static const char* kNames[] = {"chest", "abdomen", "upper_arm", "forearm", "thigh", "lower_leg"};
  return kNames[static_cast<int>(segment)];
}

bool has_side(BodySegment segment) {
  return segment != BodySegment::chest && segment != BodySegment::abdomen;
}

std::string BodyAddress::str() const {
  const std::string which = side > 0 ? "left " : side < 0 ? "right " : "";
  return which + name(segment) + " " + place_text(percent);
}

Vec3 SegmentAxes::percent(const Vec3& point) const {
  return 100 * (axes.transpose() * point - low).cwiseQuotient(high - low);
}

Vec3 SegmentAxes::point(const Vec3& percent) const {
  return axes * (low + (high - low).cwiseProduct(percent) / 100);
}

BodyAddresses::BodyAddresses(const body::Body& body) : body_(body), landmarks_(body.landmarks) {
  landmarks_.merge(address_landmarks(body));
}

std::optional<SegmentAxes> BodyAddresses::axes(BodySegment segment, int side) const {
  // Looks up a landmark; one that is missing makes an axis without length.
  const auto at = [this](const std::string& name) {
    const auto found = landmarks_.find(name);
    return found == landmarks_.end() ? Vec3(Vec3::Constant(std::nan(""))) : found->second;
  };
  const auto of = [&](const char* name) { return at(sided(name, side)); };
  // Across a limb from the wearer's left to the right.
  const auto across = [&](const char* medial, const char* lateral) {
    return side > 0 ? std::pair(of(lateral), of(medial)) : std::pair(of(medial), of(lateral));
  };
  // Chest and abdomen: the axes of the trunk between landmarks of both sides.
  if (!has_side(segment)) {
    const auto trunk = trunk_axes(body_);
    if (!trunk) return std::nullopt;
    if (segment == BodySegment::chest)
      return make(columns(trunk->right, trunk->front, trunk->down),
                  {{{at("acromion_L"), at("acromion_R")},
                    {at("c7"), at("xiphoid")},
                    {at("c7"), at("xiphoid")}}});
    return make(columns(trunk->right, -trunk->front, -trunk->down),
                {{{at("asis_L"), at("asis_R")},
                  {(at("asis_L") + at("asis_R")) / 2, at("psis")},
                  {at("front_waist"), at("xiphoid")}}});
  }
  // Limbs: long axis towards the trunk, x from the wearer's left to the right.
  const bool arm = segment == BodySegment::upper_arm || segment == BodySegment::forearm;
  const auto limb = arm ? arm_of(body_, side) : leg_of(body_, side);
  if (!limb) return std::nullopt;
  const bool upper = segment == BodySegment::upper_arm || segment == BodySegment::thigh;
  const Vec3 down = upper ? limb->upper : limb->lower;
  const Vec3 right = (limb->across - limb->across.dot(down) * down).normalized();
  const Mat3 axes = columns(right, right.cross(down), -down);
  const Vec3 far = upper ? limb->joint : body_.joints.at(sided(arm ? "wrist" : "ankle", side));
  // Each axis runs from 0 to 100 % between two landmarks.
  switch (segment) {
    case BodySegment::upper_arm:
      return make(axes, {{across("epicondyle_medial", "epicondyle_lateral"),
                          {of("olecranon"), of("cubital_fossa")},
                          {far, of("acromion")}}});
    case BodySegment::forearm:
      return make(axes, {{across("wrist_medial", "wrist_lateral"),
                          {of("olecranon"), of("cubital_fossa")},
                          {far, of("epicondyle_lateral")}}});
    case BodySegment::thigh:
      return make(axes, {{across("knee_medial", "knee_lateral"),
                          {of("popliteal"), of("patella")},
                          {far, of("trochanter")}}});
    default:
      return make(axes, {{across("malleolus_medial", "malleolus_lateral"),
                          {of("popliteal"), of("patella")},
                          {far, of("patella")}}});
  }
}

std::optional<BodyAddress> BodyAddresses::address(const geometry::ClosestPoint& skin) const {
  // The segment of the nearest vertex decides; hands count to the forearm, feet to the leg.
  if (skin.triangle < 0) return std::nullopt;
  int nearest = 0;
  skin.barycentric.maxCoeff(&nearest);
  const int vertex = body_.surface.triangles[skin.triangle][nearest];
  BodyAddress found;
  switch (body_.segment[vertex]) {
    case body::Segment::upper_arm:
      found.segment = BodySegment::upper_arm;
      break;
    case body::Segment::forearm:
    case body::Segment::hand:
      found.segment = BodySegment::forearm;
      break;
    case body::Segment::thigh:
      found.segment = BodySegment::thigh;
      break;
    case body::Segment::shank:
    case body::Segment::foot:
      found.segment = BodySegment::lower_leg;
      break;
    default:
      found.segment = BodySegment::chest;
  }
  if (has_side(found.segment)) found.side = body_.side[vertex] >= 0 ? 1 : -1;
  // Below the end of the chest's axis the trunk is abdomen, where the body has one.
  auto frame = axes(found.segment, found.side);
  if (found.segment == BodySegment::chest &&
      (!frame || frame->percent(skin.point).z() > 100 + 1e-9))
    if (auto lower = axes(BodySegment::abdomen, 0)) {
      found.segment = BodySegment::abdomen;
      frame = lower;
    }
  if (!frame) return std::nullopt;
  found.percent = frame->percent(skin.point);
  return found;
}

bool BodyAddresses::belongs(int vertex, const BodyAddress& address) const {
  const body::Segment own = body_.segment[vertex];
  if (has_side(address.segment) && (body_.side[vertex] >= 0 ? 1 : -1) != address.side) return false;
  switch (address.segment) {
    case BodySegment::chest:
      return own == body::Segment::torso || own == body::Segment::neck ||
             own == body::Segment::head;
    case BodySegment::abdomen:
      return own == body::Segment::torso;
    case BodySegment::upper_arm:
      return own == body::Segment::upper_arm;
    case BodySegment::forearm:
      return own == body::Segment::forearm || own == body::Segment::hand;
    case BodySegment::thigh:
      return own == body::Segment::thigh;
    default:
      return own == body::Segment::shank || own == body::Segment::foot;
  }
}

geometry::ClosestPoint BodyAddresses::nearest(const Vec3& point, const BodyAddress& address) const {
  geometry::ClosestPoint best;
  for (int i = 0; i < static_cast<int>(body_.surface.triangles.size()); ++i) {
    const Triangle& t = body_.surface.triangles[i];
    if (!belongs(t[0], address) && !belongs(t[1], address) && !belongs(t[2], address)) continue;
    const Vec3 &a = body_.surface.vertices[t[0]], &b = body_.surface.vertices[t[1]],
               &c = body_.surface.vertices[t[2]];
    const Vec3 w = geometry::closest_barycentric(point, a, b, c);
    const Vec3 on = w[0] * a + w[1] * b + w[2] * c;
    if (const double d = (on - point).norm(); d < best.distance) best = {i, w, on, d};
  }
  return best;
}

geometry::ClosestPoint BodyAddresses::skin(const BodyAddress& address) const {
  // Segments come in pairs or not; the address has to say the same.
  const std::string words = name(address.segment);
  if (has_side(address.segment) != (address.side != 0))
    throw InvalidInput(InputPlace{"", 0, "side"}, address.side == 0 ? "nothing" : "a side",
                       has_side(address.segment) ? "left or right: " + words + " has two"
                                                 : "no side: there is one " + words);
  const auto frame = axes(address.segment, address.side);
  if (!frame)
    throw InvalidInput(
        InputPlace{"", 0, "segment"}, words,
        "a segment whose landmarks and joints this body has" + body::ends_in_words(body_.joints));
  // A point that lies on the segment's skin already is taken as it is.
  const Vec3 point = frame->point(address.percent);
  const geometry::ClosestPoint near = nearest(point, address);
  if (near.triangle < 0)
    throw InvalidInput(InputPlace{"", 0, "segment"}, words, "a segment that this body has");
  if (near.distance <= kOnSkin) return near;

  // Otherwise the ray from the segment's middle through the point has to meet its skin.
  const auto refuse = [&](const std::string& expected) {
    BodyAddress valid = address;
    valid.percent = frame->percent(near.point);
    return InvalidInput(InputPlace{"", 0, "ratios"}, address.str(), expected,
                        "the nearest place on it is " + valid.str());
  };
  const Vec2 off = address.percent.head<2>() - Vec2(50, 50);
  if (off.norm() < kOnAxis) throw refuse("a place away from the middle of the segment");
  const Vec3 middle = frame->point(Vec3(50, 50, address.percent.z()));
  const auto on_segment = [&](int i) {
    for (int v : body_.surface.triangles[i])
      if (belongs(v, address)) return true;
    return false;
  };
  // Of several crossings (folds of skin) the one nearest to the point.
  std::optional<RayCrossing> best;
  const double distance = (point - middle).norm();
  const Vec3 direction = (point - middle) / distance;
  for (const RayCrossing& hit : ray_crossings(body_.surface, middle, direction, on_segment))
    if (!best || std::abs(hit.distance - distance) < std::abs(best->distance - distance))
      best = hit;
  if (!best) throw refuse("a place on the " + words);
  return {best->triangle, best->barycentric, best->point, 0};
}

}  // namespace loosefit::placement
