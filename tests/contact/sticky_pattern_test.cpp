#include "loosefit/contact/sticky_pattern.h"

#include <gtest/gtest.h>

#include <set>

#include "loosefit/contact/contact_tuning.h"

namespace loosefit::contact {
namespace {

using Stencil = std::array<int, 4>;

std::size_t blocks(const StickyPattern& r, int particles) {
  particles::BlockPattern pattern(particles);
  r.add_to(pattern);
  pattern.compress();
  std::size_t n = 0;
  for (const auto& rows : pattern.rows_of_column()) n += rows.size() - 1;  // less the diagonal
  return n;
}

TEST(StickyPattern, VersionChangesOnlyWithNewBlocks) {
  StickyPattern r(10);
  const auto set = [&](std::initializer_list<Stencil> contacts) {
    r.begin();
    for (const Stencil& c : contacts) r.use(c, 4);
    r.end();
    return r.version();
  };
  const auto first = set({{0, 1, 2, 3}});
  EXPECT_EQ(r.size(), 6u);
  EXPECT_EQ(set({{0, 1, 2, 3}}), first);
  EXPECT_EQ(set({{3, 2, 1, 0}}), first);
  EXPECT_EQ(set({}), first);  // a lost contact stays remembered
  const auto second = set({{0, 1, 2, 4}});
  EXPECT_NE(second, first);
  EXPECT_EQ(r.size(), 9u);
  EXPECT_EQ(r.used(), 6u);
  EXPECT_EQ(set({{0, 1, 2, 3}, {0, 1, 2, 4}}), second);
  EXPECT_EQ(r.used(), 9u);
  EXPECT_EQ(blocks(r, 10), 9u);
}

TEST(StickyPattern, GoesBackUnderAVersionThatNeitherHasHad) {
  StickyPattern r(10);
  const auto grow = [&](const Stencil& contact) {
    r.begin();
    r.use(contact, 4);
    r.end();
    return r.version();
  };
  std::set<std::uint64_t> seen = {grow({0, 1, 2, 3})};
  const StickyPattern earlier = r;
  seen.insert(grow({0, 1, 2, 4}));
  r.recall(earlier);
  EXPECT_EQ(blocks(r, 10), 6u);
  EXPECT_TRUE(seen.insert(r.version()).second);
  EXPECT_TRUE(seen.insert(grow({5, 6, 7, 8})).second) << "as many blocks, but others";
}

TEST(StickyPattern, ForgetsWhatIsNotInUseWhenTooMuchHasPiledUp) {
  constexpr int kParticles = 3000;
  StickyPattern r(kParticles);
  std::uint64_t last = r.version();
  int shrunk = 0;
  for (int i = 0; i + 4 <= kParticles; i += 4) {
    const std::size_t before = r.size();
    r.begin();
    r.use(Stencil{i, i + 1, i + 2, i + 3}, 4);
    r.end();
    EXPECT_LE(r.size(), 2 * r.used() + kContact.barrier.pattern_slack);
    EXPECT_NE(r.version(), last);
    last = r.version();
    if (r.size() > before) continue;
    ++shrunk;
    EXPECT_EQ(r.size(), 6u);
    EXPECT_EQ(blocks(r, kParticles), 6u);
  }
  EXPECT_EQ(shrunk, 2);
}

}  // namespace
}  // namespace loosefit::contact
