#pragma once
#include <string>

namespace loosefit {

/// Says on standard error, even to those who want it quiet, that files of `folder` were moved to
/// its folder `aside`; nothing when that is empty.
void note_what_was_set_aside(const std::string& folder, const std::string& aside);

}  // namespace loosefit
