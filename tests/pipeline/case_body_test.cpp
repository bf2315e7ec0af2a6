#include "loosefit/pipeline/case_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/scan_person.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/case_pattern.h"
#include "loosefit/pipeline/simulation_options.h"
#include "support/scratch_folder.h"

namespace loosefit::pipeline {
namespace {

double arm_angle(const body::Body& body) {
  const Vec3 arm = body.joints.at("elbow_L") - body.joints.at("shoulder_L");
  return degrees(std::acos(-arm.normalized().z()));
}

TEST(MakeBody, MeetsTheWishesAndListsThem) {
  scenario::ScenarioBody wished;
  wished.measurements = {{"chest", 0.90}, {"waist", 0.74}};
  const CaseBody made = make_body(wished);
  EXPECT_NEAR(made.body->measured.at("height"), 1.68, 0.005);
  EXPECT_NEAR(made.body->measured.at("chest"), 0.90, 0.005);
  EXPECT_NEAR(made.body->measured.at("waist"), 0.74, 0.005);
  EXPECT_GE(made.asked.size(), 2u);
}

TEST(MakeBody, PathLeadsFromDressingToWantedPostureOnOneTopology) {
  const CaseBody made = make_body({});
  const body::Body start = made.path(0), end = made.path(1);
  EXPECT_EQ(start.surface.triangles, end.surface.triangles);
  EXPECT_NEAR(arm_angle(start), 40, 2);
  EXPECT_NEAR(arm_angle(end), 8, 2);
  EXPECT_EQ(end.surface.vertices, made.body->surface.vertices) << "the same bits every time";
}

TEST(MakeBody, MissingScanIsAnError) {
  scenario::ScenarioBody wished;
  wished.file = "/nowhere/scan.obj";
  EXPECT_THROW(make_body(wished), Error);
}

TEST(MakeBody, FleshThatHangingArmsPressIsThereAgainInTheScansMeasures) {
  scenario::ScenarioBody wished;
  wished.height = 1.66;
  wished.measurements = {{"chest", 0.94}, {"waist", 0.78}, {"hip", 1.00}};
  const body::PosedBody standing = make_body(wished).body;
  const auto found = body::person_from_scan(body::BodyModel::load(), standing->surface,
                                            {.file = "scan.obj", .units = "m", .up = "z"});
  ASSERT_TRUE(found);
  for (const char* girth : {"chest", "underbust", "waist", "hip", "upper_arm", "armscye", "neck"})
    EXPECT_NEAR(found->body.measured.at(girth), standing->measured.at(girth), 0.010) << girth;
}

struct MakeBodyOfScan : ::testing::Test {
  const support::ScratchFolder folder;
  /// The scan of a person in a posture, metres, z up, so far from the origin.
  scenario::ScenarioBody scan_of(const body::Posture& posture,
                                 const Vec3& place = Vec3::Zero()) const;
};

scenario::ScenarioBody MakeBodyOfScan::scan_of(const body::Posture& posture,
                                               const Vec3& place) const {
  const body::BodyModel model = body::BodyModel::load();
  body::BodySpec spec;
  spec.sex = 0, spec.age = 30, spec.height = 1.68;
  const body::Body person = model.build(body::fit_body(model, spec).parameters, posture);
  const auto file = folder / "scan.obj";
  std::ofstream out(file);
  for (const Vec3& p : person.surface.vertices) out << "v " << (p + place).transpose() << '\n';
  for (const Triangle& t : person.surface.triangles)
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  scenario::ScenarioBody wished;
  wished.file = file.string(), wished.units = "m", wished.up = "z";
  return wished;
}

bool warned(const CaseBody& body, const std::string& words) {
  return std::ranges::any_of(body.warnings, [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

TEST_F(MakeBodyOfScan, WithOpenArmsStaysAsItIs) {
  const CaseBody made = make_body(scan_of(body::kArmsApart));
  EXPECT_FALSE(made.person);
  EXPECT_NEAR(arm_angle(made.body), 40, 2);
  EXPECT_EQ(made.path(0).body().surface.vertices, made.body->surface.vertices);
  EXPECT_TRUE(warned(made, "the body model lies on the scan"));
}

TEST_F(MakeBodyOfScan, WithHangingArmsIsDressedWithThemApart) {
  const CaseBody made = make_body(scan_of(body::kStanding));
  ASSERT_TRUE(made.person);
  EXPECT_NEAR(arm_angle(made.body), 8, 4);
  EXPECT_NEAR(arm_angle(made.path(0)), 40, 2);
  EXPECT_TRUE(warned(made, "posed by a fitted skeleton"));
}

TEST_F(MakeBodyOfScan, TakesThePostureThatIsAskedFor) {
  const Vec3 place(0.8, -0.5, 0.2);
  scenario::ScenarioBody wished = scan_of(body::kArmsApart, place);
  wished.as_scanned = false;
  wished.posture = body::kStanding;
  const CaseBody made = make_body(wished);
  ASSERT_TRUE(made.person);
  EXPECT_NEAR(arm_angle(made.body), 8, 4);
  // What was placed round the scan is carried along.
  EXPECT_LT((made.body->from_world * place).norm(), 0.1);
}

TEST_F(MakeBodyOfScan, MustShowAPersonForAPosture) {
  scenario::ScenarioBody wished;
  wished.as_scanned = false;
  wished.file = (folder / "tube.obj").string();
  std::ofstream(wished.file) << "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nv 0 0 1.7\n"
                                "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  EXPECT_THROW(make_body(wished), Error);
}

/// As a scenario that says nothing of postures.
scenario::ScenarioBody usual() {
  scenario::ScenarioBody wished;
  wished.dress_posture = body::default_dress_posture(wished.posture);
  return wished;
}

TEST(MakeBody, OffersArmsWideApartUnlessADressingPostureWasChosen) {
  EXPECT_NEAR(arm_angle(make_body(usual()).wide_path(0)), 55, 2);
  scenario::ScenarioBody chosen;
  chosen.dress_posture = {radians(30), 0, 0};
  EXPECT_FALSE(make_body(chosen).wide_path);
}

TEST(MakeBody, ArmsAreAsWideApartAsSleevesAreDrawn) {
  CaseBody body = make_body(usual());
  for (const auto& [asked, made] : {std::pair{90., 90.}, {70., 70.}, {20., 55.}, {130., 90.}}) {
    widen(body, radians(asked));
    EXPECT_NEAR(arm_angle(body.wide_path(0)), made, 3) << asked;
    EXPECT_NEAR(arm_angle(clone_wearer(body).wide_path(0)), made, 3) << asked;
  }
}

/// A wearer whose usual dressing posture leaves a shirt no room: arms hanging straight down.
CaseBody pinched() {
  CaseBody body = make_body(usual());
  body.path = [body = body.body](double) {
    body::Body tight = body;
    for (const char* side : {"_L", "_R"})
      tight.joints[std::string("elbow") + side] =
          tight.joints[std::string("shoulder") + side] - Vec3(0, 0, 0.28);
    return tight;
  };
  return body;
}

class PutOn : public ::testing::Test {
 protected:
  scenario::Scenario scenario_ =
      io::parse_scenario("[simulation]\nedge_length = 0.05\ntime_budget = 0.1\n", "");
  CaseBody body_ = pinched();
  garment::GarmentHierarchy garment_ = garment::build_hierarchy(
      make_pattern(scenario_.studied().spec, body_.body).pattern, scenario_.simulation.edge_length,
      scenario_.studied().material.material, {});
  drape::DrapeOptions options_ = drape_options(scenario_.simulation);
  Progress silent_;
  drape::DrapeSession session_{garment_, scenario_.studied().material.material, options_, silent_};
};

TEST_F(PutOn, SpreadsTheArmsWhereTheUsualPostureLeavesNoRoom) {
  EXPECT_FALSE(put_on(session_, body_, {}, &scenario_).positions.empty());
  ASSERT_EQ(body_.dressing_warnings.size(), 1u);
  EXPECT_NE(body_.dressing_warnings.back().find("arms wide apart"), std::string::npos);
  EXPECT_NEAR(arm_angle(body_.path(0)), 55, 2) << "the next donning goes there at once";
}

TEST_F(PutOn, DoesNotAdviseWiderArmsWhereTheyDidNotHelp) {
  body_.wide_path = body_.path;
  try {
    put_on(session_, body_, {}, &scenario_);
    FAIL();
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("even with the arms wide apart"), std::string::npos);
    EXPECT_NE(error.hint().find("a smaller garment.fit"), std::string::npos) << error.hint();
    EXPECT_EQ(error.hint().find("abduction"), std::string::npos) << error.hint();
  }
}

// A pattern file has no fit, and a file without sizes no size.
TEST_F(PutOn, AdvisesOnlyKeysThatTheGarmentHas) {
  body_.wide_path = body_.path;
  const auto hint = [&] {
    try {
      put_on(session_, body_, {}, &scenario_);
    } catch (const GeometryError& error) {
      return error.hint();
    }
    return std::string("no error");
  };
  scenario_.studied().spec.file = "/tmp/tee.json";
  EXPECT_EQ(hint().find("garment.fit"), std::string::npos) << hint();
  EXPECT_EQ(hint().find("garment.size"), std::string::npos) << hint();
  EXPECT_NE(hint().find("a pattern of less width"), std::string::npos) << hint();
  scenario_.studied().spec.size = "XL";
  EXPECT_NE(hint().find("another garment.size of its file"), std::string::npos) << hint();
  scenario_.studied().spec.file.clear();
  scenario_.studied().spec.size = "women-38";
  EXPECT_NE(hint().find("a smaller garment.size"), std::string::npos) << hint();
}

TEST_F(PutOn, DoesNotAdviseAPostureThatItHasAlready) {
  body_.wide_path = {};
  body_.from = body::kArmsWide;
  try {
    put_on(session_, body_, {}, &scenario_);
    FAIL();
  } catch (const GeometryError& error) {
    EXPECT_EQ(error.hint().find("posture"), std::string::npos) << error.hint();
    EXPECT_NE(error.hint().find("garment.fit"), std::string::npos) << error.hint();
  }
}

TEST_F(PutOn, TriesNoOtherPostureForABodyThatLacksWhatAShirtHangsOn) {
  body_.path = [body = body_.body](double) {
    body::Body bare = body;
    bare.landmarks.clear();
    return bare;
  };
  EXPECT_THROW(put_on(session_, body_, {}, &scenario_), GeometryError);
  EXPECT_TRUE(body_.warnings.empty());
}

TEST_F(PutOn, KeepsToThePostureThatWasAskedForAndSaysWhichOneMayDo) {
  body_.wide_path = {};
  const auto hint = [&] {
    try {
      put_on(session_, body_, {}, &scenario_);
    } catch (const GeometryError& error) {
      return error.hint();
    }
    return std::string("no error");
  };
  EXPECT_NE(hint().find("body.dress_posture"), std::string::npos);
  body_.person = nullptr;  // as a scan, which has the posture that it has
  EXPECT_NE(hint().find("scan"), std::string::npos);
}

}  // namespace
}  // namespace loosefit::pipeline
