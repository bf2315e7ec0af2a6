#include <cmath>

#include "support/scanned_twin.h"

// Hair that hangs to the shoulders or the back is one surface with the skin in a scan.
namespace loosefit::body {
namespace {

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A mass of hair round all of the head but the face, `thick` off the skull and as far off the
/// neck as that, down to `length` below the seventh neck vertebra [m].
geometry::TriangleMesh with_hair(const Body& body, double thick, double length) {
  geometry::TriangleMesh scan = body.surface;
  const double c7 = body.landmarks.at("c7").z();
  const double ends = c7 - length, middle = body.landmarks.at("c7").y() - 0.06;
  for (std::size_t v = 0; v < body.segment.size(); ++v) {
    const Vec3 &p = body.surface.vertices[v], &n = body.normals[v];
    const Segment part = body.segment[v];
    if (part != Segment::head && part != Segment::neck && part != Segment::torso) continue;
    if (std::abs(p.x()) > 0.13) continue;
    // Round the head all of the sides; lower down behind the shoulders only.
    const double front = p.z() > c7 ? -0.05 : 0.02;
    const double behind = smooth_step(front, front + 0.05, p.y() - middle);
    const double below = smooth_step(ends, ends + 0.05, p.z());
    const double aside = 1 - smooth_step(0.09, 0.13, std::abs(p.x()));
    // The neck is narrower than the head, and hair hangs straight over it.
    const double over_neck = part == Segment::neck ? 0.03 : 0.0;
    scan.vertices[v] += (thick + over_neck) * behind * below * aside * n;
  }
  return scan;
}

struct Hair {
  const char* name;
  double thick, length;
};

/// Taken with the measures of the twin, or refused with a reason.
void expect_told_or_right(const Body& known, const geometry::TriangleMesh& scan) {
  const support::ScanVerdict found = support::read_scan(support::as_scan(scan));
  if (found.measured.empty()) {
    EXPECT_NE(found.reason.find("scan.obj: found clothes or hair"), std::string::npos)
        << found.reason;
    EXPECT_NE(found.reason.find("over the neck"), std::string::npos) << found.reason;
    return;
  }
  for (const char* girth : {"height", "chest", "waist", "hip", "neck", "upper_arm", "forearm",
                            "wrist", "thigh", "knee", "calf"})
    EXPECT_NEAR(found.measured.at(girth), known.measured.at(girth), support::kTape) << girth;
}

TEST(ScanHair, IsTakenForHairOrRefused) {
  const BodyParameters twin = support::person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, {radians(40), 0, 0});
  for (const auto& [name, thick, length] :
       {Hair{"to the shoulders", 0.03, 0.02}, Hair{"a mass to the back", 0.06, 0.15}}) {
    SCOPED_TRACE(name);
    expect_told_or_right(known, with_hair(known, thick, length));
  }
}

TEST(ScanHair, ShortHairIsNoReasonToRefuse) {
  const BodyParameters twin = support::person(1, 40, 1.78, 1.02, 0.90, 1.02);
  const Body known = body_model().build(twin, {radians(40), 0, 0});
  const geometry::TriangleMesh scan = with_hair(known, 0.008, -0.10);
  const support::ScanVerdict found = support::read_scan(support::as_scan(scan));
  EXPECT_EQ(found.reason, "");
  expect_told_or_right(known, scan);
}

// What the refusal advises.
TEST(ScanHair, HairPressedOntoTheNeckIsTaken) {
  const BodyParameters twin = support::person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, {radians(40), 0, 0});
  geometry::TriangleMesh scan = with_hair(known, 0.03, 0.25);
  for (std::size_t v = 0; v < known.segment.size(); ++v)
    if (known.segment[v] != Segment::head) scan.vertices[v] = known.surface.vertices[v];
  const support::ScanVerdict found = support::read_scan(support::as_scan(scan));
  ASSERT_FALSE(found.measured.empty()) << found.reason;
  // The height is that of the hair.
  for (const char* girth : {"chest", "waist", "hip", "neck", "upper_arm", "wrist", "thigh"})
    EXPECT_NEAR(found.measured.at(girth), known.measured.at(girth), support::kTape) << girth;
}

// A collar's width of a neck, a little wide where the scan ends, tells nothing of hair. That the
// head is missing is what has to be said.
TEST(ScanHair, StubOfANeckIsNoHair) {
  const BodyParameters twin = support::person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, {radians(40), 0, 0});
  geometry::TriangleMesh scan = known.surface;
  const double c7 = known.landmarks.at("c7").z();
  std::erase_if(scan.triangles, [&](const Triangle& t) {
    return std::ranges::any_of(
        t, [&](int v) { return known.surface.vertices[std::size_t(v)].z() > c7 + 0.015; });
  });
  for (std::size_t v = 0; v < known.segment.size(); ++v)
    if (known.segment[v] == Segment::neck) scan.vertices[v] += 0.015 * known.normals[v];
  const support::ScanVerdict found = support::read_scan(support::as_scan(scan));
  EXPECT_EQ(found.reason.find("hair"), std::string::npos) << found.reason;
  EXPECT_NE(found.reason.find("no head"), std::string::npos) << found.reason;
}

}  // namespace
}  // namespace loosefit::body
