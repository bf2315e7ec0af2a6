#include "loosefit/pipeline/case_sewn_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <variant>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/lines/find_course.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/pipeline/simulation_options.h"
#include "loosefit/placement/site_points.h"

namespace loosefit::pipeline {
namespace {

constexpr double kCoarseResidual = 0.01;
constexpr double kFarOff = 0.015;  // [m]

using placement::GarmentPoint;
using placement::LinePlace;
using placement::LineSpec;
using placement::SiteSpec;

bool is_sewn_line(const SiteSpec& site) { return site.line && site.line->is_sewn_part(); }

/// A board with a place in the pattern from which it is shifted.
bool is_shifted_board(const SiteSpec& site) {
  return site.board && !site.panel.empty() && !site.shift.isZero();
}

/// Its places in the pattern are seen on a drape only.
bool needs_drape(const SiteSpec& site) {
  if (is_sewn_line(site))
    return !site.line->over.empty() ||
           std::any_of(site.line->stops.begin(), site.line->stops.end(),
                       [](const LinePlace& place) { return place.panel.empty(); });
  return site.board && site.panel.empty();
}

/// The mesh cuts the corners of a curved outline, at a concave one to its outside.
Vec2 inside(const pattern::Panel& panel, const Vec2& place) {
  const std::vector<Vec2> outline = pattern::outline_polygon(panel);
  for (const pattern::PanelHole& hole : panel.holes)
    if (pattern::inside_polygon(hole.points, place))
      return pattern::closest_on_polygon(hole.points, place);
  return pattern::inside_polygon(outline, place) ? place
                                                 : pattern::closest_on_polygon(outline, place);
}

/// `work` on a site of the scenario; complaints get its key.
template <class Work>
auto for_site(std::size_t i, const Work& work) try {
  return work();
} catch (const InvalidInput& error) {
  throw error.at({"", 0, "site[" + std::to_string(i) + "]." + error.place().key});
}

/// Boards that are shifted from a place in the pattern: their way is seen on the flat cloth.
void place_on_flat(const garment::Garment& mesh, const pattern::Pattern& pattern,
                   std::vector<SiteSpec>& sites) {
  for (std::size_t i = 0; i < sites.size(); ++i) {
    SiteSpec& site = sites[i];
    if (!is_shifted_board(site)) continue;
    site = for_site(i, [&] { return placement::without_shift(site, mesh); });
    site.at = inside(pattern.panels[pattern.find_panel(site.panel)], site.at);
  }
}

/// Gives sites that need it their places on the bare garment, draped on its coarsest mesh over what
/// is worn under it.
void place_on_drape(const scenario::Scenario& scenario, const CaseBody& body,
                    const std::vector<CasePattern>& patterns,
                    const std::vector<CaseGarment>& coarse, std::vector<SiteSpec>& sites,
                    Progress& progress) {
  const garment::Garment& bare = coarse.back().mesh();
  placement::check_sites(bare, body.body, sites);
  drape::DrapeOptions options = drape_options(scenario.simulation);
  options.residual_tolerance = kCoarseResidual;
  CaseBody wearer = clone_wearer(body);
  drape::DrapeSession session(cloth_layers(scenario, coarse), options, progress);
  const drape::Drape drape =
      split_drape(put_on(session, wearer, usual_movements(scenario.donning), &scenario), scenario,
                  coarse)
          .back();

  const maps::WornGarment worn = maps::relate(bare, drape.positions, body.body);
  const lines::CourseFinder finder(bare, drape.positions, body.body, worn);
  const pattern::Pattern& pattern = patterns.back().pattern;
  const auto in_pattern = [&](const std::string& panel, const Vec2& at) {
    return inside(pattern.panels[pattern.find_panel(panel)], at);
  };
  // What carries no board is looked for on the final drape, and only warned of if it is not there.
  std::vector<placement::UncoveredSite> uncovered;
  const std::vector<placement::Site> found =
      placement::find_sites(bare, drape.positions, body.body, worn, {}, sites, false, &uncovered);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    SiteSpec& site = sites[i];
    if (!needs_drape(site)) continue;
    if (!site.line) {
      const auto at = std::find_if(found.begin(), found.end(), [&](const placement::Site& other) {
        return other.name == site.name;
      });
      site.panel = at->panel;
      site.at = in_pattern(at->panel, at->at);
      if (site.shift.isZero()) continue;
      site.angle = at->angle;
      // It is not meant to lie over its landmark: only the place in the pattern stays.
      site.shift.setZero();
      site.landmark.clear();
      site.anatomy.reset();
    } else {
      const std::vector<GarmentPoint> stops = for_site(i, [&] { return finder.stops(*site.line); });
      site.line->stops.clear();
      for (const GarmentPoint& stop : stops) {
        LinePlace& place = site.line->stops.emplace_back();
        place.panel = bare.panel_names[bare.triangle_panel[stop.triangle]];
        place.at = in_pattern(place.panel, placement::pattern_place(bare, stop));
      }
      site.line->over.clear();
    }
  }
}

/// The cables of a line. \pre its stops are places of the pattern
std::vector<garment::Attachment> line_cables(const SiteSpec& site, const garment::Garment& mesh,
                                             const pattern::Pattern& pattern) {
  const LineSpec& line = *site.line;
  std::vector<GarmentPoint> stops;
  for (std::size_t k = 0; k < line.stops.size(); ++k) try {
      stops.push_back(placement::pattern_point(mesh, line.stops[k].panel, line.stops[k].at));
    } catch (const InvalidInput& error) {
      throw error.at({"", 0, lines::stop_key(k, line.stops.size())});
    }
  const lines::LineCourse course =
      lines::lay_course(mesh, lines::flat_surface(mesh), stops, line.course, line.part);
  return cables_along(site.name, line, course, mesh, pattern);
}

}  // namespace

