#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit {

/// Stage "pattern": the flat pieces and how they fit this body.
struct CasePattern {
  Pattern pattern;
  std::map<std::string, double> girths;  ///< of the garment per level [m]: chest, waist, hip, …
  std::map<std::string, double> fit;     ///< BGM per level, garment girth / body girth − 1
  std::vector<std::string> warnings;     ///< of reading a pattern file
};

/// Drafts the shirt to the body's measures and the wished fit, or to a garment size, or reads the
/// pattern file. \throws InvalidInput, GeometryError for what cannot be drafted or sewn.
CasePattern make_pattern(const ScenarioGarment& wished, const Body& body);

/// What the shirt draft needs to know of a body. \throws InvalidInput naming a missing measure.
ShirtMeasures shirt_measures(const Body& body);

}  // namespace loosefit
