#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/io/text_file.h"
#include "support/program_output.h"
#include "support/scratch_folder.h"

// `--json`: one document on standard output whatever happens, and exit codes that stay.
namespace loosefit {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

// A drape that is stopped long before it settles: quick.
const char* const kStopped =
    "[donning]\nmovements = []\n[simulation]\nedge_length = 0.05\nmax_iterations = 2\n"
    "[output]\nmaps = [\"shear\"]\nviews = [\"front\"]\npreset_sites = false\n"
    "[[site]]\nname = \"spine\"\nlandmark = \"mid_back\"\n";

struct JsonOutput : ::testing::Test {
  const support::ScratchFolder base;
  std::string file(const std::string& name, const std::string& text) const {
    io::write_text_file((base / name).string(), text);
    return (base / name).string();
  }
  ProgramOutput loosefit(const std::string& arguments, const std::string& environment = {}) const {
    return run_apart(base, arguments, environment);
  }
  /// The document of a command that ends with this code.
  Json document(const std::string& arguments, int code = 0, const std::string& environment = {}) {
    const ProgramOutput run = loosefit(arguments, environment);
    EXPECT_EQ(run.exit_code, code) << arguments << "\n" << run.err;
    const Json json = run.document();
    EXPECT_TRUE(json.is_object()) << arguments << "\n" << run.out;
    return json.is_object() ? json : Json::object();
  }
};

TEST_F(JsonOutput, FactsAreDocuments) {
  EXPECT_TRUE(document("version --json")["versions"].contains("loosefit"));
  const Json doctor = document("doctor --json");
  EXPECT_EQ(doctor["can_run"], true);
  EXPECT_EQ(doctor["checks"].size(), 4u);
  const Json materials = document("material list --json")["materials"];
  EXPECT_GT(materials.size(), 10u);
  const Json wool = document("material show wool-measured --json");
  EXPECT_NEAR(wool["bending_length_warp_m"].get<double>(), 0.0165, 5e-5);
  EXPECT_FALSE(wool["curves"]["warp"]["elongation"].empty());
  bool found = false;
  for (const Json& c : wool["constants"])
    if (c["key"] == "areal_density") found = c["unit"] == "kg/m²" && c["value"] > 0.01;
  EXPECT_TRUE(found) << wool["constants"];
  EXPECT_FALSE(document("validate --list --json")["benchmarks"].empty());
}

TEST_F(JsonOutput, BodyAndPatternTellWhatTheirTablesTell) {
  const std::string out = (base / "out").string();
  const Json body = document("body --height 1.7 --json -o " + out);
  EXPECT_EQ(body["asked"][0]["measure"], "height");
  EXPECT_NEAR(body["asked"][0]["measured_m"].get<double>(), 1.7, 0.005);
  EXPECT_GT(body["measured"]["volume_m3"].get<double>(), 0.03);
  for (const Json& name : body["files"]) EXPECT_TRUE(fs::exists(base / "out" / name)) << name;
  const Json pattern = document("pattern --size women-38 --json");
  EXPECT_EQ(pattern["files"].size(), 0u);
  double area = 0;
  for (const Json& piece : pattern["pieces"]) area += piece["area_m2"].get<double>();
  EXPECT_GT(area, 0.5);
  EXPECT_LT(area, 3);
  for (const Json& seam : pattern["seams"]) EXPECT_GT(seam["first"]["length_m"].get<double>(), 0);
  EXPECT_FALSE(document("pattern --list-sizes --json")["sizes"].empty());
}

TEST_F(JsonOutput, ErrorsAreDocumentsToo) {
  const std::string scenario = file("case.toml", "[body]\n\nheight = 168\n");
  const ProgramOutput run = loosefit("run " + scenario + " --json -o " + (base / "out").string());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("error: "), std::string::npos) << "for people as ever";
  const Json json = run.document();
  ASSERT_TRUE(json.is_object()) << run.out;
  EXPECT_EQ(json["exit_code"], 2);
  const Json& error = json["error"];
  EXPECT_EQ(error["place"]["file"], scenario);
  EXPECT_EQ(error["place"]["line"], 3);
  EXPECT_EQ(error["place"]["key"], "body.height");
  EXPECT_EQ(error["found"], "168");
  EXPECT_EQ(error["expected"], "metres from 0.7 to 2.3");
  EXPECT_NE(error["hint"].get<std::string>().find("1.68"), std::string::npos);
  const Json missing = document("drape nowhere.toml --json -o " + (base / "out").string(), 2);
  EXPECT_TRUE(missing["error"]["found"].is_null()) << missing;
  for (const char* usage : {"--json", "rnu --json", "run --json", "body --heigth 1 --json"})
    EXPECT_EQ(document(usage, 2)["exit_code"], 2) << usage;
}

