#include "loosefit/maps/fine_cloth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/maps/air_gap.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

constexpr double kSkin = 0.12, kCloth = 0.13, kHeight = 0.4;
constexpr int kCorners = 36;

/// A tube of flat facets round a smooth cylinder.
struct FacetTube {
  body::Body body = testing::cylinder_body(kSkin, 1.0, 720, 40);
  garment::Garment garment = testing::tube_garment(2 * kPi * kCloth, kHeight, kCorners, 18);
  std::vector<Vec3> positions =
      testing::settled_drape(garment, [](const Vec2& uv) {
        const double a = uv.x() / kCloth;
        return Vec3(kCloth * std::cos(a), kCloth * std::sin(a), 0.3 + uv.y());
      }).positions;
  /// Between the facets and the round skin [m³].
  double air() const {
    return kHeight *
           (0.5 * kCorners * kCloth * kCloth * std::sin(2 * kPi / kCorners) - kPi * kSkin * kSkin);
  }
};

// The skin under flat triangles is cut off as a polygon of as many corners; error ~ edge².
TEST(FineCloth, PartnersOfSmallTrianglesFollowRoundSkin) {
  const FacetTube tube;
  const double coarse =
      air_gap(tube.garment, tube.positions, relate(tube.garment, tube.positions, tube.body), 0)
          .volume;
  EXPECT_NEAR(
      coarse / tube.air() - 1,
      kHeight * kSkin * kSkin * (kPi - 0.5 * kCorners * std::sin(2 * kPi / kCorners)) / tube.air(),
      2e-3);
  EXPECT_GT(coarse, 1.02 * tube.air());
  for (const auto& [edge, bound] : {std::pair(0.013, 0.010), std::pair(0.006, 0.0025)}) {
    const FineCloth fine = cut_finer(tube.garment, tube.positions, tube.body, edge);
    EXPECT_NEAR(air_gap(fine.garment, fine.positions, fine.worn, 0).volume, tube.air(),
                bound * tube.air())
        << edge;
  }
}

TEST(FineCloth, IsTheSameSurfaceWithTheSameFirstVertices) {
  const FacetTube tube;
  const FineCloth fine = cut_finer(tube.garment, tube.positions, tube.body, 0.013);
  ASSERT_EQ(fine.garment.triangles.size(), 4 * tube.garment.triangles.size());
  ASSERT_EQ(fine.positions.size(), static_cast<std::size_t>(fine.garment.vertex_count));
  for (std::size_t v = 0; v < tube.positions.size(); ++v)
    EXPECT_EQ(fine.positions[v], tube.positions[v]);
  double area = 0, flat = 0;
  for (std::size_t t = 0; t < fine.garment.triangles.size(); ++t) {
    const Triangle& c = fine.garment.triangles[t];
    area +=
        geometry::triangle_area(fine.positions[c[0]], fine.positions[c[1]], fine.positions[c[2]]);
    const auto& [a, b, d] = fine.garment.triangle_uv[t];
    flat += 0.5 * ((b - a).x() * (d - a).y() - (b - a).y() * (d - a).x());
  }
  const double facet = 2 * kCloth * std::sin(kPi / kCorners);
  EXPECT_NEAR(area, kCorners * facet * kHeight, 1e-12);
  EXPECT_NEAR(flat, 2 * kPi * kCloth * kHeight, 1e-6) << "flat pieces keep their area";
  const FineCloth same = cut_finer(tube.garment, tube.positions, tube.body, 1.0);
  EXPECT_EQ(same.garment.triangles, tube.garment.triangles) << "fine enough already";
  EXPECT_THROW(cut_finer(tube.garment, tube.positions, tube.body, 0), InvalidInput);
}

}  // namespace
}  // namespace loosefit::maps
