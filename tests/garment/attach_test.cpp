#include "loosefit/garment/attach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/garment/hierarchy.h"
#include "loosefit/geometry/flat_triangle.h"
#include "support/simple_patterns.h"

namespace loosefit::garment {
namespace {

using namespace testing_support;

pattern::Pattern cloth_square() {
  pattern::Pattern p;
  p.panels = {rectangle_panel("front", .4, .4)};
  return p;
}

Attachment board(const Vec2& at, const Vec2& size, double mass) {
  Board b;
  b.centre = at;
  b.size = size;
  b.mass = mass;
  b.bending = 2e-3;
  b.membrane_factor = 5;
  return {"sensor", "front", b};
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// ∫ added bending dA over the garment [N m³].
double bending_integral(const Garment& g) {
  double sum = 0;
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    sum += g.triangle_added_bending[t] * geometry::flat_area(g.triangle_uv[t]);
  return sum;
}

TEST(Attachment, BoardKeepsMassAndCentreOfMassOnEveryLevel) {
  const pattern::Pattern p = cloth_square();
  const Vec2 at(.137, .211), size(.05, .03);
  Attachment tilted = board(at, size, .02);
  std::get<Board>(tilted.part).angle = radians(30);
  Attachment massless = tilted;  // whose outline the mesh follows as well
  std::get<Board>(massless.part).mass = 0;
  EXPECT_TRUE(build_hierarchy(p, .01, {}).finest().vertex_attached_mass.empty());
  const GarmentHierarchy plain = build_hierarchy(p, .01, {}, {massless});
  const GarmentHierarchy loaded = build_hierarchy(p, .01, {}, {tilted});
  for (std::size_t l = 0; l < plain.levels.size(); ++l) {
    const Garment &a = plain.levels[l], &b = loaded.levels[l];
    EXPECT_NEAR(total(b.vertex_mass) - total(a.vertex_mass), .02, 1e-12);
    EXPECT_NEAR(b.mass - a.mass, .02, 1e-12);
    ASSERT_EQ(a.vertex_count, b.vertex_count);
    EXPECT_NEAR(total(b.vertex_attached_mass), .02, 1e-12);
    for (int v = 0; v < b.vertex_count; ++v) EXPECT_NEAR(b.cloth_mass(v), a.vertex_mass[v], 1e-15);
    Vec2 moment = Vec2::Zero();
    for (int v = 0; v < b.vertex_count; ++v)
      moment += (b.vertex_mass[v] - a.vertex_mass[v]) * b.vertex_uv[v];
    EXPECT_LT((moment / .02 - at).norm(), 1e-9);
    EXPECT_NEAR(bending_integral(b), 2e-3 * .05 * .03, .06 * 2e-3 * .05 * .03);
  }
  const Garment& g = loaded.finest();
  double stiffest = 0;
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const Vec2 centre = (g.triangle_uv[t][0] + g.triangle_uv[t][1] + g.triangle_uv[t][2]) / 3;
    stiffest = std::max(stiffest, g.triangle_membrane_factor[t]);
    if ((centre - at).norm() > .04) {
      EXPECT_EQ(g.triangle_added_bending[t], 0);
      EXPECT_EQ(g.triangle_membrane_factor[t], 1);
    }
  }
  EXPECT_NEAR(stiffest, 5, 1e-12);
}

TEST(Attachment, DiscSmallerThanATriangleStillCarriesItsMass) {
  Board b;
  b.centre = {.2, .2};
  b.radius = .003;
  b.mass = .005;
  const Garment g = build_hierarchy(cloth_square(), .03, {}, {{"button", "front", b}}).finest();
  EXPECT_NEAR(total(g.vertex_mass), g.mass, 1e-12);
}

TEST(Attachment, CableAddsItsLineMassAndRigidity) {
  Cable cable;
  cable.path = {{.05, .05}, {.05, .25}, {.30, .25}};
  cable.linear_density = .03;
  cable.bending = 4e-6;
  cable.width = .02;
  const pattern::Pattern p = cloth_square();
  const Garment plain = build_hierarchy(p, .005, {}).finest();
  const Garment g = build_hierarchy(p, .005, {}, {{"cable", "front", cable}}).finest();
  const double length = .20 + .25;
  EXPECT_NEAR(total(g.vertex_mass) - total(plain.vertex_mass), .03 * length, 1e-12);
  // B / width over a strip of that width: ∫ = B length, plus the round ends, less the inner corner.
  EXPECT_NEAR(bending_integral(g), 4e-6 * length, .1 * 4e-6 * length);
  EXPECT_EQ(*std::max_element(g.triangle_membrane_factor.begin(), g.triangle_membrane_factor.end()),
            1);
}

std::string error_of(const Attachment& a) {
  try {
    build_hierarchy(cloth_square(), .03, {}, {a});
  } catch (const InvalidInput& e) {
    return std::string(e.what()) + " | " + e.hint();
  }
  return "accepted";
}

TEST(Attachment, WrongPlacesAreNamed) {
  Attachment a = board({.2, .2}, {.05, .03}, .02);
  EXPECT_EQ(error_of(a), "accepted");
  a.panel = "frnt";
  EXPECT_NE(error_of(a).find("attachment sensor.panel: found \"frnt\", expected one of front"),
            std::string::npos);
  EXPECT_NE(error_of(a).find("did you mean \"front\""), std::string::npos) << error_of(a);
  EXPECT_NE(error_of(board({.5, .1}, {.05, .03}, .02))
                .find("sensor.position: found (0.5000, 0.1000) m, outside panel front, expected a "
                      "point inside; the nearest is (0.4000, 0.1000) m"),
            std::string::npos)
      << error_of(board({.5, .1}, {.05, .03}, .02));
  EXPECT_NE(error_of(board({.2, .2}, {.05, .03}, -1)).find("sensor.mass: found -1 kg"),
            std::string::npos);
  EXPECT_NE(error_of(board({.2, .2}, {.05, std::nan("")}, 1)).find("sensor.height: found nan m"),
            std::string::npos);
  Cable cable;
  cable.path = {{.1, .1}};
  EXPECT_NE(error_of({"wire", "front", cable}).find("wire.path: found 1 points, expected at least"),
            std::string::npos);
  cable.path = {{.1, .1}, {.1, 3}};
  EXPECT_NE(error_of({"wire", "front", cable}).find("wire.path[1]: found (0.1000, 3.0000) m"),
            std::string::npos);
}

}  // namespace
}  // namespace loosefit::garment
