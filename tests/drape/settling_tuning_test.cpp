#include "loosefit/drape/settling_tuning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/drape/drape_session.h"

namespace loosefit::drape {
namespace {

/// What validate says; empty when it is content.
std::string complaint(const SettlingTuning& tuning) {
  try {
    tuning.validate();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

void set(const TuningField& field, double value) {
  std::visit([&](auto* p) { *p = static_cast<std::remove_reference_t<decltype(*p)>>(value); },
             field.value);
}

TEST(SettlingTuning, DefaultsAreWithinTheirBounds) { EXPECT_EQ(complaint({}), ""); }

TEST(SettlingTuning, EachNumberOutOfItsBoundsIsNamedWithValueAndBound) {
  SettlingTuning tuning;
  std::set<std::string> names;
  for (const TuningField& field : tuning_fields(tuning)) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    const SettlingTuning before = tuning;
    for (const double bad : {field.least - 1, field.most + 1}) {
      set(field, bad);
      const std::string text = complaint(tuning);
      EXPECT_EQ(text.find("tuning." + field.name + ": found "), 0u) << text;
      EXPECT_NE(text.find("expected "), std::string::npos) << text;
    }
    tuning = before;
  }
  EXPECT_GT(names.size(), 60u);
}

TEST(SettlingTuning, NotANumberIsRefused) {
  SettlingTuning tuning;
  tuning.levels.tolerance = std::nan("");
  EXPECT_NE(complaint(tuning).find("levels.tolerance"), std::string::npos);
}

TEST(SettlingTuning, TheFieldsCoverTheWholeStruct) {
  SettlingTuning tuning;
  std::vector<char> covered(sizeof tuning, 0);
  for (const TuningField& field : tuning_fields(tuning))
    std::visit(
        [&](auto* p) {
          const auto first = reinterpret_cast<char*>(p) - reinterpret_cast<char*>(&tuning);
          std::fill_n(covered.begin() + first, sizeof *p, 1);
        },
        field.value);
  // Gaps may only be what aligns an odd number of ints: one missing double is wider.
  int gap = 0;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    gap = covered[i] ? 0 : gap + 1;
    EXPECT_LT(gap, 8) << "at byte " << i;
  }
}

TEST(SettlingTuning, LayersThatCoupleAtNoDistanceAreRefused) {
  SettlingTuning tuning;
  tuning.carry.layer_close = tuning.carry.layer_apart;
  EXPECT_NE(complaint(tuning).find("carry.layer_apart"), std::string::npos);
}

TEST(SettlingTuning, ASessionRefusesABadOne) {
  DrapeOptions options;
  options.tuning.contract.pad_thickness = -1;
  Progress silent;
  garment::GarmentHierarchy none;
  EXPECT_THROW(DrapeSession(none, fabric::Material{}, options, silent), InvalidInput);
}

}  // namespace
}  // namespace loosefit::drape
