#include "loosefit/placement/site_ranking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "loosefit/base/error.h"
#include "support/tube_garment.h"

namespace loosefit::placement {
namespace {

constexpr double kBody = 0.12, kRadius = 0.13;

/// Tube round an upright cylinder, shifted sideways by 8 mm: its gap is 10 mm + 8 mm cos(angle),
/// less half the thickness, least at u of half way round.
class SiteRanking : public ::testing::Test {
 protected:
  SiteRanking() {
    body_.landmarks = {
        {"c7", {0, kBody, 0.75}}, {"back_waist", {0, kBody, 0.40}}, {"sternum", {0, -kBody, 0.62}}};
    body_.joints = {{"pelvis", {0, 0, 0.3}}, {"neck", {0, 0, 0.9}}};
    for (const Vec2& uv : tube_.vertex_uv) positions_.push_back(place(uv));
    worn_ = maps::relate(tube_, positions_, body_);
    material_.thickness = 0.0004;
    meter_ = std::make_unique<SiteMeter>(tube_, material_,
                                         std::vector<WornState>{{0, 0, positions_, body_, worn_}});
    wish_.scorecard.name = "gap";
    wish_.scorecard.footprint.radius = 0.004;
    wish_.scorecard.criteria = {{"gap_mm", {0, 20}, {}, "hangs off", "", "test"}};
  }
  static Vec3 place(const Vec2& uv) {
    const double a = uv.x() / kRadius;
    return {kRadius * std::cos(a) + 0.008, kRadius * std::sin(a), 0.35 + uv.y()};
  }
  static double gap(const Vec3& at) { return std::hypot(at.x(), at.y()) - kBody - 0.0002; }
  RankingGround ground() { return {tube_, positions_, body_, worn_, *meter_}; }
  std::vector<Site> sites(const std::vector<SiteSpec>& wished) {
    return find_sites(tube_, positions_, body_, worn_, {}, wished, false);
  }

