#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <thread>

#include "loosefit/io/scenario.h"
#include "loosefit/loosefit.h"
#include "loosefit/pipeline/run_case.h"
#include "loosefit/pipeline/summary.h"

namespace loosefit::library {
namespace {

constexpr char kScenario[] = R"(
[garment]
pattern = "tank-top"
[simulation]
edge_length = 0.040
[donning]
movements = []
)";

TEST(Library, GivesWhatTheStagesMake) {
  const Outcome outcome = run_text(kScenario);
  Progress silent;
  const pipeline::CaseResult result =
      pipeline::run_case(io::parse_scenario(kScenario, "scenario"), silent);
  const drape::Certificate& certificate = result.certificate();
  EXPECT_EQ(outcome.verdict.holds, certificate.holds());
  EXPECT_EQ(outcome.verdict.residual, certificate.residual);
  ASSERT_TRUE(outcome.verdict.holds) << outcome.verdict.stop_reason;

  const Garment& garment = outcome.studied();
  const pipeline::CaseGarment& made = result.studied();
  ASSERT_EQ(garment.surface.vertices.size(), made.drape.positions.size());
  for (std::size_t v = 0; v < made.drape.positions.size(); ++v)
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(garment.surface.vertices[v][k], made.drape.positions[v][k]) << v;
  EXPECT_EQ(garment.surface.triangles, made.mesh().triangles);
  EXPECT_EQ(outcome.body.vertices.size(), result.body.body->surface.vertices.size());
  ASSERT_EQ(garment.maps.size(), made.maps.maps.size());
  for (std::size_t m = 0; m < garment.maps.size(); ++m) {
    const std::vector<double>& asked = made.maps.maps[m].map.values;
    ASSERT_EQ(garment.maps[m].values.size(), garment.surface.vertices.size());
    for (std::size_t v = 0; v < asked.size(); ++v) {
      const double value = garment.maps[m].values[v];
      ASSERT_TRUE(value == asked[v] || (std::isnan(value) && std::isnan(asked[v])));
    }
  }
  ASSERT_NE(garment.find_map("distance_mm"), nullptr);
  EXPECT_EQ(garment.find_map("distance_mm")->unit, "mm");
  EXPECT_EQ(garment.find_map("distance"), nullptr);
  EXPECT_NE(outcome.summary_json.find("\"residual\""), std::string::npos);
}

TEST(Library, TwoRunsAtTheSameTimeAreAsOneAfterTheOther) {
  const RunSettings only_drape{.allow_unsettled = false, .only_drape = true};
  const Outcome alone = run_text(kScenario, "scenario", only_drape);
  Outcome first, second;
  std::thread other([&] { first = run_text(kScenario, "scenario", only_drape); });
  second = run_text(kScenario, "scenario", only_drape);
  other.join();
  EXPECT_EQ(alone.studied().surface.vertices, first.studied().surface.vertices);
  EXPECT_EQ(alone.studied().surface.vertices, second.studied().surface.vertices);
}

TEST(Library, ErrorsNamePlaceFoundAndExpected) {
  try {
    run_text("[simulation]\nedge_length = \"wide\"\n", "mine.toml");
    FAIL() << "was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().file, "mine.toml");
    EXPECT_EQ(error.place().line, 2);
  }
}

TEST(Library, CanBeStopped) {
  struct Impatient : Progress {
    void stage(const std::string& name) override {
      if (name == "settle") request_cancel();
    }
  } progress;
  EXPECT_THROW(run_text(kScenario, "scenario", {}, progress), Cancelled);
}

}  // namespace
}  // namespace loosefit::library
