#include "loosefit/pipeline/check_worn.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/text.h"
#include "loosefit/drape/hood_seam.h"
#include "loosefit/drape/limb_lines.h"
#include "loosefit/drape/putting_on.h"
#include "loosefit/drape/worn.h"
#include "loosefit/maps/strain_range.h"

namespace loosefit::pipeline {
namespace {

/// Where a garment would tear, or nobody would get into it; nothing where neither is so.
std::vector<std::string> overstrained(const garment::Garment& mesh, const pattern::Pattern& pattern,
                                      const std::vector<Vec3>& positions,
                                      const fabric::Material& material,
                                      const body::PosedBody& body) {
  std::vector<std::string> found =
      drape::overstretched_rims(drape::garment_rims(mesh, pattern, body), positions, material);
  for (const maps::TornRegion& torn : maps::torn_regions(mesh, positions, material, body))
    found.push_back(fmt::format(
        "{:.0f} % of the cloth at {} is strained beyond what {} bears ({} up to {:.0f} % where it "
        "bears {:.3g} %): it would tear, or nobody would get into it",
        100 * torn.share, torn.name, printable(material.name), torn.is_warp ? "warp" : "weft",
        100 * torn.largest, 100 * torn.limit));
  return found;
}

/// Whether a neck went over no head. In a hood the head is not through the opening.
bool head_is_outside(const CaseGarment& garment, const body::PosedBody& body) {
  const std::vector<drape::Opening> openings =
      drape::garment_openings(garment.mesh(), garment.pattern.pattern, body);
  const drape::LimbLines lines = drape::limb_lines(body);
  if (lines[drape::kHead].empty()) return false;
  return std::ranges::any_of(openings, [&](const drape::Opening& o) {
    return o.use == kinds::OpeningUse::neck &&
           drape::limbs_through_openings(o.loop, garment.drape.positions, lines) ==
               drape::kRoundNothing &&
           drape::hood_seam(garment.mesh(), openings, o).empty();
  });
}

/// What is said of a garment, with its number and name where it is under the studied one.
std::string of_garment(const std::string& said, std::size_t g,
                       const std::vector<CaseGarment>& garments) {
  if (g + 1 == garments.size()) return said;
  return fmt::format("under {} ({}): {}", g + 1, printable(garments[g].pattern.pattern.name), said);
}

/// Of all garments.
std::vector<std::string> reasons(const std::vector<drape::Drape>& drapes,
                                 const std::vector<CaseGarment>& garments,
                                 const scenario::Scenario& scenario, const body::PosedBody& body) {
  std::vector<std::string> all;
  for (std::size_t g = 0; g < garments.size(); ++g) {
    const pattern::Pattern& pattern = garments[g].pattern.pattern;
    const bool over_others = g > 0;
    std::vector<std::string> own =
        drape::why_not_worn(garments[g].mesh(), pattern, drapes[g].positions, body, over_others);
    for (const std::string& reason : overstrained(garments[g].mesh(), pattern, drapes[g].positions,
                                                  scenario.garments[g].material.material, body))
      own.push_back(reason);
    if (drapes[g].certificate.reason == drape::StopReason::slides_down)
      own.push_back("it slides down the body and nothing holds it");
    for (const std::string& reason : own) all.push_back(of_garment(reason, g, garments));
  }
  return all;
}

std::vector<drape::Drape> with_reasons(std::vector<drape::Drape> drapes,
                                       const std::vector<std::string>& found) {
  for (drape::Drape& drape : drapes) drape.certificate.worn_reasons = found;
  return drapes;
}

/// Whether unusual openings have the limbs through them that they have in the reference state.
bool worn_as_in_reference(const std::vector<drape::Drape>& drapes, const body::PosedBody& body,
                          const CaseResult& reference) {
  for (std::size_t g = 0; g < reference.garments.size(); ++g) {
    const CaseGarment& garment = reference.garments[g];
    if (!drape::worn_alike(garment.mesh(), garment.pattern.pattern, drapes[g].positions, body,
                           garment.drape.positions, reference.body.body))
      return false;
  }
  return true;
}

}  // namespace

std::vector<drape::Drape> check_worn(std::vector<drape::Drape> drapes,
                                     const std::vector<CaseGarment>& garments,
                                     const scenario::Scenario& scenario,
                                     const body::PosedBody& body) {
  const std::vector<std::string> found = reasons(drapes, garments, scenario, body);
  return with_reasons(std::move(drapes), found);
}

std::vector<drape::Drape> check_worn(std::vector<drape::Drape> drapes, const body::PosedBody& body,
                                     const CaseResult& reference) {
  std::vector<std::string> found = reasons(drapes, reference.garments, reference.scenario, body);
  if (found.empty() && !worn_as_in_reference(drapes, body, reference))
    found.push_back(
        "a limb or the trunk has left the opening it went through, or gone through the cloth");
  return with_reasons(std::move(drapes), found);
}

PuttingOn judge_putting_on(const std::vector<CaseGarment>& garments,
                           const scenario::Scenario& scenario, const body::PosedBody& body) {
  const body::PassingGirths girths = body::passing_girths(body);
  PuttingOn all{.possible = true, .reasons = {}};
  for (std::size_t g = 0; g < garments.size(); ++g) {
    const pattern::Pattern& pattern = garments[g].pattern.pattern;
    const drape::PuttingOn one =
        drape::putting_on(drape::garment_rims(garments[g].mesh(), pattern, body), girths,
                          scenario.garments[g].material.material);
    const std::optional<bool> possible = one.possible();
    if (possible == false || (all.possible == true && !possible)) all.possible = possible;
    for (const std::string& reason : one.reasons())
      all.reasons.push_back(of_garment(reason, g, garments));
  }
  return all;
}

void doubt_putting_on(CaseResult& result) {
  for (std::size_t g = 0; g < result.garments.size(); ++g) {
    const CaseGarment& garment = result.garments[g];
    const body::PosedBody& body = result.body.body;
    std::vector<std::string> shown =
        overstrained(garment.mesh(), garment.pattern.pattern, garment.drape.positions,
                     result.scenario.garments[g].material.material, body);
    if (head_is_outside(garment, body)) shown.push_back("the head is not through the neck opening");
    if (shown.empty()) continue;
    if (result.putting_on.possible == true) result.putting_on.possible = std::nullopt;
    for (const std::string& reason : shown)
      result.putting_on.reasons.push_back(of_garment("as draped, " + reason, g, result.garments));
  }
}

std::string putting_on_verdict(const PuttingOn& putting_on) {
  if (putting_on.possible == true) return "yes";
  if (putting_on.reasons.empty()) return "not asked";
  return (putting_on.possible ? "not without a fastening: " : "not judged: ") +
         join(putting_on.reasons, "; ");
}

std::string what_worn_says(const CaseResult& result) {
  if (result.body.body->joints.empty())
    return "as far as a body without joints tells: the garment touches the skin";
  for (const CaseGarment& garment : result.garments)
    if (!drape::unjudged_openings(garment.mesh(), garment.pattern.pattern, garment.drape.positions,
                                  result.body.body)
             .empty())
      return "as far as it is known what its openings are for: see the warnings";
  return "every limb goes through its opening, and no opening has left its place";
}

CaseState check_worn(CaseState state, const body::PosedBody& body, const CaseResult& reference) {
  if (!state.draped()) return state;
  state.drapes = check_worn(std::move(state.drapes), body, reference);
  if (const drape::Certificate c = state.certificate(); c.settled() && !c.worn())
    state.left_out = "not worn: " + join(c.worn_reasons, "; ");
  return state;
}

}  // namespace loosefit::pipeline
