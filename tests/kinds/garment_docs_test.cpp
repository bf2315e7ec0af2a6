#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "loosefit/base/text.h"
#include "loosefit/kinds/registry.h"

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

}  // namespace
}  // namespace loosefit::kinds
