#include "loosefit/kinds/shirt/shirt_draft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/self_crossing.h"
#include "support/shirt_kind.h"

namespace loosefit::kinds {
namespace {

const ShirtMeasures kAdult;
const ShirtMeasures kChild{.chest = .700,
                           .waist = .620,
                           .hip = .745,
                           .neck = .310,
                           .upper_arm = .215,
                           .wrist = .145,
                           .shoulder_breadth = .335,
                           .shoulder_slope = radians(18),
                           .scye_depth = .120,
                           .hps_to_waist = .340,
                           .hps_to_hem = .520,
                           .arm_length = .480};
const ShirtMeasures kMeanFemale{.chest = .974,
                                .waist = .803,
                                .hip = 1.041,
                                .neck = .375,
                                .upper_arm = .293,
                                .wrist = .159,
                                .shoulder_breadth = .347,
                                .shoulder_slope = radians(20.9),
                                .scye_depth = .1265,
                                .hps_to_waist = .400,
                                .hps_to_hem = .580,
                                .arm_length = .516};

ShirtFit fit_of(double chest, double hip, double sleeve, double wrist) {
  ShirtFit fit;
  fit.chest = chest;
  fit.hip = hip;
  fit.sleeve = sleeve;
  fit.wrist = wrist;
  return fit;
}

double edge_length(const pattern::Pattern& p, const std::string& panel, const std::string& edge) {
  const int i = p.find_panel(panel);
  return pattern::EdgePath(p.panels[i], pattern::find_edge(p.panels[i], edge)).length();
}

double pattern_area(const pattern::Pattern& p) {
  double area = 0;
  for (const pattern::Panel& panel : p.panels)
    area += pattern::signed_area(pattern::outline_polygon(panel, 400));
  return area;
}

/// Girths exact, seams equal, outlines simple and counter-clockwise (docs/theory/patterns.md 3, 5).
void expect_sound(const pattern::Pattern& shirt, const ShirtMeasures& m, const ShirtFit& fit) {
  const auto girths = shirt_girths(shirt, m.hps_to_waist);
  EXPECT_NEAR(girths.at("chest") / m.chest - 1, fit.chest, 1e-12);
  EXPECT_NEAR(girths.at("hip") / m.hip - 1, fit.hip, 1e-12);
  EXPECT_NEAR(girths.at("sleeve") / m.upper_arm - 1, fit.sleeve, 1e-12);
  EXPECT_NEAR(girths.at("wrist") / m.wrist - 1, fit.wrist, 1e-12);
  if (fit.waist) {
    EXPECT_NEAR(girths.at("waist") / m.waist - 1, *fit.waist, 1e-9);
  }
  ASSERT_EQ(shirt.stitches.size(), 12u);
  for (const pattern::Stitch& s : shirt.stitches)
    EXPECT_NEAR(pattern::EdgePath(shirt.panels[s.first.panel], s.first.edge).length(),
                pattern::EdgePath(shirt.panels[s.second.panel], s.second.edge).length(), 1e-7)
        << s.name;
  for (const pattern::Panel& panel : shirt.panels) {
    EXPECT_EQ(pattern::first_self_crossing(pattern::outline_polygon(panel)).first, -1)
        << panel.name;
    EXPECT_GT(pattern::signed_area(pattern::outline_polygon(panel)), 0) << panel.name;
  }
}

/// One row of the table in docs/theory/patterns.md 5; seven digits from the executable form of the
/// draft with 600 chords a curve.
struct Golden {
  const char* name;
  ShirtMeasures body;
  ShirtFit fit;
  double armhole, depth, cap_height, ratio, front_share, deepened, area, neck;
};

std::vector<Golden> goldens() {
  ShirtFit tight = fit_of(-.15, -.15, -.15, -.10);
  tight.neck_ease = 0;
  ShirtFit waisted = fit_of(.05, -.05, .15, .15);
  waisted.waist = .02;
  return {
      {"adult", kAdult, fit_of(.05, .05, .10, .15), .3838121, .1682484, .0990091, .5884696,
       .5136830, 0, .8145276, .4314534},
      {"adult 0", kAdult, fit_of(0, 0, 0, 0), .3784999, .1700000, .1126566, .6626857, .5152817, 0,
       .7636413, .4314534},
      {"adult tight", kAdult, tight, .3921408, .1805096, .1428050, .7911210, .5191013, 0, .6606103,
       .3955043},
      {"adult loose", kAdult, fit_of(.30, .10, .05, .05), .4157050, .1594904, .1312809, .8231275,
       .5182689, 0, .8555874, .4314534},
      {"adult wide sleeve", kAdult, fit_of(.05, .20, .60, .60), .5374797, .2482484, .1265470,
       .5097594, .5076526, .08, .9330665, .4314534},
      {"child 0", kChild, fit_of(0, 0, 0, 0), .3033135, .1450000, .0971524, .6700166, .5135597, 0,
       .5055682, .3737600},
      {"child", kChild, fit_of(.15, .10, .20, .20), .3121175, .1409182, .0777699, .5518795,
       .5125043, 0, .5737784, .3737600},
      {"child loose", kChild, fit_of(.35, .25, .40, .50), .3426470, .1429758, .0715838, .5006706,
       .5115078, .0075, .6553982, .3737600},
      {"child waisted", kChild, waisted, .3057651, .1436394, .0799779, .5567963, .5117176, 0,
       .5173456, .3737600},
      {"mean female 0", kMeanFemale, fit_of(0, 0, 0, 0), .4038476, .1490000, .1257569, .8440061,
       .5206894, -.0025, .7187322, .4487633},
      {"mean female", kMeanFemale, fit_of(.15, .10, .25, .30), .4400022, .1465310, .1078085,
       .7357382, .5156511, 0, .8287009, .4487633},
  };
}

TEST(ShirtDraft, ReproducesCheckValues) {
  for (const Golden& g : goldens()) {
    SCOPED_TRACE(g.name);
    ShirtDraftReport r;
    const pattern::Pattern shirt = draft_shirt(g.body, g.fit, &r);
    expect_sound(shirt, g.body, g.fit);
    EXPECT_NEAR(r.armhole, g.armhole, 2e-6);
    EXPECT_NEAR(r.armhole_depth, g.depth, 1e-7);
    EXPECT_NEAR(r.cap_height, g.cap_height, 5e-6);
    EXPECT_NEAR(r.cap_ratio, g.ratio, 5e-5);
    EXPECT_NEAR(r.front_share, g.front_share, 5e-6);
    EXPECT_NEAR(r.deepened, g.deepened, 1e-9);
    EXPECT_NEAR(r.dropped, 0, 1e-12);
    EXPECT_NEAR(pattern_area(shirt), g.area, 5e-6);
    EXPECT_NEAR(edge_length(shirt, "front", "neck") + edge_length(shirt, "back", "neck"), g.neck,
                2e-6);
    EXPECT_NEAR(edge_length(shirt, "front", "armhole_L") + edge_length(shirt, "back", "armhole_L"),
                r.armhole, 1e-9);
  }
}

TEST(ShirtDraft, PrintedTableAgreesToItsDigits) {
  // armhole, d, h [m], ratio, area [m²] as printed in docs/theory/patterns.md 5, in the order of
  // goldens().
  const double table[11][5] = {
      {.384, .168, .099, .59, .815}, {.378, .170, .113, .66, .764}, {.392, .181, .143, .79, .661},
      {.416, .159, .131, .82, .856}, {.537, .248, .127, .51, .933}, {.303, .145, .097, .67, .506},
      {.312, .141, .078, .55, .574}, {.343, .143, .072, .50, .655}, {.306, .144, .080, .56, .517},
      {.404, .149, .126, .84, .719}, {.440, .147, .108, .74, .829}};
  const std::vector<Golden> rows = goldens();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE(rows[i].name);
    ShirtDraftReport r;
    const pattern::Pattern shirt = draft_shirt(rows[i].body, rows[i].fit, &r);
    EXPECT_NEAR(r.armhole, table[i][0], 5.1e-4);
    EXPECT_NEAR(r.armhole_depth, table[i][1], 5.1e-4);
    EXPECT_NEAR(r.cap_height, table[i][2], 5.1e-4);
    EXPECT_NEAR(r.cap_ratio, table[i][3], 5.1e-3);
    EXPECT_NEAR(pattern_area(shirt), table[i][4], 5.1e-4);
  }
}

TEST(ShirtDraft, TorsoAndSleeveFitsAreIndependent) {
  for (const ShirtMeasures& m : {kAdult, kChild, kMeanFemale})
    for (const double torso : {-.2, 0., .2, .4})
      for (const double sleeve : {-.2, 0., .3, .6}) {
        SCOPED_TRACE(testing::Message() << m.chest << " " << torso << " " << sleeve);
        const ShirtFit fit = fit_of(torso, torso, sleeve, sleeve);
        ShirtDraftReport r;
        expect_sound(draft_shirt(m, fit, &r), m, fit);
        EXPECT_GT(r.cap_ratio, .485);
        EXPECT_LT(r.cap_ratio, .855);
      }
}

TEST(ShirtDraft, SeamsPairEndWithStartOnTheSameSideOfTheBody) {
  const pattern::Pattern shirt = draft_shirt(kAdult);
  const auto world = [&](int p, const Vec2& x) -> Vec3 {
    return shirt.panels[p].rotation * Vec3(x.x(), x.y(), 0) + shirt.panels[p].translation;
  };
  for (const pattern::Stitch& s : shirt.stitches) {
    const pattern::EdgePath a(shirt.panels[s.first.panel], s.first.edge),
        b(shirt.panels[s.second.panel], s.second.edge);
    const double straight =
        (world(s.first.panel, a.at(0)) - world(s.second.panel, b.at(1))).norm() +
        (world(s.first.panel, a.at(1)) - world(s.second.panel, b.at(0))).norm();
    const double crossed = (world(s.first.panel, a.at(0)) - world(s.second.panel, b.at(0))).norm() +
                           (world(s.first.panel, a.at(1)) - world(s.second.panel, b.at(1))).norm();
    EXPECT_LT(straight, crossed) << s.name;
    const double side = s.name.back() == 'L' ? 1 : -1;  // +x is the wearer's left
    EXPECT_GT(side * world(s.first.panel, a.at(.5)).x(), 0) << s.name;
    EXPECT_GT(side * world(s.second.panel, b.at(.5)).x(), 0) << s.name;
  }
  for (const pattern::Panel& panel : shirt.panels) {
    EXPECT_NEAR(panel.rotation.determinant(), 1, 1e-12);
    const bool front = panel.name.find("front") != std::string::npos;
    EXPECT_EQ(panel.rotation.col(2).y() < 0, front) << panel.name << ": outside faces away";
  }
}

std::string message_of(const ShirtMeasures& m, const ShirtFit& fit) {
  try {
    draft_shirt(m, fit);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "accepted";
}

TEST(ShirtDraft, ImpossibleInputIsNamed) {
  EXPECT_EQ(message_of(kAdult, fit_of(-.9, 0, 0, 0)), "fit.chest: found -0.9, expected -0.5 to 2");
  EXPECT_EQ(message_of(kAdult, fit_of(std::nan(""), 0, 0, 0)),
            "fit.chest: found nan, expected -0.5 to 2");
  ShirtMeasures inches = kAdult;
  inches.chest = 34.6;
  EXPECT_EQ(message_of(inches, {}), "measures.chest: found 34.6 m, expected 0.35 to 2.2 m");
  EXPECT_NE(message_of(kAdult, fit_of(0, 0, 1.8, 0)).find("fit.sleeve: found 1.8, expected below"),
            std::string::npos);
  ShirtMeasures thick = kAdult;
  thick.neck = .79;
  thick.shoulder_breadth = .30;
  EXPECT_NE(message_of(thick, {}).find("measures.neck: found 0.79 m, expected at most"),
            std::string::npos);
  ShirtMeasures stub = kAdult;
  stub.arm_length = .15;
  EXPECT_NE(message_of(stub, {}).find("measures.arm_length: found 0.15 m, expected at least"),
            std::string::npos);
}

TEST(ShirtDraft, TheLimitItNamesForTheSleeveIsUsable) {
  const std::string message = message_of(kAdult, fit_of(.05, .05, 1.8, .1));
  const std::size_t at = message.find("below about ");
  ASSERT_NE(at, std::string::npos) << message;
  const double limit = std::stod(message.substr(at + 12));
  EXPECT_EQ(message_of(kAdult, fit_of(.05, .05, limit - .03, .1)), "accepted") << limit;
}

TEST(ShirtDraft, AnyInputInRangeIsDraftedOrRefused) {
  // A deterministic walk through the corners and middles of the input ranges.
  unsigned state = 1;
  const auto pick = [&](double low, double high) {
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * ((state >> 16) % 5) / 4.0;
  };
  int accepted = 0;
  for (int i = 0; i < 120; ++i) {
    ShirtMeasures m{.chest = pick(.35, 2.2),
                    .waist = pick(.3, 2.2),
                    .hip = pick(.35, 2.2),
                    .neck = pick(.15, .8),
                    .upper_arm = pick(.08, .9),
                    .wrist = pick(.06, .4),
                    .shoulder_breadth = pick(.15, .8),
                    .shoulder_slope = pick(0, radians(45)),
                    .scye_depth = pick(.05, .35),
                    .hps_to_waist = pick(.15, .8),
                    .hps_to_hem = pick(.2, 1.6),
                    .arm_length = pick(.15, 1)};
    ShirtFit fit = fit_of(pick(-.5, 2), pick(-.5, 2), pick(-.5, 3), pick(-.5, 3));
    if (i % 2) fit.waist = pick(-.5, 3);
    try {
      const pattern::Pattern shirt = draft_shirt(m, fit);
      expect_sound(shirt, m, fit);
      ++accepted;
    } catch (const InvalidInput&) {
    }
  }
  EXPECT_GT(accepted, 5);
}

TEST(ShirtSizes, EverySizeDraftsToItsFinishedGirths) {
  std::set<std::string> names;
  for (const std::string& name : support::shirt_size_names()) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(names.insert(name).second);
    const support::ShirtSize size = support::shirt_size(name);
    ShirtDraftReport r;
    expect_sound(draft_shirt(size.body, size.fit, &r), size.body, size.fit);
    EXPECT_GT(r.cap_ratio, .45);
    EXPECT_FALSE(find_size(shirt_sizes(), name).source.empty());
  }
  const support::ShirtSize child = support::shirt_size("Child-142");
  const auto girths = shirt_girths(draft_shirt(child.body, child.fit), child.body.hps_to_waist);
  EXPECT_NEAR(girths.at("chest"), .86, 1e-9);
  EXPECT_NEAR(girths.at("waist"), .84, 1e-9);
  EXPECT_NEAR(girths.at("hip"), .86, 1e-9);
  EXPECT_NEAR(girths.at("sleeve"), .32, 1e-9);
  EXPECT_THROW(support::shirt_size("child-900"), InvalidInput);
}

TEST(ShortSleeves, EndWhereTheyAreAskedToWithTheAskedGirthThere) {
  for (const ShirtMeasures& body : {kAdult, kChild, kMeanFemale})
    for (const double length : {0.36, 0.5, 0.75}) {
      ShirtFit fit = fit_of(0.1, 0.1, 0.2, 0.15);
      fit.sleeve_length = length;
      fit.shoulder_follow = 0;
      ShirtDraftReport report;
      const pattern::Pattern shirt = draft_shirt(body, fit, &report);
      EXPECT_NEAR(edge_length(shirt, "sleeve_L_front", "top"),
                  length * body.arm_length - report.dropped, 1e-9);
      const auto girths = shirt_girths(shirt, body.hps_to_waist);
      EXPECT_NEAR(girths.at("sleeve"), 1.2 * body.upper_arm, 1e-6);
      EXPECT_NEAR(girths.at("wrist"), 1.15 * arm_girth_at(body, length), 1e-9);
      EXPECT_NEAR(edge_length(shirt, "sleeve_L_front", "under"),
                  edge_length(shirt, "sleeve_L_back", "under"), 1e-9);
    }
}

TEST(ShortSleeves, ArmGirthIsThatOfUpperArmAndWristAtTheirPlaces) {
  EXPECT_EQ(arm_girth_at(kAdult, 0.3), kAdult.upper_arm);
  EXPECT_EQ(arm_girth_at(kAdult, 0.5), kAdult.upper_arm);
  EXPECT_NEAR(arm_girth_at(kAdult, 0.75), (kAdult.upper_arm + kAdult.wrist) / 2, 1e-12);
  EXPECT_EQ(arm_girth_at(kAdult, 1), kAdult.wrist);
}

TEST(ShortSleeves, TooShortAndTooLongAreErrorsThatSayWhatWouldDo) {
  const auto message = [](double length, double sleeve) {
    ShirtFit fit = fit_of(0.1, 0.1, sleeve, 0.15);
    fit.sleeve_length = length;
    try {
      draft_shirt(kMeanFemale, fit);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("drafted");
  };
  EXPECT_NE(message(0.25, -0.2).find("fit.sleeve_length: found 0.25, expected at least"),
            std::string::npos)
      << message(0.25, -0.2);
  EXPECT_NE(message(1.2, 0.1).find("fit.sleeve_length: found 1.2, expected 0.25 to 1"),
            std::string::npos);
}

}  // namespace
}  // namespace loosefit::kinds
