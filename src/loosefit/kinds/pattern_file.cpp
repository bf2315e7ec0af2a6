#include "loosefit/kinds/pattern_file.h"

namespace loosefit::kinds {

GarmentKind pattern_file() {
  GarmentKind kind;
  kind.name = pattern::Pattern{}.kind;
  kind.title = "pattern file";
  kind.levels = [](const pattern::Pattern&, const NamedValues&, const NamedValues&) {
    return std::vector<FitLevel>{};
  };
  kind.note_parts = [](pattern::Pattern&) { return false; };
  return kind;
}

}  // namespace loosefit::kinds
