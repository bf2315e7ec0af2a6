#include "loosefit/pipeline/case_lines.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/run_case.h"

namespace loosefit::pipeline {
namespace {

CaseResult run(const std::string& sites) {
  Progress silent;
  return run_case(io::parse_scenario("[garment]\npattern = \"t-shirt\"\n"
                                     "[simulation]\nedge_length = 0.035\n"
                                     "[donning]\nmovements = []\n" +
                                         sites,
                                     "case.toml"),
                  silent);
}

const CaseLine& line_of(const CaseResult& result, const std::string& name) {
  for (const CaseLine& line : result.lines)
    if (line.name == name) return line;
  throw Error("no line " + name);
}

const char* const kRound =
    "[[site]]\nname = \"chest\"\nfrom = \"front:-0.15,-0.3\"\nto = \"front:0.15,-0.3\"\n";

TEST(CaseLines, AStiffLineGathersTheClothThatItIsSewnOn) {
  const CaseResult bare = run(kRound);
  const CaseResult elastic =
      run(std::string(kRound) + "stiffness = 400\npre_stretch = 0.3\nwidth = 0.02\n");
  ASSERT_TRUE(bare.certificate().holds());
  ASSERT_TRUE(elastic.certificate().holds());
  const lines::LineState &loose = line_of(bare, "chest").states.front(),
                         &pulled = line_of(elastic, "chest").states.front();
  EXPECT_EQ(loose.force, 0);
  EXPECT_GT(pulled.force, 0.5) << "it is stretched";
  EXPECT_LT(pulled.length, 0.97 * loose.length) << "and gathers the cloth";
  EXPECT_LT(pulled.elongation, 0.3) << "which gives way";
}

TEST(CaseLines, WithBoardsBesideThemLieWhereTheyWereWanted) {
  const CaseResult result =
      run("[[site]]\nname = \"board\"\nlandmark = \"upper_back\"\nboard = { mass = 0.02 }\n"
          "[[site]]\nname = \"spine\"\nfrom = \"upper_back\"\nto = \"lower_back\"\nstiffness = 50\n"
          "linear_density = 0.005\n");
  ASSERT_TRUE(result.certificate().holds());
  EXPECT_TRUE(result.lines_left_out.empty());
  const CaseLine& line = line_of(result, "spine");
  EXPECT_NEAR(line.course.length, 0.3, 0.1);
  // Its places are in the pattern now, and its mass in the garment.
  for (const placement::SiteSpec& site : result.scenario.sites)
    if (site.line) {
      for (const placement::LinePlace& place : site.line->stops) EXPECT_EQ(place.panel, "back");
    } else {
      EXPECT_EQ(site.panel, "back");
    }
  double attached = 0;
  for (const double mass : result.studied().mesh().vertex_attached_mass) attached += mass;
  EXPECT_NEAR(attached, 0.02 + 0.005 * line.course.length, 1e-4);
  // Judged by all scorecards of lines: a lead of one drape can be, a stretch sensor not.
  ASSERT_EQ(line.verdicts.size(), 2u);
  EXPECT_TRUE(line.verdicts[0].score.q.has_value()) << line.verdicts[0].score.reason;
  EXPECT_FALSE(line.verdicts[1].score.q.has_value());
  EXPECT_NE(line.verdicts[1].score.reason.find("sweep"), std::string::npos);
}

TEST(CaseLines, WhatTheGarmentDoesNotCoverIsToldAndTheRestIsKept) {
  const CaseResult result = run(
      std::string(kRound) +
      "[[site]]\nname = \"leg\"\nfrom = \"waist_L\"\nto = \"patella_L\"\n"
      "[[site]]\nname = \"tight\"\nfrom = \"ecg_L\"\nto = \"waist_L\"\ncourse = \"least-strain\"\n"
      "longest = 0.05\n");
  EXPECT_EQ(result.lines.size(), 1u);
  ASSERT_EQ(result.lines_left_out.size(), 2u);
  EXPECT_NE(result.lines_left_out[0].why.find("patella_L"), std::string::npos)
      << result.lines_left_out[0].why;
  EXPECT_NE(result.lines_left_out[1].why.find("longest"), std::string::npos)
      << result.lines_left_out[1].why;
  int told = 0;
  for (const std::string& text : result.warnings)
    told += text.find("is left out") != std::string::npos;
  EXPECT_EQ(told, 2);
}

TEST(CaseLines, WhatNoGarmentHasIsToldBeforeTheDrape) {
  for (const auto& [sites, key] :
       {std::pair("[[site]]\nname = \"a\"\nfrom = \"front:0,-0.3\"\nto = \"frnt:0.1,-0.3\"\n",
                  "to"),
        std::pair("[[site]]\nname = \"a\"\nfrom = \"ecg_L\"\nto = \"waist_L\"\n"
                  "course = \"least-strain\"\nkeep_out = [\"frnt:0,0,0.1\"]\n",
                  "keep_out")})
    try {
      run(sites);
      ADD_FAILURE() << key;
    } catch (const InvalidInput& error) {
      EXPECT_NE(error.place().key.find(key), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace loosefit::pipeline
