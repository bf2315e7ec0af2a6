#include "loosefit/io/csv.h"

#include <cmath>

#include "loosefit/base/text.h"

namespace loosefit::io {

std::string csv_field(const std::string& raw) {
  const std::string text = terminal_line(raw);
  if (text.find_first_of(",\"") == std::string::npos) return text;
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

}  // namespace loosefit::io
