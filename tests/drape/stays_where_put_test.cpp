#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "loosefit/drape/drape_session.h"
#include "loosefit/drape/worn.h"
#include "support/sewn_garments.h"
#include "support/shirt_on_body.h"

namespace loosefit::drape {
namespace {

using namespace testing_support;

body::BodyParameters heavy_man_parameters() {
  body::BodyParameters p;
  p.sex = 1;
  p.age = 50;
  p.weight = 0.9;
  return p;
}

/// Arms wide aside, so that flat panels find room between them.
constexpr double kArms = 70;

struct Wearer {
  std::string name;
  body::BodyParameters parameters;
};
void PrintTo(const Wearer& wearer, std::ostream* out) { *out << wearer.name; }

class StaysWherePut : public ::testing::TestWithParam<Wearer> {
 protected:
  const body::Body body = support::standing(GetParam().parameters, kArms);
  const Levels levels = levels_of(body);

  Drape drape(const garment::GarmentHierarchy& garment, const fabric::Material& material) const {
    Progress silent;
    return drape_garment(
        garment, material, [this](double) { return body; }, DrapeOptions{}, silent);
  }
  /// Height of the highest point of the garment at rest [m].
  double top(const pattern::Pattern& pattern, fabric::Material material = {}) const {
    material.bending_warp = material.bending_weft = 5e-6;
    const garment::GarmentHierarchy garment = garment::build_hierarchy(pattern, 0.03, material);
    const Drape d = drape(garment, material);
    EXPECT_TRUE(d.certificate.settled()) << pattern.name << ": " << d.certificate.stop_reason
                                         << (d.unsettled ? d.unsettled->why : "");
    EXPECT_EQ(why_not_worn(garment.finest(), pattern, d.positions, body),
              std::vector<std::string>{})
        << pattern.name;
    double highest = 0;
    for (const Vec3& p : d.positions) highest = std::max(highest, p.z());
    return highest;
  }
};

TEST_P(StaysWherePut, SkirtsNarrowerThanTheHip) {
  // A ring without ease cannot fall past the widest place of the trunk below it.
  for (const double ring : {0.85, 0.95}) {
    const double moved = top(skirt(levels, ring, 1.4, 0.45, 8)) - levels.waist_height;
    EXPECT_GT(moved, -0.08) << ring;
    EXPECT_LT(moved, 0.10) << ring;
  }
}

TEST_P(StaysWherePut, TrousersWithASnugWaist) {
  const double moved = top(trousers(levels, 0.97, 1.12)) - levels.waist_height;
  EXPECT_GT(moved, -0.08);
  EXPECT_LT(moved, 0.06);
}

TEST_P(StaysWherePut, DressesAndTopsOnTheShoulders) {
  for (const double length : {0.6, 0.9}) {
    const double moved =
        top(testing_support::dress(levels, 1.15, length * levels.neck_height / 1.44)) -
        levels.neck_height;
    EXPECT_GT(moved, -0.04) << length;
    EXPECT_LT(moved, 0.04) << length;
  }
}

INSTANTIATE_TEST_SUITE_P(Wearers, StaysWherePut,
                         ::testing::Values(Wearer{"woman", support::adult_parameters()},
                                           Wearer{"child", support::slim_child_parameters()},
                                           Wearer{"man", heavy_man_parameters()}),
                         [](const auto& wearer) { return wearer.param.name; });

}  // namespace
}  // namespace loosefit::drape
