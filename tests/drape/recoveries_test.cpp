#include "loosefit/drape/recoveries.h"

#include <gtest/gtest.h>

#include <set>

#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {
namespace {

TEST(Recoveries, EachHasANameAFailureAndAReasonOfItsOwn) {
  std::set<RecoveryKind> kinds;
  std::set<std::string> texts;
  for (const Recovery& row : recoveries()) {
    EXPECT_TRUE(kinds.insert(row.kind).second) << row.name;
    for (const std::string& text : {row.name, row.failure, row.why})
      EXPECT_TRUE(!text.empty() && texts.insert(text).second) << text;
    EXPECT_GT(row.most_attempts(SettlingTuning{}), 0) << row.name;
  }
  EXPECT_EQ(kinds.size(), 9u);
}

/// A state that no phase has touched, with two rows of one point.
struct TwoRows {
  garment::GarmentHierarchy garment;
  std::vector<ClothLayer> layers{{&garment, {}}};
  DrapeOptions options;
  Progress silent;
  bool first_fails = true, second_fails = true;
  std::vector<std::string> acted;
  Recoveries table = {row(RecoveryKind::shorter_step, "first", 2, first_fails),
                      row(RecoveryKind::settle_longer, "second", 1, second_fails)};
  ClothState state{layers, options, table, silent};

  Recovery row(RecoveryKind kind, const std::string& name, int attempts, const bool& fails) {
    return {kind,
            RecoveryPoint::at_rest,
            name,
            "",
            "",
            [attempts](const SettlingTuning&) { return attempts; },
            [&fails](ClothState&) { return fails; },
            [this, name](ClothState&) { acted.push_back(name); }};
  }
};

TEST(Recoveries, TheFirstRowWhoseFailureHoldsIsTriedAsOftenAsItMayBeThenTheNext) {
  TwoRows rows;
  while (rows.state.recover(RecoveryPoint::at_rest)) {
  }
  EXPECT_EQ(rows.acted, (std::vector<std::string>{"first", "first", "second"}));
  ASSERT_EQ(rows.state.report.recoveries.size(), 2u);
  EXPECT_EQ(rows.state.report.recoveries[0].name, "first");
  EXPECT_EQ(rows.state.report.recoveries[0].times, 2);
  EXPECT_EQ(rows.state.report.recoveries[1].times, 1);
}

TEST(Recoveries, ARowWhoseFailureDoesNotHoldAndOneOfAnotherPointAreLeftOut) {
  TwoRows rows;
  rows.first_fails = false;
  EXPECT_FALSE(rows.state.recover(RecoveryPoint::dressed));
  EXPECT_TRUE(rows.state.recover(RecoveryPoint::at_rest));
  EXPECT_EQ(rows.acted, std::vector<std::string>{"second"});
  EXPECT_FALSE(rows.state.report.was_tried(RecoveryKind::shorter_step));
}

}  // namespace
}  // namespace loosefit::drape
