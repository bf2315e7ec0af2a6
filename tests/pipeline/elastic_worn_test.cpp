#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "loosefit/geometry/flat_triangle.h"
#include "support/only_draped.h"
#include "support/scratch_folder.h"
#include "support/trunk_tubes.h"

namespace loosefit::pipeline {
namespace {

/// Length of the hem of a worn T-shirt [m].
double hem(const std::string& elastic) {
  const CaseResult result =
      support::only_draped("[garment]\npattern = \"t-shirt\"\n" + elastic +
                           "[simulation]\nedge_length = 0.03\n[donning]\nmovements = []\n");
  const auto& x = result.studied().drape.positions;
  double length = 0;
  for (const char* panel : {"front", "back"}) {
    const auto* chain = result.studied().mesh().find_chain(panel, "hem");
    for (std::size_t i = 0; i + 1 < chain->vertices.size(); ++i)
      length += (x[chain->vertices[i + 1]] - x[chain->vertices[i]]).norm();
  }
  return length;
}

TEST(ElasticWorn, AHemWithElasticIsGathered) {
  const double free = hem("");
  // A soft tape gathers it less than one that pulls it down to its own length or to the body.
  const auto with = [](const char* stiffness) {
    return hem(
        "[[garment.elastic]]\nedges = [\"front.hem\", \"back.hem\"]\nratio = 0.85\n"
        "stiffness = " +
        std::string(stiffness) + "\n");
  };
  const double soft = with("2"), firm = with("50");
  EXPECT_LT(soft, 0.995 * free);
  EXPECT_LT(firm, 0.95 * free);
  EXPECT_LT(firm, soft);
}

// A ring of tape in tension T that lies on a convex body presses on it with 2π T in all, whatever
// the shape: the curve turns by 2π once round. What the cloth under it carried would be missing.
TEST(ElasticWorn, AWaistPressesWithTheTensionOfItsTape) {
  const support::ScratchFolder scratch;
  const auto file = scratch / "elastic_waist.json";
  std::ofstream(file) << support::tube_file(46, 48, 18, 96);
  const double ratio = 0.6, stiffness = 50;
  const CaseResult result = support::only_draped(
      "[garment]\npattern = \"" + file.string() +
      "\"\n[[garment.elastic]]\nedges = [\"front.edge_2\", \"back.edge_2\"]\nratio = 0.6\n"
      "stiffness = 50\n[simulation]\nedge_length = 0.02\n[donning]\nmovements = []\n");
  const garment::Garment& g = result.studied().mesh();
  const drape::Drape& drape = result.studied().drape;
  double tension = 0, weight = 0;
  for (const fabric::BandPart& part : g.bands) {
    double stretch = 0;
    for (const fabric::BandTriangle& t : part.triangles) {
      Vec3 image = Vec3::Zero();
      for (int k = 0; k < 3; ++k) image += t.row[k] * drape.positions[g.triangles[t.triangle][k]];
      stretch += t.share * image.norm();
    }
    tension += part.length * stiffness * fabric::band_law(stretch / ratio - 1).force;
    weight += part.length;
  }
  tension /= weight;
  double pressing = 0;
  for (const double force : drape.body_normal_force) pressing += force;
  EXPECT_GT(tension, 2);
  EXPECT_NEAR(pressing, 2 * kPi * tension, 0.15 * 2 * kPi * tension);
  // The cloth under it is gathered to the waist, though not to the tape's own length.
  double along = 0, area = 0;
  for (const fabric::BandPart& part : g.bands)
    for (const fabric::BandTriangle& under : part.triangles) {
      const int t = under.triangle;
      const auto f =
          geometry::deformation_gradient(g.triangle_uv[t], g.triangles[t], drape.positions);
      const double flat = geometry::flat_area(g.triangle_uv[t]);
      along += flat * f.col(0).norm();
      area += flat;
    }
  EXPECT_GT(along / area, 1.1 * ratio);
  EXPECT_LT(along / area, 0.9);
}

}  // namespace
}  // namespace loosefit::pipeline
