#include "loosefit/drape/worn.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/drape/openings.h"
#include "loosefit/drape/worn_way.h"
#include "loosefit/garment/hierarchy.h"
#include "loosefit/io/garmentcode_read.h"
#include "support/sewn_garments.h"
#include "support/shirt_kind.h"
#include "support/shirt_on_body.h"
#include "support/trunk_tubes.h"
#include "support/worn_shirt.h"

namespace loosefit::pipeline {
namespace {

using Reasons = std::vector<std::string>;

const body::PosedBody& woman() {
  static const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  return body;
}

/// A garment with its cut.
struct Sewn {
  pattern::Pattern pattern;
  garment::GarmentHierarchy levels;
  explicit Sewn(pattern::Pattern cut)
      : pattern(std::move(cut)), levels(garment::build_hierarchy(pattern, 0.03, support::knit())) {}
  const garment::Garment& mesh() const { return levels.finest(); }
  Reasons on(const std::vector<Vec3>& x, const body::PosedBody& body = woman()) const {
    return drape::why_not_worn(mesh(), pattern, x, body);
  }
};

const Sewn& shirt() {
  static const Sewn made(support::shirt_for(woman(), 0.2));
  return made;
}
const Sewn& trousers() {
  static const Sewn made(
      io::parse_garmentcode(support::trousers_file(52, 24, 66, 26, 10), "t").pattern);
  return made;
}

std::vector<Vec3> moved(std::vector<Vec3> x, const Vec3& way) {
  for (Vec3& p : x) p += way;
  return x;
}

std::vector<kinds::OpeningUse> uses(const Sewn& garment) {
  std::vector<kinds::OpeningUse> all;
  for (const drape::Opening& o : drape::garment_openings(garment.mesh(), garment.pattern))
    all.push_back(o.use);
  std::sort(all.begin(), all.end());
  return all;
}

/// Where the pattern places the pieces, nearer to the body, before and behind the body, the seams
/// drawn up to the middle, and so much lower.
std::vector<Vec3> round_the_body(const Sewn& garment, double down) {
  std::vector<Vec3> x = drape::placed_by_pattern(garment.mesh(), garment.pattern);
  for (Vec3& p : x) p = Vec3(p.x(), 0.5 * p.y(), p.z() - down);
  return x;
}

TEST(Openings, AreToldByHowTheyLieToEachOther) {
  EXPECT_EQ(uses(shirt()),
            (std::vector<kinds::OpeningUse>{kinds::OpeningUse::neck, kinds::OpeningUse::left_arm,
                                            kinds::OpeningUse::right_arm, kinds::OpeningUse::hem}));
  EXPECT_EQ(uses(trousers()), (std::vector<kinds::OpeningUse>{kinds::OpeningUse::left_leg,
                                                              kinds::OpeningUse::right_leg,
                                                              kinds::OpeningUse::waist}));
  const Sewn skirt(io::parse_garmentcode(support::tube_file(36, 50, 45, 60), "s").pattern);
  EXPECT_EQ(uses(skirt),
            (std::vector<kinds::OpeningUse>{kinds::OpeningUse::upper, kinds::OpeningUse::hem}));
}

TEST(Openings, KeepTheirUseWhereverThePatternIsPlaced) {
  pattern::Pattern high = shirt().pattern;
  for (pattern::Panel& panel : high.panels) panel.translation += Vec3(0.4, 0.1, 3);
  EXPECT_EQ(uses(Sewn(high)), uses(shirt()));
}

TEST(Worn, AShirtAsItIsPutOn) {
  const std::vector<Vec3> x = support::dress_shirt(shirt().mesh(), woman());
  EXPECT_EQ(shirt().on(x), Reasons{});
  EXPECT_EQ(shirt().on(moved(x, {0, 0, -0.03})), Reasons{}) << "settles by a few centimetres";
}

TEST(Worn, NotAShirtThatHasFallen) {
  const std::vector<Vec3> x = support::dress_shirt(shirt().mesh(), woman());
  const Reasons low = shirt().on(moved(x, {0, 0, -0.4}));
  EXPECT_EQ(low, (Reasons{"the neck opening lies below both shoulders", "the left sleeve is empty",
                          "the right sleeve is empty"}))
      << "worn as a skirt";
  const Reasons high = shirt().on(moved(x, {0, 0, 3}));
  ASSERT_FALSE(high.empty());
  EXPECT_EQ(high.front(), "the garment touches the body nowhere");
  EXPECT_NE(std::find(high.begin(), high.end(), "the head is not through the neck opening"),
            high.end());
}

TEST(Worn, NotAShirtOfWhichOneSleeveIsEmpty) {
  std::vector<Vec3> x = support::dress_shirt(shirt().mesh(), woman());
  const Vec3 shoulder = woman()->joints.at("shoulder_L");
  for (Vec3& p : x)  // swung down before the trunk
    if (p.x() > shoulder.x() + 0.04) p = Vec3(shoulder.x() + 0.04, p.y() - 0.5, p.z() - 0.3);
  EXPECT_EQ(shirt().on(x), Reasons{"the left sleeve is empty"});
}

/// The woman whose left arm ends at this share of the way from shoulder to wrist.
body::PosedBody with_arm_to(double share) {
  body::Body body = woman().body();
  const Vec3 shoulder = body.joints.at("shoulder_L"), wrist = body.joints.at("wrist_L");
  body.joints["arm_end_L"] = shoulder + share * (wrist - shoulder);
  return body;
}

TEST(Worn, AnEmptySleeveOfWhomLacksTheArmButNotOfWhomLacksTheHand) {
  const std::vector<Vec3> worn = support::dress_shirt(shirt().mesh(), woman());
  std::vector<Vec3> empty = worn;
  const Vec3 shoulder = woman()->joints.at("shoulder_L");
  for (Vec3& p : empty)
    if (p.x() > shoulder.x() + 0.04) p = Vec3(shoulder.x() + 0.04, p.y() - 0.5, p.z() - 0.3);
  for (const double share : {0.0, 0.03}) {
    EXPECT_EQ(shirt().on(worn, with_arm_to(share)), Reasons{}) << share;
    EXPECT_EQ(shirt().on(empty, with_arm_to(share)), Reasons{}) << share;
  }
  for (const double share : {0.6, 0.8, 1.0}) {
    EXPECT_EQ(shirt().on(worn, with_arm_to(share)), Reasons{}) << share;
    EXPECT_EQ(shirt().on(empty, with_arm_to(share)), Reasons{"the left sleeve is empty"}) << share;
  }
}

TEST(Worn, ASleeveThatIsLongerThanItsArm) {
  std::vector<Vec3> x = support::dress_shirt(shirt().mesh(), woman());
  const Vec3 elbow = woman()->joints.at("elbow_L"), wrist = woman()->joints.at("wrist_L");
  const Vec3 along = (wrist - elbow).normalized();
  for (Vec3& p : x) {
    const double beyond = (p - elbow).dot(along) - 0.05;
    if (p.x() > 0.2 && beyond > 0) p += beyond * along;  // twice as long from the forearm on
  }
  EXPECT_EQ(shirt().on(x), Reasons{});
}

TEST(Worn, TrousersAtTheWaistAndNotRoundTheKnees) {
  EXPECT_EQ(trousers().on(round_the_body(trousers(), 0)), Reasons{});
  EXPECT_EQ(trousers().on(round_the_body(trousers(), 0.05)), Reasons{}) << "on the upper hips";
  EXPECT_EQ(trousers().on(round_the_body(trousers(), 0.5)),
            Reasons{"the waistband has slid to the knees"});
  EXPECT_EQ(trousers().on(round_the_body(trousers(), 0.92)),
            Reasons{"the waistband has slid to the feet"});
}

TEST(Worn, NotTrousersWhoseWaistbandLiesOnTheForearms) {
  std::vector<Vec3> x = round_the_body(trousers(), 0);
  ASSERT_EQ(trousers().on(x), Reasons{});
  // The waistband is spread beyond both arms, all below it stays round the trunk.
  for (Vec3& p : x)
    if (const double up = std::clamp((p.z() - 0.96) / 0.06, 0.0, 1.0); up > 0)
      p = Vec3((1 + 0.9 * up) * p.x(), (1 + 1.2 * up) * p.y(), p.z());
  EXPECT_EQ(trousers().on(x), Reasons{"the waistband goes round the trunk and both arms"});
}

TEST(Worn, TheBoundIsHalfTheWayFromWaistToCrotch) {
  double held = 0, gone = 0.5;
  while (gone - held > 0.002) {
    const double down = 0.5 * (held + gone);
    (trousers().on(round_the_body(trousers(), down)).empty() ? held : gone) = down;
  }
  const body::Body& body = woman();
  const double waist =
      0.5 * (body.landmarks.at("back_waist").z() + body.landmarks.at("front_waist").z());
  const double top = 1.02;  // of the trousers [m]
  EXPECT_NEAR(top - held, waist - 0.5 * (waist - body.landmarks.at("crotch").z()), 0.02);
}

TEST(Worn, AWaistThatHasRisenIsToldAndAboveTheBustItIsNotWorn) {
  const body::Body& body = woman();
  const double waist =
      0.5 * (body.landmarks.at("back_waist").z() + body.landmarks.at("front_waist").z());
  const double way = waist - body.landmarks.at("crotch").z();
  // Made for the hips, where the lowest level of a waist is.
  const Sewn skirt(io::parse_garmentcode(support::tube_file(40, 46, 12, 70), "s").pattern);
  const std::vector<Vec3> low = round_the_body(skirt, 0);
  double top = 0;
  for (const Vec3& p : low) top = std::max(top, p.z());
  const auto at = [&](double above) { return moved(low, {0, 0, waist + above - top}); };
  const auto risen = [&](double above) {
    return drape::risen_edges(skirt.mesh(), skirt.pattern, at(above), body);
  };
  EXPECT_EQ(skirt.on(at(0.4 * way)), Reasons{});
  EXPECT_EQ(risen(0.4 * way), Reasons{});
  EXPECT_EQ(skirt.on(at(0.65 * way)), Reasons{}) << "below the bust";
  EXPECT_EQ(risen(0.65 * way), Reasons{fmt::format("the waistband lies {:.2f} m above the waist: "
                                                   "further down the garment is too narrow for "
                                                   "this body",
                                                   0.65 * way)});
  EXPECT_FALSE(skirt.on(at(0.85 * way)).empty()) << "over the bust";
}

TEST(Worn, AShirtThatIsGatheredAboveTheHipsIsTold) {
  const std::vector<Vec3> x = support::dress_shirt(shirt().mesh(), woman());
  const auto risen = [](const std::vector<Vec3>& at) {
    return drape::risen_edges(shirt().mesh(), shirt().pattern, at, woman());
  };
  EXPECT_EQ(risen(x), Reasons{});
  // Behind alone: the wearer faces −y.
  std::vector<Vec3> rolled = x;
  const Vec3& waist = woman()->landmarks.at("back_waist");
  for (Vec3& p : rolled)
    if (p.y() > 0.5 * (waist.y() + woman()->landmarks.at("front_waist").y()))
      p.z() = std::max(p.z(), waist.z() + 0.04);
  EXPECT_EQ(shirt().on(rolled), Reasons{}) << "neck, arms and trunk go through";
  const Reasons told = risen(rolled);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_TRUE(told[0].starts_with("the hem has ridden up")) << told[0];
}

TEST(Worn, LevelsGoAlongWithAPosture) {
  const body::Body sitting = body_model().build(support::adult_parameters(), {radians(40), 0, 1});
  const double waist =
      0.5 * (sitting.landmarks.at("back_waist").z() + sitting.landmarks.at("front_waist").z());
  const Sewn skirt(io::parse_garmentcode(support::tube_file(40, 46, 12, 92), "s").pattern);
  std::vector<Vec3> x = drape::placed_by_pattern(skirt.mesh(), skirt.pattern);
  const Vec3 back = sitting.landmarks.at("back_waist"), front = sitting.landmarks.at("front_waist");
  const double y = 0.5 * (back.y() + front.y());
  for (Vec3& p : x) p = Vec3(p.x(), y + 0.5 * p.y(), p.z() + waist - 1.04);
  EXPECT_EQ(skirt.on(x, sitting), Reasons{}) << "at the waist of a sitter, lower than the pattern";
}

TEST(Worn, NothingIsAskedOfABodyWithoutJointsButTheTouch) {
  body::Body statue = woman();
  statue.joints.clear();
  EXPECT_EQ(trousers().on(round_the_body(trousers(), 0.5), statue), Reasons{});
  EXPECT_EQ(trousers().on(round_the_body(trousers(), -3), statue),
            Reasons{"the garment touches the body nowhere"});
}

/// Two equal pieces before and behind the body, sewn at both sides: `neck` and `hem` flat widths
/// [m].
pattern::Pattern two_panels(double neck, double hem, double length, double x, double top) {
  using namespace testing_support;
  pattern::Pattern pattern;
  for (const bool back : {false, true})
    pattern.panels.push_back(placed(
        polygon_panel(
            back ? "back" : "front",
            {{-hem / 2, -length}, {hem / 2, -length}, {neck / 2, 0}, {0, -0.03}, {-neck / 2, 0}}),
        back, x, top));
  pattern.stitches = {stitch(0, 1, 1, 4), stitch(0, 4, 1, 1)};
  return pattern;
}

double neck_height(const body::Body& body) { return body.landmarks.at("hps_L").z(); }

TEST(Worn, APonchoOnTheShouldersButNotBelowThem) {
  const Sewn poncho(two_panels(0.30, 1.10, 0.55, 0, neck_height(woman()) + 0.02));
  const std::vector<Vec3> x = round_the_body(poncho, 0.02);
  EXPECT_EQ(poncho.on(x), Reasons{});
  EXPECT_EQ(poncho.on(moved(x, {0, 0, -0.45})),
            Reasons{"the neck opening lies below both shoulders"});
  EXPECT_FALSE(poncho.on(moved(x, {0.6, 0, 0})).empty()) << "beside the head";
}

// Its waist is placed where this wearer has her neck, as a poncho's neck opening would be.
TEST(Worn, ASkirtThatWasPlacedForSomebodyTallerHangsAtTheWaist) {
  const double waist = woman()->measured.at("waist_level");
  pattern::Pattern cut = two_panels(0.38, 0.60, 0.5, 0, neck_height(woman()) + 0.02);
  for (pattern::Panel& panel : cut.panels) panel.label = "leg";
  const Sewn skirt(cut);
  const std::vector<Vec3> x = round_the_body(skirt, neck_height(woman()) + 0.02 - waist);
  EXPECT_EQ(skirt.on(x), Reasons{});
  EXPECT_FALSE(skirt.on(moved(x, {0, 0, -0.3})).empty());
}

// A file may place it so; what its edges are for is told by their labels.
TEST(Worn, NotASkirtThatIsWornUpsideDown) {
  const double waist = woman()->measured.at("waist_level");
  pattern::Pattern cut = two_panels(0.60, 0.42, 0.5, 0, waist);
  const std::vector<Vec3> x = round_the_body(Sewn(cut), 0);
  EXPECT_EQ(Sewn(cut).on(x), Reasons{}) << "a tube without labels may be narrow at its hem";
  for (pattern::Panel& panel : cut.panels) panel.edges[0].label = "lower_interface";
  const Reasons labelled = Sewn(cut).on(x);
  EXPECT_EQ(labelled, (Reasons{"the waistband has slid to the knees",
                               "the garment is upside down: its hem lies above its waist"}));
}

// A rib at the hem of a top may be called a waistband.
TEST(Worn, AStraplessTopWithABandAtItsHemAndASkirtOnItsHeadByTheNameOfItsBand) {
  /// Front and back with strips sewn to their lower edges.
  const auto banded = [](pattern::Pattern cut, double width, const std::string& name) {
    using namespace testing_support;
    const double low = cut.panels[0].translation.z() + cut.panels[0].vertices[0].y();
    for (const bool back : {false, true})
      cut.panels.push_back(placed(rectangle_panel(back ? "wb_back" : "wb_front", width, 0.04), back,
                                  (back ? 1 : -1) * width / 2, low - 0.04));
    for (pattern::Panel& panel : cut.panels)
      if (!panel.name.starts_with("wb")) panel.name = name + panel.name;
    for (const auto& seam :
         {stitch(2, 2, 0, 0), stitch(3, 2, 1, 0), stitch(2, 1, 3, 3), stitch(2, 3, 3, 1)})
      cut.stitches.push_back(seam);
    return cut;
  };
  const double chest = woman()->measured.at("chest");
  const double top = woman()->landmarks.at("sternum").z() + 0.03;
  const Sewn tube(banded(two_panels(0.48 * chest, 0.46 * chest, 0.30, 0, top), 0.46 * chest, ""));
  EXPECT_EQ(tube.on(round_the_body(tube, 0)), Reasons{});
  const double waist = woman()->measured.at("waist_level");
  const Sewn skirt(banded(two_panels(0.60, 0.42, 0.5, 0, waist), 0.42, "skirt_"));
  EXPECT_EQ(skirt.on(round_the_body(skirt, 0)).back(),
            "the garment is upside down: its hem lies above its waist");
}

TEST(WornWay, InsideOutAndTurnedAreTold) {
  const Sewn skirt(two_panels(0.42, 0.60, 0.5, 0, woman()->measured.at("waist_level")));
  const std::vector<Vec3> x = round_the_body(skirt, 0);
  const auto told = [&](auto&& change) {
    std::vector<Vec3> changed = x;
    for (Vec3& p : changed) p = change(p);
    const drape::WayRound way = drape::way_round(skirt.mesh(), skirt.pattern, changed, woman());
    Reasons said;
    for (const std::string& line : {way.inside_out, way.turned})
      if (!line.empty()) said.push_back(line);
    return said;
  };
  EXPECT_EQ(told([](const Vec3& p) { return p; }), Reasons{});
  const auto turned = [&](double angle) {
    const Eigen::AngleAxisd turn(radians(angle), Vec3::UnitZ());
    return told([turn](const Vec3& p) { return Vec3(turn * p); });
  };
  EXPECT_EQ(turned(40), Reasons{});
  // The wearer faces −y, her left is +x.
  EXPECT_EQ(turned(90), Reasons{"the garment is worn turned: the pieces for the front lie 90° to "
                                "the left of the wearer's front"});
  EXPECT_EQ(turned(-90), Reasons{"the garment is worn turned: the pieces for the front lie 90° to "
                                 "the right of the wearer's front"});
  const Reasons mirrored = told([](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); });
  ASSERT_EQ(mirrored.size(), 1u);
  EXPECT_TRUE(mirrored[0].starts_with("the garment is worn inside out")) << mirrored[0];
  body::Body statue = woman();
  statue.joints.clear();
  std::vector<Vec3> other_hand = x;
  for (Vec3& p : other_hand) p.x() = -p.x();
  EXPECT_EQ(drape::way_round(skirt.mesh(), skirt.pattern, other_hand, statue).inside_out, "");
}

TEST(Worn, AStockingOnItsLegAndNotBesideIt) {
  const body::Body& body = woman();
  const Vec3 knee = body.joints.at("knee_L"), hip = body.joints.at("hip_L");
  const double top = 0.3 * knee.z() + 0.7 * hip.z();
  const Sewn stocking(two_panels(0.18, 0.14, 0.4, 0.5 * (knee.x() + hip.x()), top));
  const std::vector<Vec3> x = moved(round_the_body(stocking, 0), {0, knee.y(), 0});
  EXPECT_EQ(stocking.on(x), Reasons{});
  EXPECT_EQ(stocking.on(moved(x, {0.4, -0.1, 0})).back(),
            "an opening made for the left leg goes round no part of the body");
  EXPECT_EQ(stocking.on(moved(x, {-2 * knee.x(), 0, 0})),
            Reasons{"an opening made for the left leg goes round the right leg"});
  EXPECT_EQ(stocking.on(moved(x, {0, 0, -0.08})), Reasons{});
  const Reasons slid = stocking.on(moved(x, {0, 0, -0.35}));
  ASSERT_EQ(slid.size(), 1u) << "on the shank";
  EXPECT_TRUE(slid[0].starts_with("what goes round the left leg has slid down it by 0.3"))
      << slid[0];
  // Made for somebody taller: no stocking lies above the crotch.
  pattern::Pattern tall = stocking.pattern;
  for (pattern::Panel& panel : tall.panels) panel.translation.z() += 0.12;
  const Sewn high(tall);
  const std::vector<Vec3> placed = moved(round_the_body(high, 0), {0, knee.y(), 0});
  EXPECT_EQ(high.on(moved(placed, {0, 0, -0.16})), Reasons{}) << "on the upper thigh";
}

// Its cuff is beyond the hand, and its upper end on the forearm.
TEST(Worn, NotASleeveAloneThatHasSlidToTheHand) {
  const body::Body& body = woman();
  const Vec3 shoulder = body.joints.at("shoulder_L"), wrist = body.joints.at("wrist_L");
  const Vec3 along = (wrist - shoulder).normalized();
  // Along the arm, its upper end so far below the shoulder.
  const auto on_arm = [&](pattern::Pattern& cut, double from) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(-Vec3::UnitZ(), along);
    for (pattern::Panel& panel : cut.panels) {
      panel.translation = turn * panel.translation + shoulder + from * along;
      panel.rotation = turn * panel.rotation;
    }
  };
  pattern::Pattern upper = two_panels(0.20, 0.16, 0.25, 0, 0);
  on_arm(upper, 0.05);
  const Sewn sleeve(upper);
  std::vector<Vec3> x = drape::placed_by_pattern(sleeve.mesh(), sleeve.pattern);
  EXPECT_EQ(sleeve.on(x), Reasons{});
  const Reasons slid = sleeve.on(moved(x, 0.25 * along));
  ASSERT_FALSE(slid.empty());
  EXPECT_TRUE(slid.back().starts_with("what goes round the left arm has slid down it by 0."))
      << slid.back();
}

