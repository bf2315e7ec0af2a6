#include "loosefit/io/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "loosefit/base/text.h"

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

CsvFields csv_fields(const std::string& line) {
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
    } else if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) field = without_guard(field);
  return {std::move(fields), !quoted};
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.substr(text.starts_with(kMark) ? kMark.size() : 0);
}

}  // namespace loosefit::io
