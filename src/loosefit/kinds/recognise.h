#pragma once
#include <string>

#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// What is found out about the kind of a pattern that was read from a file.
enum class Recognised {
  yes,            ///< Pattern::kind and the parts of panels and edges are noted
  no,             ///< a garment of somebody else
  unknown_draft,  ///< its mark is that of no draft known here
  sewn_otherwise  ///< it has the mark of a draft, but is not sewn like it
};

/// Which draft made a pattern: by the mark that our writer leaves in files (`mark`, may be empty),
/// or by the names of all of its parts in files of versions that wrote none. Only what is still
/// sewn like the draft counts.
Recognised recognise_kind(pattern::Pattern& pattern, const std::string& mark);

/// Mark of the draft that made the pattern (GarmentKind::mark) when every piece and edge is still
/// sewn like the part it is noted as; empty otherwise.
std::string draft_mark(const pattern::Pattern& pattern);

}  // namespace loosefit::kinds
