#include "loosefit/kinds/registry.h"

#include <gtest/gtest.h>

#include <set>

#include "loosefit/base/error.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/recognise.h"
#include "support/body_fixture.h"
#include "support/shirt_on_body.h"

namespace loosefit::kinds {
namespace {

/// Every kind that can be drafted, on a grown woman and a slim child.
class EveryKind : public testing::TestWithParam<std::string> {
 protected:
  const GarmentKind& kind = garment_kind(GetParam());
  DraftedGarment draft(const body::Body& body) const {
    return kind.draft({draft_measures(kind, body.measured), "", {}, {}});
  }
};

TEST_P(EveryKind, HasTheUsualFitOnTheBodyItIsDraftedFor) {
  for (const body::BodyParameters& person :
       {support::adult_parameters(), support::slim_child_parameters()}) {
    const body::Body body = support::standing(person, 40);
    const DraftedGarment garment = draft(body);
    EXPECT_EQ(garment.pattern.kind, kind.name);
    const NamedValues measures = known_measures(kind, body.measured);
    int compared = 0;
    for (const FitLevel& level : kind.levels(garment.pattern, measures, garment.fit)) {
      const auto key = garment.fit.find(level.name);
      if (!level.body || key == garment.fit.end()) continue;
      ++compared;
      EXPECT_NEAR(level.garment / *level.body - 1, key->second, 1e-6) << level.name;
    }
    EXPECT_GE(compared, 2);
  }
}

TEST_P(EveryKind, IsKnownAgainByItsSeamsAndLosesItsMarkWithOneOfThem) {
  const body::Body body = support::standing(support::adult_parameters(), 40);
  const pattern::Pattern pattern = draft(body).pattern;
  EXPECT_EQ(draft_mark(pattern), kind.mark);
  pattern::Pattern read = pattern;
  read.kind = pattern::Pattern{}.kind;
  for (pattern::Panel& panel : read.panels) {
    panel.part.clear();
    panel.name = "my " + panel.name;
    for (pattern::PanelEdge& edge : panel.edges) edge.part.clear();
  }
  pattern::Pattern torn = read;
  torn.stitches.pop_back();
  ASSERT_EQ(recognise_kind(read, kind.mark), Recognised::yes);
  EXPECT_EQ(garment_kind(read.kind).mark, kind.mark);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p)
    EXPECT_EQ(read.panels[p].part, pattern.panels[p].part);
  EXPECT_EQ(recognise_kind(torn, kind.mark), Recognised::sewn_otherwise);
  EXPECT_EQ(torn.kind, pattern::Pattern{}.kind);
  EXPECT_EQ(recognise_kind(torn, "coat 9"), Recognised::unknown_draft);
  EXPECT_EQ(recognise_kind(torn, ""), Recognised::no);
}

TEST_P(EveryKind, SaysWhatGoesThroughAllOfItsOpenEdges) {
  const body::Body body = support::standing(support::adult_parameters(), 40);
  const garment::Garment garment = garment::assemble(draft(body).pattern, 0.03, fabric::Material{});
  std::map<std::pair<int, int>, int> sides;  // of an edge between two vertices: its triangles
  for (const Triangle& t : garment.triangles)
    for (int k = 0; k < 3; ++k) ++sides[std::minmax(t[k], t[(k + 1) % 3])];
  const auto is_open = [&](const garment::Garment::EdgeChain& chain) {
    return sides.at(std::minmax(chain.vertices[0], chain.vertices[1])) == 1;
  };
  std::set<std::pair<std::string, std::string>> told;
  for (const KindOpening& opening : kind.openings) {
    int open = 0;  // of the edges and those of the bands that may be sewn to them
    for (const auto& edge : opening.edges) {
      const auto* chain = garment.find_part(edge.first, edge.second);
      open += chain && is_open(*chain);
      EXPECT_TRUE(told.insert(edge).second);
    }
    EXPECT_EQ(open, 2) << "front and back";
  }
  for (const garment::Garment::EdgeChain& chain : garment.edge_chains) {
    if (is_open(chain)) {
      EXPECT_EQ(told.count({garment.panel_parts[chain.panel], chain.part}), 1u) << chain.part;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryKind, testing::ValuesIn(drafted_kinds()),
                         [](const auto& kind) {
                           std::string name = kind.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(GarmentKinds, HaveNamesOfTheirOwnAndKeysWithinTheirRange) {
  std::set<std::string> names;
  for (const GarmentKind& kind : garment_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    std::set<std::string> keys;
    for (const KindKey& key : kind.keys) {
      SCOPED_TRACE(kind.name + "." + key.name);
      EXPECT_TRUE(keys.insert(key.name).second);
      EXPECT_LT(key.low, key.high);
      if (key.usual) {
        EXPECT_GE(*key.usual, key.low);
        EXPECT_LE(*key.usual, key.high);
      }
    }
  }
}

TEST(GarmentKinds, AnUnknownOneIsRefusedWithTheNearestName) {
  try {
    garment_kind("t-shrit");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(error.hint().find("t-shirt"), std::string::npos) << error.hint();
  }
}

}  // namespace
}  // namespace loosefit::kinds
