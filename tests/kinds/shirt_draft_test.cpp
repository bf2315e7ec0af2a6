#include "loosefit/kinds/shirt/shirt_draft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/kinds/shirt/sleeve_ease.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/self_crossing.h"
#include "support/shirt_kind.h"

namespace loosefit::kinds {
namespace {

const ShirtMeasures kAdult;
const ShirtMeasures kChild = with_usual_measures(ShirtMeasures{.chest = .700,
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
                                                               .arm_length = .480});
const ShirtMeasures kMeanFemale = with_usual_measures(ShirtMeasures{.chest = .974,
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
                                                                    .arm_length = .516});

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
  for (const pattern::Stitch& s : shirt.stitches) {
    const double ease = s.name.starts_with("armhole") ? fit.cap_ease : 0;
    EXPECT_NEAR((1 + ease) * pattern::EdgePath(shirt.panels[s.first.panel], s.first.edge).length(),
                pattern::EdgePath(shirt.panels[s.second.panel], s.second.edge).length(), 1e-7)
        << s.name;
  }
  for (const pattern::Panel& panel : shirt.panels) {
    EXPECT_EQ(pattern::first_self_crossing(pattern::outline_polygon(panel)).first, -1)
        << panel.name;
    EXPECT_GT(pattern::signed_area(pattern::outline_polygon(panel)), 0) << panel.name;
  }
}

/// Bodies and fits of the table in docs/theory/patterns.md 5.
struct Row {
  const char* name;
  ShirtMeasures body;
  ShirtFit fit;
};

std::vector<Row> rows() {
  ShirtFit tight = fit_of(-.15, -.15, -.15, -.10);
  tight.neck_ease = 0;
  ShirtFit waisted = fit_of(.05, -.05, .15, .15);
  waisted.waist = .02;
  return {{"adult", kAdult, fit_of(.05, .05, .10, .15)},
          {"adult 0", kAdult, fit_of(0, 0, 0, 0)},
          {"adult tight", kAdult, tight},
          {"adult loose", kAdult, fit_of(.30, .10, .05, .05)},
          {"adult wide sleeve", kAdult, fit_of(.05, .20, .60, .60)},
          {"child 0", kChild, fit_of(0, 0, 0, 0)},
          {"child", kChild, fit_of(.15, .10, .20, .20)},
          {"child loose", kChild, fit_of(.35, .25, .40, .50)},
          {"child waisted", kChild, waisted},
          {"mean female 0", kMeanFemale, fit_of(0, 0, 0, 0)},
          {"mean female", kMeanFemale, fit_of(.15, .10, .25, .30)}};
}

TEST(ShirtDraft, PrintedTableIsWhatTheDraftArrivesAt) {
  // armhole, d, h [m], ratio, area [m²] in the order of rows(), as the document prints them.
  const double table[11][5] = {
      {.441, .188, .142, .75, .819}, {.429, .186, .147, .79, .768}, {.410, .182, .154, .85, .671},
      {.418, .159, .133, .84, .871}, {.526, .233, .117, .50, .967}, {.342, .158, .123, .78, .505},
      {.376, .165, .125, .76, .568}, {.409, .167, .125, .75, .647}, {.376, .172, .130, .76, .512},
      {.399, .145, .122, .84, .735}, {.457, .145, .122, .84, .848}};
  const std::vector<Row> all = rows();
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(all[i].name);
    ShirtDraftReport r;
    const pattern::Pattern shirt = draft_shirt(all[i].body, all[i].fit, &r);
    expect_sound(shirt, all[i].body, all[i].fit);
    EXPECT_NEAR(r.armhole, table[i][0], 5.1e-4);
    EXPECT_NEAR(r.armhole_depth, table[i][1], 5.1e-4);
    EXPECT_NEAR(r.cap_height, table[i][2], 5.1e-4);
    EXPECT_NEAR(r.cap_ratio, table[i][3], 5.1e-3);
    EXPECT_NEAR(pattern_area(shirt), table[i][4], 5.1e-4);
  }
}

TEST(ShirtDraft, NeckSeamIsAsLongAndAsWideAsTheNeckBaseWithItsEase) {
  for (const ShirtMeasures& m : {kAdult, kChild, kMeanFemale})
    for (const double ease : {-.05, 0., .06, .3}) {
      ShirtFit fit;
      fit.neck_ease = ease;
      const pattern::Pattern shirt = draft_shirt(m, fit);
      EXPECT_NEAR(edge_length(shirt, "front", "neck") + edge_length(shirt, "back", "neck"),
                  (1 + ease) * m.neck, 1e-6);
      const pattern::Panel& front = shirt.panels[shirt.find_part("front")];
      const pattern::PanelEdge& neck = front.edges[pattern::find_edge_part(front, "neck")];
      EXPECT_NEAR((front.vertices[neck.start] - front.vertices[neck.end]).norm(),
                  (1 + ease) * m.neck_width, 1e-9);
      EXPECT_NEAR(fit_neck(m, fit).drop_back, (1 + ease) * m.neck_depth_back, 1e-12);
    }
}

