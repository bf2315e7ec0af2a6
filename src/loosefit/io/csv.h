#pragma once
#include <string>
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
CsvFields csv_fields(const std::string& line, char separator = ',');

/// A table of a spreadsheet.
struct CsvTable {
  struct Row {
    int line = 0;  ///< of the file
    std::vector<std::string> fields;
  };
  std::vector<Row> rows;  ///< the first one holds the names of the columns
  char separator = ',';
};

/// Reads a table whatever a spreadsheet has made of it: commas, semicolons or tabs between the
/// fields, told by the first line or by the line "sep=;" that Excel takes; lines that end in LF, CR
/// LF or CR; blanks round fields. Lines with nothing in them are left out. `text` is UTF-8
/// (io/text_file.h: read_plain_text). \throws InvalidInput with the line of a quote that is not
/// closed, and for another kind of file (io/file_kind.h).
CsvTable read_csv(const std::string& text, const std::string& file);

/// Hint for a row that has not as many fields as the first one; empty without one.
std::string row_hint(const CsvTable& table, const CsvTable::Row& row);

}  // namespace loosefit::io
