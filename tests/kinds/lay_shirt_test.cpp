#include "loosefit/kinds/shirt/lay_shirt.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/dress/dress_layers.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/shirt_kind.h"
#include "support/shirt_on_body.h"

namespace loosefit::kinds {
namespace {

using support::dress_shirt;
using support::shirt_for;
using support::standing;

constexpr double kEdge = 0.03;

/// Solid angle of a triangle seen from p, over 4π (Van Oosterom and Strackee 1983).
double winding(const Vec3& p, const Vec3& x, const Vec3& y, const Vec3& z) {
  const Vec3 a = x - p, b = y - p, c = z - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return std::atan2(a.dot(b.cross(c)),
                    la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb) /
         (2 * kPi);
}

struct DressCase {
  bool child;
  double arms, fit;
};
void PrintTo(const DressCase& c, std::ostream* out) {
  *out << (c.child ? "child" : "adult") << ", arms " << c.arms << ", fit " << c.fit;
}
class DressShirt : public ::testing::TestWithParam<DressCase> {};

TEST_P(DressShirt, EnclosesTheBodyWithoutIntersectionsOrTurnedPanels) {
  const DressCase& c = GetParam();
  const auto parameters = c.child ? support::slim_child_parameters() : support::adult_parameters();
  const body::Body body = standing(parameters, c.arms);
  const pattern::Pattern pattern = shirt_for(body, c.fit);
  const garment::Garment shirt = garment::assemble(pattern, kEdge, fabric::Material{});
  const std::vector<Vec3> x = dress_shirt(shirt, body);
  ASSERT_EQ(static_cast<int>(x.size()), shirt.vertex_count);
  for (const Vec3& p : x) ASSERT_TRUE(p.allFinite());
  EXPECT_TRUE(geometry::self_intersections(x, shirt.triangles).empty());
  const auto& skin = body.surface;
  const geometry::ClosestPointTree tree(skin);
  // Outside the body, but for a few millimetres at a child's throat. (Triangles between such
  // vertices may still cut thumb and throat; settling takes them out.)
  double deepest = 1;
  for (const Vec3& p : x) deepest = std::min(deepest, tree.signed_distance(p));
  EXPECT_GT(deepest, -0.005);
  RecordProperty("deepest_um", static_cast<int>(1e6 * deepest));

  // Every triangle of a front panel faces forwards (−y), of a back panel backwards.
  for (std::size_t t = 0; t < shirt.triangles.size(); ++t) {
    const Triangle& tri = shirt.triangles[t];
    const bool back = shirt.panel_names[shirt.triangle_panel[t]].find("back") != std::string::npos;
    const Vec3 n = geometry::triangle_normal(x[tri[0]], x[tri[1]], x[tri[2]]);
    EXPECT_GT((back ? 1 : -1) * n[1], 0) << shirt.panel_names[shirt.triangle_panel[t]];
  }

  // Waist and chest of the body lie inside: the shirt winds round them. Hem, neck and cuffs are
  // open, so the winding number stays below one; outside it is near zero.
  const double chest_z = body.landmarks.at("back_waist")[2] + 0.1 * body.measured.at("height");
  double least = 1;
  int tested = 0;
  for (std::size_t v = 0; v < skin.vertices.size(); v += 37) {
    if (body.segment[v] != body::Segment::torso || std::abs(skin.vertices[v][2] - chest_z) > 0.05)
      continue;
    double w = 0;
    for (const Triangle& t : shirt.triangles)
      w += winding(skin.vertices[v], x[t[0]], x[t[1]], x[t[2]]);
    least = std::min(least, w);
    ++tested;
  }
  EXPECT_GT(tested, 10);
  EXPECT_GT(least, 0.6);
  double outside = 0;
  for (const Triangle& t : shirt.triangles)
    outside += winding(Vec3(0, -1, chest_z), x[t[0]], x[t[1]], x[t[2]]);
  EXPECT_LT(std::abs(outside), 0.1);
  RecordProperty("least_winding_1e-3", static_cast<int>(1e3 * least));

  // Sleeves lie on the arm of their own side.
  for (int v = 0; v < shirt.vertex_count; ++v) {
    const std::string& panel = shirt.panel_names[shirt.vertex_panel[v]];
    if (panel.find("sleeve_L") == 0) {
      EXPECT_GT(x[v][0], 0);
    }
    if (panel.find("sleeve_R") == 0) {
      EXPECT_LT(x[v][0], 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, DressShirt,
                         ::testing::Values(DressCase{false, 25, -0.05}, DressCase{false, 25, 0.45},
                                           DressCase{false, 42, -0.05}, DressCase{false, 42, 0.45},
                                           DressCase{true, 25, -0.05}, DressCase{true, 25, 0.45},
                                           DressCase{true, 42, -0.05}, DressCase{true, 42, 0.45}));

TEST(DressShirtParts, CountAndNamesDoNot) {
  const body::Body body = standing(support::adult_parameters(), 40);
  const pattern::Pattern pattern = shirt_for(body, 0.1);
  const garment::Garment shirt = garment::assemble(pattern, kEdge, fabric::Material{});
  pattern::Pattern renamed = pattern;
  for (pattern::Panel& panel : renamed.panels) panel.name = "piece of " + panel.name;
  std::swap(renamed.panels[0].name, renamed.panels[1].name);
  const garment::Garment other = garment::assemble(renamed, kEdge, fabric::Material{});
  EXPECT_EQ(dress_shirt(other, body), dress_shirt(shirt, body));
}

TEST(DressShirtParts, OfNoKindIsPutOnAsItIsPlaced) {
  const body::Body body = standing(support::adult_parameters(), 40);
  pattern::Pattern foreign =
      shirt_for(body, 0.1);  // of somebody else, who calls panels and edges as we do
  foreign.kind = pattern::Pattern{}.kind;
  const garment::Garment unknown = garment::assemble(foreign, kEdge, fabric::Material{});
  EXPECT_FALSE(garment_kind(foreign.kind).lay);
  std::vector<Vec3> placed = dress_shirt(unknown, body);
  for (Vec3& p : placed) p.z() += 1;
  const auto place = [&](const body::PosedBody&) { return placed; };
  EXPECT_EQ(dress::dress_layers({{&unknown, garment_kind(foreign.kind).lay, place}}, body), placed);
}

TEST(DressShirtErrors, HangingArmsAreRefusedWithTheAngle) {
  const body::Body open = standing(support::adult_parameters(), 25);
  const garment::Garment shirt =
      garment::assemble(shirt_for(open, 0.15), kEdge, fabric::Material{});
  const body::Body closed = standing(support::adult_parameters(), 5);
  try {
    dress_shirt(shirt, closed);
    FAIL() << "no error";
  } catch (const dress::NoRoom& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("arm"), std::string::npos) << what;
    EXPECT_NE(what.find("15"), std::string::npos) << what;
  }
}

TEST(DressShirtErrors, BodyWithoutJointsIsRefusedByName) {
  body::Body body = standing(support::adult_parameters(), 25);
  const garment::Garment shirt =
      garment::assemble(shirt_for(body, 0.15), kEdge, fabric::Material{});
  body.joints.clear();
  try {
    dress_shirt(shirt, body);
    FAIL() << "no error";
  } catch (const GeometryError& e) {
    EXPECT_NE(std::string(e.what()).find("shoulder_"), std::string::npos) << e.what();
  }
  body = standing(support::adult_parameters(), 25);
  body.landmarks.clear();
  EXPECT_THROW(dress_shirt(shirt, body), GeometryError);
}

}  // namespace
}  // namespace loosefit::kinds
