#pragma once
#include <string>

namespace loosefit {

/// Text that may come from a file, as one line that a terminal can be given: valid UTF-8 stays,
/// control characters (ESC, newline, those of Latin-1) and bytes that are no UTF-8 become \xNN.
std::string one_line(const std::string& text);

}  // namespace loosefit
