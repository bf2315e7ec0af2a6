#include "loosefit/pipeline/case_warnings.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "loosefit/base/text.h"
#include "loosefit/drape/worn.h"
#include "loosefit/drape/worn_way.h"
#include "loosefit/flesh/soft_body.h"
#include "loosefit/pipeline/case_ease.h"
#include "loosefit/pipeline/case_sewn_parts.h"
#include "loosefit/pipeline/ease_on_mesh.h"
#include "loosefit/placement/site_points.h"

namespace loosefit::pipeline {
namespace {

using Lines = std::vector<std::string>;

void add(Lines& all, const std::string& stage, const Lines& warnings,
         const std::string& garment = "") {
  for (const std::string& text : warnings) all.push_back(stage + ": " + garment + text);
}

/// Of skin that passes through itself in a posture, where flesh could not give way far enough.
void add_passing_skin(Lines& all, const CaseResult& result) {
  if (!result.body.person) return;  // as scanned: checked when it was read
  const auto tell = [&](const body::PosedBody& body, const std::string& where) {
    const flesh::Overlaps left = result.body.person->left_in(body);
    if (left.empty()) return;
    std::map<body::Region, int> count;
    for (const auto& pair : left)
      ++count[body.regions()[std::size_t(body->surface.triangles[std::size_t(pair.first)][0])]];
    const auto most = std::ranges::max_element(count, {}, [](const auto& c) { return c.second; });
    all.push_back(fmt::format(
        "body: {} pairs of triangles of the skin pass through each other{}, most near {}: flesh "
        "could not give way far enough, and distances and pressures there are unreliable",
        left.size(), where, body::name(most->first)));
  };
  tell(result.body.body, "");
  for (std::size_t p = 0; p < result.wear.bodies.size(); ++p)
    if (static_cast<int>(p) != StateId::kReferencePosture)
      tell(result.wear.bodies[p], " in " + result.wear.postures[p]);
}

/// Of patterns and materials; the studied garment first.
void add_garments(Lines& all, const CaseResult& result) {
  add(all, "pattern", result.studied().pattern.warnings);
  add(all, "material", result.scenario.studied().material.notes);
  for (std::size_t g = 0; g < result.worn_under().size(); ++g) {
    add(all, fmt::format("pattern of under {}", g + 1), result.garments[g].pattern.warnings);
    add(all, fmt::format("material of under {}", g + 1),
        result.scenario.garments[g].material.notes);
  }
}

/// "under 1: " for a garment under the studied one; nothing for that one.
std::string under(std::size_t garment, const CaseResult& result) {
  return garment + 1 < result.garments.size() ? fmt::format("under {}: ", garment + 1) : "";
}

std::string label_of(const CaseState& state, const CaseResult& result) {
  return state_label(state, result.wear.donnings.size());
}

/// What is to be said of one drape, by what it is about.
using Told = std::map<std::string, Lines>;

/// What is told of several drapes: of each kind what the reference state has, or else the first
/// that has it, and the names of all that do.
Lines told_once(const Told& in_reference,
                const std::vector<std::pair<std::string, Told>>& in_states) {
  std::map<std::string, Lines> first, where;
  for (const auto& [name, told] : in_states)
    for (const auto& [kind, lines] : told) {
      if (in_reference.contains(kind)) continue;
      first.try_emplace(kind, lines);
      if (std::ranges::count(where[kind], name) == 0) where[kind].push_back(name);
    }
  Lines all;
  for (const auto& [kind, lines] : in_reference) all.insert(all.end(), lines.begin(), lines.end());
  for (const auto& [kind, lines] : first) {
    const Lines& names = where[kind];
    const std::string also =
        names.size() > 1 ? "; also in " + join(Lines(names.begin() + 1, names.end())) : "";
    for (const std::string& line : lines)
      all.push_back(fmt::format("{} (in {}{})", line, names.front(), also));
  }
  return all;
}

/// How a garment is worn in one drape, where not as usual.
Told way_of_wearing(const CaseGarment& garment, const drape::Drape& drape,
                    const body::PosedBody& body) {
  Told told;
  told["risen"] =
      drape::risen_edges(garment.mesh(), garment.pattern.pattern, drape.positions, body);
  const drape::WayRound way =
      drape::way_round(garment.mesh(), garment.pattern.pattern, drape.positions, body);
  if (!way.inside_out.empty()) told["inside out"] = {way.inside_out};
  if (!way.turned.empty()) told["turned"] = {way.turned};
  if (!way.upside_down.empty()) told["upside down"] = {way.upside_down};
  told["unjudged"] = {
      drape::unjudged_openings(garment.mesh(), garment.pattern.pattern, drape.positions, body)};
  std::erase_if(
      told, [](const auto& entry) { return entry.second.empty() || entry.second.front().empty(); });
  return told;
}

/// The same of all states that count.
Lines ways_of_wearing(const CaseResult& result, std::size_t g) {
  const CaseGarment& garment = result.garments[g];
  std::vector<std::pair<std::string, Told>> in_states;
  for (const CaseState& state : result.wear.states)
    if (state.counts())
      in_states.emplace_back(
          label_of(state, result),
          way_of_wearing(garment, state.drapes[g], result.body_in(state.id.posture)));
  return told_once(way_of_wearing(garment, garment.drape, result.body.body), in_states);
}

/// What the skin bears beyond comfort; of the studied garment in all states that count.
Lines comfort_of(const CaseResult& result, std::size_t g) {
  const auto told = [](const Lines& lines) { return lines.empty() ? Told{} : Told{{"", lines}}; };
  const CaseMaps& maps = result.garments[g].maps;
  const Told here = told(comfort_warnings(maps.pressure.field, maps.worn.regions));
  std::vector<std::pair<std::string, Told>> in_states;
  if (g + 1 == result.garments.size())
    for (const CaseState& state : result.wear.states)
      if (state.counts())
        in_states.emplace_back(
            label_of(state, result),
            told(comfort_warnings(state.maps.pressure, state.maps.worn.regions)));
  return told_once(here, in_states);
}

/// Cloth that is strained beyond the range of its card; also the state of which most is, where that
/// is more than of twice the area of the reference state, and where no range is stated the one that
/// is strained most, where it is told of that alone.
Lines strain_of(const CaseResult& result, std::size_t g) {
  const CaseGarment& garment = result.garments[g];
  const scenario::MaterialCard& card = result.scenario.garments[g].material;
  const maps::StrainRange& here = garment.maps.strain_range;
  Lines all = strain_range_warnings(here, card);
  const Lines unstated_here = unstated_strain_warnings(here);
  double beyond = 2 * here.share_beyond, largest = 0;
  std::string where_beyond, where_unstated;
  maps::StrainRange most, unstated;
  for (const CaseState& state : result.wear.states) {
    if (!state.counts()) continue;
    const maps::StrainRange range =
        maps::strain_range(garment.mesh(), state.drapes[g].positions, card.material);
    if (range.share_beyond > beyond)
      most = range, beyond = range.share_beyond, where_beyond = label_of(state, result);
    if (const double strain = largest_unstated(range); strain > largest)
      unstated = range, largest = strain, where_unstated = label_of(state, result);
  }
  const auto add_in = [&all](const Lines& lines, const std::string& where) {
    for (const std::string& line : lines)
      all.push_back(line + " (in " + where + ", the most of all states)");
  };
  if (!where_beyond.empty()) add_in(beyond_range_warnings(most, card), where_beyond);
  if (unstated_here.empty() && !where_unstated.empty())
    add_in(unstated_strain_warnings(unstated), where_unstated);
  return all;
}

/// What makes a drape that is at rest less exact than others.
Told doubts_of_settling(const drape::Drape& drape, double thickness, std::size_t triangles) {
  Told told;
  if (drape.certificate.settled() && drape.certificate.stable == false)
    told["saddle"] = {
        "not stable: the forces balance, but on a saddle of the energy that was not left; a touch "
        "would send the cloth into other folds"};
  const drape::SettleReport& report = drape.report;
  if (report.coarsened_field > 0)
    told["coarse field"] = {fmt::format(
        "the field of distances to the skin has a spacing of {:.1f} mm, coarser than asked for, "
        "since the cloth takes up so much room: contact is less exact",
        1e3 * report.coarsened_field)};
  constexpr double kToldShare = 0.001, kToldOffset = 0.0005;  // of the triangles; [m]
  if (report.held_off_triangles > kToldShare * static_cast<double>(triangles) &&
      report.largest_contact_offset > 0.5 * thickness + kToldOffset)
    told["held off"] = {fmt::format(
        "{} of {} triangles are held off the skin, by up to {:.1f} mm, where they would cut it: "
        "gaps, contact and pressure there are of that distance",
        report.held_off_triangles, triangles, 1e3 * report.largest_contact_offset)};
  return told;
}

/// The same of the reference state and all states that count.
Lines doubts_of_settling(const CaseResult& result) {
  double thickness = 0;
  std::size_t triangles = 0;
  for (std::size_t g = 0; g < result.garments.size(); ++g) {
    thickness = std::max(thickness, result.scenario.garments[g].material.material.thickness);
    triangles += result.garments[g].mesh().triangles.size();
  }
  std::vector<std::pair<std::string, Told>> in_states;
  for (const CaseState& state : result.wear.states)
    if (state.counts())
      in_states.emplace_back(label_of(state, result),
                             doubts_of_settling(state.drape(), thickness, triangles));
  return told_once(doubts_of_settling(result.studied().drape, thickness, triangles), in_states);
}

/// How the garments fit, and whether their cloth was measured as far as it is strained. What the
/// skin bears at a garment under others is the weight and the tightness of all of them: whether it
/// is loose by itself cannot be told from it.
void add_fit(Lines& all, const CaseResult& result) {
  for (std::size_t g = 0; g < result.garments.size(); ++g) {
    const CaseGarment& garment = result.garments[g];
    const scenario::ScenarioGarment& asked = result.scenario.garments[g];
    const bool outermost = g + 1 == result.garments.size();
    Lines told =
        ease_warnings(station_eases(garment, asked.spec),
                      outermost ? garment.maps.load : std::nullopt, asked.material.material);
    const auto tell = [&told](const Lines& more) {
      told.insert(told.end(), more.begin(), more.end());
    };
    if (result.certificate().worn()) tell(ways_of_wearing(result, g));
    Lines comfort = comfort_of(result, g);
    if (!outermost)
      for (std::string& line : comfort) line += ", with what is worn over it";
    tell(comfort);
    add(all, "fit", told, under(g, result));
    add(all, "garment", limb_mesh_warnings(garment.mesh(), garment.pattern), under(g, result));
    add(all, "material", strain_of(result, g), under(g, result));
  }
}

/// Of a body without joints the certificate says that nothing was asked.
void add_putting_on(Lines& all, const CaseResult& result) {
  const PuttingOn& on = result.putting_on;
  if (on.possible == true || on.reasons.empty() || result.body.body->joints.empty()) return;
  all.push_back((on.possible ? "fit: cannot be put on without a fastening: "
                             : "fit: whether it can be put on is not judged: ") +
                join(on.reasons, "; "));
}

/// Drapes that differ in nothing that is drawn have no spread.
Lines alike_warnings(const scenario::Scenario& scenario) {
  const scenario::ScenarioDonning& d = scenario.donning;
  const bool moves_alike = d.movements.empty() || d.movement_spread == 0;
  Lines lines;
  if (scenario.simulation.repeats > 1 && scenario.simulation.start_perturbation == 0 && moves_alike)
    lines.push_back(
        "repeats begin alike, as start_perturbation is 0: that they do not differ says nothing");
  if (d.repeats > 1 && d.shift == 0 && d.twist == 0 && d.friction_spread == 0 && moves_alike)
    lines.push_back(
        "donnings are alike, as shift, twist_deg, friction_spread and what movements draw are 0: "
        "that they do not differ says nothing");
  return lines;
}

void add_certificate(Lines& all, const drape::Certificate& certificate) {
  if (!certificate.settled())
    all.push_back(
        fmt::format("settle: not settled ({}): residual {:.2e}, intersections with the "
                    "body {}, with itself {}",
                    certificate.stop_reason, certificate.residual, certificate.intersections_body,
                    certificate.intersections_self));
  if (!certificate.worn()) all.push_back("not worn: " + join(certificate.worn_reasons, "; "));
}

/// Boards are flattened before the cloth settles, as far as nothing is in the way.
void add_bent_boards(Lines& all, const CaseResult& result) {
  if (result.studied().hierarchy.levels.empty()) return;  // nothing is sewn
  constexpr double kBent = radians(1.0);
  const CaseGarment& garment = result.studied();
  const std::vector<Vec3>& x = garment.drape.positions;
  for (const garment::Garment::RigidBoard& board : garment.mesh().rigid_boards) {
    std::vector<Vec3> normals;
    Vec3 mean = Vec3::Zero();
    for (const int t : board.triangles) {
      const Triangle& c = garment.mesh().triangles[t];
      normals.push_back((x[c[1]] - x[c[0]]).cross(x[c[2]] - x[c[0]]).normalized());
      mean += normals.back();
    }
    double bend = 0;
    for (const Vec3& n : normals)
      bend = std::max(bend, std::acos(std::clamp(n.dot(mean.normalized()), -1.0, 1.0)));
    if (bend > kBent)
      all.push_back(
          fmt::format("settle: the rigid board {} could not be made flat: its parts lie "
                      "{:.1f}° askew",
                      printable(board.name), degrees(bend)));
  }
}

}  // namespace

std::vector<std::string> state_warnings(const CaseResult& result) {
  Lines all;
  const CaseWear& wear = result.wear;
  if (!wear.postures.empty() && wear.states.empty())
    all.push_back(
        "postures: none taken and nothing put on again: the first drape is not settled and worn");
  for (const CaseState& s : wear.states) {
    if (s.counts()) continue;
    const std::string where = label_of(s, result);
    const drape::Certificate c = s.certificate();
    all.push_back(fmt::format("postures: {} is left out of all statistics: {}", where,
                              s.left_out.empty() ? fmt::format("not settled ({}), residual {:.2e}",
                                                               c.stop_reason, c.residual)
                                                 : s.left_out));
  }
  return all;
}

std::vector<std::string> case_warnings(const CaseResult& result) {
  Lines all = flexible_board_notes(result.scenario);
  const Lines moved = moved_board_warnings(result);
  all.insert(all.end(), moved.begin(), moved.end());
  add(all, "body", result.body.warnings);
  add(all, "body", result.body.dressing_warnings);
  Lines of_donnings = result.wear.warnings;
  std::erase_if(of_donnings, [&](const std::string& text) {
    return std::ranges::count(result.body.dressing_warnings, text) > 0;
  });
  add(all, "body", of_donnings);
  add_passing_skin(all, result);
  add_garments(all, result);
  add(all, "simulation", result.scenario.simulation.notes);
  add_fit(all, result);
  add_putting_on(all, result);
  for (const placement::UncoveredSite& site : result.uncovered_sites)
    if (!site.preset)
      all.push_back("placement: site " + site.name + " is not covered by the garment: " + site.why);
  const std::vector<std::string> presets = placement::preset_names();
  for (const placement::Site& site : result.sites)
    if (!site.not_covering.empty() && std::ranges::count(presets, site.name) == 0)
      all.push_back("placement: site " + site.name + " has no skin under it: " + site.not_covering);
  for (const placement::UncoveredSite& line : result.lines_left_out)
    all.push_back("placement: line " + line.name + " is left out: " + line.why);
  add_certificate(all, result.certificate());
  add_bent_boards(all, result);
  add(all, "settle", doubts_of_settling(result));
  add(all, "settle", result.repeats.warnings);
  add(all, "settle", alike_warnings(result.scenario));
  if (result.scenario.simulation.repeats > 1 && result.repeats.spread.empty())
    all.push_back("settle: no spread over repeats: it takes two drapes from different starts");
  const Lines states = state_warnings(result);
  all.insert(all.end(), states.begin(), states.end());
  return all;
}

}  // namespace loosefit::pipeline
