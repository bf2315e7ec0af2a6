#include <cmath>
#include <map>
#include <set>

#include "support/cut_scan.h"
#include "support/scanned_twin.h"

// Many a scan is taken with the hands closed: round ends without fingers.
namespace loosefit::body {
namespace {

constexpr int kRings = 8;

using Sides = std::vector<const char*>;

/// What no triangle uses any more is no part of a scan.
void drop_unused(geometry::TriangleMesh& scan) {
  std::vector<int> place(scan.vertices.size(), -1);
  std::vector<Vec3> used;
  for (Triangle& t : scan.triangles)
    for (int& v : t) {
      if (place[v] < 0) place[v] = int(used.size()), used.push_back(scan.vertices[v]);
      v = place[v];
    }
  scan.vertices = std::move(used);
}

/// Without the skin of the hands of these sides.
geometry::TriangleMesh handless(const Body& body, const Sides& sides) {
  geometry::TriangleMesh scan = body.surface;
  const auto is_hand = [&](int v) {
    return body.segment[std::size_t(v)] == Segment::hand &&
           std::ranges::any_of(sides, [&](const std::string& side) {
             return body.joints.at("wrist_" + side).x() * scan.vertices[std::size_t(v)].x() > 0;
           });
  };
  std::erase_if(scan.triangles,
                [&](const Triangle& t) { return is_hand(t[0]) || is_hand(t[1]) || is_hand(t[2]); });
  return scan;
}

/// The hands of these sides as balls of the size of a fist, sewn to the skin at the wrists.
geometry::TriangleMesh with_fists(const Body& body, double radius, const Sides& sides) {
  geometry::TriangleMesh scan = handless(body, sides);
  // From each edge at the cut to the next one round it; triangles of the fist run the other way.
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : scan.triangles)
    for (int k = 0; k < 3; ++k) uses[{t[k], t[(k + 1) % 3]}] = 1;
  std::map<int, int> next;
  for (const auto& [edge, count] : uses)
    if (!uses.count({edge.second, edge.first})) next[edge.second] = edge.first;
  for (const char* side : sides) {
    const Vec3 wrist = body.joints.at(std::string("wrist_") + side);
    const Vec3 along = (wrist - body.joints.at(std::string("elbow_") + side)).normalized();
    int start = -1;
    for (const auto& [from, to] : next)
      if (start < 0 || (scan.vertices[from] - wrist).norm() < (scan.vertices[start] - wrist).norm())
        start = from;
    std::vector<int> ring = {start};
    while (next.at(ring.back()) != start) ring.push_back(next.at(ring.back()));
    Vec3 middle = Vec3::Zero();
    for (const int v : ring) middle += scan.vertices[v] / double(ring.size());
    double narrow = 0;
    for (const int v : ring) narrow += (scan.vertices[v] - middle).norm() / double(ring.size());
    // A ball through the wrist: from there to its far end in steps of equal angle.
    const double first = kPi - std::asin(std::min(1.0, narrow / radius));
    const Vec3 centre = middle - radius * std::cos(first) * along;
    const std::vector<Vec3> cut(scan.vertices);
    const std::vector<int> rim = ring;
    const auto add = [&](int a, int b, int c) { scan.triangles.push_back({a, b, c}); };
    for (int k = 1; k < kRings; ++k) {
      const double angle = first * (1 - double(k) / kRings);
      std::vector<int> outer;
      for (const int v : rim) {
        Vec3 out = cut[v] - middle;
        out = (out - out.dot(along) * along).normalized();
        outer.push_back(int(scan.vertices.size()));
        scan.vertices.push_back(centre +
                                radius * (std::cos(angle) * along + std::sin(angle) * out));
      }
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t j = (i + 1) % ring.size();
        add(ring[i], ring[j], outer[j]), add(ring[i], outer[j], outer[i]);
      }
      ring = outer;
    }
    const int tip = int(scan.vertices.size());
    scan.vertices.push_back(centre + radius * along);
    for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()], tip);
  }
  drop_unused(scan);
  return scan;
}