TEST(ShirtDraft, ShoulderSeamSlopesByTwoThirdsOfTheShoulder) {
  for (const ShirtMeasures& m : {kAdult, kChild, kMeanFemale})
    for (const char* part : {"front", "back"}) {
      const pattern::Pattern shirt = draft_shirt(m, fit_of(.05, .05, .10, .15));
      const pattern::Panel& panel = shirt.panels[shirt.find_part(part)];
      const pattern::PanelEdge& seam = panel.edges[pattern::find_edge_part(panel, "shoulder_L")];
      const Vec2 way = panel.vertices[seam.start] - panel.vertices[seam.end];
      EXPECT_NEAR(std::atan(std::abs(way.y() / way.x())), m.shoulder_slope / 1.5, 1e-9) << part;
    }
}

// What a straight taper from upper arm to wrist does not do: the forearm is no cone.
TEST(ShirtDraft, SleevesHaveTheAskedEaseAllAlongTheArm) {
  for (const ShirtMeasures& m : {kAdult, kChild, kMeanFemale})
    for (const double sleeve : {0.05, 0.25, 0.5})
      for (const double wrist : {0.05, 0.25, 0.5}) {
        const ShirtFit fit = fit_of(.1, .1, sleeve, wrist);
        const pattern::Pattern shirt = draft_shirt(m, fit);
        const double least = std::min(sleeve, wrist);
        int stations = 0;
        for (const FitStation& s : shirt_stations(shirt, named(m), named(fit))) {
          if (s.limb != "arm") continue;
          ++stations;
          const double arm = arm_girth_at(m, s.along / m.arm_length);
          EXPECT_GE(s.garment / arm - 1, least - 0.01) << s.along << " " << sleeve << " " << wrist;
        }
        EXPECT_GT(stations, 10);
      }
}

TEST(ShirtDraft, SleevesPassThroughWhatIsAskedAtElbowAndForearm) {
  ShirtFit fit = fit_of(.1, .1, .25, .25);
  fit.elbow = .45;
  fit.forearm = .35;
  const pattern::Pattern shirt = draft_shirt(kAdult, fit);
  const pattern::Panel &front = shirt.panels[shirt.find_part("sleeve_L_front")],
                       &back = shirt.panels[shirt.find_part("sleeve_L_back")];
  const double top = edge_length(shirt, "sleeve_L_front", "top");
  double cuff = 0;
  for (const Vec2& p : front.vertices) cuff = std::min(cuff, p.y());
  const auto girth = [&](double along) {
    const double y = cuff + kAdult.arm_length - along;
    return width_at(front, y) + width_at(back, y);
  };
  EXPECT_LE(top, kAdult.arm_length + 1e-9);
  EXPECT_NEAR(girth(kAdult.elbow_length), 1.45 * kAdult.elbow, 1e-4);
  const double forearm = kAdult.elbow_length + 0.25 * (kAdult.arm_length - kAdult.elbow_length);
  EXPECT_NEAR(girth(forearm), 1.35 * kAdult.forearm, 1e-4);
}

TEST(ShirtDraft, BellyGetsTheEaseOfChestAndHipWithoutAnAskedWaist) {
  ShirtMeasures belly = kAdult;
  belly.waist = 1.15;
  const pattern::Pattern shirt = draft_shirt(belly, fit_of(.1, .1, .2, .2));
  EXPECT_NEAR(shirt_girths(shirt, belly.hps_to_waist).at("waist"), 1.1 * belly.waist, 1e-9);
}

TEST(ShirtDraft, FrontIsAsMuchLongerAndWiderAsTheBodyIs) {
  ShirtMeasures bust = kAdult;
  bust.front_balance = .03;
  bust.front_fullness = .04;
  const ShirtFit fit = fit_of(.1, .1, .2, .2);
  const pattern::Pattern shirt = draft_shirt(bust, fit);
  expect_sound(shirt, bust, fit);
  const pattern::Panel &front = shirt.panels[shirt.find_part("front")],
                       &back = shirt.panels[shirt.find_part("back")];
  // Halfway at the sides, where front and back meet.
  const auto hem_at = [](const pattern::Panel& panel, double share) {
    return pattern::EdgePath(panel, pattern::find_edge_part(panel, "hem")).at(share).y();
  };
  EXPECT_NEAR(hem_at(back, 0.5) - hem_at(front, 0.5), .03, 1e-9);
  EXPECT_NEAR(hem_at(back, 0.5), -bust.hps_to_hem, 1e-9);
  for (const pattern::Panel* panel : {&front, &back})
    for (const double end : {0., 1.})
      EXPECT_NEAR(hem_at(*panel, end), -bust.hps_to_hem - .015, 1e-9);
  const double y = -bust.hps_to_waist;
  EXPECT_NEAR(width_at(front, y) - width_at(back, y), 2 * 1.1 * .04, 1e-9);
}

