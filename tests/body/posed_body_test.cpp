#include "loosefit/body/posed_body.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <set>

#include "loosefit/base/error.h"
#include "loosefit/body/body_frame.h"
#include "support/tube_garment.h"

namespace loosefit::body {
namespace {

TEST(PosedBody, IsABodyWhereverOneIsAskedFor) {
  const Body cylinder = testing::cylinder_body(0.1, 1.0, 12, 4);
  const PosedBody posed = cylinder;
  const Body& body = posed;
  EXPECT_EQ(body.surface.vertices, cylinder.surface.vertices);
  EXPECT_EQ(posed->surface.triangles, cylinder.surface.triangles);
}

TEST(PosedBody, CopiesShareWhatOneOfThemHasMade) {
  const PosedBody posed = testing::cylinder_body(0.1, 1.0, 12, 4);
  const PosedBody copy = posed;
  EXPECT_EQ(&copy.body(), &posed.body());
  EXPECT_EQ(&copy.tree(), &posed.tree());
  EXPECT_EQ(&copy.partners(), &posed.partners());
  EXPECT_EQ(&copy.axes(), &posed.axes());
  EXPECT_EQ(&copy.regions(), &posed.regions());
  EXPECT_EQ(&copy.tree().mesh(), &posed->surface);
}

TEST(PosedBody, OutlivesTheOneItWasCopiedFrom) {
  auto first = std::make_unique<const PosedBody>(testing::cylinder_body(0.1, 1.0, 64, 4));
  const geometry::ClosestPointTree* tree = &first->tree();
  const PosedBody copy = *first;
  first.reset();
  EXPECT_EQ(&copy.tree(), tree);
  EXPECT_NEAR(copy.tree().signed_distance(Vec3(0.3, 0, 0.5)), 0.2, 1e-3);
}

TEST(RememberedBody, KeepsTheIndexOnlyAsLongAsSomebodyElseHoldsIt) {
  auto held = std::make_unique<const PosedBody>(testing::cylinder_body(0.1, 1.0, 12, 4));
  const geometry::ClosestPointTree* tree = &held->tree();
  RememberedBody remembered(*held);
  EXPECT_EQ(&remembered.posed().tree(), tree) << "shared while it is in use";
  const std::vector<Vec3> vertices = (*held)->surface.vertices;
  const Body* body = &held->body();
  held.reset();
  const PosedBody again = remembered.posed();
  EXPECT_EQ(&again.body(), body) << "the body itself is kept";
  EXPECT_EQ(again->surface.vertices, vertices);
  EXPECT_EQ(&remembered.posed().tree(), &again.tree()) << "and shares the next index";
}

TEST(PosedBody, AnswersAsIndicesMadeForItAlone) {
  const Body body = testing::cylinder_body(0.1, 1.0, 24, 8);
  const PosedBody posed = body;
  EXPECT_EQ(posed.axes(), segment_axes(body));
  EXPECT_EQ(posed.regions(), body_regions(body));
  const geometry::ClosestPointTree tree(body.surface);
  const PartnerFinder finder(body, tree);
  const Vec3 place(0.13, 0.02, 0.4), normal(1, 0, 0);
  const BodyPartner own = finder.find(place, normal, BodyPart::trunk),
                    shared = posed.partners().find(place, normal, BodyPart::trunk);
  EXPECT_EQ(shared.exact.triangle, own.exact.triangle);
  EXPECT_EQ(shared.exact.point, own.exact.point);
  EXPECT_EQ(shared.particle_distance, own.particle_distance);
}

TEST(PosedBody, ManyThreadsThatAskAtOnceGetOneIndex) {
  for (int round = 0; round < 20; ++round) {
    const PosedBody posed = testing::cylinder_body(0.1, 1.0, 48, 24);
    std::vector<const void*> trees(64), finders(64);
    std::vector<double> distance(64);
    tbb::parallel_for(0, 64, [&](int i) {
      finders[i] = &posed.partners();
      trees[i] = &posed.tree();
      distance[i] = posed.tree().signed_distance(Vec3(0.12, 0, 0.5));
    });
    EXPECT_EQ(std::set(trees.begin(), trees.end()).size(), 1u);
    EXPECT_EQ(std::set(finders.begin(), finders.end()).size(), 1u);
    EXPECT_EQ(std::set(distance.begin(), distance.end()).size(), 1u);
  }
}

TEST(PosedBody, PartnersNeedSegmentsAndSayItEachTime) {
  Body body = testing::cylinder_body(0.1, 1.0, 12, 4);
  body.segment.clear();
  const PosedBody posed = body;
  EXPECT_THROW(posed.partners(), InvalidInput);
  EXPECT_THROW(posed.partners(), InvalidInput);
  EXPECT_NO_THROW(posed.tree());
}

}  // namespace
}  // namespace loosefit::body
