#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "loosefit/geometry/closest_point_tree.h"
#include "support/only_draped.h"

// A shirt and trousers in one drape: the order of the scenario says which is tucked into which.
namespace loosefit::pipeline {
namespace {

constexpr double kNear = 0.03;  ///< farther apart two garments lie over different parts of the body

geometry::TriangleMesh surface_of(const CaseGarment& garment) {
  return {garment.drape.positions, garment.mesh().triangles};
}

/// Corners on free edges: beyond one the nearest point says nothing of the side.
std::set<int> border_of(const geometry::TriangleMesh& cloth) {
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : cloth.triangles)
    for (int k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
  std::set<int> border;
  for (const auto& [edge, count] : uses)
    if (count == 1) border.insert({edge.first, edge.second});
  return border;
}

struct Sides {
  int outside = 0, inside = 0;
  double share_outside() const { return outside / double(outside + inside); }
};

/// On which side of `under` the corners of `over` lie, where the two lie over each other; outside
/// is away from the skin.
Sides sides_of(const CaseGarment& over, const CaseGarment& under, const body::PosedBody& body) {
  const geometry::TriangleMesh cloth = surface_of(under);
  const geometry::ClosestPointTree tree(cloth);
  const std::set<int> border = border_of(cloth);
  Sides sides;
  for (const Vec3& p : over.drape.positions) {
    const geometry::ClosestPoint hit = tree.query(p);
    if ((p - hit.point).norm() > kNear) continue;
    const Triangle& t = cloth.triangles[hit.triangle];
    if (border.count(t[0]) || border.count(t[1]) || border.count(t[2])) continue;
    const Vec3 &a = cloth.vertices[t[0]], &b = cloth.vertices[t[1]], &c = cloth.vertices[t[2]];
    Vec3 normal = (b - a).cross(c - a);
    const double away = 1e-3 / normal.norm();
    // From the skin the distance grows, whichever way the triangles are numbered.
    if (body.tree().signed_distance(hit.point + away * normal) <
        body.tree().signed_distance(hit.point - away * normal))
      normal = -normal;
    ++((p - hit.point).dot(normal) > 0 ? sides.outside : sides.inside);
  }
  return sides;
}

void expect_order(const CaseResult& result) {
  ASSERT_EQ(result.garments.size(), 2u);
  const CaseGarment &inner = result.garments[0], &outer = result.garments[1];
  const Sides over = sides_of(outer, inner, result.body.body);
  EXPECT_GT(over.outside + over.inside, 50) << "they lie over each other somewhere";
  // The nearest triangle of a fold may be its far side.
  EXPECT_GT(over.share_outside(), 0.97);
  EXPECT_LT(sides_of(inner, outer, result.body.body).share_outside(), 0.03);
}

double lowest(const CaseGarment& garment) {
  double z = 1e9;
  for (const Vec3& p : garment.drape.positions) z = std::min(z, p.z());
  return z;
}

double highest(const CaseGarment& garment) {
  double z = -1e9;
  for (const Vec3& p : garment.drape.positions) z = std::max(z, p.z());
  return z;
}

std::string scenario(const std::string& outer, const std::string& inner) {
  return "[body]\nsex = \"male\"\nage = 35\nheight = 1.78\n[garment]\n" + outer + "[[under]]\n" +
         inner + "[simulation]\nedge_length = 0.03\n[donning]\nmovements = []\n";
}

constexpr const char* kShirt = "fit = { chest = 0.15, hip = 0.12, sleeve = 0.30, wrist = 0.30 }\n";

TEST(ShirtAndTrousers, ShirtThatHangsOverTheWaistbandLiesOutsideOfIt) {
  const CaseResult result = support::only_draped(
      scenario(kShirt, "pattern = \"trousers\"\n[under.material]\nname = \"wool\"\n"));
  expect_order(result);
  EXPECT_LT(lowest(result.garments[1]), highest(result.garments[0]) - 0.05)
      << "the hem is below the waistband";
}

TEST(ShirtAndTrousers, ShirtThatIsTuckedInLiesInsideTheTrousers) {
  const CaseResult result =
      support::only_draped(scenario("pattern = \"trousers\"\n[material]\nname = \"wool\"\n",
                                    "pattern = \"long-sleeve-shirt\"\n" + std::string(kShirt)));
  expect_order(result);
  EXPECT_LT(lowest(result.garments[0]), highest(result.garments[1]) - 0.05)
      << "the hem is below the waistband";
}

}  // namespace
}  // namespace loosefit::pipeline