// Its file may place it anywhere.
TEST(Worn, ASkirtThatIsPlacedRoundOneLegIsNoStocking) {
  const double waist = woman()->measured.at("waist_level");
  const Sewn skirt(two_panels(0.40, 0.60, 0.5, 0.24, waist - 0.12));
  const std::vector<Vec3> x = moved(round_the_body(skirt, 0), {-0.24, 0, 0.12});
  EXPECT_EQ(skirt.on(x), Reasons{});
}

TEST(WornWay, ATubeThatIsWiderAtItsTopMayBeUpsideDown) {
  const auto told = [](double top, double bottom, const std::string& label = "") {
    pattern::Pattern cut = two_panels(top, bottom, 0.5, 0, woman()->measured.at("waist_level"));
    for (pattern::Panel& panel : cut.panels) panel.edges[2].label = panel.edges[3].label = label;
    const Sewn skirt(cut);
    return drape::way_round(skirt.mesh(), cut, round_the_body(skirt, 0), woman()).upside_down;
  };
  EXPECT_EQ(told(0.42, 0.60), "");
  EXPECT_EQ(told(0.60, 0.50), "") << "a tulip";
  EXPECT_NE(told(0.60, 0.42).find("upside down"), std::string::npos);
  EXPECT_EQ(told(0.60, 0.42, "lower_interface"), "") << "its label says which is the waist";
}

