#include "loosefit/io/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/file_kind.h"

namespace loosefit::io {
namespace {

constexpr char kGuard = '\'';

/// Whether a spreadsheet would begin to compute here: OWASP, CSV injection. The wide forms of the
/// signs count too, blanks before them do not.
bool begins_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  for (const std::string_view sign : {"=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20"})
    if (text.starts_with(sign)) return true;
  return false;
}

bool is_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

/// The text behind guards: one is taken off when the field is read, so those of its own count.
std::string_view unguarded(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kGuard), text.size()));
  return text;
}

std::string guarded(const std::string& text) {
  return begins_formula(unguarded(text)) && !is_number(text) ? kGuard + text : text;
}

std::string without_guard(const std::string& field) {
  return field.starts_with(kGuard) && begins_formula(unguarded(field)) ? field.substr(1) : field;
}

}  // namespace

std::string csv_field(const std::string& raw) {
  const std::string text = guarded(terminal_line(raw));
  // Where a comma is the decimal point, spreadsheets part cells at semicolons.
  if (text.find_first_of(",;\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_field(double value) {
  return std::isfinite(value) ? shortest(value) : std::string();
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) line += (i > 0 ? "," : "") + fields[i];
  return line + "\n";
}

CsvFields csv_fields(const std::string& line, char separator) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted) {
      if (c != '"')
        fields.back() += c;
      else if (i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[i++];
      else
        quoted = false;
    } else if (c == '"' && fields.back().empty()) {
      quoted = true;
    } else if (c == separator) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) field = without_guard(field);
  return {std::move(fields), !quoted};
}

namespace {

/// Name of a column by its number from 1; empty where the table has none.
std::string column_of(const CsvTable& table, std::size_t number) {
  if (table.rows.empty() || number > table.rows[0].fields.size()) return {};
  return printable(table.rows[0].fields[number - 1]);
}

}  // namespace

CsvTable read_csv(const std::string& text, const std::string& file) {
  refuse_other_kinds(text, file, "a table (CSV)");
  CsvTable table;
  bool told = false;
  std::size_t at = 0;
  for (int number = 1; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    if (!told && line.size() == 5 && line.starts_with("sep=")) {
      table.separator = line[4];
      told = true;
      continue;
    }
    if (!told && line.find_first_not_of(" \t") != std::string::npos) {
      // Names of columns have none of these; a semicolon stands where commas are decimal.
      for (const char known : {'\t', ';', ','}) {
        table.separator = known;
        if (line.find(known) != std::string::npos) break;
      }
      told = true;
    }
    CsvFields read = csv_fields(line, table.separator);
    if (!read.closed)
      throw InvalidInput({file, number, column_of(table, read.fields.size())},
                         "a quote that is not closed", "a closing quote on the same line");
    bool empty = true;
    for (std::string& field : read.fields) {
      const auto first = field.find_first_not_of(" \t"), last = field.find_last_not_of(" \t");
      field = first == std::string::npos ? "" : field.substr(first, last - first + 1);
      empty = empty && field.empty();
    }
    if (!empty) table.rows.push_back({number, std::move(read.fields)});
  }
  return table;
}

std::string row_hint(const CsvTable& table, const CsvTable::Row& row) {
  if (table.rows.empty() || row.fields.size() <= table.rows[0].fields.size()) return {};
  return table.separator == ','
             ? "a comma in a number or a text parts it: put it in quotes, or save the table with "
               "semicolons, or with points in its numbers"
             : "";
}

}  // namespace loosefit::io
