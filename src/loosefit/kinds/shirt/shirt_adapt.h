#pragma once
#include <set>
#include <string>
#include <vector>

#include "loosefit/kinds/shirt/shirt_draft.h"

namespace loosefit::kinds {

/// A value that gave way.
struct ShirtChange {
  std::string key;               ///< "fit.scye_ease", "measures.neck", …
  double before = 0, after = 0;  ///< wished and drafted, in the unit of the key
  std::string reason;            ///< what would otherwise be, as a clause
  /// "fit.sleeve: 0.2 instead of 0.4, since otherwise …"
  std::string told() const;
};

/// A shirt and what it was drafted from.
struct AdaptedShirt {
  pattern::Pattern pattern;
  ShirtMeasures measures;
  ShirtFit fit;
  ShirtDraftReport report;
  std::vector<ShirtChange> changes;  ///< every value that differs from the wished one, visibly
};

/// The shirt of these measures and this fit where it can be drafted: then exactly draft_shirt.
/// Otherwise values that nobody asked for give way, by no more than the draft needs, so that the
/// shirt changes steadily with the body: those of the fit first (sleeve, wrist, neck_ease,
/// scye_ease, shoulder_follow, sleeve_length; girths of the trunk never), then measures, if no fit
/// that was asked for stands against them.
/// `yielding`: what may give way, "fit.sleeve_length", "measures.neck", …
/// \throws InvalidInput for what still cannot be drafted, naming a value that was asked for.
AdaptedShirt draft_adapted_shirt(const ShirtMeasures& measures, const ShirtFit& fit,
                                 const std::set<std::string>& yielding);

}  // namespace loosefit::kinds
