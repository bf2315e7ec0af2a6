#include <gtest/gtest.h>

#include "support/only_draped.h"

// Boards on a worn shirt.
namespace loosefit::pipeline {
namespace {

/// Largest angle between two triangles of a rigid board [°].
double bent(const garment::Garment::RigidBoard& board, const garment::Garment& mesh,
            const std::vector<Vec3>& x) {
  std::vector<Vec3> normals;
  for (int t : board.triangles) {
    const auto& [a, b, c] = mesh.triangles[t];
    normals.push_back((x[b] - x[a]).cross(x[c] - x[a]).normalized());
  }
  double most = 0;
  for (const Vec3& n : normals) most = std::max(most, n.cross(normals[0]).norm());
  return degrees(std::asin(most));
}

TEST(BoardWorn, IsPlaneStandingAndBentInsideAndOutside) {
  const CaseResult result = support::only_draped(
      "[garment]\npattern = \"t-shirt\"\n[material]\nname = \"cotton-jersey\"\n"
      "[simulation]\nedge_length = 0.03\n[donning]\nmovements = []\n"
      "[postures]\nlist = [\"standing\", \"forward-bend-30\"]\n"
      "[[attachment]]\nkind = \"board\"\nname = \"spine\"\npanel = \"back\"\nat = [0, -0.14]\n"
      "size = [0.04, 0.03]\nmass = 0.015\nthickness = 0.008\n"
      "[[attachment]]\nkind = \"board\"\nname = \"chest\"\npanel = \"front\"\nat = [0.06, -0.2]\n"
      "radius = 0.018\nangle_deg = 20\nmass = 0.01\nthickness = 0.004\nside = \"inside\"\n");
  const garment::Garment& mesh = result.garments.back().mesh();
  ASSERT_EQ(mesh.rigid_boards.size(), 2u);
  ASSERT_EQ(result.wear.states.size(), 1u);
  ASSERT_TRUE(result.wear.states[0].draped()) << result.wear.states[0].left_out;
  for (const drape::Drape* drape : {&result.studied().drape, &result.wear.states[0].drape()})
    for (const auto& board : mesh.rigid_boards) {
      EXPECT_LT(bent(board, mesh, drape->positions), 0.01) << board.name;
      // As long as it was cut: an affine image that is a turned one.
      for (int k = 0; k < 3; ++k) {
        const int a = board.leaders[k], b = board.leaders[(k + 1) % 3];
        const double length = (board.leader_uv[k] - board.leader_uv[(k + 1) % 3]).norm();
        EXPECT_NEAR((drape->positions[a] - drape->positions[b]).norm(), length, 0.003 * length);
      }
    }
}

}  // namespace
}  // namespace loosefit::pipeline
