#include "loosefit/kinds/shirt/shirt_adapt.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/kinds/shirt/shirt_checks.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/pattern/outline.h"
#include "support/shirt_kind.h"

namespace loosefit::kinds {
namespace {

using support::usual_fit;

constexpr int kPeople = 24;

/// The parametric boy of 9.5 years and 1.35 m.
const ShirtMeasures kBoy = with_usual_measures(ShirtMeasures{.chest = .7180,
                                                             .waist = .5930,
                                                             .hip = .7001,
                                                             .neck = .3767,
                                                             .upper_arm = .2308,
                                                             .wrist = .1072,
                                                             .shoulder_breadth = .2942,
                                                             .shoulder_slope = .3913,
                                                             .scye_depth = .1260,
                                                             .hps_to_waist = .3683,
                                                             .hps_to_hem = .4978,
                                                             .arm_length = .4083});

std::set<std::string> all_but(const std::set<std::string>& asked) {
  std::set<std::string> keys;
  const GarmentKind& shirt = garment_kind("long-sleeve-shirt");
  for (const KindMeasure& measure : shirt.measures) keys.insert("measures." + measure.name);
  for (const KindKey& key : shirt.keys)
    if (!asked.count(key.name)) keys.insert("fit." + key.name);
  return keys;
}

bool same(const pattern::Pattern& a, const pattern::Pattern& b) {
  if (a.panels.size() != b.panels.size() || a.name != b.name) return false;
  for (std::size_t p = 0; p < a.panels.size(); ++p) {
    const pattern::Panel &x = a.panels[p], &y = b.panels[p];
    if (x.vertices != y.vertices || x.translation != y.translation || x.rotation != y.rotation)
      return false;
    for (std::size_t e = 0; e < x.edges.size(); ++e) {
      if (x.edges[e].knots != y.edges[e].knots) return false;
      for (std::size_t c = 0; c < x.edges[e].curves.size(); ++c)
        if (x.edges[e].curves[c].control != y.edges[e].curves[c].control) return false;
    }
  }
  return true;
}

/// People whose measures belong together more or less, children to giants; every eighth is odd.
class People {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * double(random_() % 100001) / 1e5;
  }
  ShirtMeasures next() {
    const auto names = support::shirt_size_names();
    ShirtMeasures m = coin() ? kBoy : support::shirt_size(names[random_() % names.size()]).body;
    const double size = uniform(0.65, 1.25), girth = uniform(0.8, 1.5);
    const double odd = ++count_ % 8 == 0 ? 0.35 : 0.15;
    const auto about = [&](double& value, double scale) {
      value *= scale * uniform(1 - odd, 1 + odd);
    };
    for (double* value : {&m.chest, &m.waist, &m.hip, &m.upper_arm}) about(*value, size * girth);
    for (double* value : {&m.neck, &m.wrist}) about(*value, size * std::sqrt(girth));
    for (double* value :
         {&m.shoulder_breadth, &m.scye_depth, &m.hps_to_waist, &m.hps_to_hem, &m.arm_length})
      about(*value, size);
    m.shoulder_slope = radians(uniform(2, 38));
    m = with_usual_measures(m);
    m.front_balance = uniform(-0.02, 0.06);
    m.front_fullness = uniform(-0.02, 0.05);
    return m;
  }
  bool coin() { return random_() % 2 == 0; }