TEST(Worn, NoArmIsInWhatIsCalledASleeve) {
  pattern::Pattern cut = two_panels(0.42, 0.60, 0.5, 0, woman()->measured.at("waist_level"));
  for (pattern::Panel& panel : cut.panels) panel.name = "sleeve_" + panel.name;
  const Sewn sleeve(cut);
  EXPECT_EQ(sleeve.on(round_the_body(sleeve, 0)), Reasons{"no arm is in a sleeve"});
}

TEST(Worn, ATubeThatIsPlacedRoundNothingGoesRoundWhateverIsInBothEnds) {
  const body::Body& body = woman();
  const Vec3 knee = body.joints.at("knee_L");
  const Sewn far(two_panels(0.20, 0.18, 0.3, 3, knee.z() + 0.1));
  const std::vector<Vec3> x = round_the_body(far, 0);
  EXPECT_EQ(far.on(moved(x, {knee.x() - 3, knee.y(), 0})), Reasons{});
  EXPECT_EQ(far.on(moved(x, {knee.x() - 2.7, knee.y(), 0})).back(),
            "nothing goes through both ends of a tube");
}

TEST(Worn, ATankTopOnTheShoulders) {
  using namespace testing_support;
  for (const double length : {0.45, 0.65}) {
    const Sewn top(testing_support::dress(levels_of(woman()), 1.15, length));
    const std::vector<Vec3> x = round_the_body(top, 0.01);
    EXPECT_EQ(top.on(x), Reasons{}) << length;
    const Reasons low = top.on(moved(x, {0, 0, -0.4}));
    EXPECT_NE(std::find(low.begin(), low.end(), "the neck opening lies below both shoulders"),
              low.end())
        << length;
  }
}

