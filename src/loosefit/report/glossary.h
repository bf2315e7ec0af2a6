#pragma once
#include <string>
#include <vector>

namespace loosefit::report {

/// A word of the report that is no map, and what it means; unit and source are in the text.
struct GlossaryTerm {
  std::string id;     ///< of its place on the page: "residual"
  std::string title;  ///< "Residual"
  std::string meaning;
};

/// All of them, in the order of the report. Sections link to them with defined() (html.h).
const std::vector<GlossaryTerm>& glossary();

}  // namespace loosefit::report
