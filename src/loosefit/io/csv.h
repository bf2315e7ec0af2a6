#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace loosefit::io {

/// One field of a CSV line (RFC 4180): quoted where it must be. Control characters, line ends
/// included, and bytes that are not UTF-8 are escaped as terminal_line does (`\x1b`), so that every
/// record is one line and a file can be shown on a terminal. A text that a spreadsheet would take
/// for a formula (= + - @ at its begin) is led by an apostrophe, unless it is a number.
std::string csv_field(const std::string& text);
/// Shortest text that reads back to the same number; empty when it is not finite.
std::string csv_field(double value);
/// Fields with commas between them and a line end; empty ones keep their place.
std::string csv_line(const std::vector<std::string>& fields);

/// Fields of one line (RFC 4180): one in quotes may hold commas and doubled quotes; the apostrophe
/// before what looks like a formula is taken off. Of a line with a quote that is not closed
/// `closed` is false, and the last field is the one it stands in.
struct CsvFields {
  std::vector<std::string> fields;
  bool closed = true;
};
CsvFields csv_fields(const std::string& line);

/// Text without the byte order mark that spreadsheets put before UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace loosefit::io