TEST(Worn, AStraplessDressAtTheChestAndNotAtTheHips) {
  const double chest = woman()->measured.at("chest");
  const Sewn dress(
      two_panels(0.48 * chest, 0.7 * chest, 0.7, 0, woman()->landmarks.at("sternum").z() + 0.03));
  const std::vector<Vec3> x = round_the_body(dress, 0);
  EXPECT_EQ(dress.on(x), Reasons{});
  EXPECT_EQ(dress.on(moved(x, {0, 0, -0.35})), Reasons{"the upper opening has slid to the hips"});
}

TEST(Worn, AShirtWithTheArmsRaisedAside) {
  const body::Body raised = support::standing(support::adult_parameters(), 80);
  const Sewn made(support::shirt_for(raised, 0.2));
  EXPECT_EQ(made.on(support::dress_shirt(made.mesh(), raised), raised), Reasons{});
}

/// The shirt cut open along the middle of its front, without labels on its edges.
struct Jacket {
  pattern::Pattern pattern = shirt().pattern;
  garment::Garment mesh = shirt().mesh();
  Jacket() {
    for (pattern::Panel& panel : pattern.panels)
      for (pattern::PanelEdge& edge : panel.edges) edge.label.clear();
    const std::vector<Vec3> flat = drape::placed_by_pattern(mesh, pattern);
    const garment::Garment whole = mesh;
    mesh.triangles.clear(), mesh.triangle_uv.clear(), mesh.triangle_panel.clear();
    for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
      const Triangle& c = whole.triangles[t];
      const Vec3 middle = (flat[c[0]] + flat[c[1]] + flat[c[2]]) / 3;
      if (middle.y() < 0 && std::abs(middle.x()) < 0.03) continue;
      mesh.triangles.push_back(c);
      mesh.triangle_uv.push_back(whole.triangle_uv[t]);
      mesh.triangle_panel.push_back(whole.triangle_panel[t]);
    }
  }
  Reasons on(const std::vector<Vec3>& x) const {
    return drape::why_not_worn(mesh, pattern, x, woman());
  }
};

