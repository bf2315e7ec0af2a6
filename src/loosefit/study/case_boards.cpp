#include "loosefit/study/case_boards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/drape/drape_session.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/placement/site_points.h"
#include "loosefit/study/case_layers.h"
#include "loosefit/study/case_stages.h"

namespace loosefit {
namespace {

constexpr double kCoarseResidual = 0.01;
constexpr double kFarOff = 0.015;  // [m]

bool wants_place(const SiteSpec& site) { return site.board && site.panel.empty(); }

/// The mesh cuts the corners of a curved outline, at a concave one to its outside.
Vec2 inside(const Panel& panel, const Vec2& place) {
  const std::vector<Vec2> outline = outline_polygon(panel);
  return inside_polygon(outline, place) ? place : closest_on_polygon(outline, place);
}

}  // namespace

std::vector<Attachment> all_attachments(const Scenario& scenario) {
  std::vector<Attachment> all = scenario.attachments;
  const std::vector<Attachment> boards = site_boards(scenario.sites);
  all.insert(all.end(), boards.begin(), boards.end());
  return all;
}

void place_boards(CaseResult& result, Progress& progress) {
  std::vector<SiteSpec>& sites = result.scenario.sites;
  if (std::none_of(sites.begin(), sites.end(), wants_place)) return;
  const Scenario& scenario = result.scenario;
  const double edge = scenario.simulation.edge_length *
                      std::pow(2.0, hierarchy_refinements(scenario.simulation.edge_length));
  const Pattern& pattern = result.pattern.pattern;
  CaseResult coarse;  // bare, over what is worn under it
  coarse.scenario = scenario;
  coarse.under = result.under;
  mesh_under(coarse, edge);
  coarse.garment =
      build_hierarchy(pattern, edge, scenario.studied().material.material, scenario.attachments);
  const Garment& bare = coarse.mesh();
  check_sites(bare, result.body.body, sites);
  DrapeOptions options = drape_options(scenario.simulation);
  options.residual_tolerance = kCoarseResidual;
  DrapeSession session(cloth_layers(coarse), options, progress);
  take_drape(put_on(session, result.body), coarse);
  const WornGarment worn = relate(bare, coarse.drape.positions, result.body.body);
  const std::vector<Site> found =
      find_sites(bare, coarse.drape.positions, result.body.body, worn, {}, sites, false);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (!wants_place(sites[i])) continue;
    sites[i].panel = found[i].panel;
    sites[i].at = inside(pattern.panels[pattern.find_panel(found[i].panel)], found[i].at);
  }
}

void warn_of_moved_boards(CaseResult& result) {
  const SitePoints points(result.body.body);
  for (const SiteSpec& spec : result.scenario.sites) {
    if (!spec.board || (spec.landmark.empty() && !spec.anatomy)) continue;
    const auto site = std::find_if(result.sites.begin(), result.sites.end(),
                                   [&](const Site& s) { return s.name == spec.name; });
    if (site == result.sites.end()) continue;
    const Vec3 wanted = spec.landmark.empty() ? points.addresses().skin(*spec.anatomy).point
                                              : points.at(spec.landmark);
    const double off = (site->body_point - wanted).norm();
    if (off > kFarOff)
      result.warnings.push_back(
          fmt::format("placement: the board of site {} lies {:.0f} mm from where it was wanted: "
                      "give panel and at instead",
                      spec.name, 1000 * off));
  }
}

}  // namespace loosefit
