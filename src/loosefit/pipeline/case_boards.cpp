#include "loosefit/pipeline/case_boards.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/drape/drape_session.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/pipeline/simulation_options.h"
#include "loosefit/placement/site_points.h"

namespace loosefit::pipeline {
namespace {

constexpr double kCoarseResidual = 0.01;
constexpr double kFarOff = 0.015;  // [m]

bool needs_place(const placement::SiteSpec& site) { return site.board && site.panel.empty(); }

/// The mesh cuts the corners of a curved outline, at a concave one to its outside.
Vec2 inside(const pattern::Panel& panel, const Vec2& place) {
  const std::vector<Vec2> outline = pattern::outline_polygon(panel);
  return pattern::inside_polygon(outline, place) ? place
                                                 : pattern::closest_on_polygon(outline, place);
}

}  // namespace

std::vector<garment::Attachment> all_attachments(const scenario::Scenario& scenario) {
  std::vector<garment::Attachment> all = scenario.attachments;
  const std::vector<garment::Attachment> boards = placement::site_boards(scenario.sites);
  all.insert(all.end(), boards.begin(), boards.end());
  return all;
}

std::vector<placement::SiteSpec> place_boards(const scenario::Scenario& scenario,
                                              const CaseBody& body,
                                              const std::vector<CasePattern>& patterns,
                                              Progress& progress) {
  std::vector<placement::SiteSpec> sites = scenario.sites;
  if (std::none_of(sites.begin(), sites.end(), needs_place)) return sites;

  // The bare garment over what is worn under it, on its coarsest mesh.
  const std::vector<CaseGarment> coarse =
      mesh_garments(scenario, patterns, scenario.attachments, MeshLevels::coarsest);
  const garment::Garment& bare = coarse.back().mesh();
  placement::check_sites(bare, body.body, sites);
  drape::DrapeOptions options = drape_options(scenario.simulation);
  options.residual_tolerance = kCoarseResidual;
  CaseBody wearer = clone_wearer(body);
  drape::DrapeSession session(cloth_layers(scenario, coarse), options, progress);
  const drape::Drape drape =
      split_drape(put_on(session, wearer, usual_movements(scenario.donning)), scenario, coarse)
          .back();

  // Its place over the skin that the scenario names is that of the board.
  const maps::WornGarment worn = maps::relate(bare, drape.positions, body.body);
  const std::vector<placement::Site> found =
      placement::find_sites(bare, drape.positions, body.body, worn, {}, sites, false);
  const pattern::Pattern& pattern = patterns.back().pattern;
  std::size_t next = 0;  // lines are not among those found
  for (placement::SiteSpec& site : sites) {
    if (site.line) continue;
    const placement::Site& at = found[next++];
    if (!needs_place(site)) continue;
    site.panel = at.panel;
    site.at = inside(pattern.panels[pattern.find_panel(at.panel)], at.at);
  }
  return sites;
}

std::vector<std::string> moved_board_warnings(const CaseResult& result) {
  std::vector<std::string> warnings;
  if (result.sites.empty()) return warnings;
  const placement::SitePoints points(result.body.body);
  for (const placement::SiteSpec& spec : result.scenario.sites) {
    if (!spec.board || (spec.landmark.empty() && !spec.anatomy)) continue;
    const auto site = std::find_if(result.sites.begin(), result.sites.end(),
                                   [&](const placement::Site& s) { return s.name == spec.name; });
    if (site == result.sites.end()) continue;
    const Vec3 asked = spec.landmark.empty() ? points.addresses().skin(*spec.anatomy).point
                                             : points.at(spec.landmark);
    const double off = (site->body_point - asked).norm();
    if (off > kFarOff)
      warnings.push_back(
          fmt::format("placement: the board of site {} lies {:.0f} mm from where it was wanted: "
                      "give panel and at instead",
                      spec.name, 1000 * off));
  }
  return warnings;
}

}  // namespace loosefit::pipeline