/// A scan with the measures of its owner, of whose hands this was told.
void expect_right_without_hands(
    const Body& known, const geometry::TriangleMesh& scan,
    const std::string& told = "a hand is closed, ends in the palm, or is held") {
  const support::ScanVerdict found = support::read_scan(support::as_scan(scan));
  EXPECT_EQ(found.reason, "");
  EXPECT_TRUE(std::ranges::any_of(found.warnings, [&](const std::string& warning) {
    return warning.find(told) != std::string::npos;
  }));
  ASSERT_FALSE(found.measured.empty());
  for (const char* girth : {"height", "chest", "waist", "hip", "neck", "upper_arm", "forearm",
                            "wrist", "thigh", "calf", "arm_length"})
    EXPECT_NEAR(found.measured.at(girth), known.measured.at(girth), support::kTape) << girth;
}

TEST(ScanFists, ClosedHandsChangeNoOtherMeasure) {
  const BodyParameters twin = support::person(1, 40, 1.78, 1.02, 0.90, 1.02);
  for (const Posture& posture :
       {Posture{radians(40), 0, 0}, Posture{radians(12), 0, 0, 0, 0.66, 0, 1}}) {
    const Body known = body_model().build(twin, posture);
    expect_right_without_hands(known, with_fists(known, 0.045, {"L", "R"}));
  }
}

// A child's fist is small, and the other hand, which is open, lies well.
TEST(ScanFists, OneFistOfAChildChangesNoOtherMeasure) {
  const BodyParameters twin = support::person(0, 6, 1.15, 0.58, 0.54, 0.60);
  const Body known = body_model().build(twin, {radians(40), 0, 0});
  expect_right_without_hands(known, with_fists(known, 0.029, {"L"}));
}

// What ends in the palm is a hand without fingers: the wrist is there, and it is told.
TEST(ScanFists, AHandThatEndsInThePalmIsTold) {
  const BodyParameters twin = support::person(1, 40, 1.78, 1.02, 0.90, 1.02);
  const Body known = body_model().build(twin, {radians(40), 0, 0});
  for (const double share : {0.4, 0.6}) {
    SCOPED_TRACE(share);
    const Vec3 wrist = known.joints.at("wrist_L"), way = wrist - known.joints.at("elbow_L");
    std::vector<double> beyond(known.segment.size(), 0);
    double hand = 0;
    for (std::size_t v = 0; v < beyond.size(); ++v)
      if (known.segment[v] == Segment::hand && known.side[v] > 0) {
        beyond[v] = way.normalized().dot(known.surface.vertices[v] - wrist);
        hand = std::max(hand, beyond[v]);
      }
    std::vector<char> gone(beyond.size(), 0);
    for (std::size_t v = 0; v < gone.size(); ++v) gone[v] = beyond[v] > share * hand;
    geometry::TriangleMesh scan = support::without(known.surface, gone);
    support::close(scan);
    drop_unused(scan);
    expect_right_without_hands(known, scan);
  }
}

TEST(ScanFists, MissingHandChangesNoOtherMeasure) {
  const BodyParameters twin = support::person(0, 6, 1.15, 0.58, 0.54, 0.60);
  const Body known = body_model().build(twin, {radians(40), 0, 0});
  geometry::TriangleMesh scan = handless(known, {"R"});
  drop_unused(scan);
  expect_right_without_hands(known, scan, "the scan has no right hand");
}

// Somebody with both hands open is told nothing of them.
TEST(ScanFists, OpenHandsAreTaken) {
  const BodyParameters twin = support::person(0, 6, 1.15, 0.58, 0.54, 0.60);
  const Body known = body_model().build(twin, {radians(40), 0, 0});
  const support::ScanVerdict found = support::read_scan(support::as_scan(known.surface));
  ASSERT_FALSE(found.measured.empty()) << found.reason;
  for (const std::string& warning : found.warnings)
    EXPECT_EQ(warning.find("hand"), std::string::npos) << warning;
}

}  // namespace
}  // namespace loosefit::body