std::vector<garment::Attachment> cables_along(const std::string& name, const LineSpec& line,
                                              const lines::LineCourse& course,
                                              const garment::Garment& mesh,
                                              const pattern::Pattern& pattern) {
  std::vector<garment::Attachment> cables;
  const std::vector<lines::PanelStretch> stretches = lines::stretches(mesh, course);
  for (const lines::PanelStretch& stretch : stretches) {
    garment::Cable cable;
    const pattern::Panel& panel =
        pattern.panels[pattern.find_panel(mesh.panel_names[stretch.panel])];
    for (const Vec2& p : stretch.points) cable.path.push_back(inside(panel, p));
    cable.width = line.width;
    cable.linear_density = line.linear_density;
    cable.bending = line.bending;
    cable.axial_stiffness = line.axial_stiffness(course.length);
    cable.pre_stretch = line.pre_stretch;
    const std::string part =
        stretches.size() > 1 ? fmt::format(" {} of {}", cables.size() + 1, stretches.size()) : "";
    cables.push_back({name + part, panel.name, std::move(cable)});
  }
  return cables;
}

SewnParts place_sewn_parts(const scenario::Scenario& scenario, const CaseBody& body,
                           const std::vector<CasePattern>& patterns, Progress& progress) {
  SewnParts parts{scenario.sites, scenario.attachments};
  const bool drapes = std::any_of(parts.sites.begin(), parts.sites.end(), needs_drape);
  const bool lines = std::any_of(parts.sites.begin(), parts.sites.end(), is_sewn_line);
  const bool shifts = std::any_of(parts.sites.begin(), parts.sites.end(), is_shifted_board);
  std::vector<CaseGarment> coarse;
  if (drapes || lines || shifts)
    coarse = mesh_garments(scenario, patterns, scenario.attachments, MeshLevels::coarsest);
  if (shifts) place_on_flat(coarse.back().mesh(), patterns.back().pattern, parts.sites);
  if (drapes) place_on_drape(scenario, body, patterns, coarse, parts.sites, progress);
  const std::vector<garment::Attachment> boards = placement::site_boards(parts.sites);
  parts.attachments.insert(parts.attachments.end(), boards.begin(), boards.end());
  for (std::size_t i = 0; i < parts.sites.size(); ++i) {
    if (!is_sewn_line(parts.sites[i])) continue;
    const auto cables = for_site(i, [&] {
      return line_cables(parts.sites[i], coarse.back().mesh(), patterns.back().pattern);
    });
    parts.attachments.insert(parts.attachments.end(), cables.begin(), cables.end());
  }
  return parts;
}

namespace {

double flat_area(const garment::Board& board) {
  return board.radius > 0 ? kPi * board.radius * board.radius : board.size.prod();
}

/// Rigid boards that reach over the rim of their piece: what is beyond is not simulated.
void add_cut_boards(const CaseResult& result, std::vector<std::string>& warnings) {
  if (result.studied().hierarchy.levels.empty()) return;  // nothing is sewn
  constexpr double kWhole = 0.85;        // coarse triangles follow an outline that well
  std::map<std::string, double> wanted;  // by name of the part
  for (const garment::Attachment& part : result.scenario.attachments)
    if (const auto* board = std::get_if<garment::Board>(&part.part))
      wanted[part.name] = flat_area(*board);
  for (const placement::SiteSpec& site : result.scenario.sites) {
    if (!site.board) continue;
    garment::Board board;
    board.size = site.board->size.isZero() ? site.footprint.size : site.board->size;
    if (board.size.isZero()) board.radius = site.footprint.radius;
    wanted[site.name] = flat_area(board);
  }
  for (const garment::Garment::RigidBoard& board : result.studied().mesh().rigid_boards)
    if (const auto whole = wanted.find(board.name);
        whole != wanted.end() && board.area < kWhole * whole->second)
      warnings.push_back(fmt::format(
          "attachment: of the board of {} only {:.0f} % lies on its piece of the pattern: the rest "
          "hangs on nothing here, and all of its mass hangs on that part",
          printable(board.name), 100 * board.area / whole->second));
}

}  // namespace

std::vector<std::string> moved_board_warnings(const CaseResult& result) {
  std::vector<std::string> warnings;
  add_cut_boards(result, warnings);
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

std::vector<std::string> flexible_board_notes(const scenario::Scenario& scenario) {
  std::vector<std::string> notes;
  const auto note = [&](const std::string& what, const garment::BoardMake& board) {
    if (board.bending || board.membrane_factor)
      notes.push_back(
          fmt::format("attachment: the board of {} bends with the cloth, as its keys {} "
                      "say: without them it is rigid",
                      what,
                      !board.membrane_factor ? "bending"
                      : board.bending        ? "bending and membrane_factor"
                                             : "membrane_factor"));
  };
  for (const garment::Attachment& a : scenario.attachments)
    if (const auto* board = std::get_if<garment::Board>(&a.part))
      note("attachment " + a.name, *board);
  for (const SiteSpec& site : scenario.sites)
    if (site.board) note("site " + site.name, *site.board);
  return notes;
}

}  // namespace loosefit::pipeline