// One run for all later commands. Without DISPLAY, with a dead one, and without Xvfb.
TEST_F(JsonOutput, RunsTellTheirVerdictAndDrawWithoutADisplay) {
  const std::string scenario = file("case.toml", kStopped), out = (base / "out").string();
  const std::string no_screen = "DISPLAY=:54321 PATH=/nowhere";
  Json run = document("run " + scenario + " --json --allow-unsettled -o " + out, 1, "-u DISPLAY");
  EXPECT_EQ(run["summary"], out + "/summary.json");
  EXPECT_EQ(run["holds"], false);
  EXPECT_EQ(run["settled"], false);
  EXPECT_TRUE(run["worn"].is_boolean());
  EXPECT_TRUE(run["can_be_put_on"].is_boolean());
  EXPECT_EQ(run["can_be_put_on"] == false, !run["can_be_put_on_reasons"].empty());
  EXPECT_GT(run["residual"].get<double>(), 0);
  for (const Json& name : run["files"]) EXPECT_TRUE(fs::exists(base / "out" / name)) << name;
  EXPECT_TRUE(fs::exists(base / "out/maps/shear-front.png"));
  EXPECT_EQ(run["warnings"].dump().find("pictures need a screen"), std::string::npos);

  for (const char* command : {"map", "render", "report"}) {
    run = document(std::string(command) + " " + out + " --json --allow-unsettled", 1, no_screen);
    const bool warned = run["warnings"].dump().find("pictures need a screen") != std::string::npos;
    EXPECT_EQ(warned, std::string(command) != "map") << command << run["warnings"];
  }
  for (const char* name : {"summary.json", "report.html"})
    EXPECT_NE(io::read_text_file(out + "/" + name, 50000000).find("no Xvfb on PATH"),
              std::string::npos)
        << name;
  const std::string figure = (base / "figure.svg").string();
  const std::string draw = "render " + out + " -o " + figure + " --map drape --view 30,10 --json";
  EXPECT_EQ(document(draw, 2, no_screen)["exit_code"], 2) << "a figure alone needs a screen";
  EXPECT_FALSE(fs::exists(figure));
  EXPECT_EQ(document(draw)["file"], figure);
  EXPECT_TRUE(fs::exists(figure));
  EXPECT_EQ(document(draw, 2)["error"]["found"], "a file that is there already");
  EXPECT_GT(document(draw + " --overwrite")["width_px"], 100);
  EXPECT_EQ(document("render " + out + " --json --view left", 2)["error"]["place"]["key"],
            "--view");
  EXPECT_EQ(document("render " + out + " " + out + " --json", 2)["exit_code"], 2);
  const Json rank = document("rank " + out + " -m temperature --json --allow-unsettled", 1);
  EXPECT_EQ(rank["ranking"]["sites"][0]["name"], "spine");
  for (const Json& name : rank["files"]) EXPECT_TRUE(fs::exists(base / "out" / name)) << name;
  EXPECT_EQ(document("map " + out + " --json", 2)["exit_code"], 2) << "sealed";
}

TEST_F(JsonOutput, TwoRunsAtOnceDrawOnScreensOfTheirOwn) {
  const std::string scenario = file("case.toml", kStopped), program = LOOSEFIT_BINARY;
  const auto run = [&](const char* out) {
    return "env -u DISPLAY " + program + " run " + scenario + " -q --allow-unsettled -o " +
           (base / out).string();
  };
  run_program("bash -c \"" + run("one") + " & " + run("two") + "; wait\"");
  for (const char* out : {"one", "two"})
    EXPECT_TRUE(fs::exists(base / out / "maps/drape-front.png")) << out;
}

TEST_F(JsonOutput, InterruptedCommandsSaySo) {
  const std::string scenario = file("case.toml", "[simulation]\nedge_length = 0.005\n");
  const ProgramRun run = run_program("bash -c \"timeout -s INT --preserve-status 3 " +
                                     std::string(LOOSEFIT_BINARY) + " drape " + scenario +
                                     " -q --json -o " + (base / "out").string() + " 2>/dev/null\"");
  EXPECT_EQ(run.exit_code, 130) << run.output;
  const Json json = Json::parse(run.output, nullptr, false);
  ASSERT_TRUE(json.is_object()) << run.output;
  EXPECT_EQ(json["exit_code"], 130);
}

TEST_F(JsonOutput, ValidationIsTheDocumentOfItsFile) {
  const Json json = document("validate --quick --only t1 --json");
  EXPECT_EQ(json["pass"], true);
  EXPECT_EQ(json["benchmarks"][0]["id"], "T1");
}

TEST_F(JsonOutput, ScenariosAreCheckedWithoutRunning) {
  const std::string good = file("good.toml", ""), bad = file("bad.toml", "[body]\nage = 300\n");
  const Json json = document("schema --json --check " + good + " " + bad, 2);
  EXPECT_EQ(json["scenarios"][0]["accepted"], true);
  EXPECT_EQ(json["scenarios"][1]["accepted"], false);
  EXPECT_EQ(json["scenarios"][1]["error"]["place"]["key"], "body.age");
  EXPECT_EQ(document("schema")["$schema"], "https://json-schema.org/draft/2020-12/schema");
}

}  // namespace
}  // namespace loosefit
