#include "loosefit/kinds/hoodie/hoodie.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/pattern/outline.h"
#include "support/shirt_on_body.h"

namespace loosefit::kinds {
namespace {

DraftedGarment drafted(const body::Body& body, const NamedValues& fit = {}) {
  const GarmentKind kind = hoodie();
  return kind.draft({draft_measures(kind, body.measured), "", fit, {}});
}

double length_of(const pattern::Pattern& pattern, const std::string& part,
                 const std::string& edge) {
  const pattern::Panel& panel = pattern.panels[pattern.find_part(part)];
  return pattern::EdgePath(panel, pattern::find_edge_part(panel, edge)).length();
}

std::vector<body::Body> people() {
  body::BodyParameters man;
  man.sex = 1;
  return {support::standing(support::adult_parameters(), 40), support::standing(man, 40),
          support::standing(support::slim_child_parameters(), 40)};
}

TEST(Hoodie, SeamsAreAsLongOnBothSidesButForEaseAndStretch) {
  for (const body::Body& body : people()) {
    const DraftedGarment hoodie = drafted(body);
    for (const pattern::Stitch& s : hoodie.pattern.stitches) {
      const auto length = [&](const pattern::Stitch::Side& side) {
        return pattern::EdgePath(hoodie.pattern.panels[side.panel], side.edge).length();
      };
      const bool cuff = s.name.starts_with("cuff_L_") || s.name.starts_with("cuff_R_");
      const bool hem = s.name == "hem_band_front" || s.name == "hem_band_back";
      const bool end = s.name.ends_with("top") || s.name.ends_with("under");
      const double held = s.name.starts_with("armhole_") ? 1 + hoodie.fit.at("cap_ease")
                          : cuff && !end                 ? 1 - hoodie.fit.at("cuff_stretch")
                          : hem                          ? 1 - hoodie.fit.at("hem_band_stretch")
                                                         : 1;
      EXPECT_NEAR(length(s.second), held * length(s.first), 1e-9) << s.name;
    }
  }
}

TEST(Hoodie, TheHoodReachesOverTheHead) {
  for (const body::Body& body : people()) {
    const pattern::Pattern hoodie = drafted(body).pattern;
    EXPECT_GT(length_of(hoodie, "hood_L", "face"), body.measured.at("hps_to_crown") + 0.05);
    // From front edge to nape over the crown: farther than straight up.
    EXPECT_GT(length_of(hoodie, "hood_L", "back"), length_of(hoodie, "hood_L", "face"));
    EXPECT_NEAR(
        length_of(hoodie, "hood_L", "neck_front") + length_of(hoodie, "hood_L", "neck_back"),
        length_of(hoodie, "front", "neck_L") + length_of(hoodie, "back", "neck_L"), 1e-9);
  }
}

TEST(Hoodie, AHoodTooLowForTheHeadIsRefusedOrGivesWay) {
  for (const body::Body& body : people()) {
    const double least = body.measured.at("hps_to_crown") + 0.03;
    double told = 0;
    try {
      drafted(body, {{"hood_height", least - 0.001}});
      ADD_FAILURE() << "a hood that slides off the head";
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.place().key, "fit.hood_height");
      const std::string said = error.what();
      ASSERT_NE(said.find("at least "), std::string::npos) << said;
      told = std::stod(said.substr(said.find("at least ") + 9));
    }
    // What is told is no less than is needed, and may be asked for.
    EXPECT_GE(told, least);
    EXPECT_LT(told, least + 0.001);
    EXPECT_NEAR(length_of(drafted(body, {{"hood_height", told}}).pattern, "hood_L", "face"), told,
                1e-9);
    EXPECT_NEAR(length_of(drafted(body, {{"hood_height", least}}).pattern, "hood_L", "face"), least,
                1e-9);
    const GarmentKind kind = hoodie();
    const DraftedGarment higher = kind.draft(
        {draft_measures(kind, body.measured), "", {{"hood_height", 0.16}}, {"fit.hood_height"}});
    EXPECT_NEAR(length_of(higher.pattern, "hood_L", "face"), told, 1e-9);
    EXPECT_TRUE(std::ranges::any_of(higher.notes, [&](const std::string& note) {
      return note.starts_with(fmt::format("fit.hood_height: {:.3f} instead of 0.16, ", told));
    }));
  }
  // Whatever the head: the nearest figure is too low for half of them.
  NamedValues measures = draft_measures(hoodie(), people()[0].measured);
  for (int i = 0; i < 10; ++i) {
    measures["hps_to_crown"] = 0.2401 + 0.00037 * i;
    const DraftedGarment higher =
        hoodie().draft({measures, "", {{"hood_height", 0.16}}, {"fit.hood_height"}});
    EXPECT_NO_THROW(
        hoodie().draft({measures, "", {{"hood_height", higher.fit.at("hood_height")}}, {}}));
    const std::string note = higher.notes.back();
    EXPECT_NO_THROW(
        hoodie().draft({measures, "", {{"hood_height", std::stod(note.substr(17))}}, {}}))
        << note;
  }
  // Whose head is not known is told nothing of it.
  EXPECT_NO_THROW(hoodie().draft({{}, "women-38", {}, {}}));
}

TEST(Hoodie, HalvesAreMirrorImages) {
  const pattern::Pattern hoodie = drafted(people()[0]).pattern;
  const pattern::Panel &l = hoodie.panels[hoodie.find_part("hood_L")],
                       &r = hoodie.panels[hoodie.find_part("hood_R")];
  for (const char* edge : {"neck_front", "neck_back", "back", "face"})
    EXPECT_NEAR(length_of(hoodie, "hood_L", edge), length_of(hoodie, "hood_R", edge), 1e-12);
  EXPECT_LT((l.translation - Vec3(-r.translation.x(), r.translation.y(), r.translation.z())).norm(),
            1e-12);
}

TEST(Hoodie, MakingKeysChangeHoodAndBands) {
  const body::Body body = people()[0];
  const pattern::Pattern high = drafted(body, {{"hood_height", 0.40}}).pattern;
  EXPECT_NEAR(length_of(high, "hood_L", "face"), 0.40, 1e-9);
  const pattern::Pattern plain = drafted(body, {{"hem_band_width", 0}, {"cuff_width", 0}}).pattern;
  EXPECT_EQ(plain.find_part("hem_band_front"), -1);
  EXPECT_EQ(plain.find_part("cuff_L_front"), -1);
  EXPECT_NE(plain.find_part("hood_L"), -1);
}

TEST(Hoodie, AHoodTooShallowForTheNecklineIsRefusedByItsKey) {
  try {
    drafted(people()[0], {{"hood_depth", 0.16}});
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("fit.hood_depth"), std::string::npos) << error.what();
  }
  EXPECT_THROW(drafted(people()[0], {{"hood_height", 2}}), InvalidInput);
}

TEST(Hoodie, HasTheSizesOfTheShirt) {
  const DraftedGarment hoodie = kinds::hoodie().draft({{}, "women-38", {}, {}});
  EXPECT_GT(length_of(hoodie.pattern, "hood_L", "face"), 0.3);
  EXPECT_EQ(hoodie.pattern.kind, "hoodie");
}

TEST(Hoodie, IsKnownAgainByItsSeams) {
  for (const double band : {0.0, 0.06}) {
    pattern::Pattern hoodie = drafted(people()[1], {{"hem_band_width", band}}).pattern;
    for (pattern::Panel& panel : hoodie.panels) {
      panel.part.clear();
      for (pattern::PanelEdge& edge : panel.edges) edge.part.clear();
    }
    ASSERT_TRUE(kinds::hoodie().note_parts(hoodie));
    EXPECT_EQ(hoodie.panels[hoodie.find_panel("hood_L")].part, "hood_L");
  }
}

}  // namespace
}  // namespace loosefit::kinds
