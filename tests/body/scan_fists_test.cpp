#include <cmath>
#include <map>
#include <set>

#include "support/scanned_twin.h"

// Many a scan is taken with the hands closed: round ends without fingers.
namespace loosefit::body {
namespace {

constexpr int kRings = 8;

/// The hands as balls of the size of a fist, sewn to the skin at the wrists.
geometry::TriangleMesh with_fists(const Body& body) {
  geometry::TriangleMesh scan = body.surface;
  const auto is_hand = [&](int v) { return body.segment[std::size_t(v)] == Segment::hand; };
  std::erase_if(scan.triangles,
                [&](const Triangle& t) { return is_hand(t[0]) || is_hand(t[1]) || is_hand(t[2]); });
  // From each edge at the cut to the next one round it; triangles of the fist run the other way.
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : scan.triangles)
    for (int k = 0; k < 3; ++k) uses[{t[k], t[(k + 1) % 3]}] = 1;
  std::map<int, int> next;
  for (const auto& [edge, count] : uses)
    if (!uses.count({edge.second, edge.first})) next[edge.second] = edge.first;
  for (const char* side : {"L", "R"}) {
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
    const double radius = 0.045;
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
  // What no triangle uses any more is no part of a scan.
  std::vector<int> place(scan.vertices.size(), -1);
  std::vector<Vec3> used;
  for (Triangle& t : scan.triangles)
    for (int& v : t) {
      if (place[v] < 0) place[v] = int(used.size()), used.push_back(scan.vertices[v]);
      v = place[v];
    }
  scan.vertices = std::move(used);
  return scan;
}

TEST(ScanFists, ClosedHandsChangeNoOtherMeasure) {
  const BodyParameters twin = support::person(1, 40, 1.78, 1.02, 0.90, 1.02);
  for (const Posture& posture :
       {Posture{radians(40), 0, 0}, Posture{radians(12), 0, 0, 0, 0.66, 0, 1}}) {
    const Body known = body_model().build(twin, posture);
    const support::ScanVerdict found = support::read_scan(support::as_scan(with_fists(known)));
    EXPECT_EQ(found.reason, "");
    EXPECT_TRUE(std::ranges::any_of(found.warnings, [](const std::string& warning) {
      return warning.find("the hands are closed") == 0;
    }));
    ASSERT_FALSE(found.measured.empty());
    for (const char* girth : {"height", "chest", "waist", "hip", "neck", "upper_arm", "forearm",
                              "wrist", "thigh", "calf", "arm_length"})
      EXPECT_NEAR(found.measured.at(girth), known.measured.at(girth), support::kTape) << girth;
  }
}

}  // namespace
}  // namespace loosefit::body
