#include "loosefit/pipeline/check_worn.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/drape/worn.h"
#include "loosefit/maps/strain_range.h"

namespace loosefit::pipeline {
namespace {

constexpr double kOverstrained = 0.5;  ///< of the area, from which on cloth is torn, not worn

/// Why nobody would get into a garment; nothing where somebody would.
std::vector<std::string> overstrained(const garment::Garment& mesh, const drape::Drape& drape,
                                      const fabric::Material& material) {
  const maps::StrainRange range = maps::strain_range(mesh, drape.positions, material);
  if (range.share_far_beyond <= kOverstrained) return {};
  const auto limit = [&](const maps::DirectionRange& d) {
    return d.limit > 0 ? d.largest / d.limit : 0;
  };
  const bool warp = limit(range.warp) > limit(range.weft);
  const maps::DirectionRange& most = warp ? range.warp : range.weft;
  return {fmt::format(
      "{:.0f} % of the cloth is strained to more than {:g} times what {} was measured for "
      "({} up to {:.0f} % where {:.3g} % are stated): it would tear, or nobody would get into it",
      100 * range.share_far_beyond, maps::kFarBeyond, printable(material.name),
      warp ? "warp" : "weft", 100 * most.largest, 100 * most.limit)};
}

/// Of all garments; those of a garment under the studied one with its number and name.
std::vector<std::string> reasons(const std::vector<drape::Drape>& drapes,
                                 const std::vector<CaseGarment>& garments,
                                 const scenario::Scenario& scenario, const body::PosedBody& body) {
  std::vector<std::string> all;
  for (std::size_t g = 0; g < garments.size(); ++g) {
    const pattern::Pattern& pattern = garments[g].pattern.pattern;
    const bool studied = g + 1 == garments.size(), over_others = g > 0;
    std::vector<std::string> own =
        drape::why_not_worn(garments[g].mesh(), pattern, drapes[g].positions, body, over_others);
    for (const std::string& reason :
         overstrained(garments[g].mesh(), drapes[g], scenario.garments[g].material.material))
      own.push_back(reason);
    for (const std::string& reason : own)
      all.push_back(studied
                        ? reason
                        : fmt::format("under {} ({}): {}", g + 1, printable(pattern.name), reason));
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
