#include "loosefit/report/ranking_output.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/report/sewing_plan.h"
#include "support/scratch_folder.h"

namespace loosefit::report {
namespace {

/// Score = contact_ratio; two tied sites, a clear last one, and one that lacks a donning.
placement::RankingTable table() {
  placement::RankingTable t;
  t.scorecard.name = "plain";
  t.scorecard.title = "Plain sensor";
  t.scorecard.criteria = {{"contact_ratio", {1, 0}, {}, "lifts off", "", "test"}};
  t.sites = {{"low, \"left\"", {{{"contact_ratio", 0.2}, {"gap_mm", 3}}, {{"contact_ratio", 0.3}}}},
             {"a", {{{"contact_ratio", 1.0}}, {{"contact_ratio", 0.6}}}},
             {"b", {{{"contact_ratio", 0.6}}, {{"contact_ratio", 1.0}}}},
             {"torn", {{{"contact_ratio", 0.6}}, {}}}};
  t.ranking = placement::rank_sites(t.sites, t.scorecard);
  t.places.resize(4);
  t.places[0].region = "chest";
  t.places[0].panel = "front";
  t.places[0].at = {0.1, 0.2};
  t.places[0].position = {1, 2, 3};
  t.places[0].angle = kPi / 2;
  t.places[0].anatomy =
      placement::BodyAddress{placement::BodySegment::forearm, 1, {50, 100.04, 70}};
  t.places[0].to_seam = 0.03;
  t.sample_names = {"first", "second"};
  t.places[1].tolerance = placement::Tolerance{
      {0, 1}, 0.012, 0.004, placement::Tolerance::End::outline, placement::Tolerance::End::score};
  return t;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

TEST(RankingText, ShowsTiesIntervalsReasonsAndNotes) {
  const auto text = lines(ranking_text(table()));
  ASSERT_EQ(text.size(), 8u);
  EXPECT_EQ(text[0], "Plain sensor: 2 samples, passes from 0.5");
  EXPECT_EQ(text[2].substr(0, 4), "1=  ");
  EXPECT_NE(text[2].find("0.60     0.60-1.00  0.80    100 %  1-2"), std::string::npos) << text[2];
  EXPECT_NE(text[2].find("lifts off: 0.6, good from 1, fails at 0 (second)"), std::string::npos);
  EXPECT_EQ(text[3].substr(0, 4), "1=  ");
  EXPECT_EQ(text[4].substr(0, 4), "3   ");
  EXPECT_NE(text[5].find("<= 0.60"), std::string::npos);
  EXPECT_NE(text[5].find("not rated: needs contact_ratio"), std::string::npos);
  EXPECT_EQ(text[7], "note: the robust score is the worst of 2 samples");
}

TEST(RankingText, OneSampleHasNoColumnsOfSpread) {
  placement::RankingTable t = table();
  t.sites = {{"a", {{{"contact_ratio", 0.4}}}}};
  t.ranking = placement::rank_sites(t.sites, t.scorecard);
  t.sample_names = {"only"};
  const auto text = lines(ranking_text(t));
  EXPECT_EQ(text[0], "Plain sensor: 1 sample, passes from 0.5");
  EXPECT_EQ(text[2], "rank  site  panel u, v [mm]  score  limited by");
  EXPECT_EQ(text[3], "1     a     front 100, 200   0.40   lifts off: 0.4, good from 1, fails at 0");
}

TEST(RankingText, OfAPartSaysThatScoresAreBounds) {
  placement::RankingTable t = table();
  t.scorecard.left_out = {"slip_mm"};
  t.notes = {"mind the gap"};
  const std::string text = ranking_text(t);
  EXPECT_NE(text.find("note: scores are upper bounds: not looked at: slip_mm (several postures)"),
            std::string::npos);
  EXPECT_NE(text.find("note: mind the gap"), std::string::npos);
}

TEST(RankingCsv, QuotesAndKeepsOneShape) {
  const auto rows = lines(ranking_csv(table()));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0].substr(0, 40), "rank,name,score_robust,score_median,pass");
  EXPECT_EQ(rows[0].substr(rows[0].rfind("tolerance_around_mm")),
            "tolerance_around_mm,contact_ratio,gap_mm,sensor_diameter_mm");
  EXPECT_EQ(rows[3].substr(0, 34), "3,\"low, \"\"left\"\"\",0.2,0.25,0,0.2,0");
  EXPECT_NE(rows[3].find(",first,chest,front,0.1,0.2,90,1,2,3,30,,forearm,left,50,100,70,disc of "
                         "24 mm,,,0.25,3,24"),
            std::string::npos)
      << rows[3];
  EXPECT_NE(rows[1].find(",12,4,"), std::string::npos) << "tolerance in mm: " << rows[1];
  EXPECT_EQ(rows[4].substr(0, 7), ",torn,,");
}

TEST(RankingJson, HoldsEverySample) {
  const auto json = nlohmann::json::parse(ranking_json(table()));
  EXPECT_EQ(json["modality"], "plain");
  EXPECT_EQ(json["samples"], 2);
  const auto& first = json["sites"][0];
  EXPECT_EQ(first["rank"], 1);
  EXPECT_EQ(first["tied_with"], nlohmann::json({"b"}));
  EXPECT_EQ(first["scores"], nlohmann::json({1.0, 0.6}));
  EXPECT_DOUBLE_EQ(first["score_robust_interval"][1], 1.0);
  EXPECT_DOUBLE_EQ(first["tolerance"]["along_mm"], 12);
  EXPECT_EQ(first["tolerance"]["along_ends_at"], "outline");
  EXPECT_EQ(json["sites"][2]["metrics"]["gap_mm"], nlohmann::json({3.0, nullptr}));
  EXPECT_DOUBLE_EQ(json["sites"][2]["angle_deg"], 90);
  EXPECT_EQ(json["sites"][2]["limiting_sample"], "first");
  EXPECT_EQ(json["sites"][2]["body_address"]["segment"], "forearm");
  EXPECT_EQ(json["sites"][2]["body_address"]["side"], "left");
  EXPECT_EQ(json["sites"][2]["body_address"]["percent"][2], 70);
  EXPECT_TRUE(first["body_address"].is_null());
  EXPECT_DOUBLE_EQ(json["sites"][2]["to_seam_mm"], 30);
  EXPECT_TRUE(json["sites"][2]["to_edge_mm"].is_null());
  EXPECT_DOUBLE_EQ(first["footprint"]["radius_m"], 0.012);
  EXPECT_TRUE(json["sites"][3]["rank"].is_null());
  EXPECT_EQ(json["sites"][3]["missing"], nlohmann::json({"contact_ratio"}));
}

TEST(RankingFiles, AreWrittenOrRefused) {
  const support::ScratchFolder folder;
  const pattern::Pattern shirt = kinds::draft_shirt({});
  write_ranking(folder, table(), shirt);
  const auto read = [&](const char* file) {
    return io::read_text_file((folder / file).string(), 1000000);
  };
  EXPECT_EQ(read("ranking-plain.csv"), ranking_csv(table()));
  EXPECT_EQ(read("ranking-plain.json"), ranking_json(table()));
  EXPECT_EQ(read("sewing-plan-plain.svg"), sewing_plan_svg(table(), shirt));
  EXPECT_NE(read("sewing-plan-plain.dxf").find("low, \"left\""), std::string::npos);
  EXPECT_THROW(write_ranking(folder / "none", table(), shirt), IoError);
}

TEST(RankingText, WhereNothingPassesOneSentenceSaysSo) {
  placement::RankingTable t = table();
  t.scorecard.criteria[0].limit = {1, 0.9};
  t.sites = {{"a", {{{"contact_ratio", 0.2}}}}, {"b", {{{"contact_ratio", 0.4}}}}};
  t.ranking = placement::rank_sites(t.sites, t.scorecard);
  t.sample_names = {"only"};
  const auto text = lines(ranking_text(t));
  EXPECT_EQ(text[1],
            "no site passes: all score 0 of 0.5; b: lifts off: 0.4, good from 1, fails at 0.9");
  t.scorecard.criteria[0].limit = {1, 0.3};
  t.ranking = placement::rank_sites(t.sites, t.scorecard);
  EXPECT_EQ(
      lines(ranking_text(t))[1].rfind("no site passes: b, the nearest to it, scores 0.14 of", 0),
      0u)
      << ranking_text(t);
  t.scorecard.criteria[0].limit = {1, 0.9};
  t.ranking = placement::rank_sites(t.sites, t.scorecard);
  EXPECT_EQ(text[3].substr(0, 9), "-     b  ") << "no rank, shared or not, for what fails";
  EXPECT_EQ(text[4].substr(0, 9), "-     a  ");
  EXPECT_EQ(nlohmann::json::parse(ranking_json(t))["verdict"], text[1]);
  EXPECT_EQ(ranking_verdict(table()), "");
}

TEST(RankingText, UncoveredSitesAreListedApart) {
  placement::RankingTable t = table();
  t.uncovered = {{"mine", false, "the garment ends 243 mm away from it"}, {"wrist_L", true, "x"}};
  const std::string text = ranking_text(t);
  EXPECT_NE(text.find("note: not covered by the garment, so not ranked: mine (the garment ends 243 "
                      "mm away from it)\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("note: presets that the garment does not cover: wrist_L\n"),
            std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(ranking_json(t))["uncovered"][0]["name"], "mine");
}

TEST(RankingText, NamesFromFilesCannotMoveTheCursor) {
  placement::RankingTable t = table();
  t.scorecard.title = "sensor\x1b[2J";
  t.notes = {"note\nof two lines"};
  t.uncovered = {{"site\x1b[31m", false, "far"}};
  const std::string text = ranking_text(t);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("note: note\\nof two lines\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace loosefit::report
