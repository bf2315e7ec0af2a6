#include "loosefit/pipeline/check_worn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/drape/rims.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/vtp_read.h"
#include "loosefit/io/vtp_write.h"
#include "loosefit/pipeline/case_files.h"
#include "loosefit/pipeline/case_warnings.h"
#include "loosefit/pipeline/load_case.h"
#include "loosefit/pipeline/map_case.h"
#include "loosefit/pipeline/run_case.h"
#include "support/scratch_folder.h"
#include "support/trunk_tubes.h"

namespace loosefit::pipeline {
namespace {

namespace fs = std::filesystem;

class CheckWorn : public ::testing::Test {
 protected:
  /// A tube round the trunk of a woman, cut by support::tube_file, as the whole pipeline sees it.
  CaseResult tube(double top, double bottom, double height, double above_floor,
                  const std::string& more = "", bool allow = false) const {
    const fs::path file = folder_ / "tube.json";
    io::write_text_file(file.string(), support::tube_file(top, bottom, height, above_floor));
    const std::string text =
        "[body]\nsex = \"female\"\nage = 30\nheight = 1.68\n"
        "[garment]\npattern = \"" +
        file.string() +
        "\"\n"
        "[output]\nmaps = [\"distance\"]\npreset_sites = false\n"
        "[simulation]\nedge_length = 0.04\ntime_budget = 60\n" +
        more;
    Progress silent;
    RunOptions options;
    options.allow_unsettled = allow;
    return run_case(io::parse_scenario(text, "case.toml"), silent, options);
  }
  void store(const CaseResult& result) const {
    write_case_files(folder_, result);
    write_summary_file(folder_, result);
  }
  const support::ScratchFolder folder_;
};

TEST_F(CheckWorn, ASkirtWithASnugWaistIsWorn) {
  const CaseResult result = tube(34, 56, 45, 60);
  const drape::Certificate& c = result.certificate();
  ASSERT_TRUE(c.settled()) << c.stop_reason;
  EXPECT_EQ(c.worn_reasons, std::vector<std::string>{});
  EXPECT_FALSE(result.sealed());
  EXPECT_FALSE(result.studied().maps.maps.empty());
}

// A tube that is narrower than the hips is put on at the waist and climbs above it.
TEST_F(CheckWorn, ATubeThatClimbsToBelowTheBustIsWornWithAWarning) {
  const CaseResult result = tube(36, 36, 22, 50);
  ASSERT_TRUE(result.certificate().settled()) << result.certificate().stop_reason;
  EXPECT_EQ(result.certificate().worn_reasons, std::vector<std::string>{});
  EXPECT_FALSE(result.sealed());
  EXPECT_TRUE(std::any_of(result.warnings.begin(), result.warnings.end(), [](const auto& warning) {
    return warning.starts_with("fit: the waistband lies") &&
           warning.find("is too narrow for this body") != std::string::npos;
  }));
}

bool warns(const CaseResult& result, const std::string& begin, const std::string& end) {
  const std::vector<std::string> all = case_warnings(result);
  return std::any_of(all.begin(), all.end(), [&](const std::string& warning) {
    return warning.starts_with(begin) && warning.ends_with(end);
  });
}

std::vector<std::string> reasons_of(const CaseResult& result, const std::vector<Vec3>& positions) {
  drape::Drape drape = result.studied().drape;
  drape.positions = positions;
  return check_worn({drape}, result.garments, result.scenario, result.body.body)
      .front()
      .certificate.worn_reasons;
}

bool any_has(const std::vector<std::string>& reasons, const std::string& part) {
  return std::any_of(reasons.begin(), reasons.end(), [&](const std::string& reason) {
    return reason.find(part) != std::string::npos;
  });
}

TEST_F(CheckWorn, ClothThatIsStrainedToTearingInARegionIsNotWorn) {
  const CaseResult result = tube(34, 56, 45, 60);
  ASSERT_EQ(result.certificate().worn_reasons, std::vector<std::string>{});
  // The lower half is drawn out downwards; its rims keep their length.
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& p : result.studied().drape.positions)
    low = std::min(low, p.z()), high = std::max(high, p.z());
  const auto drawn_out = [&](double stretch) {
    std::vector<Vec3> x = result.studied().drape.positions;
    for (Vec3& p : x) p.z() += stretch * std::min(0.0, p.z() - 0.5 * (low + high));
    return reasons_of(result, x);
  };
  EXPECT_FALSE(any_has(drawn_out(0.9 * drape::kTears), "strained beyond"));
  const auto reasons = drawn_out(1.5 * drape::kTears);
  EXPECT_TRUE(any_has(reasons, "of the cloth at thigh_")) << join(reasons, "; ");
  EXPECT_FALSE(any_has(reasons, "of the cloth at abdomen")) << join(reasons, "; ");
}

// A small part of the whole, which half of its area would never tell.
TEST_F(CheckWorn, ARimThatIsStretchedToTearingIsNotWornAndIsNamed) {
  const CaseResult result = tube(34, 56, 45, 60);
  const auto rims = drape::garment_rims(result.studied().mesh(), result.studied().pattern.pattern,
                                        result.body.body);
  ASSERT_EQ(rims.size(), 2u);
  for (const drape::Rim& rim : rims)
    for (const double stretch : {0.9 * drape::kTears, 1.1 * drape::kTears}) {
      // The rim alone is widened about its middle to a length of its own.
      std::vector<Vec3> x = result.studied().drape.positions;
      Vec3 middle = Vec3::Zero();
      for (const int v : rim.opening.loop)
        middle += x[v] / static_cast<double>(rim.opening.loop.size());
      const double factor = (1 + stretch) * rim.cut() / rim.length(x);
      for (const int v : rim.opening.loop) x[v] = middle + factor * (x[v] - middle);
      const auto reasons = reasons_of(result, x);
      EXPECT_EQ(any_has(reasons, rim.name + " is stretched to"), stretch > drape::kTears)
          << rim.name << ": " << join(reasons, "; ");
    }
}

TEST_F(CheckWorn, ASkirtThatPassesNeitherHipsNorChestNeedsAFasteningAndIsWorn) {
  const CaseResult narrow = tube(34, 56, 45, 60);  // 0.68 m at the waist
  EXPECT_EQ(narrow.putting_on.possible, false);
  EXPECT_TRUE(narrow.certificate().worn());
  EXPECT_TRUE(warns(narrow, "fit: cannot be put on without a fastening: the waist opens to", ""));
  store(narrow);
  const auto summary =
      nlohmann::json::parse(io::read_text_file((folder_ / "summary.json").string(), 50000000));
  EXPECT_EQ(summary["can_be_put_on"], false);
  EXPECT_EQ(summary["can_be_put_on_reasons"].size(), 1u);
  Progress silent;
  const CaseResult again = load_case(folder_, silent);
  EXPECT_EQ(again.putting_on.possible, false);
  EXPECT_EQ(again.putting_on.reasons, narrow.putting_on.reasons);
}

TEST_F(CheckWorn, ADrapeWithATornRimTakesBackThatItCanBePutOn) {
  CaseResult wide = tube(44, 56, 45, 60);
  ASSERT_EQ(wide.putting_on.possible, true) << join(wide.putting_on.reasons, "; ");
  doubt_putting_on(wide);
  EXPECT_EQ(wide.putting_on.possible, true) << "nothing is torn";
  for (Vec3& p : wide.garments.back().drape.positions) p *= 3;
  doubt_putting_on(wide);
  EXPECT_FALSE(wide.putting_on.possible.has_value());
  EXPECT_NE(putting_on_verdict(wide.putting_on).find("not judged: as draped, "), std::string::npos);
}

TEST_F(CheckWorn, AWaistThatHasRisenIsToldOfPosturesAndOfGarmentsUnderOthers) {
  const CaseResult risen = tube(36, 36, 22, 50);
  const std::string kRisen = "the waistband lies", kEnd = "is too narrow for this body";
  EXPECT_TRUE(warns(risen, "fit: " + kRisen, kEnd));
  // Where it was put on it lies at the waist; it rises in two postures.
  CaseResult later = risen;
  for (Vec3& p : later.garments[0].drape.positions) p.z() -= 0.15;
  EXPECT_FALSE(warns(later, "fit: " + kRisen, ""));
  CaseState reaching;
  reaching.drapes = {risen.studied().drape};
  reaching.name = "reaching";
  CaseState stretching = reaching, not_settled = reaching;
  stretching.name = "stretching", not_settled.name = "falling";
  not_settled.left_out = "not settled";
  later.wear.states = {not_settled, reaching, stretching, reaching};
  EXPECT_TRUE(warns(later, "fit: " + kRisen, kEnd + " (in reaching; also in stretching)"));
  // A second garment over it.
  CaseResult two = risen;
  two.garments.push_back(two.garments[0]);
  two.scenario.garments.push_back(two.scenario.garments[0]);
  EXPECT_TRUE(warns(two, "fit: under 1: " + kRisen, kEnd));
}

// What only a further posture or donning shows is told with its name.
TEST_F(CheckWorn, WhatFurtherStatesShowIsWarnedOfWithTheirNames) {
  CaseResult result = tube(34, 56, 45, 60);
  ASSERT_TRUE(result.certificate().holds());
  const double limit = result.scenario.studied().material.material.valid_strain_weft;
  const auto state = [&](const std::string& name, int donning) {
    CaseState made;
    made.name = name;
    made.id = {1, donning};
    made.drapes = {result.studied().drape};
    result.wear.states.push_back(made);
    return &result.wear.states.back();
  };
  result.wear.postures = {"standing", "reaching"};
  result.wear.bodies = {result.body.body, result.body.body};
  EXPECT_FALSE(warns(result, "material: strained", ""));
  for (Vec3& p : state("reaching", 0)->drapes[0].positions) p.head<2>() *= 1 + 2 * limit;
  EXPECT_TRUE(warns(result, "material: strained", " (in reaching, the most of all states)"));
  // Of donnings the number is told, too.
  result.wear.donnings.resize(2);
  drape::Drape& again = state("reaching", 1)->drapes[0];
  again.certificate.stable = false;
  again.report.coarsened_field = 0.004;
  again.report.held_off_triangles = static_cast<int>(result.studied().mesh().triangles.size());
  again.report.largest_contact_offset = 0.003;
  const std::string there = " (in reaching of donning 2)";
  EXPECT_TRUE(warns(result, "settle: not stable", there));
  EXPECT_TRUE(warns(result, "settle: the field of distances", there));
  EXPECT_TRUE(warns(result, "settle: ", "are of that distance" + there));
  EXPECT_TRUE(
      warns(result, "material: strained", " (in reaching of donning 1, the most of all states)"));
  // Nothing of a state that does not count.
  for (CaseState& s : result.wear.states) s.left_out = "not settled";
  EXPECT_FALSE(warns(result, "settle: not stable", ""));
  EXPECT_FALSE(warns(result, "material: strained", ""));
}

TEST_F(CheckWorn, ATubeThatSlidesToTheFeetIsSealedNamedAndJudgedAgainWhenItIsRead) {
  const CaseResult result = tube(56, 56, 22, 50);
  const drape::Certificate& c = result.certificate();
  ASSERT_TRUE(c.settled()) << c.stop_reason;
  ASSERT_EQ(c.worn_reasons.size(), 1u);
  ASSERT_NE(c.worn_reasons[0].find("slid to the feet"), std::string::npos) << c.worn_reasons[0];
  EXPECT_TRUE(result.sealed());
  EXPECT_TRUE(result.studied().maps.maps.empty());
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(result.warnings.back().find("slid to the feet"), std::string::npos);
  store(result);
  const auto summary =
      nlohmann::json::parse(io::read_text_file((folder_ / "summary.json").string(), 50000000));
  EXPECT_EQ(summary["settled"], true);
  EXPECT_EQ(summary["worn"], false);
  EXPECT_EQ(summary["worn_reasons"][0], c.worn_reasons[0]);
  EXPECT_EQ(io::read_drape_vtp(folder_ / "drape.vtp").drape.certificate.worn_reasons,
            c.worn_reasons);

  // As an earlier version stored it: nothing said of being worn.
  drape::Drape old = result.studied().drape;
  old.certificate.worn_reasons.clear();
  io::write_drape_vtp(folder_ / "drape.vtp", result.studied().mesh(), old);
  Progress silent;
  CaseResult again = load_case(folder_, silent);
  EXPECT_EQ(again.certificate().worn_reasons, c.worn_reasons);
  try {
    map_case(again, false);
    ADD_FAILURE() << "maps of what is not worn";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("slid to the feet"), std::string::npos);
  }
  EXPECT_FALSE(map_case(again, true).garments.back().maps.empty());
}

// Wide enough to slide from every start; a narrower one may hold to the hips by friction.
TEST_F(CheckWorn, WhatIsNotWornIsPutOnNoFurtherAndHasNoSpread) {
  const CaseResult result =
      tube(56, 56, 22, 50, "repeats = 3\n[postures]\nlist = [\"standing\", \"forward-bend-15\"]\n",
           true);
  EXPECT_TRUE(result.wear.states.empty());
  EXPECT_TRUE(result.repeats.spread.empty());
  int named = 0;
  for (const std::string& text : result.repeats.warnings)
    named += (text.find("is not worn (the waistband has slid to the ") != std::string::npos ||
              text.find("slides down and nothing holds it") != std::string::npos) &&
             text.find("left out") != std::string::npos;
  EXPECT_EQ(named, 2) << join(result.repeats.warnings, "\n");
}

}  // namespace
}  // namespace loosefit::pipeline
