#pragma once
#include <string>
#include <vector>

namespace loosefit::io {

/// One field of a CSV line (RFC 4180): quoted where it must be. Control characters, line ends
/// included, and bytes that are not UTF-8 are escaped as terminal_line does (`\x1b`), so that every
/// record is one line and a file can be shown on a terminal.
std::string csv_field(const std::string& text);
/// Shortest text that reads back to the same number; empty when it is not finite.
std::string csv_field(double value);
/// Fields with commas between them and a line end; empty ones keep their place.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace loosefit::io
