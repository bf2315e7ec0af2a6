#include "loosefit/pipeline/case_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/text.h"
#include "loosefit/drape/worn.h"
#include "loosefit/pipeline/case_ease.h"
#include "loosefit/pipeline/case_sewn_parts.h"

namespace loosefit::pipeline {
namespace {

using Lines = std::vector<std::string>;

void add(Lines& all, const std::string& stage, const Lines& warnings) {
  for (const std::string& text : warnings) all.push_back(stage + ": " + text);
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

/// How the studied garment fits, and whether its cloth was measured as far as it is strained.
void add_fit(Lines& all, const CaseResult& result) {
  const CaseGarment& studied = result.studied();
  const scenario::ScenarioGarment& asked = result.scenario.studied();
  add(all, "fit", ease_warnings(station_eases(studied.pattern, asked.spec), studied.maps.load));
  if (studied.drape.certificate.worn())
    add(all, "fit",
        drape::risen_waists(studied.mesh(), studied.pattern.pattern, studied.drape.positions,
                            result.body.body));
  add(all, "fit", comfort_warnings(studied.maps));
  for (std::size_t g = 0; g < result.garments.size(); ++g)
    add(all, "material",
        strain_range_warnings(result.garments[g].maps.strain_range,
                              result.scenario.garments[g].material));
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