  body::Body body_ = testing::cylinder_body(kBody, 1.0, 120, 40);
  garment::Garment tube_ = testing::tube_garment(2 * kPi * kRadius, 0.4, 80, 40);
  std::vector<Vec3> positions_;
  maps::WornGarment worn_;
  fabric::Material material_;
  std::unique_ptr<SiteMeter> meter_;
  RankingWish wish_;
};

TEST_F(SiteRanking, GivenSitesByTheirGap) {
  const double turn = 2 * kPi * kRadius;
  wish_.sites = sites({{"far", "tube", {0.01 * turn, 0.2}},
                       {"near", "tube", {0.5 * turn, 0.2}},
                       {"between", "tube", {0.25 * turn, 0.2}}});
  const RankingTable table = make_ranking(ground(), wish_);
  ASSERT_EQ(table.ranking.sites.size(), 3u);
  EXPECT_EQ(table.ranking.sites[0].name, "near");
  EXPECT_EQ(table.ranking.sites[1].name, "between");
  EXPECT_EQ(table.ranking.sites[2].name, "far");
  for (const RankedSite& site : table.ranking.sites) {
    const double expected = gap(table.places[site.index].position);
    EXPECT_NEAR(site.score.robust, 1 - expected / 0.020, 0.01) << site.name;
  }
  EXPECT_EQ(table.ranking.samples, 1);
  EXPECT_EQ(table.places[0].panel, "tube");
}

TEST_F(SiteRanking, SearchFindsTheNarrowSideAndRanksItAmongTheGiven) {
  const double turn = 2 * kPi * kRadius;
  wish_.sites = sites({{"mine", "tube", {0.25 * turn, 0.2}}});
  wish_.best = 2;
  wish_.constraints.spacing = 0.08;
  const RankingTable table = make_ranking(ground(), wish_);
  ASSERT_EQ(table.ranking.sites.size(), 3u);
  EXPECT_EQ(table.ranking.sites[2].name, "mine");
  for (int i = 1; i <= 2; ++i) {
    EXPECT_EQ(table.sites[i].name, "best_" + std::to_string(i));
    EXPECT_NEAR(table.places[i].at.x(), turn / 2, 0.05);
    ASSERT_TRUE(table.places[i].tolerance.has_value());
    EXPECT_TRUE(table.places[0].tolerance.has_value()) << "given sites have one as well";
    // Around: the gap grows by 8 mm (1 - cos(s/R)); a tenth of the score 0.9 is 1.8 mm.
    const double off = std::abs(table.places[i].at.x() - turn / 2);
    const double score = table.ranking.sites[i - 1].score.robust;
    const double a = std::acos(std::cos(off / kRadius) - 0.1 * score * 0.020 / 0.008) * kRadius;
    EXPECT_NEAR(table.places[i].tolerance->around, std::min(0.05, a - off), 0.004);
  }
}

TEST_F(SiteRanking, SearchLooksWhereTheScorecardOrTheWishSays) {
  wish_.best = 1;
  const auto found = [&] { return make_ranking(ground(), wish_); };
  const std::string narrow = found().places.at(0).region;
  wish_.scorecard.regions = {body::Region::side_left};
  const RankingTable by_card = found();
  EXPECT_NE(narrow, "side_L");
  EXPECT_EQ(by_card.places.at(0).region, "side_L");
  EXPECT_EQ(by_card.notes.at(0), "searched over side_L");
  wish_.constraints.regions = {body::Region::chest};
  EXPECT_EQ(found().places.at(0).region, "chest");
}

TEST_F(SiteRanking, MissingPosturesAreSaidOrLeftOut) {
  wish_.sites = sites({{"mine", "tube", {0.1, 0.2}}});
  wish_.scorecard.criteria.push_back({"slip_mm", {2, 6}, {}, "slips", "", "test"});
  const RankingTable strict = make_ranking(ground(), wish_);
  EXPECT_EQ(strict.ranking.sites[0].rank, 0);
  EXPECT_EQ(strict.ranking.sites[0].score.reason, "not rated: needs slip_mm (several postures)");
  wish_.partial = true;
  const RankingTable part = make_ranking(ground(), wish_);
  EXPECT_EQ(part.ranking.sites[0].rank, 1);
  EXPECT_EQ(part.scorecard.left_out, std::vector<std::string>{"slip_mm"});
  wish_.scorecard.criteria.erase(wish_.scorecard.criteria.begin());
  EXPECT_EQ(make_ranking(ground(), wish_).ranking.sites[0].rank, 0) << "nothing to judge by";
}

TEST_F(SiteRanking, EveryMetricIsThatOfTheSitesOwnFootprint) {
  std::mt19937_64 rng(11);
  std::uniform_real_distribution<double> side(0.012, 0.045), any(0, 1);
  wish_.scorecard.footprint.radius = 0.012;
  std::vector<SiteSpec> specs;
  for (int i = 0; i < 8; ++i) {
    SiteSpec& spec =
        specs.emplace_back(SiteSpec{"s" + std::to_string(i), "tube", {0.1 + 0.2 * any(rng), 0.2}});
    spec.angle = 1.5 * any(rng);
    spec.footprint.kind = FootprintShape::Kind::rectangle;
    spec.footprint.size = {side(rng), side(rng)};
  }
  wish_.sites = sites(specs);
  const RankingTable table = make_ranking(ground(), wish_);
  const SensorProbe probe(ground(), wish_.scorecard);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const MetricValues& ranked = table.sites[i].samples.at(0);
    EXPECT_NEAR(ranked.at("sensor_diameter_mm"), 1e3 * specs[i].footprint.size.maxCoeff(), 1e-9);
    const MetricValues here = probe.at(wish_.sites[i]).at(0),
                       state = probe.in_states(wish_.sites[i]).at(0);
    for (const auto& [metric, value] : ranked) {
      if (!std::isfinite(value)) continue;
      EXPECT_EQ(here.at(metric), value) << metric;
      EXPECT_EQ(state.at(metric), value) << metric << ": one state is all of them";
    }
  }
}

TEST_F(SiteRanking, SensorIsThatOfTheScorecardUnlessTheSiteStatesOne) {
  SiteSpec plain{"plain", "tube", {0.2, 0.2}}, own = plain, turned = plain, band = plain;
  own.name = "own";
  own.footprint.kind = FootprintShape::Kind::rectangle;
  own.footprint.size = {0.02, 0.03};
  turned.name = "turned";
  turned.angle = 0.3;
  band.name = "band";
  band.footprint.kind = FootprintShape::Kind::girth;
  wish_.scorecard.around = true;
  std::vector<std::string> left_out;
  const auto with =
      sites_with_sensor(ground(), sites({plain, own, turned, band}), wish_.scorecard, left_out);
  ASSERT_EQ(with.size(), 3u);
  EXPECT_EQ(left_out, std::vector<std::string>{"band"});
  EXPECT_DOUBLE_EQ(with[0].shape.radius, 0.004);
  EXPECT_NEAR(with[0].angle, kPi / 2, 0.01) << "around the trunk";
  EXPECT_EQ(with[1].shape.kind, FootprintShape::Kind::rectangle);
  EXPECT_EQ(with[1].angle, 0);
  EXPECT_EQ(with[2].angle, 0.3);
  wish_.scorecard.footprint.kind = FootprintShape::Kind::line;
  wish_.scorecard.footprint.length = 0.06;
  EXPECT_EQ(sites_with_sensor(ground(), sites({band}), wish_.scorecard, left_out).size(), 1u);
}

// A tube 4 % too wide for its pattern all round: strain 0.04 around, none along.
TEST_F(SiteRanking, LineAroundMeasuresTheHoopStrain) {
  for (Vec3& p : positions_) p.head<2>() *= 1.04;
  worn_ = maps::relate(tube_, positions_, body_);
  meter_ = std::make_unique<SiteMeter>(tube_, material_,
                                       std::vector<WornState>{{0, 0, positions_, body_, worn_}});
  wish_.scorecard.criteria = {{"strain", {0.05, 0}, {}, "loose", "", "test"}};
  wish_.scorecard.footprint.kind = FootprintShape::Kind::line;
  wish_.scorecard.footprint.length = 0.06;
  SiteSpec band{"band", "tube", {0.2, 0.2}};
  band.footprint.kind = FootprintShape::Kind::girth;
  for (const bool around : {true, false}) {
    wish_.scorecard.around = around;
    wish_.sites = sites({{"line", "tube", {0.2, 0.2}}, band});
    const RankingTable table = make_ranking(ground(), wish_);
    EXPECT_NEAR(table.sites[0].samples[0].at("strain"), around ? 0.04 : 0, 1e-3);
    EXPECT_NEAR(table.sites[1].samples[0].at("strain"), 0.04, 1e-3) << "a girth is always around";
  }
}

TEST_F(SiteRanking, SearchWithAGirthIsRefused) {
  wish_.scorecard.footprint.kind = FootprintShape::Kind::girth;
  wish_.best = 1;
  EXPECT_THROW(make_ranking(ground(), wish_), InvalidInput);
}

/// The same tube on the same body, shifted by another length.
struct OtherWearer {
  std::vector<Vec3> positions;
  maps::WornGarment worn;
  SiteMeter meter;
  OtherWearer(const garment::Garment& tube, std::vector<Vec3> at, const body::Body& body,
              const fabric::Material& material)
      : positions(std::move(at)),
        worn(maps::relate(tube, positions, body)),
        meter(tube, material, {{0, 0, positions, body, worn}}) {}
};

TEST_F(SiteRanking, EveryWearerIsASampleOfTheSameSewnPlace) {
  std::vector<Vec3> nearer = positions_;
  for (Vec3& p : nearer) p.x() -= 0.003;  // now 5 mm off the middle
  const OtherWearer other(tube_, nearer, body_, material_);
  const std::vector<RankingWearer> wearers = {
      {"one", ground()}, {"two", {tube_, other.positions, body_, other.worn, other.meter}}};
  const double turn = 2 * kPi * kRadius;
  wish_.sites = sites({{"mine", "tube", {0.01 * turn, 0.2}}, {"near", "tube", {0.5 * turn, 0.2}}});
  wish_.best = 1;
  const RankingTable table = make_ranking(wearers, wish_);
  EXPECT_EQ(table.sample_names, (std::vector<std::string>{"one", "two"}));
  ASSERT_EQ(table.ranking.samples, 2);
  ASSERT_EQ(table.sites.size(), 3u);
  for (const SiteSamples& site : table.sites) ASSERT_EQ(site.samples.size(), 2u) << site.name;
  // At u = 0 the tube stands off most: 10 + 8 mm on the first, 10 + 5 on the second.
  EXPECT_NEAR(table.sites[0].samples[0].at("gap_mm"), 17.8, 0.1);
  EXPECT_NEAR(table.sites[0].samples[1].at("gap_mm"), 14.8, 0.1);
  // Half way round the first is nearer, so the second makes the robust score.
  EXPECT_NEAR(table.sites[1].samples[1].at("gap_mm"), 4.8, 0.1);
  for (const RankedSite& site : table.ranking.sites)
    EXPECT_EQ(site.score.robust_sample, site.name == "mine" ? 0 : 1) << site.name;
}

TEST_F(SiteRanking, AnotherMeshOfTheSameCutIsFoundByThePlaceInThePattern) {
  const garment::Garment fine = testing::tube_garment(2 * kPi * kRadius, 0.4, 120, 60);
  std::vector<Vec3> at;
  for (const Vec2& uv : fine.vertex_uv) at.push_back(place(uv));
  const OtherWearer other(fine, at, body_, material_);
  wish_.sites = sites({{"mine", "tube", {0.21, 0.2}}});
  const RankingTable table = make_ranking(
      {{"one", ground()}, {"two", {fine, other.positions, body_, other.worn, other.meter}}}, wish_);
  EXPECT_NEAR(table.sites[0].samples[0].at("gap_mm"), table.sites[0].samples[1].at("gap_mm"), 0.1);
}

TEST_F(SiteRanking, WearersOfOtherCutsHaveTheirOwnSitesAndNoSearch) {
  const double turn = 2 * kPi * kRadius;
  wish_.sites = sites({{"mine", "tube", {0.01 * turn, 0.2}}});
  std::vector<RankingWearer> wearers = {{"one", ground()}, {"two", ground()}};
  wearers[1].sites = sites({{"mine", "tube", {0.5 * turn, 0.2}}});
  const RankingTable table = make_ranking(wearers, wish_);
  EXPECT_NEAR(table.sites[0].samples[0].at("gap_mm"), 17.8, 0.1);
  EXPECT_NEAR(table.sites[0].samples[1].at("gap_mm"), 1.8, 0.1);
  EXPECT_FALSE(table.places[0].tolerance) << "one shift of two places means nothing";
  wish_.best = 1;
  EXPECT_THROW(make_ranking(wearers, wish_), InvalidInput);
  wish_.best = 0;
  wearers[1].sites[0].name = "yours";
  EXPECT_THROW(make_ranking(wearers, wish_), InvalidInput);
  EXPECT_THROW(make_ranking(std::vector<RankingWearer>{}, wish_), InvalidInput);
}

TEST_F(SiteRanking, APlaceThatAWearersGarmentLacksIsRefused) {
  const garment::Garment narrow = testing::tube_garment(0.5, 0.4, 80, 40);
  std::vector<Vec3> at;
  for (const Vec2& uv : narrow.vertex_uv) at.push_back(place(uv));
  const OtherWearer other(narrow, at, body_, material_);
  wish_.sites = sites({{"mine", "tube", {0.7, 0.2}}});
  try {
    make_ranking(
        {{"one", ground()}, {"two", {narrow, other.positions, body_, other.worn, other.meter}}},
        wish_);
    FAIL() << "nothing there";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("site mine: found no cloth at panel tube"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(SiteRanking, DistancesToBordersAreToldAndNearOnesNoted) {
  // The hems of the tube are at v = 0 and 0.4; its seam is welded at u = 0.
  wish_.sites = sites({{"low", "tube", {0.3, 0.012}}, {"middle", "tube", {0.3, 0.2}}});
  const RankingTable table = make_ranking(ground(), wish_);
  EXPECT_NEAR(table.places[0].to_edge, 0.012, 1e-9);
  EXPECT_NEAR(table.places[1].to_edge, 0.2, 1e-9);
  bool noted = false;
  for (const std::string& note : table.notes)
    noted |=
        note ==
        "nearer to a seam (10 mm), an edge (10 mm) or what is kept free than a search allows: low";
  EXPECT_TRUE(noted);
}

TEST_F(SiteRanking, ZonesOnPanelsThatAreNotThereAreRefusedWithoutASearchToo) {
  wish_.sites = sites({{"mine", "tube", {0.3, 0.2}}});
  KeepOutZone zone;
  zone.name = "pocket";
  zone.panel = "tubs";
  wish_.constraints.keep_out.zones = {zone};
  EXPECT_THROW(make_ranking(ground(), wish_), InvalidInput);
  wish_.constraints.keep_out.zones[0].panel = "tube";
  wish_.constraints.keep_out.zones[0].lower = {0.25, 0.15};
  wish_.constraints.keep_out.zones[0].upper = {0.35, 0.25};
  const RankingTable table = make_ranking(ground(), wish_);
  EXPECT_NE(table.notes.back().find("what is kept free than a search allows: mine"),
            std::string::npos);
}

TEST_F(SiteRanking, ToleranceEndsWhereNoSensorMayBe) {
  // 4 mm radius and 10 mm clearance: the centre stays 14 mm off the hem, so 26 mm of shift are
  // left.
  wish_.scorecard.criteria = {{"gap_mm", {0, 200}, {}, "hangs off", "", "test"}};
  wish_.sites = sites({{"low", "tube", {0.3, 0.040}}});
  const RankingTable table = make_ranking(ground(), wish_);
  ASSERT_TRUE(table.places[0].tolerance);
  EXPECT_NEAR(table.places[0].tolerance->along, 0.026, 1e-4);
  EXPECT_EQ(table.places[0].tolerance->along_end, Tolerance::End::outline);
}

TEST_F(SiteRanking, SegmentDirectionFollowsTheCut) {
  const SegmentDirection straight(tube_, positions_, body_, worn_);
  EXPECT_NEAR(straight.along(1234), 0, 1e-2);
  EXPECT_NEAR(straight.around(1234), kPi / 2, 1e-2);
  // The same tube cut with the grain around it: u up, v the other way round.
  garment::Garment turned = tube_;
  for (auto& uv : turned.triangle_uv)
    for (Vec2& p : uv) p = Vec2(p.y(), -p.x());
  const SegmentDirection across(turned, positions_, body_, worn_);
  EXPECT_NEAR(std::abs(std::remainder(across.along(1234) + kPi / 2, 2 * kPi)), 0, 1e-2);
}

TEST_F(SiteRanking, PlacesWithoutSkinUnderThemAreListedApart) {
  for (Vec3& p : positions_)
    if (p.x() > 0) p.x() += 0.2;  // one half of the tube stands off
  worn_ = maps::relate(tube_, positions_, body_);
  meter_ = std::make_unique<SiteMeter>(tube_, material_,
                                       std::vector<WornState>{{0, 0, positions_, body_, worn_}});
  const double turn = 2 * kPi * kRadius;
  wish_.sites = sites({{"off", "tube", {0.01 * turn, 0.2}}, {"on", "tube", {0.5 * turn, 0.2}}});
  wish_.uncovered = {{"wrist", false, "the garment ends 300 mm away from it"}};
  wish_.best = 5;
  const RankingTable table = make_ranking(ground(), wish_);
  for (const RankedSite& site : table.ranking.sites) EXPECT_NE(site.name, "off");
  for (const RankedPlace& place : table.places) EXPECT_LT(place.position.x(), 0.14);
  ASSERT_EQ(table.uncovered.size(), 2u);
  EXPECT_EQ(table.uncovered[0].name, "wrist");
  EXPECT_EQ(table.uncovered[1].name, "off");
}

}  // namespace
}  // namespace loosefit::placement
