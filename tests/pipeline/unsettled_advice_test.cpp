#include "loosefit/pipeline/unsettled_advice.h"

#include <gtest/gtest.h>

#include "loosefit/io/scenario.h"

namespace loosefit::pipeline {
namespace {

drape::Drape cut_by(body::Segment part) {
  drape::Drape drape;
  drape.certificate.reason = drape::StopReason::converged;
  drape.certificate.intersections_body = 3;
  drape.unsettled.emplace();
  drape::CutTriangle cut;
  cut.segment = part;
  cut.body = true;
  drape.unsettled->cuts = {cut};
  return drape;
}

std::string advice(const scenario::Scenario& scenario,
                   body::Segment part = body::Segment::upper_arm) {
  return unsettled_advice(scenario, cut_by(part));
}

bool has(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

TEST(UnsettledAdvice, NamesOnlyKeysThatTheCaseCanHave) {
  scenario::Scenario scenario = io::default_scenario();
  EXPECT_TRUE(has(advice(scenario), "garment.fit"));
  EXPECT_TRUE(has(advice(scenario), "body.posture"));
  EXPECT_FALSE(has(advice(scenario, body::Segment::shank), "arms"));
  scenario.studied().spec.size = "women-38";
  EXPECT_FALSE(has(advice(scenario), "garment.fit"));
  EXPECT_TRUE(has(advice(scenario), "garment.size"));
  scenario.studied().spec.size.clear();
  scenario.studied().spec.file = "/tmp/trousers.json";
  EXPECT_FALSE(has(advice(scenario), "garment."));
  scenario.body.file = "/tmp/scan.obj";
  EXPECT_FALSE(has(advice(scenario), "posture"));
  scenario.body.as_scanned = false;
  EXPECT_TRUE(has(advice(scenario), "body.posture"));
  scenario.simulation.edge_length = 0.003;
  EXPECT_FALSE(has(advice(scenario), "edge_length")) << "there is no smaller one";
}

TEST(UnsettledAdvice, AnotherStartByWhatTheCaseHas) {
  drape::Drape drape = cut_by(body::Segment::torso);
  drape.certificate.intersections_body = 0;
  scenario::Scenario scenario = io::default_scenario();
  EXPECT_TRUE(has(unsettled_advice(scenario, drape), "start_perturbation = 0.001"));
  EXPECT_TRUE(has(unsettled_advice(scenario, drape), "body.dress_posture"));
  scenario.body.file = "/tmp/scan.obj";
  scenario.simulation.start_perturbation = 0.001;
  EXPECT_FALSE(has(unsettled_advice(scenario, drape), "posture"));
  EXPECT_TRUE(has(unsettled_advice(scenario, drape), "simulation.seed"));
}

TEST(UnsettledAdvice, MoreTimeDoesNotHelpWhatFalls) {
  drape::Drape drape = cut_by(body::Segment::torso);
  scenario::Scenario scenario = io::default_scenario();
  scenario.studied().spec.file = "/tmp/trousers.json";
  drape.certificate.reason = drape::StopReason::cloth_falls;
  EXPECT_TRUE(has(unsettled_advice(scenario, drape), "place the panels"));
  drape.certificate.reason = drape::StopReason::pieces_fall;
  EXPECT_TRUE(has(unsettled_advice(scenario, drape), "stitch"));
  drape.certificate.reason = drape::StopReason::time_budget;
  EXPECT_EQ(unsettled_advice(scenario, drape), "raise simulation.time_budget");
}

}  // namespace
}  // namespace loosefit::pipeline
