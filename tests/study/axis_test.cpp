#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/study/plan.h"

// Designs that say something else than their author means.
namespace loosefit::study {
namespace {

const std::string kHead = "[study]\nname = \"x\"\nmodalities = [\"imu-inclination\"]\n";
const std::string kPeople =
    "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = 2 }\n";

std::string axis(const std::string& name, const std::string& rest) {
  return "[[axis]]\nname = \"" + name + "\"\n" + rest + "\n";
}

std::string set_of(const std::string& one, const std::string& other) {
  return "levels = [{ set = { " + one + " } }, { set = { " + other + " } }]";
}

Plan plan_of(const std::string& text) { return make_plan(parse_study_file(text, "study.toml")); }

/// With its hint.
std::string complaint(const std::string& text) {
  try {
    plan_of(text);
  } catch (const InvalidInput& error) {
    return std::string(error.what()) + "; " + error.hint();
  }
  return "accepted";
}

void expect_refused(const std::string& text, const std::string& phrase) {
  EXPECT_NE(complaint(text).find(phrase), std::string::npos) << complaint(text) << "\n" << text;
}

TEST(StudyAxes, ThatSetOneKeyAreRefused) {
  const std::string height = axis("tall", "key = \"body.height\"\nvalues = [1.55, 1.7]");
  const std::string said = "each key in one axis";
  expect_refused(kHead + kPeople + height,
                 "study.toml:7: axis[1]: found body.height in the axes \"person\" and \"tall\", "
                 "expected each key in one axis");
  expect_refused(kHead + height + kPeople, "found body.height in the axes \"tall\" and \"person\"");
  expect_refused(kHead + kPeople + axis("s", set_of("body = { sex = 0 }", "body = { sex = 1 }")),
                 "found body.sex");
  // Of any level, not of the first alone.
  expect_refused(
      kHead + kPeople + axis("s", set_of("body = { muscle = 0.6 }", "body = { age = 40 }")),
      "found body.age");
  const std::string fit = axis("fit", "key = \"garment.fit.chest\"\nvalues = [0.1, 0.2]");
  expect_refused(kHead + kPeople + fit + axis("ease", "ease = { chosen = \"blouse\", count = 2 }"),
                 "found garment.fit.chest in the axes \"fit\" and \"ease\"");
  // Paired levels and drawn ones as well.
  expect_refused("[study]\ndesign = \"paired\"\n" + fit +
                     axis("loose", "key = \"garment.fit.chest\"\nrange = [0.1, 0.2]\ncount = 2"),
                 said);
  // A whole value of which the other sets a part.
  const std::string posture =
      axis("p", set_of("body = { posture = \"standing\" }", "body = { posture = \"sitting\" }"));
  const std::string bend = axis("b", "key = \"body.posture.forward_bend_deg\"\nvalues = [5, 20]");
  expect_refused(kHead + posture + bend, "found body.posture in the axes");
  expect_refused(kHead + bend + posture, said);
  const auto site = [](const char* landmark) {
    return std::string("site = [{ name = \"s\", landmark = \"") + landmark + "\" }]";
  };
  const std::string sites = set_of(site("c7"), site("sternum"));
  expect_refused(kHead + axis("one", sites) + axis("other", sites), "found site in the axes");
}

TEST(StudyAxes, OfDrawnFabricsAndOfCardsAreRefusedTogether) {
  const std::string cards = axis("card", "fabrics = [\"denim\", \"cotton-jersey\"]");
  const std::string drawn = axis("cloth", "fabrics = { population = \"618-measured\", count = 2 }");
  const std::string phrase = "material.name in the axes \"";
  expect_refused(kHead + cards + drawn,
                 phrase + "card\" and \"cloth\", expected each key in one axis");
  expect_refused(kHead + drawn + cards, phrase + "cloth\" and \"card\"");
  expect_refused(
      kHead + drawn + axis("mass", "key = \"material.areal_density\"\nvalues = [0.1, 0.2]"),
      "material.areal_density in the axes");
  // Another constant of whatever cloth is another axis.
  const std::string rub = axis("rub", "key = \"material.friction_body\"\nvalues = [0.2, 0.4]");
  EXPECT_EQ(plan_of(kHead + cards + rub).cases.size(), 4u);
  EXPECT_EQ(plan_of(kHead + drawn + rub).cases.size(), 4u);
}

TEST(StudyAxes, OfOtherKeysOfOneTableAreTakenTogether) {
  const std::string several = axis(
      "fit", set_of("garment = { fit = { chest = 0.1, hip = 0.1 } }, body = { muscle = 0.4 }",
                    "garment = { fit = { chest = 0.2, hip = 0.2 } }, body = { muscle = 0.6 }"));
  const std::string sleeve = axis("sleeve", "key = \"garment.fit.sleeve\"\nvalues = [0.1, 0.3]");
  const std::string nothing = axis("cup", set_of("", "body = { cup = 0.3 }"));
  EXPECT_EQ(plan_of(kHead + kPeople + several + sleeve + nothing).cases.size(), 16u);
  const std::string donned =
      axis("put on", "donnings = 2") + axis("times", "key = \"donning.repeats\"\nvalues = [1, 2]");
  EXPECT_EQ(plan_of(kHead + donned).cases.size(), 4u);
}

// A decimal comma makes two values of one.
TEST(StudyAxes, OfOneLevelTwiceAreRefused) {
  const auto values = [](const std::string& list) {
    return kHead + axis("fit", "key = \"garment.fit.chest\"\nvalues = [" + list + "]");
  };
  expect_refused(values("0,1, 0,2"),
                 "study.toml:7: axis[0].values: found the level 0 twice, expected each level once; "
                 "decimals have a point: 0.1, not 0,1");
  expect_refused(values("0.1, 0.2, 0.1"), "found the level 0.1 twice, expected each level once; ");
  expect_refused(values("1, 1.0"), "found the level 1 twice");
  expect_refused(values("0.1, 0.2, 0.10\n]\nlabels = [\"a\", \"b\", \"c\""), "the level 0.1 twice");
  expect_refused(
      kHead + axis("size", "key = \"garment.size\"\nvalues = [\"women-36\", \"women-36\"]"),
      "the level women-36 twice");
  expect_refused(kHead + axis("p", "postures = [[\"standing\"], [\"standing\"]]"),
                 "the level standing twice");
  // Whatever the order of their keys.
  expect_refused(kHead + axis("a", set_of("body = { muscle = 0.4, cup = 0.4 }",
                                          "body = { cup = 0.4, muscle = 0.4 }")),
                 "axis[0].levels: found the level level 2 twice");
  EXPECT_EQ(plan_of(values("0.1, 0.2, 0.3")).cases.size(), 3u);
}

TEST(StudyAxes, OfARangeThatIsNoneAreRefused) {
  const auto range = [](const std::string& ends) {
    return kHead + axis("fit", "key = \"garment.fit.chest\"\nrange = [" + ends + "]");
  };
  expect_refused(range("0.5, 0.1"), "axis[0].range: found 0.5, 0.1, expected low < high: the ends");
  expect_refused(range("0.1, 0.1"), "found 0.1, 0.1, expected low < high");
  expect_refused(range("0.1"), "found an array of 1, expected [low, high]");
  expect_refused(range("0,1, 0,5"), "decimals have a point");
}

TEST(StudyAxes, OfEaseInCentimetresNeedAChest) {
  const std::string ease = axis("ease", "ease = { chosen = \"blouse\", count = 2 }");
  expect_refused(kHead + ease, "body.measurements.chest: found nothing in case 1 (");
  const std::string scan = complaint(kHead + "[scenario.body]\nfile = \"me.obj\"\n" + ease);
  EXPECT_NE(scan.find("a scan has no measured chest"), std::string::npos) << scan;
  EXPECT_NE(scan.find("use garment.fit"), std::string::npos) << scan;
}

TEST(StudyAxes, InATomlFileThatIsNotUtf8AreRefused) {
  expect_refused("[study]\nname = \"\xE9tude\"\n", "study.toml:2: ");
  // Names of files are bytes; those that come into documents must be text.
  const auto of_file = [](const std::string& text, const std::string& path) -> std::string {
    try {
      return parse_study_file(text, path).name;
    } catch (const InvalidInput& error) {
      return error.what();
    }
  };
  const std::string latin1 = "/tmp/\xE9tude.toml", ecg = "modalities = [\"ecg\"]\n";
  EXPECT_NE(of_file("[study]\n" + ecg, latin1).find("study.name: found nothing, and a file whose"),
            std::string::npos);
  EXPECT_EQ(of_file("[study]\nname = \"x\"\n" + ecg, latin1), "x");
  EXPECT_NE(of_file("[study]\nmodalities = [\"my.toml\"]\n", "/tmp/\xE9/x.toml")
                .find("study.modalities: found \"my.toml\" in a folder that is not UTF-8"),
            std::string::npos);
}

}  // namespace
}  // namespace loosefit::study
