#include "loosefit/pipeline/check_worn.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/drape/worn.h"

namespace loosefit::pipeline {
namespace {

/// Of all garments; those of a garment under the studied one with its number and name.
std::vector<std::string> reasons(const std::vector<drape::Drape>& drapes,
                                 const std::vector<CaseGarment>& garments,
                                 const body::PosedBody& body) {
  std::vector<std::string> all;
  for (std::size_t g = 0; g < garments.size(); ++g) {
    const pattern::Pattern& pattern = garments[g].pattern.pattern;
    const bool studied = g + 1 == garments.size(), over_others = g > 0;
    for (const std::string& reason :
         drape::why_not_worn(garments[g].mesh(), pattern, drapes[g].positions, body, over_others))
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
                                     const body::PosedBody& body) {
  const std::vector<std::string> found = reasons(drapes, garments, body);
  return with_reasons(std::move(drapes), found);
}

std::vector<drape::Drape> check_worn(std::vector<drape::Drape> drapes, const body::PosedBody& body,
                                     const CaseResult& reference) {
  std::vector<std::string> found = reasons(drapes, reference.garments, body);
  if (found.empty() && !worn_as_in_reference(drapes, body, reference))
    found.push_back(
        "a limb or the trunk has left the opening it went through, or gone through the cloth");
  return with_reasons(std::move(drapes), found);
}

CaseState check_worn(CaseState state, const body::PosedBody& body, const CaseResult& reference) {
  if (!state.certificate().settled()) return state;
  state.drapes = check_worn(std::move(state.drapes), body, reference);
  if (const drape::Certificate c = state.certificate(); !c.worn())
    state.left_out = "not worn: " + join(c.worn_reasons, "; ");
  return state;
}

}  // namespace loosefit::pipeline
