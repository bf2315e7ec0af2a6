#include <gtest/gtest.h>

#include "loosefit/drape/openings.h"
#include "loosefit/drape/settle_garment.h"
#include "loosefit/pattern/outline.h"
#include "support/shirt_kind.h"
#include "support/worn_shirt.h"

namespace loosefit::drape {
namespace {

/// A T-shirt with neckband, cuffs and hem for a woman with her arms apart.
const pattern::Pattern& banded_shirt() {
  static const pattern::Pattern pattern = [] {
    const body::Body body = support::standing(support::adult_parameters(), 25);
    const kinds::GarmentKind& kind = kinds::garment_kind("t-shirt");
    kinds::ShirtFit fit = support::usual_fit("t-shirt");
    fit.neckband = 0.02;
    fit.cuff = 0.02;
    fit.edge_finish = 0.015;
    kinds::NamedValues measures;
    for (const kinds::KindMeasure& m : kind.measures)
      if (const auto found = body.measured.find(m.of_body); found != body.measured.end())
        measures[m.name] = found->second;
    return kind.draft({measures, {}, kinds::named(fit), {}}).pattern;
  }();
  return pattern;
}

double rim(const std::string& part) {
  double length = 0;
  for (const pattern::Panel& panel : banded_shirt().panels)
    if (panel.part.starts_with(part))
      length += pattern::EdgePath(panel, pattern::find_edge_part(panel, "rim")).length();
  return length;
}

TEST(DrapeBands, RimsOfBandsAreTheOpenings) {
  const auto garment = garment::build_coarsest_level(banded_shirt(), 0.02, support::knit());
  std::map<kinds::OpeningUse, double> girth;
  for (const Opening& opening : garment_openings(garment.finest(), banded_shirt()))
    girth[opening.use] = opening.girth;
  ASSERT_EQ(girth.size(), 4u);
  EXPECT_NEAR(girth.at(kinds::OpeningUse::neck), rim("neckband"), 1e-9);
  EXPECT_NEAR(girth.at(kinds::OpeningUse::left_arm), rim("cuff_L"), 1e-9);
  EXPECT_NEAR(girth.at(kinds::OpeningUse::right_arm), rim("cuff_R"), 1e-9);
  EXPECT_TRUE(girth.count(kinds::OpeningUse::hem));
}

TEST(DrapeBands, AShirtWithBandsSettlesRoundTheNeck) {
  const auto garment = garment::build_hierarchy(banded_shirt(), 0.03, support::knit());
  Progress silent;
  const Drape drape =
      drape_garment(garment, support::knit(),
                    support::arms_path(support::adult_parameters(), 25, 25), {}, silent);
  EXPECT_TRUE(drape.certificate.settled()) << drape.certificate.residual;
  // The rim lies round the neck, above its seam on average, and is not pulled over the shoulders.
  const garment::Garment& shirt = garment.finest();
  const auto mean_of = [&](const char* panel, const char* edge) {
    Vec3 sum = Vec3::Zero();
    const auto* chain = shirt.find_part(panel, edge);
    for (const int v : chain->vertices) sum += drape.positions[v];
    return Vec3(sum / double(chain->vertices.size()));
  };
  for (const char* half : {"neckband_front", "neckband_back"}) {
    const Vec3 above = mean_of(half, "rim"), seam = mean_of(half, "seam");
    EXPECT_GT(above.z(), seam.z() + 0.004) << half;
    EXPECT_LT((above - seam).norm(), 0.05) << half;
  }
}

}  // namespace
}  // namespace loosefit::drape
