#include "loosefit/lines/line_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loosefit::lines {
namespace {

/// The state of a donning in the reference posture; nullptr without.
const LineState* reference_of(const std::vector<LineState>& states, int donning, int posture) {
  for (const LineState& state : states)
    if (state.donning == donning && state.posture == posture) return &state;
  return nullptr;
}

}  // namespace

std::vector<double> signals(const std::vector<LineState>& states, int reference_posture) {
  std::vector<double> all;
  for (const LineState& state : states) {
    const LineState* reference = reference_of(states, state.donning, reference_posture);
    all.push_back(reference && reference->length > 0 ? state.length / reference->length - 1
                                                     : std::numeric_limits<double>::quiet_NaN());
  }
  return all;
}

std::vector<std::map<std::string, double>> line_metrics_by_donning(
    const std::vector<LineState>& states, double cut_length, int reference_posture) {
  std::map<int, std::vector<const LineState*>> by_donning;
  for (const LineState& state : states) by_donning[state.donning].push_back(&state);
  if (by_donning.empty()) return {};
  const LineState* first = reference_of(states, by_donning.begin()->first, reference_posture);
  std::vector<std::map<std::string, double>> all;
  for (const auto& [donning, of_it] : by_donning) {
    std::map<std::string, double>& m = all.emplace_back();
    const auto range = [&](const auto& value) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const LineState* state : of_it)
        low = std::min(low, value(*state)), high = std::max(high, value(*state));
      return std::pair(low, high);
    };
    const auto elongation = range([](const LineState& s) { return s.elongation; });
    m["line_elongation_most"] = elongation.second;
    m["line_elongation_least"] = elongation.first;
    m["line_part_elongation"] = range([](const LineState& s) { return s.largest_part(); }).second;
    m["line_part_strain"] = range([](const LineState& s) { return s.largest_strain(); }).second;
    m["line_force_N"] = range([](const LineState& s) { return s.force; }).second;
    m["line_slack"] = range([](const LineState& s) { return s.slack; }).second;
    m["line_contact"] = range([](const LineState& s) { return s.contact; }).first;
    const double radius = range([](const LineState& s) { return s.bend_radius; }).first;
    if (std::isfinite(radius)) m["line_bend_radius_mm"] = 1e3 * radius;
    const LineState* reference = reference_of(states, donning, reference_posture);
    if (reference) m["line_elongation"] = reference->elongation;
    const auto length = range([](const LineState& s) { return s.length; });
    if (of_it.size() > 1) m["line_swing_mm"] = 1e3 * (length.second - length.first);
    if (of_it.size() > 1 && reference && reference->length > 0)
      m["line_swing"] = (length.second - length.first) / reference->length;
    if (reference && first && reference != first)
      m["line_donning_shift"] = std::abs(reference->length - first->length) / cut_length;
  }
  return all;
}

}  // namespace loosefit::lines
