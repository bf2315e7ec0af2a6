#include "loosefit/pipeline/case_lines.h"

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/io/csv.h"
#include "loosefit/io/scorecard_file.h"
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

lines::RouteWish route_wish(const placement::LineSpec& line, const CaseResult& mapped) {
  lines::RouteWish wish;
  wish.part = line.part;
  wish.longest = line.longest;
  wish.prices.seam = line.seam_price;
  wish.prices.bending = line.bend_price;
  wish.prices.slip = line.slip_price;
  if (line.keep_out.empty()) return wish;
  const garment::Garment& mesh = mapped.studied().mesh();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& uv = mesh.triangle_uv[t];
    const Vec2 middle = (uv[0] + uv[1] + uv[2]) / 3;
    bool kept = false;
    for (const placement::KeepOutZone& zone : line.keep_out.zones)
      kept |= zone.panel == mesh.panel_names[mesh.triangle_panel[t]] && zone.distance(middle) <= 0;
    for (const body::Region region : line.keep_out.regions)
      for (const int corner : mesh.triangles[t])
        kept |= region == mapped.studied().maps.worn.regions[corner];
    wish.kept_free.push_back(kept);
  }
  return wish;
}

/// Its way and its sensor. \throws InvalidInput as CourseFinder::find and find_routes.
void lay(CaseLine& line, const placement::LineSpec& spec, const lines::CourseFinder& finder,
         const std::vector<placement::WornState>& states, const CaseResult& mapped) {
  const garment::Garment& mesh = mapped.studied().mesh();
  line.course = finder.find(spec);
  line.sensor = {spec.height, spec.pre_stretch, spec.axial_stiffness(line.course.length)};
  if (spec.course != placement::LineSpec::Course::least_strain) return;
  line.shortest = lines::judged(mesh, finder.surface(), line.course, states);
  line.routes = lines::find_routes(mesh, finder.surface(), line.course.stops, states,
                                   route_wish(spec, mapped));
  line.course = line.routes.front().course;
}

/// "from: \"knee_L\": the garment ends 243 mm away from it".
std::string why_not(const InvalidInput& error) {
  return error.place().key + ": " + error.found() +
         (error.expected().empty() ? "" : ", expected " + error.expected());
}

/// The scorecards by which a line is judged.
std::vector<placement::Scorecard> scorecards_of(const placement::LineSpec& line) {
  if (!line.scorecard.empty()) return {io::load_scorecard(line.scorecard, true)};
  std::vector<placement::Scorecard> all;
  for (const std::string& name : io::line_scorecard_names())
    all.push_back(io::load_scorecard(name, true));
  return all;
}

/// A line is as good as in its worst donning; of sweeps, as in the one of most gain.
CaseLine::Verdict judged_by(const placement::Scorecard& card, const CaseLine& line) {
  std::map<std::string, double> of_sweep;
  double most = -1;
  for (const lines::Sensitivity& s : line.sensitivities)
    if (std::abs(s.gain) > most) most = std::abs(s.gain), of_sweep = lines::sensitivity_metrics(s);
  CaseLine::Verdict worst{card.name, card.title, {}, card.pass};
  for (std::size_t d = 0; d < line.metrics.size(); ++d) {
    placement::MetricValues values = line.metrics[d];
    values.insert(of_sweep.begin(), of_sweep.end());
    placement::Score score = placement::score(values, card);
    if (d == 0 || score.margin < worst.score.margin) worst.score = std::move(score);
  }
  return worst;
}

}  // namespace

void check_lines(const CaseResult& prepared) {
  if (!has_lines(prepared.scenario)) return;
  const placement::SitePoints points(prepared.body.body.body());
  for_lines(prepared.scenario, [&](const placement::SiteSpec& site) {
    lines::check_stops(prepared.studied().mesh(), points, *site.line);
    try {
      placement::check_keep_out(site.line->keep_out, prepared.studied().mesh().panel_names);
    } catch (const InvalidInput& error) {
      throw error.at({"", 0, "keep_out"});
    }
  });
}

LineStage measure_lines(const CaseResult& mapped) {
  LineStage stage;
  if (!has_lines(mapped.scenario)) return stage;
  const CaseGarment& studied = mapped.studied();
  const lines::CourseFinder finder(studied.mesh(), studied.drape.positions, mapped.body.body,
                                   studied.maps.worn);
  const std::vector<placement::WornState> states = worn_states(mapped);
  std::vector<const placement::LineSpec*> specs;
  for (const placement::SiteSpec& site : mapped.scenario.sites) {
    if (!site.line) continue;
    CaseLine line;
    line.name = site.name;
    try {
      lay(line, *site.line, finder, states, mapped);
    } catch (const InvalidInput& error) {
      stage.left_out.push_back({site.name, false, why_not(error)});
      continue;
    }
    stage.lines.push_back(std::move(line));
    specs.push_back(&*site.line);
  }
  for (const placement::WornState& state : states) {
    const lines::LineMeter meter(studied.mesh(), mapped.scenario.studied().material.material,
                                 state);
    for (CaseLine& line : stage.lines)
      line.states.push_back(meter.measure(line.course, line.sensor));
  }
  for (std::size_t i = 0; i < stage.lines.size(); ++i) {
    CaseLine& line = stage.lines[i];
    line.signals = lines::signals(line.states);
    line.metrics = lines::line_metrics_by_donning(line.states, line.course.length);
    line.sensitivities = lines::sensitivities(mapped.wear.postures, line.states, line.signals);
    for (const placement::Scorecard& card : scorecards_of(*specs[i]))
      line.verdicts.push_back(judged_by(card, line));
  }
  return stage;
}

std::string lines_csv(const CaseResult& result) {
  std::string text = io::csv_line({"name", "posture", "donning", "length_cut_m", "length_worn_m",
                                   "elongation", "signal", "part_elongation_largest", "slack",
                                   "contact", "bend_radius_mm", "force_N"});
  for (const CaseLine& line : result.lines)
    for (std::size_t s = 0; s < line.states.size(); ++s) {
      const lines::LineState& state = line.states[s];
      const std::string posture =
          result.wear.postures.empty() ? "reference" : result.wear.postures[state.posture];
      std::vector<std::string> row = {io::csv_field(line.name), io::csv_field(posture),
                                      std::to_string(state.donning + 1)};
      for (const double value :
           {line.course.length, state.length, state.elongation, line.signals[s],
            state.largest_part(), state.slack, state.contact, 1e3 * state.bend_radius, state.force})
        row.push_back(std::isfinite(value) ? io::csv_field(value) : "");
      text += io::csv_line(row);
    }
  return text;
}

}  // namespace loosefit::pipeline