TEST(Worn, AnOpenJacketOnTheShouldersButNotOnTheForearmsAlone) {
  const Jacket jacket;
  std::vector<Vec3> x = support::dress_shirt(shirt().mesh(), woman());
  EXPECT_EQ(jacket.on(x), Reasons{});
  EXPECT_EQ(jacket.on(moved(x, {0, 0, -0.03})), Reasons{}) << "settles by a few centimetres";
  const double shoulder = woman()->joints.at("shoulder_L").x(),
               wrist = woman()->joints.at("wrist_L").x();
  for (Vec3& p : x) {  // the cuffs stay where they are
    const double along = (std::abs(p.x()) - shoulder) / (wrist - 0.05 - shoulder);
    p.z() -= 0.35 * std::clamp(1 - along, 0.0, 1.0);
  }
  const Reasons slid = jacket.on(x);
  EXPECT_NE(std::find(slid.begin(), slid.end(), "the back of the neck has slid off the shoulders"),
            slid.end());
}

TEST(Worn, PosturesAreComparedInOpeningsOfUnusualCutsAlone) {
  const Jacket jacket;
  const std::vector<Vec3> x = support::dress_shirt(shirt().mesh(), woman());
  const auto alike = [&](const garment::Garment& mesh, const Vec3& way) {
    return drape::worn_alike(mesh, jacket.pattern, moved(x, way), woman(), x, woman());
  };
  EXPECT_TRUE(alike(jacket.mesh, {0, 0, -0.03}));
  EXPECT_FALSE(alike(jacket.mesh, {0, 0, 3}));
  EXPECT_TRUE(alike(shirt().mesh(), {0, 0, 3})) << "why_not_worn knows what its openings are for";
}

