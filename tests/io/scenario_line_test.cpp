#include <gtest/gtest.h>

#include "loosefit/io/scenario_writer.h"
#include "support/refused_scenario.h"

namespace loosefit::io {
namespace {

using support::expect_refused;

TEST(ScenarioLine, IsReadAndWritten) {
  const scenario::Scenario s = parse_scenario(
      "[[site]]\nname = \"a\"\nfrom = \"wrist_L\"\nvia = [\"left forearm [50, 0, 60]\"]\n"
      "to = \"back:0.1,0.2\"\nheight = 0.002\npre_stretch = 0.1\n"
      "[[site]]\nname = \"b\"\nfrom = \"c7\"\nto = \"wrist_L\"\nover = \"back\"\n"
      "course = \"straight\"\n",
      "case.toml");
  ASSERT_TRUE(s.sites.at(0).line && s.sites.at(1).line);
  EXPECT_EQ(s.sites[0].line->stops.size(), 3u);
  EXPECT_EQ(s.sites[0].line->stops[2].at, Vec2(0.1, 0.2));
  EXPECT_EQ(s.sites[0].line->pre_stretch, 0.1);
  EXPECT_EQ(s.sites[1].line->over, "back");
  EXPECT_EQ(s.sites[1].line->course, placement::LineSpec::Course::straight);
  EXPECT_EQ(scenario_toml(parse_scenario(scenario_toml(s), "again.toml")), scenario_toml(s));
}

TEST(ScenarioLine, WhatIsWrongIsTold) {
  expect_refused("[[site]]\nname = \"a\"\nfrom = \"c7\"", {"case.toml:1: site[0].to"});
  expect_refused("[[site]]\nname = \"a\"\nfrom = \"c7\"\nto = \"front:1\"",
                 {"case.toml:4: site[0].to", "panel with u,v"});
  expect_refused("[[site]]\nname = \"a\"\nfrom = \"c7\"\nto = \"wrist_L\"\nradius = 1",
                 {"site[0].radius"});
  expect_refused(
      "[[site]]\nname = \"a\"\nfrom = \"c7\"\nto = \"wrist_L\"\nvia = [\"c7\"]\nover = \"back\"",
      {"site[0].over", "one of the two"});
}

TEST(ScenarioSweep, ListsTheAnglesOfOneJoint) {
  const scenario::Scenario s = parse_scenario(
      "[postures]\nlist = [\"standing\"]\nreference = \"elbow-flexion-40\"\n"
      "sweep = { joint = \"elbow-flexion\", from = 0, to = 100, step = 40 }\n",
      "case.toml");
  EXPECT_EQ(s.postures,
            (std::vector<std::string>{"elbow-flexion-40", "elbow-flexion-80", "elbow-flexion-100",
                                      "standing", "elbow-flexion-0"}));
  EXPECT_EQ(degrees(s.body.posture.elbow_flexion), 40);
  const scenario::Scenario again = parse_scenario(scenario_toml(s), "again.toml");
  EXPECT_EQ(again.postures, s.postures);
  EXPECT_EQ(again.body.posture, s.body.posture);
  const std::string sweep = "[postures]\nsweep = { joint = \"elbow-flexion\", from = 0, ";
  expect_refused(sweep + "to = 140, step = 20 }", {"postures.sweep.to", "0 to 130"});
  expect_refused(sweep + "to = 130, step = 1 }", {"postures.sweep.step", "4 to 180"});
  expect_refused("[postures]\nlist = [\"elbow-flexion-170\"]", {"postures.list", "0 to 130"});
  expect_refused("[postures]\nsweep = { joint = \"elbo\", from = 0, to = 9, step = 3 }",
                 {"postures.sweep.joint"});
}

}  // namespace
}  // namespace loosefit::io
