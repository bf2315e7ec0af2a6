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
  if (value >= 1) return fmt::format("{:.0f} %", 100 * value);
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

std::string error_text(const Finding& f) {
  const bool nothing_to_miss = f.gate == Finding::Gate::reported && std::isnan(f.expected);
  return nothing_to_miss ? "-" : measure(f.error(), f);
}

std::string gate_text(const Finding& f) {
  if (f.gate == Finding::Gate::reported) return "reported";
  if (f.gate != Finding::Gate::range) return measure(f.limit, f);
  const std::string unit = f.unit.empty() ? "" : " " + f.unit;
  if (!std::isfinite(f.low)) return fmt::format("at most {:.4g}{}", f.high, unit);
  if (!std::isfinite(f.high)) return fmt::format("at least {:.4g}{}", f.low, unit);
  return fmt::format("{:.4g} to {:.4g}{}", f.low, f.high, unit);
}

std::string expected_text(const Finding& f, int digits) {
  return std::isfinite(f.expected) ? fmt::format("{:.{}g}", f.expected, digits) : "-";
}

std::string known_miss_text(const Finding& f) {
  if (!f.known_miss) return "";
  return fmt::format("{}: known to miss by up to {}: {}", f.what, measure(f.known_miss->most, f),
                     f.known_miss->reason);
}

std::string outcome_table(const BenchmarkOutcome& o) {
  std::string text =
      fmt::format("{} {}: {}, {:.1f} s\n", o.id, o.title, name(o.verdict()), o.seconds);
  if (!o.error.empty()) text += fmt::format("  error: {}\n", o.error);
  if (o.result.findings.empty()) return text;
  std::vector<std::vector<std::string>> rows = {
      {"figure", "expected", "obtained", "error", "gate", "", "mesh"}};
  for (const Finding& f : o.result.findings) {
    const std::string unit = f.unit.empty() ? "" : " [" + f.unit + "]";
    rows.push_back({f.what + unit, expected_text(f, 6), fmt::format("{:.6g}", f.obtained),
                    error_text(f), gate_text(f), name(f.verdict()), f.mesh});
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
  for (const Finding& f : o.result.findings)
    if (f.known_miss) text += "  " + known_miss_text(f) + "\n";
  return text;
}

std::string verdict_line(const Validation& validation) {
  std::string text = fmt::format("{} of {} gated benchmarks pass", validation.count(Verdict::pass),
                                 validation.gated());
  const auto add = [&](Verdict verdict, const char* heading) {
    std::vector<std::string> ids;
    for (const auto& o : validation.outcomes)
      if (o.verdict() == verdict) ids.push_back(o.id);
    if (!ids.empty()) text += std::string("; ") + heading + ": " + join(ids);
  };
  add(Verdict::known_miss, "known misses");
  add(Verdict::unexpected_pass, "stated to miss, but pass");
  add(Verdict::miss, "missed");
  return text;
}

}  // namespace loosefit::validate
