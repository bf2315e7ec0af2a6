#include "loosefit/placement/site_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "support/tube_garment.h"

namespace loosefit::placement {
namespace {

constexpr double kRadius = 0.1, kWidth = 2 * kPi * kRadius, kHeight = 0.4;

/// A tube round the z axis; the score is a cone over the pattern with its top at `best`.
class SiteSearch : public ::testing::Test {
 protected:
  SiteSearch() {
    for (const Vec2& uv : tube_.vertex_uv) {
      const double a = uv.x() / kRadius;
      field_.positions.emplace_back(kRadius * std::cos(a), kRadius * std::sin(a), uv.y());
      field_.regions.push_back(uv.y() > 0.3 ? body::Region::shoulder_left : body::Region::chest);
    }
    field_.metrics = [this](const PatternPlace& place) {
      return std::vector<MetricValues>{{{"gap_mm", 1e3 * (place.at - best_).norm()}}};
    };
    card_.footprint.radius = 0.005;
    card_.criteria = {{"gap_mm", {0, 200}, {}, "hangs off", "", "test"}};
  }
  SearchResult search() { return search_sites(tube_, field_, card_, constraints_, options_); }
  std::string refusal() {
    try {
      search();
    } catch (const InvalidInput& e) {
      return std::string(e.what()) + " / " + e.hint();
    }
    return "accepted";
  }

