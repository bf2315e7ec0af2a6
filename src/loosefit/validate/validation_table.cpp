#include "loosefit/validate/validation_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/text.h"

namespace loosefit::validate {
namespace {

std::string measure(double value, const Finding& f) {
  if (!std::isfinite(value)) return "not a number";
  if (f.gate != Finding::Gate::relative) {
    const std::string text = fmt::format("{:.3g}", value);
    return f.unit.empty() ? text : text + " " + f.unit;
  }
  return 100 * value >= 1e-3 || value == 0 ? fmt::format("{:.2g} %", 100 * value)
                                           : fmt::format("{:.1e}", value);
}

/// Display width of UTF-8 text whose characters are all one column wide.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string space(width - std::min(width, columns(text)), ' ');
  return left ? text + space : space + text;
}

}  // namespace

std::string error_text(const Finding& f) { return measure(f.error(), f); }

std::string gate_text(const Finding& f) {
  return f.gate == Finding::Gate::reported ? "reported" : measure(f.limit, f);
}

std::string verdict_text(const Finding& f) {
  if (!f.pass()) return "MISS";
  return f.gate == Finding::Gate::reported ? "-" : "pass";
}

std::string outcome_table(const BenchmarkOutcome& o) {
  std::string text =
      fmt::format("{} {}: {}, {:.1f} s\n", o.id, o.title, o.pass() ? "pass" : "MISS", o.seconds);
  if (!o.error.empty()) text += fmt::format("  error: {}\n", o.error);
  if (o.result.findings.empty()) return text;
  std::vector<std::vector<std::string>> rows = {
      {"figure", "expected", "obtained", "error", "gate", "", "mesh"}};
  for (const Finding& f : o.result.findings) {
    const std::string unit = f.unit.empty() ? "" : " [" + f.unit + "]";
    rows.push_back({f.what + unit, fmt::format("{:.6g}", f.expected),
                    fmt::format("{:.6g}", f.obtained), error_text(f), gate_text(f), verdict_text(f),
                    f.mesh});
  }
  std::vector<std::size_t> width(rows[0].size(), 0);
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], columns(row[k]));
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k)
      line += "  " + padded(row[k], width[k], k == 0 || k >= 5);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string verdict_line(const Validation& validation) {
  std::vector<std::string> missed;
  for (const auto& o : validation.outcomes)
    if (!o.pass()) missed.push_back(o.id);
  return fmt::format("{} of {} gated benchmarks pass{}", validation.passed(), validation.gated(),
                     missed.empty() ? "" : "; missed: " + join(missed));
}

}  // namespace loosefit::validate
