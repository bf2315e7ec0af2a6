#include "loosefit/study/check_worn.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/drape/worn.h"

namespace loosefit {
namespace {

/// Of all garments, the innermost first; `drape_under(l)` is that of a garment under the studied.
template <class DrapeUnder>
std::vector<std::string> reasons(const CaseResult& result, const Drape& drape,
                                 const DrapeUnder& drape_under, const Body& body) {
  std::vector<std::string> all;
  for (std::size_t l = 0; l < result.under.size(); ++l) {
    const CaseUnder& under = result.under[l];
    for (const std::string& text :
         why_not_worn(under.mesh(), under.pattern.pattern, drape_under(l).positions, body, l > 0))
      all.push_back(
          fmt::format("under {} ({}): {}", l + 1, printable(under.pattern.pattern.name), text));
  }
  const auto own = why_not_worn(result.mesh(), result.pattern.pattern, drape.positions, body,
                                !result.under.empty());
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace

void check_worn(CaseResult& result) {
  std::vector<std::string> found = reasons(
      result, result.drape, [&](std::size_t l) -> const Drape& { return result.under[l].drape; },
      result.body.body);
  for (CaseUnder& under : result.under) under.drape.certificate.worn_reasons = found;
  result.drape.certificate.worn_reasons = std::move(found);
}

void check_worn(const CaseResult& result, CaseState& state) {
  if (!state.drape.certificate.settled()) return;
  const Body& body = state.posture == 0 ? result.body.body : *result.wear.bodies[state.posture];
  auto& found = state.drape.certificate.worn_reasons;
  found = reasons(
      result, state.drape, [&](std::size_t l) -> const Drape& { return state.under[l]; }, body);
  const auto as_before = [&](const auto& layer, const Drape& now) {
    return worn_alike(layer.mesh(), layer.pattern.pattern, now.positions, body,
                      layer.drape.positions, result.body.body);
  };
  bool same = as_before(result, state.drape);
  for (std::size_t l = 0; l < result.under.size(); ++l)
    same = same && as_before(result.under[l], state.under[l]);
  if (!same && found.empty())
    found.push_back(
        "a limb or the trunk has left the opening it went through, or gone through the cloth");
  for (Drape& under : state.under) under.certificate.worn_reasons = found;
  if (!found.empty()) state.left_out = "not worn: " + join(found, "; ");
}

}  // namespace loosefit