  garment::Garment tube_ = testing::tube_garment(kWidth, kHeight, 60, 40);
  Vec2 best_ = {0.3, 0.15};
  SearchField field_;
  Scorecard card_;
  SearchConstraints constraints_;
  SearchOptions options_;
};

TEST_F(SiteSearch, FindsTheOptimumWithinTheCandidates) {
  options_.best = 1;
  const SearchResult result = search();
  ASSERT_EQ(result.sites.size(), 1u);
  const FoundSite& site = result.sites[0];
  EXPECT_LE((site.place.at - best_).norm(), 1.09 * options_.candidate_spacing);
  EXPECT_NEAR(site.score.robust, 1 - (site.place.at - best_).norm() / 0.2, 1e-12);
  const double a = site.place.at.x() / kRadius;
  EXPECT_NEAR(
      (site.position - Vec3(kRadius * std::cos(a), kRadius * std::sin(a), site.place.at.y()))
          .norm(),
      0, 2e-4)
      << "on the chord of its triangle";
  EXPECT_TRUE(result.shortfall.empty());
}

TEST_F(SiteSearch, KeepsSpacingAsWornAcrossTheSeam) {
  best_ = {0.02, 0.2};  // beside the seam, whose other side is at u = width
  field_.metrics = [this](const PatternPlace& place) {
    const double du = std::remainder(place.at.x() - best_.x(), kWidth);
    return std::vector<MetricValues>{{{"gap_mm", 1e3 * std::hypot(du, place.at.y() - best_.y())}}};
  };
  options_.best = 6;
  constraints_.spacing = 0.06;
  const SearchResult result = search();
  ASSERT_EQ(result.sites.size(), 6u);
  bool both_sides = false;
  for (std::size_t i = 0; i < 6; ++i) {
    both_sides |= result.sites[i].place.at.x() > kWidth / 2;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE((result.sites[i].position - result.sites[j].position).norm(), 0.06);
    EXPECT_LE(result.sites[i].score.robust, result.sites[i > 0 ? i - 1 : 0].score.robust);
  }
  EXPECT_TRUE(both_sides) << "the field goes on behind the seam";
}

TEST_F(SiteSearch, OutlineStaysClearOfSeamsAndEdges) {
  best_ = {0.0, 0.0};  // the corner where seam and hem meet
  constraints_.seam_clearance = 0.02;
  constraints_.edge_clearance = 0.03;
  options_.best = 1;
  const SearchResult result = search();
  ASSERT_EQ(result.sites.size(), 1u);
  EXPECT_GE(result.sites[0].place.at.x(), 0.025 - 1e-12) << "clearance and radius";
  EXPECT_GE(result.sites[0].place.at.y(), 0.035 - 1e-12);
  EXPECT_LE(result.sites[0].place.at.x(), 0.06);
  EXPECT_LE(result.sites[0].place.at.y(), 0.07);
  EXPECT_GT(result.near_seam, 0);
  EXPECT_GT(result.near_edge, 0);
}

TEST_F(SiteSearch, ZonesAndRegionsAreKeptFree) {
  KeepOutZone pocket{"pocket", "tube", KeepOutZone::Shape::rectangle, {0.35, 0.2}, {0.25, 0.1},
                     {},       0};
  constraints_.keep_out.zones = {pocket};
  options_.best = 1;
  const SearchResult beside = search();
  const Vec2 at = beside.sites.at(0).place.at;
  EXPECT_GE(pocket.distance(at), 0.005);
  EXPECT_LE(pocket.distance(at), 0.005 + 1.09 * options_.candidate_spacing);
  EXPECT_GT(beside.kept_out, 0);

  constraints_.keep_out.zones = {{"label", "tube", KeepOutZone::Shape::disc, {}, {}, best_, 0.05}};
  EXPECT_GE((search().sites.at(0).place.at - best_).norm(), 0.055);

  constraints_.keep_out.zones.clear();
  constraints_.keep_out.regions = {body::Region::chest};
  const SearchResult above = search();
  EXPECT_GT(above.kept_out, 0);
  EXPECT_GT(above.sites.at(0).place.at.y(), 0.29);

  constraints_.keep_out = {};
  constraints_.regions = {body::Region::shoulder_left, body::Region::neck};
  const SearchResult only = search();
  EXPECT_GT(only.elsewhere, 0);
  EXPECT_GT(only.sites.at(0).place.at.y(), 0.29);
}

TEST_F(SiteSearch, OnAPlateauTheMarginDecides) {
  card_.criteria[0].limit = {100, 200};  // full score within 100 mm
  options_.best = 1;
  const FoundSite site = search().sites.at(0);
  EXPECT_EQ(site.score.robust, 1);
  EXPECT_LE((site.place.at - best_).norm(), 1.09 * options_.candidate_spacing);
}

TEST_F(SiteSearch, ToleranceAlongAndAroundOfTheField) {
  // Linear in u: 10 % of q = 1 − 5 |u − u0| is lost over 0.02 q at the site; constant in v, where
  // the clearance to the hem ends the shift.
  field_.metrics = [this](const PatternPlace& place) {
    return std::vector<MetricValues>{{{"gap_mm", 1e3 * std::abs(place.at.x() - best_.x())}}};
  };
  options_.best = 1;
  options_.tolerance.reach = 0.3;
  const FoundSite site = search().sites.at(0);
  const double away = std::abs(site.place.at.x() - best_.x()), q = 1 - away / 0.2;
  EXPECT_NEAR(site.tolerance.around, 0.1 * q * 0.2, 3e-6);
  EXPECT_EQ(site.tolerance.around_end, Tolerance::End::score);
  const double clear = constraints_.edge_clearance + card_.footprint.radius;
  EXPECT_NEAR(site.tolerance.along,
              std::min(site.place.at.y(), kHeight - site.place.at.y()) - clear, 3e-6);
  EXPECT_EQ(site.tolerance.along_end, Tolerance::End::outline);
  field_.along = [](const PatternPlace&) { return Vec2(Vec2::UnitX()); };
  EXPECT_NEAR(search().sites.at(0).tolerance.along, 0.1 * q * 0.2, 3e-6);
}

TEST_F(SiteSearch, ManySamplesCountByTheWorst) {
  // Two donnings with the best place 80 mm apart: robust is best in the middle.
  const Vec2 left(0.26, 0.2), right(0.34, 0.2);
  field_.metrics = [&](const PatternPlace& place) {
    return std::vector<MetricValues>{{{"gap_mm", 1e3 * (place.at - left).norm()}},
                                     {{"gap_mm", 1e3 * (place.at - right).norm()}}};
  };
  options_.best = 1;
  EXPECT_NEAR((search().sites.at(0).place.at - Vec2(0.3, 0.2)).norm(), 0,
              1.09 * options_.candidate_spacing);
}

/// Between 0 and 1, another for every place and sample.
double chance(const PatternPlace& place, int sample) {
  const double x = 1e4 * place.at.x() * 12.9898 + 1e4 * place.at.y() * 78.233 + 37.719 * sample;
  const double y = std::sin(x) * 43758.5453;
  return y - std::floor(y);
}

TEST_F(SiteSearch, JudgesPlacesFoundByChanceBySamplesThatDidNotFindThem) {
  constexpr int kSamples = 4;
  field_.metrics = [](const PatternPlace& place) {
    std::vector<MetricValues> samples;
    for (int k = 0; k < kSamples; ++k) samples.push_back({{"gap_mm", 200 * chance(place, k)}});
    return samples;
  };
  options_.best = 8;
  double found = 0, unseen = 0;
  const SearchResult result = search();
  ASSERT_EQ(result.sites.size(), 8u);
  for (const FoundSite& site : result.sites) {
    ASSERT_EQ(site.held_out.size(), std::size_t{kSamples});
    for (int k = 0; k < kSamples; ++k) {
      found += site.score.samples[k] / (8 * kSamples);
      unseen += site.held_out[k] / (8 * kSamples);
    }
  }
  EXPECT_GT(found, 0.7) << "the best of many by chance";
  EXPECT_NEAR(unseen, 0.5, 0.2) << "as any place";

  field_.held_out_together = {0, 0, 1, 1};
  EXPECT_EQ(search().sites[0].held_out.size(), std::size_t{kSamples});
  field_.held_out_together = {0, 0, 0, 0};
  EXPECT_TRUE(search().sites[0].held_out.empty()) << "nothing is left to find a place with";
}

TEST_F(SiteSearch, PlacesThatAreGoodInEverySampleStayGood) {
  field_.metrics = [this](const PatternPlace& place) {
    return std::vector<MetricValues>(3, {{"gap_mm", 1e3 * (place.at - best_).norm()}});
  };
  for (const FoundSite& site : search().sites)
    for (const double score : site.held_out) EXPECT_EQ(score, site.score.robust);
}

TEST_F(SiteSearch, TellsProgressAndCanBeStopped) {
  std::vector<double> shares;
  field_.progress = [&](double share) { shares.push_back(share); };
  search();
  ASSERT_GT(shares.size(), 1u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1);
  field_.progress = [](double) { throw Cancelled(); };
  EXPECT_THROW(search(), Cancelled);
}

TEST_F(SiteSearch, SaysWhyThereAreFewer) {
  card_.criteria[0].limit = {0, 30};  // only within 30 mm of the optimum
  constraints_.spacing = 0.10;
  options_.best = 3;
  const SearchResult result = search();
  EXPECT_EQ(result.sites.size(), 1u);
  EXPECT_GT(result.failing, 0);
  EXPECT_NE(result.shortfall.find("1 of 3 sites"), std::string::npos) << result.shortfall;
  EXPECT_NE(result.shortfall.find(std::to_string(result.failing) + " fail"), std::string::npos);

  field_.metrics = [](const PatternPlace&) { return std::vector<MetricValues>{{}}; };
  const SearchResult unknown = search();
  EXPECT_TRUE(unknown.sites.empty());
  EXPECT_EQ(unknown.not_rated + unknown.near_seam + unknown.near_edge, unknown.candidates);
}

TEST_F(SiteSearch, RefusesWhatItCannotDo) {
  constraints_.keep_out.zones = {{"pocket", "tubs", KeepOutZone::Shape::disc, {}, {}, best_, 0.05}};
  EXPECT_EQ(refusal(),
            "keep-out: found \"tubs\" in pocket, expected a panel of the pattern / did you mean "
            "\"tube\"?");
  constraints_.keep_out.zones.clear();
  options_.best = 0;
  EXPECT_NE(refusal().find("number of sites: found 0"), std::string::npos);
  options_.best = 1;
  constraints_.spacing = -1;
  EXPECT_NE(refusal().find("spacing or clearance: found -1"), std::string::npos);
  constraints_.spacing = 0.05;
  const std::vector<body::Region> regions = field_.regions;
  field_.regions.clear();
  EXPECT_EQ(refusal(), "accepted");
  constraints_.regions = {body::Region::chest};
  EXPECT_NE(refusal().find("and 0 regions, expected one per vertex"), std::string::npos);
  field_.regions = regions;
  field_.positions.pop_back();
  EXPECT_NE(refusal().find("expected one per vertex"), std::string::npos);
}

}  // namespace
}  // namespace loosefit::placement
