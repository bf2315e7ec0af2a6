#include "loosefit/pipeline/case_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/text.h"
#include "loosefit/drape/worn.h"
#include "loosefit/drape/worn_way.h"
#include "loosefit/pipeline/case_ease.h"
#include "loosefit/pipeline/case_sewn_parts.h"

namespace loosefit::pipeline {
namespace {

using Lines = std::vector<std::string>;

void add(Lines& all, const std::string& stage, const Lines& warnings,
         const std::string& garment = "") {
  for (const std::string& text : warnings) all.push_back(stage + ": " + garment + text);
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

/// How a garment is worn in one drape, where not as usual.
Lines way_of_wearing(const CaseGarment& garment, const drape::Drape& drape,
                     const body::PosedBody& body) {
  Lines told = drape::risen_waists(garment.mesh(), garment.pattern.pattern, drape.positions, body);
  for (std::string& line : drape::unusual_way_round(garment.mesh(), drape.positions, body))
    told.push_back(std::move(line));
  return told;
}

/// The same in states that count, where the reference state has nothing to tell: what the first of
/// them has, and the names of all.
Lines way_of_wearing_in_states(const CaseResult& result, std::size_t g) {
  Lines first, where;
  for (const CaseState& state : result.wear.states) {
    if (!state.counts()) continue;
    Lines told =
        way_of_wearing(result.garments[g], state.drapes[g], result.body_in(state.id.posture));
    if (told.empty()) continue;
    if (first.empty()) first = std::move(told);
    if (std::ranges::count(where, state.name) == 0) where.push_back(state.name);
  }
  for (std::string& line : first) line += " (in " + join(where) + ")";
  return first;
}

/// How the garments fit, and whether their cloth was measured as far as it is strained.
void add_fit(Lines& all, const CaseResult& result) {
  for (std::size_t g = 0; g < result.garments.size(); ++g) {
    const CaseGarment& garment = result.garments[g];
    const scenario::ScenarioGarment& asked = result.scenario.garments[g];
    Lines told = ease_warnings(station_eases(garment.pattern, asked.spec), garment.maps.load);
    const auto tell = [&told](const Lines& more) {
      told.insert(told.end(), more.begin(), more.end());
    };
    if (result.certificate().worn()) {
      const Lines way = way_of_wearing(garment, garment.drape, result.body.body);
      tell(way.empty() ? way_of_wearing_in_states(result, g) : way);
    }
    tell(comfort_warnings(garment.maps));
    add(all, "fit", told, under(g, result));
    add(all, "material", strain_range_warnings(garment.maps.strain_range, asked.material));
  }
}

void add_certificate(Lines& all, const drape::Certificate& certificate) {
  if (!certificate.settled())
    all.push_back(
        fmt::format("settle: not settled ({}): residual {:.2e}, intersections with the "
                    "body {}, with itself {}",
                    certificate.stop_reason, certificate.residual, certificate.intersections_body,
                    certificate.intersections_self));
  else if (certificate.stable == false)
    all.push_back(
        "settle: not stable: the forces balance, but on a saddle of the energy that was not left; "
        "a touch would send the cloth into other folds");
  if (!certificate.worn()) all.push_back("not worn: " + join(certificate.worn_reasons, "; "));
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
    const std::string where = wear.donnings.size() > 1
                                  ? fmt::format("{} of donning {}", s.name, s.id.donning + 1)
                                  : s.name;
    const drape::Certificate c = s.certificate();
    all.push_back(fmt::format("postures: {} is left out of all statistics: {}", where,
                              s.left_out.empty() ? fmt::format("not settled ({}), residual {:.2e}",
                                                               c.stop_reason, c.residual)
                                                 : s.left_out));
  }
  return all;
}

std::vector<std::string> case_warnings(const CaseResult& result) {
  Lines all = moved_board_warnings(result);
  add(all, "body", result.body.warnings);
  Lines of_donnings = result.wear.warnings;
  std::erase_if(of_donnings, [&](const std::string& text) {
    return std::ranges::count(result.body.warnings, text) > 0;
  });
  add(all, "body", of_donnings);
  add_garments(all, result);
  add_fit(all, result);
  for (const placement::UncoveredSite& site : result.uncovered_sites)
    if (!site.preset)
      all.push_back("placement: site " + site.name + " is not covered by the garment: " + site.why);
  for (const placement::UncoveredSite& line : result.lines_left_out)
    all.push_back("placement: line " + line.name + " is left out: " + line.why);
  add_certificate(all, result.certificate());
  if (const double spacing = result.studied().drape.report.coarsened_field; spacing > 0)
    all.push_back(fmt::format(
        "settle: the field of distances to the skin has a spacing of {:.1f} mm, coarser "
        "than asked for, since the cloth takes up so much room: contact is less exact",
        1e3 * spacing));
  add(all, "settle", result.repeats.warnings);
  if (result.scenario.simulation.repeats > 1 && result.repeats.spread.empty())
    all.push_back("settle: no spread over repeats: it takes two drapes from different starts");
  const Lines states = state_warnings(result);
  all.insert(all.end(), states.begin(), states.end());
  return all;
}

}  // namespace loosefit::pipeline
