#include "loosefit/validate/validation_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "loosefit/base/control_characters.h"
#include "loosefit/base/version.h"
#include "loosefit/validate/solver_settings.h"

namespace loosefit::validate {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double v : values) list.push_back(number_or_null(v));
  return list;
}

const char* name_of(Finding::Gate gate) {
  switch (gate) {
    case Finding::Gate::relative:
      return "relative";
    case Finding::Gate::absolute:
      return "absolute";
    case Finding::Gate::range:
      return "range";
    case Finding::Gate::reported:
      return "reported";
  }
  return "";
}

Json json_of(const Finding& f) {
  Json j = {{"what", f.what},
            {"unit", f.unit},
            {"expected", number_or_null(f.expected)},
            {"obtained", number_or_null(f.obtained)},
            {"error", number_or_null(f.error())},
            {"gate", name_of(f.gate)},
            {"limit", nullptr},
            {"mesh", f.mesh},
            {"share_of_gate", number_or_null(f.share_of_gate())},
            {"pass", f.pass()},
            {"verdict", name(f.verdict())},
            {"known_miss", nullptr}};
  if (f.gate == Finding::Gate::range)
    j["limit"] = {number_or_null(f.low), number_or_null(f.high)};
  else if (f.gate != Finding::Gate::reported)
    j["limit"] = f.limit;
  if (f.known_miss)
    j["known_miss"] = {{"most", f.known_miss->most}, {"reason", f.known_miss->reason}};
  return j;
}

Json json_of(const report::Plot& plot) {
  Json series = Json::array();
  for (const auto& s : plot.series)
    series.push_back(
        {{"name", s.name}, {"reference", s.reference}, {"x", numbers(s.x)}, {"y", numbers(s.y)}});
  return {{"title", plot.title}, {"x_label", plot.x_label}, {"y_label", plot.y_label},
          {"log_x", plot.log_x}, {"log_y", plot.log_y},     {"series", series}};
}

Json json_of(const BenchmarkOutcome& o) {
  Json findings = Json::array(), plots = Json::array();
  for (const Finding& f : o.result.findings) findings.push_back(json_of(f));
  for (const report::Plot& p : o.result.plots) plots.push_back(json_of(p));
  return {{"id", o.id},
          {"title", o.title},
          {"reference", o.reference},
          {"gated", o.gated()},
          {"verdict", name(o.verdict())},
          {"pass", is_as_stated(o.verdict())},
          {"seconds", o.seconds},
          {"error", o.error.empty() ? Json(nullptr) : Json(o.error)},
          {"findings", findings},
          {"notes", o.result.notes},
          {"plots", plots}};
}

}  // namespace

std::string validation_json(const Validation& validation) {
  Json libraries, settings, list = Json::array();
  for (const auto& [library, number] : versions()) libraries[library] = number;
  for (const auto& [what, how] : solver_settings()) settings[what] = how;
  for (const auto& outcome : validation.outcomes) list.push_back(json_of(outcome));
  const Json all = {{"effort", validation.effort == Effort::quick ? "quick" : "full"},
                    {"pass", validation.as_stated()},
                    {"gated", validation.gated()},
                    {"passed", validation.count(Verdict::pass)},
                    {"known_misses", validation.count(Verdict::known_miss)},
                    {"unexpected_passes", validation.count(Verdict::unexpected_pass)},
                    {"missed", validation.count(Verdict::miss)},
                    {"seconds", validation.seconds},
                    {"settings", settings},
                    {"benchmarks", list},
                    {"versions", libraries}};
  return json_without_controls(all.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string benchmarks_json(const std::vector<Benchmark>& list) {
  Json entries = Json::array();
  for (const Benchmark& b : list)
    entries.push_back(
        {{"id", b.id}, {"title", b.title}, {"reference", b.reference}, {"in_quick", b.in_quick}});
  return Json{{"benchmarks", entries}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace loosefit::validate
