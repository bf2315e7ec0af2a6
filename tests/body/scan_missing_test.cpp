#include <gtest/gtest.h>

#include <string>

#include "loosefit/body/stumps.h"
#include "support/cut_scan.h"
#include "support/scanned_twin.h"

// Scans that lack a limb, or come in parts, from the surface to the person.
namespace loosefit::body {
namespace {

using support::cut_limb;
using support::cut_of;

std::vector<std::string> lacked(const ScanPerson& person) {
  return person.parameters.stumps ? person.parameters.stumps->names() : std::vector<std::string>{};
}

std::optional<ScanPerson> read(const geometry::TriangleMesh& scan) {
  return person_from_scan(body_model(), support::as_scan(scan), {"scan.obj", "cm", "y"});
}

void expect_measures(const ScanPerson& found, const Body& known) {
  for (const char* name : {"height", "chest", "waist", "hip", "neck", "upper_arm", "wrist", "thigh",
                           "calf", "arm_length", "crotch_height"})
    EXPECT_NEAR(found.body.measured.at(name), known.measured.at(name), support::kTape) << name;
}

TEST(ScanMissing, APersonWithoutALimbIsTakenWithoutIt) {
  struct Case {
    Segment in;
    double share;
    int side;
    Posture posture;
    const char* name;
  };
  const Case cases[] = {
      {Segment::upper_arm, 0.3, 1, kArmsApart, "left arm"},
      {Segment::forearm, 0.2, -1, {radians(12), 0, 0, 0, 0.66, 0, 1}, "right forearm and hand"},
      {Segment::forearm, 0.98, 1, kArmsApart, "left hand"},
      {Segment::thigh, 0.75, -1, kArmsApart, "right shank and foot"}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const BodyParameters twin = support::person(0, 30, 1.66, 0.94, 0.78, 1.00);
    const Body known = body_model().build(twin, c.posture);
    const auto found = read(cut_limb(known, cut_of(c.in, c.share), c.side));
    ASSERT_TRUE(found);
    EXPECT_EQ(lacked(*found), std::vector<std::string>{c.name});
    expect_measures(*found, known);
    EXPECT_NE(std::ranges::find_if(found->warnings,
                                   [&](const std::string& w) {
                                     return w.find(std::string("no ") + c.name) !=
                                            std::string::npos;
                                   }),
              found->warnings.end());
    for (const std::string& w : found->warnings) EXPECT_EQ(w.find("askew"), std::string::npos) << w;
  }
}

TEST(ScanMissing, AForefootThatIsNotThereIsSaidToBeTheModels) {
  const BodyParameters twin = support::person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, kArmsApart);
  const auto told = [](const ScanPerson& person, const char* side) {
    return std::ranges::any_of(person.warnings, [&](const std::string& w) {
      return w.find(std::string("the ") + side + " foot of the scan ends") != std::string::npos;
    });
  };
  for (const int side : {1, -1}) {
    const double ankle = known.joints.at(side > 0 ? "ankle_L" : "ankle_R").y();
    double toes = ankle;
    for (std::size_t v = 0; v < known.segment.size(); ++v)
      if (known.segment[v] == Segment::foot && known.side[v] == side)
        toes = std::min(toes, known.surface.vertices[v].y());
    std::vector<char> gone(known.segment.size(), 0);
    for (std::size_t v = 0; v < gone.size(); ++v)
      gone[v] = known.segment[v] == Segment::foot && known.side[v] == side &&
                known.surface.vertices[v].y() < ankle + 0.55 * (toes - ankle);
    geometry::TriangleMesh mesh = support::without(known.surface, gone);
    support::close(mesh);
    const auto found = read(mesh);
    ASSERT_TRUE(found) << side;
    EXPECT_EQ(lacked(*found), std::vector<std::string>{}) << side;
    EXPECT_EQ(told(*found, "left"), side > 0);
    EXPECT_EQ(told(*found, "right"), side < 0);
  }
}

TEST(ScanMissing, AHeadlessScanIsRefused) {
  const BodyParameters twin = support::person(1, 40, 1.78, 1.02, 0.90, 1.02);
  const Body known = body_model().build(twin, kArmsApart);
  try {
    read(support::without_segments(known, {Segment::head}));
    FAIL() << "a stature was made up";
  } catch (const InvalidInput& error) {
    // The stub under a chin is as wide as hair.
    const std::string what = error.what();
    EXPECT_TRUE(what.find("no head") != std::string::npos ||
                what.find("over the neck") != std::string::npos)
        << what;
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(ScanMissing, AScanThatEndsAtTheAnklesIsRefusedByName) {
  const BodyParameters twin = support::person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, kArmsApart);
  try {
    read(support::without_segments(known, {Segment::foot}));
    FAIL() << "a stature was made up";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("no left foot"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("no right foot"), std::string::npos) << error.what();
  }
}

TEST(ScanMissing, PartsOfAPersonAreTakenTogether) {
  const BodyParameters twin = support::person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, kArmsApart);
  for (const bool closed : {false, true}) {
    const auto found = read(support::together(support::in_parts(known, closed ? 1 : 2, closed)));
    ASSERT_TRUE(found) << closed;
    EXPECT_EQ(lacked(*found), std::vector<std::string>{});
    expect_measures(*found, known);
    EXPECT_TRUE(std::ranges::any_of(found->warnings, [](const std::string& w) {
      return w.find("5 surfaces are taken together") != std::string::npos;
    }));
  }
}

TEST(ScanMissing, AFloorIsNoPartOfThePerson) {
  const BodyParameters twin = support::person(0, 30, 1.66, 0.94, 0.78, 1.00);
  const Body known = body_model().build(twin, kArmsApart);
  geometry::TriangleMesh floor;  // a plate of 1.2 m
  for (const double z : {-0.02, 0.0})
    for (const double x : {-0.6, 0.6})
      for (const double y : {-0.6, 0.6}) floor.vertices.emplace_back(x, y, z);
  floor.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                     {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  try {
    const auto found = read(support::together({known.surface, floor}));
    EXPECT_FALSE(found);
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("a surface that is not the person"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace loosefit::body
