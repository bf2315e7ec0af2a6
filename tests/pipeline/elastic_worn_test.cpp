#include <gtest/gtest.h>

#include <cmath>

#include "support/only_draped.h"

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

}  // namespace
}  // namespace loosefit::pipeline
