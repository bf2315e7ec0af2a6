#include "loosefit/pipeline/case_lines.h"

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/io/csv.h"
#include "loosefit/lines/find_course.h"
#include "loosefit/pipeline/wear_states.h"

namespace loosefit::pipeline {
namespace {

/// `work` on each line of the scenario; complaints get the key of their site.
template <class Work>
void for_lines(const scenario::Scenario& scenario, const Work& work) {
  for (std::size_t i = 0; i < scenario.sites.size(); ++i) {
    if (!scenario.sites[i].line) continue;
    try {
      work(scenario.sites[i]);
    } catch (const InvalidInput& error) {
      throw error.at({"", 0, "site[" + std::to_string(i) + "]." + error.place().key});
    }
  }
}

bool has_lines(const scenario::Scenario& scenario) {
  for (const placement::SiteSpec& site : scenario.sites)
    if (site.line) return true;
  return false;
}

}  // namespace

void check_lines(const CaseResult& prepared) {
  if (!has_lines(prepared.scenario)) return;
  const placement::SitePoints points(prepared.body.body.body());
  for_lines(prepared.scenario, [&](const placement::SiteSpec& site) {
    lines::check_stops(prepared.studied().mesh(), points, *site.line);
  });
}

std::vector<CaseLine> measure_lines(const CaseResult& mapped) {
  std::vector<CaseLine> found;
  if (!has_lines(mapped.scenario)) return found;
  const CaseGarment& studied = mapped.studied();
  const lines::CourseFinder finder(studied.mesh(), studied.drape.positions, mapped.body.body,
                                   studied.maps.worn);
  const std::vector<placement::WornState> states = worn_states(mapped);
  for_lines(mapped.scenario, [&](const placement::SiteSpec& site) {
    CaseLine& line = found.emplace_back();
    line.name = site.name;
    line.course = finder.find(*site.line);
    line.sensor = {site.line->height, site.line->pre_stretch};
    if (site.line->course != placement::LineSpec::Course::least_strain) return;
    line.shortest = lines::judged(studied.mesh(), line.course, states);
    line.routes = lines::find_routes(studied.mesh(), finder.surface(), line.course.stops, states,
                                     {.part = site.line->part});
    line.course = line.routes.front().course;
  });
  for (const placement::WornState& state : states) {
    const lines::LineMeter meter(studied.mesh(), mapped.scenario.studied().material.material,
                                 state);
    for (CaseLine& line : found) line.states.push_back(meter.measure(line.course, line.sensor));
  }
  for (CaseLine& line : found) {
    line.signals = lines::signals(line.states);
    line.metrics = lines::line_metrics_by_donning(line.states, line.course.length);
    line.sensitivities = lines::sensitivities(mapped.wear.postures, line.states, line.signals);
  }
  return found;
}

std::string lines_csv(const CaseResult& result) {
  std::string text =
      io::csv_line({"name", "posture", "donning", "length_cut_m", "length_worn_m", "elongation",
                    "signal", "part_elongation_largest", "slack", "contact", "bend_radius_mm"});
  for (const CaseLine& line : result.lines)
    for (std::size_t s = 0; s < line.states.size(); ++s) {
      const lines::LineState& state = line.states[s];
      const std::string posture =
          result.wear.postures.empty() ? "reference" : result.wear.postures[state.posture];
      std::vector<std::string> row = {io::csv_field(line.name), io::csv_field(posture),
                                      std::to_string(state.donning + 1)};
      for (const double value :
           {line.course.length, state.length, state.elongation, line.signals[s],
            state.largest_part(), state.slack, state.contact, 1e3 * state.bend_radius})
        row.push_back(std::isfinite(value) ? io::csv_field(value) : "");
      text += io::csv_line(row);
    }
  return text;
}

}  // namespace loosefit::pipeline
