#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "loosefit/base/text.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

std::string document() {
  std::ifstream file(std::string(LOOSEFIT_SOURCE_DIR) + "/docs/garments.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// From the heading of a kind to the next one.
std::string section_of(const GarmentKind& kind, const std::string& docs) {
  const std::size_t start = docs.find("## `" + kind.name + "`: " + kind.title + "\n");
  if (start == std::string::npos) return {};
  return docs.substr(start, docs.find("\n## ", start) - start);
}

std::string row_of(const KindKey& key) {
  return fmt::format("| `{}` | {} … {} | {} | {} | {} |\n", key.name, shortest(key.low),
                     shortest(key.high), key.usual ? shortest(*key.usual) : "none", key.unit,
                     key.meaning);
}

TEST(GarmentDocs, HaveTheKeysOfEveryKindWithRangeDefaultAndMeaning) {
  const std::string docs = document();
  for (const GarmentKind& kind : garment_kinds()) {
    SCOPED_TRACE(kind.name);
    const std::string section = section_of(kind, docs);
    ASSERT_FALSE(section.empty());
    std::size_t rows = 0;
    for (std::size_t at = 0; (at = section.find("\n| `", at)) != std::string::npos; ++at) ++rows;
    EXPECT_EQ(rows, kind.keys.size());
    for (const KindKey& key : kind.keys)
      EXPECT_NE(section.find(row_of(key)), std::string::npos) << row_of(key);
  }
}

// What a key says of a garment without it is what is drafted.
TEST(GarmentDocs, SidesWithoutAWaistGoOutwardsWhereABellyNeedsRoomAsTheKeySays) {
  for (const char* name : {"long-sleeve-shirt", "t-shirt", "hoodie", "tank-top"}) {
    SCOPED_TRACE(name);
    const GarmentKind& kind = garment_kind(name);
    NamedValues slim = kind.sizes.front().measures, belly = slim;
    belly["waist"] = 1.15 * std::max(slim.at("chest"), slim.at("hip"));
    const auto is_straight = [&](const NamedValues& measures) {
      const DraftedGarment made = kind.draft({measures, "", {}, {}});
      const pattern::Panel& front = made.pattern.panels[made.pattern.find_part("front")];
      const pattern::EdgePath side(front, pattern::find_edge_part(front, "side_L"));
      return side.length() - (side.at(1) - side.at(0)).norm() < 1e-9;
    };
    EXPECT_TRUE(is_straight(slim));
    EXPECT_FALSE(is_straight(belly));
    const auto waist = std::ranges::find(kind.keys, "waist", &KindKey::name);
    ASSERT_NE(waist, kind.keys.end());
    EXPECT_NE(waist->meaning.find("run straight, and outwards where a belly needs room"),
              std::string::npos)
        << waist->meaning;
  }
}

}  // namespace
}  // namespace loosefit::kinds