TEST(ShirtDraft, GirthsOfTheTrunkEndWhereItsHemBegins) {
  for (const double balance : {-0.10, -0.02, 0.0, 0.03}) {
    ShirtMeasures m = kAdult;
    m.front_balance = balance;
    m.hps_to_hem = 0.645;
    const ShirtFit fit = fit_of(.1, .1, .2, .2);
    double lowest = 0;
    for (const FitStation& s : shirt_stations(draft_shirt(m, fit), named(m), named(fit))) {
      if (s.limb != "trunk") continue;
      lowest = std::max(lowest, s.along);
      EXPECT_GT(s.garment, 1.1 * m.chest - 0.03) << s.along << " " << balance;
    }
    EXPECT_LE(lowest, 0.645 + std::min(0.0, 0.5 * balance));
    EXPECT_GT(lowest, 0.645 + std::min(0.0, 0.5 * balance) - 0.021);
  }
}

TEST(ShirtDraft, SideSeamsFollowTheBodyOnlySoFar) {
  // As measured on a short heavy woman, whose trunk is widest far behind.
  for (const double fullness : {-.095, .13}) {
    ShirtMeasures odd = kMeanFemale;
    odd.front_fullness = fullness;
    for (const double ease : {-.05, .1, .35}) {
      const ShirtFit fit = fit_of(ease, ease, .15 + ease, .2);
      const pattern::Pattern shirt = draft_shirt(odd, fit);
      expect_sound(shirt, odd, fit);
      const double y = -odd.hps_to_waist;
      EXPECT_NEAR(width_at(shirt.panels[shirt.find_part("front")], y) -
                      width_at(shirt.panels[shirt.find_part("back")], y),
                  std::copysign(2 * (1 + ease) * .05 * odd.chest, fullness), 1e-9);
    }
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
  thick.neck_width = .34;
  ShirtFit wide;
  wide.neck_ease = .5;
  EXPECT_NE(message_of(thick, wide).find("measures.neck_width: found 0.34 m, expected at most"),
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

/// What a refusal of a shoulder seam that is too short tells; empty key: it is drafted.
std::pair<std::string, double> told_for_shoulder(const ShirtMeasures& m, const ShirtFit& fit) try {
  draft_shirt(m, fit);
  return {};
} catch (const InvalidInput& error) {
  if (std::string(error.hint()).find("shoulder seam") == std::string::npos) return {};
  const std::string said = error.expected();  // at most 0.123 m, at least -0.2
  return {error.place().key, std::stod(said.substr(said.find_first_of("-0123456789")))};
}

TEST(ShirtDraft, TheLimitThatIsToldForAShortShoulderSeamIsTaken) {
  int necks = 0, chests = 0;
  for (const double chest : {-.45, -.3, -.1, .1})
    for (const double shoulder : {.05, .08, .12})
      for (const double neck : {.15, .20, .25, .30, .35}) {
        ShirtMeasures m = kAdult;
        m.neck_width = neck, m.shoulder_length = shoulder;
        ShirtFit fit = fit_of(chest, .2, .4, .4);
        const auto [key, limit] = told_for_shoulder(m, fit);
        if (key.empty()) continue;
        SCOPED_TRACE(testing::Message() << chest << ' ' << shoulder << ' ' << neck);
        if (key == "measures.neck_width")
          m.neck_width = limit, ++necks;
        else
          fit.chest = limit, ++chests;
        EXPECT_EQ(told_for_shoulder(m, fit).first, "") << key << " = " << limit;
      }
  EXPECT_GT(necks, 3);
  EXPECT_GT(chests, 0);
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
    const ShirtMeasures m =
        with_usual_measures(ShirtMeasures{.chest = pick(.35, 2.2),
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
                                          .arm_length = pick(.15, 1)});
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

TEST(ShortSleeves, ArmGirthIsThatOfItsLevelsAtTheirPlaces) {
  const double elbow = kAdult.elbow_length / kAdult.arm_length, forearm = elbow + .25 * (1 - elbow);
  EXPECT_EQ(arm_girth_at(kAdult, 0.1), kAdult.upper_arm);
  EXPECT_NEAR(arm_girth_at(kAdult, elbow), kAdult.elbow, 1e-12);
  EXPECT_NEAR(arm_girth_at(kAdult, forearm), kAdult.forearm, 1e-12);
  EXPECT_NEAR(arm_girth_at(kAdult, (1 + forearm) / 2), (kAdult.forearm + kAdult.wrist) / 2, 1e-12);
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
