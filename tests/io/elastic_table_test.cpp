#include "loosefit/io/elastic_table.h"

#include <gtest/gtest.h>

#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/pattern/outline.h"
#include "support/side_file.h"

// Elastics in every file that may tell of one.
namespace loosefit::io {
namespace {

const std::string kHem = R"(
[[garment.elastic]]
edges = ["front.hem", "back.hem"]
ratio = 0.8
stiffness = 12.5
[[garment.elastic]]
edges = ["sleeve_L_front.cuff"]
ratio = 0.9
width = 0.01
linear_density = 0.004
)";

using support::refusal_of;

std::string scenario_refusal(const std::string& text) {
  return refusal_of([&] { parse_scenario(text, "case.toml"); });
}

TEST(ElasticTable, ThoseOfAScenarioAreReadAndWrittenAgain) {
  const scenario::Scenario scenario = parse_scenario(
      "[garment]\n" + kHem + "[[under]]\npattern = \"t-shirt\"\n[[under.elastic]]\n" +
          "edges = [\"back.hem\"]\nratio = 0.5\n",
      "case.toml");
  const auto& elastics = scenario.studied().spec.elastics;
  ASSERT_EQ(elastics.size(), 2u);
  EXPECT_EQ(elastics[0].edges, (std::vector<std::string>{"front.hem", "back.hem"}));
  EXPECT_EQ(elastics[0].elastic, (pattern::EdgeElastic{0.8, 12.5, 0.03}));
  EXPECT_EQ(elastics[1].elastic, (pattern::EdgeElastic{0.9, 20, 0.01, 0.004}));
  ASSERT_EQ(scenario.garments[0].spec.elastics.size(), 1u);
  const scenario::Scenario again = parse_scenario(scenario_toml(scenario), "again.toml");
  EXPECT_EQ(again.studied().spec.elastics, elastics);
  EXPECT_EQ(again.garments[0].spec.elastics, scenario.garments[0].spec.elastics);
}

TEST(ElasticTable, OddOnesAreRefusedByFileLineAndKey) {
  const std::string head = "[garment]\n[[garment.elastic]]\n";
  EXPECT_NE(scenario_refusal(head + "ratio = 0.8\n")
                .find("case.toml:2: garment.elastic[0].edges: found nothing"),
            std::string::npos);
  EXPECT_NE(scenario_refusal("[garment]\n[garment.elastic]\nratio = 0.8\n")
                .find("write [[garment.elastic]] with double brackets"),
            std::string::npos);
  EXPECT_NE(scenario_refusal(head + "edges = [\"front.hem\"]\n")
                .find("garment.elastic[0].ratio: found nothing"),
            std::string::npos);
  EXPECT_NE(
      scenario_refusal(head + "edges = [\"front.hem\"]\nratio = 1.2\n")
          .find("case.toml:4: garment.elastic[0].ratio: found 1.2, expected a ratio from 0.3 to 1"),
      std::string::npos);
  EXPECT_NE(scenario_refusal(head + "edges = [\"front.hem\"]\nratio = 0.8\nstifness = 3\n")
                .find("stiffness"),
            std::string::npos);
}

TEST(ElasticTable, AnEdgeIsFoundByItsNameAndHasOneElastic) {
  pattern::Pattern shirt = kinds::draft_shirt({});
  pattern::add_elastic(shirt, {{"front.hem"}, {0.8, 20, 0.03}});
  const pattern::Panel& front = shirt.panels[shirt.find_panel("front")];
  EXPECT_TRUE(front.edges[pattern::find_edge(front, "hem")].elastic);
  const auto named = [&](const std::string& edge) {
    return refusal_of([&] { pattern::add_elastic(shirt, {{edge}, {}}); });
  };
  EXPECT_NE(named("front.hem").find("an edge that has no elastic yet"), std::string::npos);
  EXPECT_NE(named("frnt.hem").find("did you mean \"front\"?"), std::string::npos);
  EXPECT_NE(named("front.hemm").find("did you mean \"hem\"?"), std::string::npos);
  EXPECT_NE(named("hem").find("a panel and an edge"), std::string::npos);
}

TEST(ElasticTable, ThoseOfAPatternComeBackFromItsFile) {
  pattern::Pattern shirt = kinds::draft_shirt({});
  const pattern::EdgeElastic tape{0.75, 18, 0.025, 0.011};
  pattern::add_elastic(shirt, {{"front.hem", "back.hem"}, tape});
  const std::string text = garmentcode_text(shirt);
  const pattern::Pattern again = parse_garmentcode(text, "p.json").pattern;
  int found = 0;
  for (const pattern::Panel& panel : again.panels)
    for (const pattern::PanelEdge& edge : panel.edges)
      if (edge.elastic) {
        ++found;
        EXPECT_EQ(edge.name, "hem");
        EXPECT_NEAR(edge.elastic->ratio, tape.ratio, 1e-12);
        EXPECT_NEAR(edge.elastic->stiffness, tape.stiffness, 1e-12);
        EXPECT_NEAR(edge.elastic->width, tape.width, 1e-9);
        EXPECT_NEAR(edge.elastic->linear_density, tape.linear_density, 1e-12);
      }
  EXPECT_EQ(found, 2);
  EXPECT_EQ(garmentcode_text(again), text);
  std::string odd = text;
  odd.replace(odd.find("\"ratio\":0.75"), 12, "\"ratio\":0.05");
  EXPECT_NE(refusal_of([&] {
              parse_garmentcode(odd, "p.json");
            }).find("loosefit_elastic.ratio: found 0.05, expected 0.3 to 1"),
            std::string::npos);
}

TEST(ElasticTable, ThoseBesideADrawingAreSewnOnToo) {
  const pattern::Pattern tee = support::tee_with_side_file(
      "[[elastic]]\nedges = [\"SLEEVE.e1\"]\nratio = 0.7\n"
      "[[seam]]\nfirst = \"SLEEVE.e1\"\nsecond = \"SLEEVE.e3\"\n");
  const pattern::Panel& sleeve = tee.panels[tee.find_panel("SLEEVE")];
  ASSERT_TRUE(sleeve.edges[pattern::find_edge(sleeve, "e1")].elastic);
  EXPECT_EQ(sleeve.edges[pattern::find_edge(sleeve, "e1")].elastic->ratio, 0.7);
  EXPECT_NE(refusal_of([&] {
              support::tee_with_side_file("[[elastic]]\nedges = [\"SLEVE.e1\"]\nratio = 0.7\n");
            }).find("tee.seams.toml:2: elastic[0].edges: found \"SLEVE.e1\", expected a panel"),
            std::string::npos);
}

}  // namespace
}  // namespace loosefit::io
