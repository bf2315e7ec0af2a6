#include "loosefit/kinds/pattern_file.h"

namespace loosefit {

GarmentKind pattern_file() {
  GarmentKind kind;
  kind.name = Pattern{}.kind;
  kind.title = "pattern file";
  kind.levels = [](const Pattern&, const NamedValues&, const NamedValues&) {
    return std::vector<FitLevel>{};
  };
  kind.note_parts = [](Pattern&) { return false; };
  return kind;
}

}  // namespace loosefit