 private:
  std::mt19937 random_{7};
  int count_ = 0;
};

TEST(AdaptedShirt, BoyWithALooseTShirtGetsALongerSleeve) {
  ShirtFit fit = usual_fit("t-shirt");
  fit.chest = 0.30;
  EXPECT_THROW(draft_shirt(kBoy, fit), InvalidInput);
  const AdaptedShirt shirt = draft_adapted_shirt(kBoy, fit, all_but({"chest"}));
  EXPECT_EQ(shirt.fit.chest, 0.30);
  EXPECT_GT(shirt.fit.sleeve_length, 0.38);
  EXPECT_LT(shirt.fit.sleeve_length, 0.55);
  EXPECT_NEAR(shirt_girths(shirt.pattern, 0).at("chest"), 1.3 * kBoy.chest, 1e-9);
  ASSERT_EQ(shirt.changes.size(), 1u);
  const std::string told = shirt.changes[0].told();
  EXPECT_EQ(told.rfind("fit.sleeve_length: 0.", 0), 0u) << told;
  EXPECT_NE(told.find("instead of 0.38"), std::string::npos) << told;
  const pattern::Panel& sleeve = shirt.pattern.panels[shirt.pattern.find_part("sleeve_L_front")];
  EXPECT_NEAR(pattern::EdgePath(sleeve, pattern::find_edge_part(sleeve, "under")).length(), 0.03,
              0.01);
}

TEST(AdaptedShirt, WhatCanBeDraftedIsDraftedAsItIs) {
  People people;
  int drafted = 0;
  for (int i = 0; i < 24; ++i) {
    const ShirtMeasures m = people.next();
    const ShirtFit fit = usual_fit(i % 2 ? "t-shirt" : "long-sleeve-shirt");
    pattern::Pattern plain;
    try {
      plain = draft_shirt(m, fit);
    } catch (const InvalidInput&) {
      continue;
    }
    ++drafted;
    const AdaptedShirt shirt = draft_adapted_shirt(m, fit, all_but({}));
    EXPECT_TRUE(same(plain, shirt.pattern)) << i;
    EXPECT_TRUE(shirt.changes.empty()) << shirt.changes[0].told();
  }
  EXPECT_GT(drafted, 8);
}

TEST(AdaptedShirt, DefaultsAreDraftedForEverybody) {
  People people;
  int refused = 0;
  for (int i = 0; i < kPeople; ++i) {
    const ShirtMeasures m = people.next();
    const ShirtFit fit = usual_fit(i % 2 ? "t-shirt" : "long-sleeve-shirt");
    try {
      draft_shirt(m, fit);
    } catch (const InvalidInput&) {
      ++refused;
    }
    try {
      const AdaptedShirt shirt = draft_adapted_shirt(m, fit, all_but({}));
      const auto girths = shirt_girths(shirt.pattern, shirt.measures.hps_to_waist);
      EXPECT_NEAR(girths.at("chest"), (1 + fit.chest) * shirt.measures.chest, 1e-9);
      EXPECT_NEAR(girths.at("hip"), (1 + fit.hip) * shirt.measures.hip, 1e-9);
    } catch (const InvalidInput& error) {
      ADD_FAILURE() << i << ": " << error.what();
    }
  }
  EXPECT_GT(refused, kPeople / 10) << "of the plain draft";
}

// Whoever is refused is told of a value that he gave.
TEST(AdaptedShirt, OnlyWhatWasAskedForIsRefused) {
  People people;
  int refused = 0;
  for (int i = 0; i < kPeople; ++i) {
    const ShirtMeasures m = people.next();
    ShirtFit fit = usual_fit(i % 2 ? "t-shirt" : "long-sleeve-shirt");
    std::set<std::string> asked;
    const auto ask = [&](const char* name, double& value, double low, double high) {
      if (people.coin()) return;
      asked.insert(name);
      value = people.uniform(low, high);
    };
    ask("chest", fit.chest, -0.35, 1.2);
    ask("hip", fit.hip, -0.3, 1.0);
    ask("sleeve", fit.sleeve, -0.3, 2.5);
    ask("wrist", fit.wrist, -0.3, 1.0);
    ask("neck_ease", fit.neck_ease, -0.2, 1.0);
    ask("sleeve_length", fit.sleeve_length, 0.25, 1.0);
    try {
      const AdaptedShirt shirt = draft_adapted_shirt(m, fit, all_but(asked));
      const auto kept = [&](const char* name, double ShirtFit::*field) {
        if (asked.count(name)) {
          EXPECT_EQ(shirt.fit.*field, fit.*field) << name;
        }
      };
      kept("sleeve", &ShirtFit::sleeve);
      kept("wrist", &ShirtFit::wrist);
      kept("neck_ease", &ShirtFit::neck_ease);
      kept("sleeve_length", &ShirtFit::sleeve_length);
      EXPECT_EQ(shirt.fit.chest, fit.chest);
      EXPECT_EQ(shirt.fit.hip, fit.hip);
    } catch (const InvalidInput& error) {
      ++refused;
      const std::string& key = error.place().key;
      ASSERT_EQ(key.rfind("fit.", 0), 0u) << i << ": " << error.what();
      EXPECT_TRUE(asked.count(key.substr(4))) << i << ": " << error.what();
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, kPeople / 2);
}

TEST(AdaptedShirt, ChangesSteadilyWithTheBody) {
  ShirtFit fit = usual_fit("t-shirt");
  double before = -1;
  int adapted = 0;
  for (double chest = 0.0; chest < 0.6; chest += 0.02) {
    fit.chest = chest;
    const double length = draft_adapted_shirt(kBoy, fit, all_but({"chest"})).fit.sleeve_length;
    adapted += length > 0.381;
    // The underarm moves by steps of 2.5 mm, the cap with it.
    if (before >= 0) {
      EXPECT_LT(std::abs(length - before), 0.04) << chest;
    }
    before = length;
  }
  EXPECT_GT(adapted, 5);
}

TEST(AdaptedShirt, MeasuresBeyondPeopleAreTakenAtTheirEndUnlessGiven) {
  ShirtMeasures scan = kBoy;
  scan.shoulder_slope = radians(-3);
  const ShirtFit fit = usual_fit("t-shirt");
  EXPECT_THROW(draft_shirt(scan, fit), InvalidInput);
  EXPECT_EQ(draft_adapted_shirt(scan, fit, all_but({})).measures.shoulder_slope, 0);
  std::set<std::string> yielding = all_but({});
  yielding.erase("measures.shoulder_slope");
  try {
    draft_adapted_shirt(scan, fit, yielding);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "measures.shoulder_slope");
  }
}

/// How far the underarm of the pieces lies below the armpit.
double underarm_below_armpit(const DraftedGarment& made, const ShirtMeasures& m) {
  const pattern::Panel& front = made.pattern.panels[made.pattern.find_part("front")];
  const pattern::EdgePath side(front, pattern::find_edge_part(front, "side_L"));
  return -std::max(side.at(0).y(), side.at(1).y()) -
         std::sin(m.shoulder_slope) * m.shoulder_length - m.scye_depth;
}

TEST(ShirtNotes, AnUnderarmThatLiesElsewhereThanAskedIsToldInOneLine) {
  int told = 0;
  for (const char* name : {"long-sleeve-shirt", "t-shirt", "hoodie"})
    for (const ShirtMeasures& m : {ShirtMeasures{}, kBoy})
      for (const double ease : {0.0, 0.025, 0.06, 0.10}) {
        const GarmentKind& kind = garment_kind(name);
        const DraftedGarment made =
            kind.draft({named(m), "", {{"scye_ease", ease}}, all_but({"scye_ease"})});
        const double below = underarm_below_armpit(made, m);
        std::vector<std::string> notes;
        for (const std::string& note : made.notes)
          if (note.starts_with("fit.scye_ease")) notes.push_back(note);
        SCOPED_TRACE(fmt::format("{}, asked {}, found {}", name, ease, below));
        ASSERT_EQ(notes.size(), std::abs(below - ease) > 0.002 ? 1u : 0u);
        if (notes.empty()) continue;
        ++told;
        EXPECT_EQ(
            notes[0].rfind(
                fmt::format("fit.scye_ease: {:.3g} instead of {:.3g}, since ", below, ease), 0),
            0u)
            << notes[0];
        EXPECT_EQ(notes[0].find("fit.cap_ratio") != std::string::npos, below > ease) << notes[0];
      }
  EXPECT_GT(told, 3);
}

// The adapter lowers the underarm so that a sleeve fits at all, the draft once more for its cap: a
// value between the two was asked for by nobody.
TEST(ShirtNotes, AnUnderarmThatTwoStepsMovedIsToldInOneLineAgainstWhatWasAskedFor) {
  int moved_twice = 0;
  for (const char* asked_too : {"scye_ease", "cap_ratio"})
    for (const ShirtMeasures& m : {ShirtMeasures{}, kBoy})
      for (double sleeve = 0.3; sleeve < 1.5; sleeve += 0.1) {
        const bool of_ease = asked_too == std::string("scye_ease");
        const GarmentKind& kind = garment_kind("long-sleeve-shirt");
        NamedValues fit = {{"sleeve", sleeve}, {"wrist", sleeve}};
        fit[asked_too] = of_ease ? 0.01 : 0.7;
        DraftedGarment made;
        try {
          made = kind.draft({named(m), "", fit, all_but({"sleeve", "wrist", "cap_ratio"})});
        } catch (const InvalidInput&) {
          continue;
        }
        const double wished = of_ease ? 0.01 : 0.025, below = underarm_below_armpit(made, m),
                     adapted = made.fit.at("scye_ease");
        if (adapted - wished < 0.002 || below - adapted < 0.002) continue;
        ++moved_twice;
        std::vector<std::string> notes;
        for (const std::string& note : made.notes)
          if (note.starts_with("fit.scye_ease")) notes.push_back(note);
        SCOPED_TRACE(fmt::format("sleeve {}, adapted {}, found {}", sleeve, adapted, below));
        ASSERT_EQ(notes.size(), 1u) << notes.back();
        EXPECT_TRUE(notes[0].starts_with(
            fmt::format("fit.scye_ease: {:.3g} instead of {:.3g}, since ", below, wished)))
            << notes[0];
        // With both reasons.
        EXPECT_NE(notes[0].find("too wide for the armhole"), std::string::npos) << notes[0];
        EXPECT_NE(notes[0].find("fit.cap_ratio"), std::string::npos) << notes[0];
      }
  EXPECT_GT(moved_twice, 2);
}

// A scenario lists every key of the fit, the usual ones as keys that give way.
TEST(ShirtNotes, TheUsualArmholeIsNotToldOfWhereNobodyAskedForIt) {
  for (const char* name : {"long-sleeve-shirt", "t-shirt"}) {
    const GarmentKind& kind = garment_kind(name);
    NamedValues usual;
    std::set<std::string> yielding;
    for (const KindKey& key : kind.keys) {
      if (key.usual) usual[key.name] = *key.usual;
      yielding.insert("fit." + key.name);
    }
    usual["chest"] = 0.10, usual["sleeve"] = 0.25;  // as of the reference shirt
    for (const ShirtMeasures& m : {ShirtMeasures{}, kBoy}) {
      const DraftedGarment made = kind.draft({named(m), "", usual, yielding});
      for (const std::string& note : made.notes)
        EXPECT_FALSE(note.starts_with("fit.scye_ease")) << note;
    }
  }
}

TEST(ShirtNotes, ACapThatIsLowerThanSoughtIsToldWithItsRatio) {
  const GarmentKind& kind = garment_kind("long-sleeve-shirt");
  const NamedValues fit = {{"sleeve", 0.60}, {"cap_ratio", 0.85}};
  const DraftedGarment made = kind.draft({named(ShirtMeasures{}), "", fit, {}});
  ASSERT_EQ(made.notes.size(), 1u);
  const std::size_t at = made.notes[0].find("with that it is ");
  ASSERT_NE(at, std::string::npos) << made.notes[0];
  const double ratio = std::stod(made.notes[0].substr(at + 16));
  EXPECT_GT(ratio, 0.48);
  EXPECT_LT(ratio, 0.84);
  // The same figure as in the line for tailors.
  EXPECT_NE(made.details.find(fmt::format("ratio {:.2f}", ratio)), std::string::npos)
      << made.details;
}

TEST(ShirtNotes, WhatNobodyAskedForIsNotTold) {
  for (const char* name : {"long-sleeve-shirt", "t-shirt", "hoodie"})
    EXPECT_TRUE(garment_kind(name).draft({named(ShirtMeasures{}), "", {}, {}}).notes.empty());
  for (const char* name : {"long-sleeve-shirt", "t-shirt"})
    EXPECT_TRUE(garment_kind(name).draft({{}, "women-38", {}, {}}).notes.empty());
}

}  // namespace
}  // namespace loosefit::kinds