// What a hole in the breast is for nobody knows; the open front of a jacket has a question of its
// own.
TEST(Worn, AnOpeningThatNobodyAsksOfIsTold) {
  const Jacket jacket;
  const std::vector<Vec3> x = support::dress_shirt(shirt().mesh(), woman());
  const auto unjudged = [&](const garment::Garment& mesh) {
    return drape::unjudged_openings(mesh, shirt().pattern, x, woman());
  };
  EXPECT_EQ(unjudged(shirt().mesh()), "");
  EXPECT_EQ(drape::unjudged_openings(jacket.mesh, jacket.pattern, x, woman()), "");
  garment::Garment holed = shirt().mesh();
  const std::vector<Vec3> flat = drape::placed_by_pattern(holed, shirt().pattern);
  const double breast = woman()->joints.at("shoulder_L").z() - 0.2;
  std::vector<std::size_t> kept;
  for (std::size_t t = 0; t < holed.triangles.size(); ++t) {
    const Triangle& c = holed.triangles[t];
    const Vec3 middle = (flat[c[0]] + flat[c[1]] + flat[c[2]]) / 3;
    if (middle.y() > 0 || std::abs(middle.x()) > 0.05 || std::abs(middle.z() - breast) > 0.05)
      kept.push_back(t);
  }
  ASSERT_LT(kept.size(), holed.triangles.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    holed.triangles[k] = holed.triangles[kept[k]];
    holed.triangle_uv[k] = holed.triangle_uv[kept[k]];
    holed.triangle_panel[k] = holed.triangle_panel[kept[k]];
  }
  holed.triangles.resize(kept.size());
  holed.triangle_uv.resize(kept.size());
  holed.triangle_panel.resize(kept.size());
  const std::string told = unjudged(holed);
  EXPECT_NE(told.find("an opening is for is not known"), std::string::npos) << told;
  EXPECT_NE(told.find("m round at front"), std::string::npos) << told;
}

