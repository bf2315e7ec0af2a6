#include "loosefit/drape/refine_contact.h"

#include <gtest/gtest.h>

#include "loosefit/drape/raise_offsets.h"
#include "support/square_over_ball.h"

namespace loosefit::drape {
namespace {

struct Square : testing_support::SquareOverBall {
  using SquareOverBall::SquareOverBall;
  const std::vector<contact::ContactPoint>& points() const { return model->body().points(); }
  const geometry::ClosestPointTree& skin() const { return body->body.tree(); }
  ContactRefinement refine(const std::set<int>& cut = {}) {
    return refine_contact(*model, *body, x, cut, PenetrationTuning{});
  }
};

TEST(RefineContact, LeavesClothFarFromTheSkinAsItIs) {
  Square square(0.01);
  const std::size_t before = square.points().size();
  const ContactRefinement done = square.refine();
  EXPECT_EQ(done.triangles, 0);
  EXPECT_EQ(done.places, 0);
  EXPECT_EQ(square.points().size(), before);
  for (const contact::ContactPoint& p : square.points()) EXPECT_EQ(p.field_error, 0);
}

TEST(RefineContact, GivesTrianglesNearTheSkinTheirPointsOnceAndKeepsTheArea) {
  Square square(1e-4);
  const auto area = [&] {
    double sum = 0;
    for (const contact::ContactPoint& p : square.points()) sum += p.area;
    return sum;
  };
  const double before = area();
  EXPECT_GT(square.refine().triangles, 0);
  EXPECT_LT(square.refine().triangles, 1);
  EXPECT_NEAR(area(), before, 1e-12 * before);
}

TEST(RefineContact, EveryPointNearTheSkinThenSeesItsExactDistance) {
  Square square(1e-4);
  square.refine();
  double largest = 0;
  int near = 0;
  for (const contact::ContactPoint& p : square.points()) {
    const double exact = square.skin().signed_distance(p.position(square.x));
    if (!(std::abs(exact) < 1e-3)) continue;
    ++near;
    const double seen = square.model->body().field_distance(p, square.x, 0.01) - p.field_error;
    EXPECT_NEAR(seen, exact, 1e-12);
    largest = std::max(largest, std::abs(p.field_error));
  }
  EXPECT_GT(near, 10);
  EXPECT_GT(largest, 2e-5);  // the ball has faces of 13 mm: the smooth field errs
}

TEST(RefineContact, ACornerOfTheSkinThatCutsATriangleGetsAPointOfItsOwn) {
  Square square(-1e-4);
  // The pole of the ball is a corner of the skin beside the middle of the square, its vertex.
  for (Vec3& p : square.x) p += Vec3(0.004, 0.003, 0);
  const auto deepest = [&] {
    double least = 1;
    for (const contact::ContactPoint& p : square.points())
      least = std::min(least, square.skin().signed_distance(p.position(square.x)));
    return least;
  };
  const double by_vertices = deepest();
  const std::set<int> cut =
      penetrating_triangles(square.model->mesh(), square.body->body, square.x);
  ASSERT_FALSE(cut.empty());
  square.refine();
  EXPECT_LT(deepest(), by_vertices);
  // No finer sampling of the cut triangles finds a deeper place.
  double sampled = 1;
  constexpr int kFine = 60;
  for (int t : cut) {
    const Triangle& c = square.garment.triangles[t];
    for (int i = 0; i <= kFine; ++i)
      for (int j = 0; i + j <= kFine; ++j) {
        const Vec3 p =
            (i * square.x[c[0]] + j * square.x[c[1]] + (kFine - i - j) * square.x[c[2]]) / kFine;
        sampled = std::min(sampled, square.skin().signed_distance(p));
      }
  }
  EXPECT_LT(deepest(), sampled + 2e-5);
}

TEST(RefineContact, NoPointRestsFartherThanHalfTheThickness) {
  Square square(-1e-3);
  square.refine();
  square.refine(penetrating_triangles(square.model->mesh(), square.body->body, square.x));
  for (const contact::ContactPoint& p : square.points())
    EXPECT_EQ(p.offset, 0.5 * square.material.thickness);
}

}  // namespace
}  // namespace loosefit::drape
