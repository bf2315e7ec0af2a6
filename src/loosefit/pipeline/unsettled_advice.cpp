#include "loosefit/pipeline/unsettled_advice.h"

#include <algorithm>
#include <vector>

#include "loosefit/base/text.h"

namespace loosefit::pipeline {
namespace {

constexpr double kFinest = 0.003;  ///< simulation.edge_length [m]

/// Whether cloth cuts the skin where arms and trunk meet.
bool cuts_arm_or_trunk(const drape::Unsettled& unsettled) {
  return std::any_of(unsettled.cuts.begin(), unsettled.cuts.end(), [](const drape::CutTriangle& c) {
    return c.segment == body::Segment::upper_arm || c.segment == body::Segment::forearm ||
           c.segment == body::Segment::torso;
  });
}

bool takes_a_posture(const scenario::ScenarioBody& body) {
  return body.file.empty() || !body.as_scanned;
}

std::string more_room(const scenario::GarmentSpec& garment) {
  if (!garment.file.empty()) return "a pattern with more room there";
  if (!garment.size.empty()) return "a larger garment.size";
  return "a looser garment.fit";
}

std::string against_falling(const scenario::Scenario& scenario, drape::StopReason reason) {
  if (reason == drape::StopReason::pieces_fall)
    return "sew what falls to the rest with a stitch in the pattern, or leave it out";
  return scenario.studied().spec.file.empty()
             ? "another garment.fit or garment.size may stay on the body"
             : "a pattern that is narrower where it hangs, or has elastic there (garment.elastic), "
               "may stay on the body; else place the panels of the pattern file round the body "
               "where they are worn, and sew them";
}

std::string against_cuts(const scenario::Scenario& scenario, const drape::Unsettled& unsettled) {
  std::vector<std::string> ways;
  if (scenario.simulation.edge_length > kFinest)
    ways.push_back("a smaller simulation.edge_length, which follows the skin more closely");
  ways.push_back(more_room(scenario.studied().spec));
  const bool arms = cuts_arm_or_trunk(unsettled);
  if (takes_a_posture(scenario.body) && scenario.postures.empty() && arms)
    ways.push_back("arms farther from the trunk (body.posture)");
  return "what may help: " + join(ways, "; ");
}

}  // namespace

std::string unsettled_advice(const scenario::Scenario& scenario, const drape::Drape& drape) {
  const drape::Certificate& c = drape.certificate;
  if (drape::falls(c.reason)) return against_falling(scenario, c.reason);
  if (c.reason == drape::StopReason::time_budget) return "raise simulation.time_budget";
  if (c.reason == drape::StopReason::iteration_limit) return "raise simulation.max_iterations";
  if (c.intersections_body > 0 && drape.unsettled) return against_cuts(scenario, *drape.unsettled);
  const bool disturbed = scenario.simulation.start_perturbation > 0 ||
                         drape.report.was_tried(drape::RecoveryKind::another_start);
  std::string text = disturbed ? "another start may do: another simulation.seed"
                               : "another start may do: simulation.start_perturbation = 0.001";
  if (takes_a_posture(scenario.body)) text += ", or another body.dress_posture";
  return text;
}

}  // namespace loosefit::pipeline
