#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/kinds/kind.h"
#include "loosefit/pattern/pattern.h"
#include "loosefit/pipeline/fit_along.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::pipeline {

/// Ease from which on a garment is meant to be loose [–].
inline constexpr double kLooseEase = 0.05;

/// Stage "pattern": the flat pieces and how they fit this body.
struct CasePattern {
  pattern::Pattern pattern;
  std::vector<kinds::FitLevel> levels;   ///< of fit, in the order of the kind
  std::map<std::string, double> girths;  ///< of the garment per level [m]: chest, waist, hip, …
  std::map<std::string, double> fit;     ///< BGM per level, garment girth / body girth − 1
  std::vector<kinds::FitStation> girths_along;  ///< of the pieces; empty: the kind cannot tell
  std::vector<StationFit> fit_along;            ///< of these on the body
  std::vector<std::string> warnings;  ///< of reading a pattern file, or of adapting the draft
};

/// The draft of a garment without a file for a body of these measures, for scenarios and for the
/// command line alike. What nobody asked for gives way: the names `wished.adapt` of the fit, and
/// measures that are not in `asked` ("measures.neck", …). A size brings measures and fit of its
/// own.
kinds::DraftedGarment draft_garment(const scenario::GarmentSpec& wished,
                                    const kinds::BodyMeasures& measures,
                                    const std::set<std::string>& asked = {});

/// Drafts the garment to the body's measures and the wished fit, or to a garment size, or reads the
/// pattern file. \throws InvalidInput, GeometryError for what cannot be drafted or sewn.
/// \param girths of the same person (kinds/girths_along.h); without them drafts follow the levels
/// of fit alone, and no station is known.
CasePattern make_pattern(const scenario::GarmentSpec& wished, const body::Body& body,
                         const kinds::GirthsAlong& girths = {});

}  // namespace loosefit::pipeline
