#include "loosefit/io/scenario.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario_place.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/maps/catalogue.h"
#include "support/refused_scenario.h"

namespace loosefit::io {
namespace {

scenario::Scenario parsed(const std::string& text) { return parse_scenario(text, "case.toml"); }

using support::refusal;

const char* const kFull = R"(
[body]
sex = "male"
age = 41
height = 1.80
measurements = { chest = 1.00, waist = 0.86, hip = 1.02 }
posture = { arm_abduction_deg = 20, forward_bend_deg = 12.5 }
dress_posture = "a-pose"
[garment]
pattern = "long-sleeve-shirt"
fit = { chest = 0.15, waist = 0.12, hip = 0.08, sleeve = 0.15, wrist = 0.2 }
[material]
name = "cotton-jersey"
bending_warp = 9e-6
[[attachment]]
kind = "board"
name = "logger"
panel = "back"
at = [0.0, -0.12]
size = [0.04, 0.03]
angle_deg = 30
mass = 0.012
bending = 0.05
[[attachment]]
kind = "cable"
name = "lead"
panel = "back"
path = [[0.0, -0.15], [0.02, -0.40]]
linear_density = 0.004
bending = 1e-6
[[site]]
name = "spine"
panel = "back"
at = [0.0, -0.25]
[[site]]
name = "neck"
landmark = "c7"
[[site]]
name = "watch"
segment = "forearm"
side = "left"
ratios = [0, 50, 30]
angle_deg = -15
footprint = { size = [0.03, 0.045] }
board = { mass = 0.02, bending = 0.01 }
[[site]]
name = "breath"
landmark = "chest_band"
[[site]]
name = "stretch"
panel = "back"
at = [0.1, -0.3]
shift = [0.005, -0.01]
angle_deg = 90
footprint = { length = 0.08 }
[simulation]
edge_length = 0.012
integrator = "implicit-euler"
seed = 7
repeats = 3
[output]
maps = ["distance"]
views = ["front", "left"]
[ranking]
modality = "ecg"
best = 3
partial = true
)";

/// Text of one line of kFull.
std::string line_of_full(int line) {
  std::istringstream in(kFull);
  std::string text;
  for (int i = 0; i < line; ++i) std::getline(in, text);
  return text;
}

TEST(Scenario, MapsMadeByDefaultAreThoseOfTheCatalogue) {
  EXPECT_EQ(default_scenario().output.maps, maps::default_map_names());
}

// Of files that earlier versions read, or wrote as scenario.toml of a run.
TEST(Scenario, ACertificateOfAnEarlierFileIsReadWithoutEffect) {
  const std::string usual = scenario_toml(default_scenario());
  EXPECT_EQ(usual.find("certificate"), std::string::npos);
  const scenario::Scenario a = parse_scenario("[simulation]\ncertificate = \"A\"\n", "a.toml"),
                           b = parse_scenario("[simulation]\ncertificate = \"B\"\n", "b.toml");
  EXPECT_EQ(scenario_toml(a), usual);
  EXPECT_EQ(scenario_toml(b), usual);
  EXPECT_TRUE(a.simulation.notes.empty()) << "it has what it asks for";
  ASSERT_EQ(b.simulation.notes.size(), 1u);
  EXPECT_NE(b.simulation.notes[0].find("no effect"), std::string::npos);
  EXPECT_NE(refusal("[simulation]\ncertificate = \"C\"\n").find("expected one of A, B"),
            std::string::npos);
}

TEST(Scenario, EmptyFileGivesTheDocumentedDefaults) {
  const scenario::Scenario s = default_scenario();
  EXPECT_EQ(s.body.height, 1.68);
  EXPECT_EQ(s.body.posture, body::kStanding);
  EXPECT_EQ(s.body.dress_posture, body::kArmsApart);
  EXPECT_EQ(s.studied().spec.fit.at("chest"), 0.10);
  EXPECT_EQ(s.studied().spec.fit.count("waist"), 0u);
  EXPECT_EQ(s.studied().material.material.name, "paper-cotton");
  EXPECT_EQ(s.studied().material.material.bending_warp, 4.41e-6);
  EXPECT_EQ(s.simulation.edge_length, 0.014);
  EXPECT_EQ(s.output.maps.size(), 5u);
}

TEST(Scenario, ReadsEveryKey) {
  const scenario::Scenario s = parsed(kFull);
  EXPECT_EQ(s.body.sex, 1);
  EXPECT_EQ(s.body.measurements.at("chest"), 1.0);
  EXPECT_DOUBLE_EQ(degrees(s.body.posture.forward_bend), 12.5);
  EXPECT_EQ(s.studied().spec.fit.at("waist"), 0.12);
  EXPECT_EQ(s.studied().material.material.areal_density, 0.187) << "from the card";
  EXPECT_EQ(s.studied().material.material.bending_warp, 9e-6) << "overridden";
  ASSERT_EQ(s.attachments.size(), 2u);
  EXPECT_EQ(std::get<garment::Board>(s.attachments[0].part).size, Vec2(0.04, 0.03));
  EXPECT_DOUBLE_EQ(std::get<garment::Board>(s.attachments[0].part).angle, radians(30));
  EXPECT_EQ(std::get<garment::Cable>(s.attachments[1].part).path.size(), 2u);
  EXPECT_EQ(std::get<garment::Cable>(s.attachments[1].part).linear_density, 0.004);
  EXPECT_EQ(s.sites[1].landmark, "c7");
  EXPECT_EQ(s.sites[1].footprint.radius, placement::kFootprintRadius);
  EXPECT_EQ(placement::name(s.sites[2].anatomy->segment), "forearm");
  EXPECT_EQ(s.sites[2].anatomy->side, 1);
  EXPECT_EQ(s.sites[2].anatomy->percent, Vec3(0, 50, 30));
  EXPECT_DOUBLE_EQ(s.sites[2].angle, radians(-15));
  EXPECT_EQ(s.sites[2].footprint.size, Vec2(0.03, 0.045));
  EXPECT_EQ(s.sites[2].board->mass, 0.02);
  EXPECT_EQ(s.sites[2].board->bending, 0.01);
  EXPECT_FALSE(s.sites[2].board->membrane_factor);
  EXPECT_FALSE(s.sites[2].board->is_rigid());
  EXPECT_EQ(s.sites[3].footprint.kind, placement::FootprintShape::Kind::girth)
      << "that of the preset";
  EXPECT_EQ(s.sites[4].footprint.kind, placement::FootprintShape::Kind::line);
  EXPECT_EQ(s.sites[4].footprint.length, 0.08);
  EXPECT_EQ(s.simulation.seed, 7u);
  EXPECT_EQ(s.simulation.start_perturbation, 0.001) << "several repeats need different starts";
  EXPECT_EQ(s.output.views, (std::vector<std::string>{"front", "left"}));
  EXPECT_EQ(s.ranking.modality, "ecg");
  EXPECT_EQ(s.ranking.best, 3);
  EXPECT_TRUE(s.ranking.partial);
  EXPECT_TRUE(default_scenario().ranking.modality.empty());
}

TEST(Scenario, ResolvedTextReadsBackToTheSame) {
  for (const char* text :
       {"", kFull, "[body]\nsex = 0.4\nage = 10\nheight = 1.4\n", "[body]\nposture = \"sitting\"\n",
        "[material]\nname = \"wool-measured\"\nstiffness_weft = 500\n",
        "[material.curve.warp]\nelongation = [0.1, 0.2]\nforce = [9, 40]\n",
        "[material.kes]\nB = 0.067\n2HB = 0.033\n"}) {
    const std::string resolved = scenario_toml(parsed(text));
    EXPECT_EQ(scenario_toml(parsed(resolved)), resolved);
  }
}

TEST(Scenario, ResolvedTextWritesOutDefaults) {
  const std::string resolved = scenario_toml(default_scenario());
  for (const char* key : {"sex", "arm_abduction_deg = 8", "neck_ease", "stiffness_shear", "seed",
                          "time_budget", "undecorated", "name = \"paper-cotton\""})
    EXPECT_NE(resolved.find(key), std::string::npos) << key;
}

TEST(ScenarioErrors, UnknownKeysAreRefusedWithAGuess) {
  EXPECT_EQ(refusal("[body]\nheigth = 1.7\n"),
            "case.toml:2: body.heigth: found an unknown key, expected a key of body | "
            "did you mean \"height\"?");
  EXPECT_EQ(refusal("[bodi]\n"),
            "case.toml:1: bodi: found an unknown key, expected a known section | "
            "did you mean \"body\"?");
  EXPECT_NE(refusal("[garment]\nfit = { cheest = 0.1 }\n").find("\"chest\""), std::string::npos);
}

TEST(ScenarioErrors, InchesOfATapeAreHintedAtForEveryMeasure) {
  for (const auto& [key, inches] : {std::pair{"chest", 36},
                                    {"waist", 30},
                                    {"hip", 38},
                                    {"neck", 15},
                                    {"thigh", 13},
                                    {"wrist", 7},
                                    {"calf", 14},
                                    {"arm_length", 24}}) {
    const std::string text = refusal("[body]\nmeasurements = { " + std::string(key) + " = " +
                                     std::to_string(inches) + " }\n");
    EXPECT_NE(text.find(fmt::format("{} inches is {:.4g}", inches, 0.0254 * inches)),
              std::string::npos)
        << text;
  }
}

TEST(ScenarioErrors, UnitsRangesAndTypesAreNamed) {
  EXPECT_EQ(refusal("[body]\nheight = 168\n"),
            "case.toml:2: body.height: found 168, expected metres from 0.7 to 2.3 | "
            "lengths are in metres: 168 cm is 1.68");
  EXPECT_NE(refusal("[body]\nheight = nan\n").find("found nan"), std::string::npos);
  EXPECT_NE(refusal("[body]\nheight = inf\n").find("found inf"), std::string::npos);
  EXPECT_NE(refusal("[body]\nheight = \"tall\"\n").find("found \"tall\", expected metres"),
            std::string::npos);
  EXPECT_NE(refusal("[simulation]\nedge_length = 1e-9\n").find("expected metres from 0.003"),
            std::string::npos);
  EXPECT_NE(refusal("[simulation]\nseed = 1.5\n").find("expected a whole number"),
            std::string::npos);
  EXPECT_NE(refusal("body = 3\n").find("case.toml:1: body: found 3, expected a table"),
            std::string::npos);
  EXPECT_NE(refusal("[output]\nviews = [\"top\"]\n").find("found \"top\""), std::string::npos);
  EXPECT_NE(refusal("[output]\nmaps = [\"strain\", \"strain\"]\n").find("twice"),
            std::string::npos);
}

TEST(ScenarioErrors, ChoicesThatExcludeEachOther) {
  EXPECT_NE(
      refusal("[garment]\nsize = \"child-142\"\nfit = { chest = 0 }\n").find("either fit.chest or"),
      std::string::npos);
  EXPECT_NE(refusal("[body]\nunits = \"cm\"\n").find("only beside file"), std::string::npos);
  EXPECT_NE(refusal("[body]\nfile = \"nowhere.obj\"\n").find("expected a file that exists"),
            std::string::npos);
  EXPECT_NE(refusal("[[site]]\nname = \"a\"\n").find("one of landmark"), std::string::npos);
  EXPECT_NE(refusal("[site]\nname = \"a\"\n").find("double brackets"), std::string::npos);
  EXPECT_NE(refusal("[[site]]\nname = \"a\"\nlandmark = \"c7\"\n[[site]]\nname = \"a\"\n"
                    "landmark = \"c7\"\n")
                .find("each name once"),
            std::string::npos);
}

TEST(ScenarioErrors, RankingNeedsAScorecard) {
  EXPECT_NE(refusal("[ranking]\nmodality = \"ecgg\"\n").find("did you mean \"ecg\"?"),
            std::string::npos);
  EXPECT_NE(refusal("[ranking]\nmodality = \"mine.toml\"\n").find("ranking.modality"),
            std::string::npos);
  EXPECT_NE(refusal("[ranking]\nbest = 2\n").find("ranking.best: found 2, expected best only"),
            std::string::npos)
      << refusal("[ranking]\nbest = 2\n");
  EXPECT_NE(refusal("[ranking]\nmodality = \"ecg\"\nbest = -1\n").find("ranking.best"),
            std::string::npos);
  EXPECT_NE(refusal("[ranking]\nmodalty = \"ecg\"\n").find("did you mean \"modality\"?"),
            std::string::npos);
}

TEST(ScenarioErrors, SitesThatCannotBe) {
  const auto site = [](const std::string& rest) {
    return refusal("[[site]]\nname = \"s\"\n" + rest);
  };
  const std::string arm = "segment = \"upper_arm\"\n", here = "landmark = \"c7\"\n";
  EXPECT_NE(site(here + arm).find("site[0].segment: found \"upper_arm\", expected one of landmark"),
            std::string::npos)
      << site(here + arm);
  EXPECT_NE(site("segment = \"upperarm\"\n").find("did you mean \"upper_arm\"?"),
            std::string::npos);
  EXPECT_NE(site(arm + "ratios = [0, 50, 50]\n").find("site[0].side: found nothing"),
            std::string::npos);
  EXPECT_NE(site(arm + "side = \"left\"\n").find("site[0].ratios: found nothing"),
            std::string::npos);
  EXPECT_NE(site(arm + "side = \"left\"\nratios = [0, 50]\n").find("expected three ratios"),
            std::string::npos);
  EXPECT_NE(site(arm + "side = \"left\"\nratios = [0, 50, 1e4]\n").find("percent from -200"),
            std::string::npos);
  EXPECT_NE(site("segment = \"chest\"\nside = \"left\"\nratios = [0, 50, 50]\n")
                .find("case.toml:4: site[0].side: found \"left\", expected no side"),
            std::string::npos);
  EXPECT_NE(site(here + "footprint = { radius = 12 }\n").find("lengths are in metres: 12 mm"),
            std::string::npos)
      << site(here + "footprint = { radius = 12 }\n");
  EXPECT_NE(site(here + "footprint = { radius = 0.01, length = 0.1 }\n")
                .find("site[0].footprint: found length, radius, expected one of radius"),
            std::string::npos)
      << site(here + "footprint = { radius = 0.01, length = 0.1 }\n");
  EXPECT_NE(site(here + "footprint = {}\n").find("found nothing"), std::string::npos);
  EXPECT_NE(site(here + "footprint = { girth = false }\n").find("expected true"),
            std::string::npos);
  EXPECT_NE(site(here + "footprint = { raduis = 0.01 }\n")
                .find("site[0].footprint.raduis: found an unknown key"),
            std::string::npos);
  EXPECT_NE(site(here + "footprint = { length = 0.1 }\nboard = { mass = 0.01 }\n")
                .find("site[0].board: found a table, expected no board under a line"),
            std::string::npos);
  EXPECT_NE(site(here + "board = { mass = 12 }\n").find("kilograms from 0 to 2"),
            std::string::npos);
  for (const auto& [wrong, found] :
       std::map<std::string, std::string>{{"0.02", "0.02"},
                                          {"\"left\"", "\"left\""},
                                          {"[0.02]", "an array of 1"},
                                          {"[0.02, \"up\"]", "an array of 2"},
                                          {"[nan, 0]", "nan, expected metres from -0.2 to 0.2"},
                                          {"[0, 20]", "20, expected metres from -0.2 to 0.2"}}) {
    const std::string told = site(here + "shift = " + wrong + "\n");
    EXPECT_NE(told.find("case.toml:4: site[0].shift: found " + found), std::string::npos) << told;
  }
  EXPECT_NE(site("from = \"c7\"\nto = \"sternum\"\nshift = [0, 0]\n")
                .find("site[0].shift: found an unknown key"),
            std::string::npos);
  EXPECT_NE(refusal("[[attachment]]\nkind = \"board\"\nname = \"s\"\npanel = \"back\"\n"
                    "at = [0, 0]\nradius = 0.01\n[[site]]\nname = \"s\"\nlandmark = \"c7\"\n"
                    "board = {}\n")
                .find("expected another name"),
            std::string::npos);
}

TEST(ScenarioErrors, LaterStagesAreToldByTheKeysOfTheFile) {
  const scenario::Scenario s = parsed(kFull);
  const auto told = [&](const std::string& key) {
    const InputPlace place = in_scenario(InvalidInput({"", 0, key}, "x", "y"), s).place();
    return place.key + ":" + (place.line > 0 ? line_of_full(place.line) : "");
  };
  EXPECT_EQ(told("attachment logger.position"), "attachment[0].at:at = [0.0, -0.12]");
  EXPECT_EQ(told("attachment logger.height"), "attachment[0].size:size = [0.04, 0.03]");
  EXPECT_EQ(told("attachment lead.path[1]"),
            "attachment[1].path[1]:path = [[0.0, -0.15], [0.02, -0.40]]");
  EXPECT_EQ(told("attachment lead.width"), "attachment[1].width:[[attachment]]");
  EXPECT_EQ(told("attachment watch.mass"),
            "site[2].board.mass:board = { mass = 0.02, bending = 0.01 }");
  EXPECT_EQ(told("attachment watch.width"),
            "site[2].footprint:footprint = { size = [0.03, 0.045] }");
  EXPECT_EQ(told("site[2].ratios"), "site[2].ratios:ratios = [0, 50, 30]");
}

TEST(ScenarioErrors, MaterialUnitsGetAHint) {
  const std::string answer = refusal("[material]\nbending_warp = 4.41\n");
  EXPECT_NE(answer.find("found 4.41, expected N m"), std::string::npos) << answer;
  EXPECT_NE(answer.find("4.41 µN m is 4.41e-06"), std::string::npos) << answer;
  EXPECT_NE(refusal("[material]\nname = \"cotton-jersy\"\n").find("did you mean \"cotton-jersey\""),
            std::string::npos);
}

TEST(ScenarioErrors, TextThatIsNotToml) {
  EXPECT_NE(refusal("[body\nsex = 1\n").find("case.toml:1: found"), std::string::npos);
  EXPECT_NE(refusal("[body]\nsex = 1\nsex = 0\n").find("case.toml:3"), std::string::npos);
  EXPECT_NE(refusal(std::string("\x00\xff\xfe", 3)).find("found binary data"), std::string::npos);
  EXPECT_NE(refusal("\x1b[31m = 1\n").find("expected valid TOML"), std::string::npos);
  EXPECT_NE(refusal(std::string(3000, 'a') + " = 1\n").find("2000 bytes"), std::string::npos);
  std::string deep = "a = ";
  for (int i = 0; i < 900; ++i) deep += "[";
  EXPECT_NE(refusal(deep + "\n"), "accepted");
  std::string dotted = "a";
  for (int i = 0; i < 900; ++i) dotted += ".a";
  EXPECT_NE(refusal(dotted + " = 1\n").find("32 deep"), std::string::npos);
  EXPECT_THROW(read_scenario("/nowhere/case.toml"), IoError);
  EXPECT_THROW(read_scenario("/tmp"), IoError);
}

TEST(ScenarioErrors, OtherDialectsAreNamed) {
  using support::expect_refused;
  expect_refused("[body]\nheight = 1,68\n", {"case.toml:2", "1,68 is 1.68"});
  expect_refused("[body]\nheight = -1,5 # x\n", {"case.toml:2", "-1,5 is -1.5"});
  expect_refused("[body]\nmeasurements = { chest = 1,00, waist = 0,86 }\n",
                 {"case.toml:2", "1,00 is 1.00"});
  expect_refused("[body]\nheight = \"1,68\"\n",
                 {"case.toml:2: body.height: found \"1,68\"", "without quotes", "1.68"});
  expect_refused("[body]\nheight: 1.68\n", {"case.toml:2", "joined by ="});
  expect_refused("[garment]\npattern = \xe2\x80\x9ct-shirt\xe2\x80\x9d\n",
                 {"case.toml:2", "plain \"quotes\""});
  expect_refused("[body]\nheight = 1.68;\n", {"case.toml:2", "semicolon"});
  expect_refused("{\"body\": {\"height\": 1.68}}", {"looks like JSON"});
  expect_refused("body:\n  height: 1.68\n", {"found a YAML file, expected a TOML file"});
  expect_refused("<html>", {"found a web page, expected a TOML file"});
  expect_refused("version https://git-lfs.github.com/spec/v1\n", {"git lfs pull"});
}

TEST(ScenarioErrors, OneScenarioIsTheSameFromEveryEditor) {
  const std::string text = "[body]\nheight = 1.68\nmeasurements = { chest = 0.9 }\n";
  std::string old_mac = text, little = "\xff\xfe", big = "\xfe\xff", windows;
  std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
  for (const char c : text) {
    little += {c, '\0'};
    big += {'\0', c};
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  for (const std::string& written :
       {text, old_mac, little, big, windows, "\xef\xbb\xbf" + text, little.substr(2)}) {
    const scenario::Scenario s = parse_scenario(written, "case.toml");
    EXPECT_EQ(s.body.height, 1.68);
    EXPECT_EQ(s.body.measurements.at("chest"), 0.9);
  }
}

TEST(ScenarioErrors, SlipsAreNamedBeforeWhatIsThenMissing) {
  const auto expect_slip = [](const std::string& text, const std::string& key,
                              const std::string& hint) {
    const std::string told = refusal(text);
    EXPECT_NE(told.find(key + ": found an unknown key"), std::string::npos) << told;
    EXPECT_NE(told.find(hint), std::string::npos) << told;
  };
  expect_slip("[[site]]\nnmae = \"s\"\nlandmark = \"c7\"\n", "site[0].nmae", "\"name\"");
  expect_slip("[[site]]\nname = \"s\"\nlandmrk = \"c7\"\n", "site[0].landmrk", "\"landmark\"");
  expect_slip("[[site]]\nname = \"s\"\nlandmark = \"c7\"\nfootprint = { raduis = 0.01 }\n",
              "site[0].footprint.raduis", "\"radius\"");
  expect_slip("[[attachment]]\nkind = \"board\"\nname = \"x\"\npanle = \"back\"\n",
              "attachment[0].panle", "\"panel\"");
  expect_slip("[[attachment]]\nkind = \"cable\"\nname = \"x\"\npanel = \"back\"\nradius = 1\n",
              "attachment[0].radius", "known: ");
  expect_slip("[postures]\nlits = [\"standing\"]\nreference = \"standing\"\n", "postures.lits",
              "\"list\"");
}

}  // namespace
}  // namespace loosefit::io