TEST(Worn, AnUnusualCutIsAskedInShareOfItsWearer) {
  using namespace testing_support;
  const body::Body child = support::standing(support::slim_child_parameters(), 40);
  const double share = child.measured.at("height") / woman()->measured.at("height");
  pattern::Pattern shawl;  // a front piece that hangs from the neck to the waist
  shawl.panels = {
      placed(rectangle_panel("front", 0.3, 0.35), false, -0.15, neck_height(woman()) - 0.35)};
  const Sewn made(shawl);
  std::vector<Vec3> on_woman = drape::placed_by_pattern(made.mesh(), made.pattern);
  double skin = 0;
  for (const Vec3& p : woman()->surface.vertices) skin = std::min(skin, p.y());
  for (Vec3& p : on_woman) p.y() = skin;
  std::vector<Vec3> on_child = on_woman;
  for (Vec3& p : on_child) p *= share;
  const auto sunk = [](const Reasons& reasons) {
    return std::any_of(reasons.begin(), reasons.end(), [](const std::string& r) {
      return r.find("below where it was put on") != std::string::npos;
    });
  };
  EXPECT_FALSE(sunk(made.on(on_woman)));
  EXPECT_FALSE(sunk(made.on(on_child, child)));
  EXPECT_TRUE(sunk(made.on(moved(on_child, {0, 0, -0.5}), child)));
  EXPECT_TRUE(sunk(made.on(moved(on_woman, {0, 0, -0.5}))));
  pattern::Pattern high = shawl;
  high.panels[0].translation.z() += 3;
  EXPECT_FALSE(sunk(Sewn(high).on(on_woman))) << "wherever the pattern is placed";
}

}  // namespace
}  // namespace loosefit::pipeline
