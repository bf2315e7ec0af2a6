#include "loosefit/report/result_text.h"

#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/text.h"
#include "loosefit/pipeline/check_worn.h"

namespace loosefit::report {
namespace {

std::string number_or_dash(double value) {
  return std::isnan(value) ? fmt::format("{:>10}", "-") : fmt::format("{:10.4g}", value);
}

std::string certificate_text(const pipeline::CaseResult& result) {
  const drape::Certificate& certificate = result.certificate();
  std::string text =
      fmt::format("{}: residual {:.2e}, intersections body {} self {} ({})\n",
                  certificate.settled() ? "settled" : "NOT SETTLED", certificate.residual,
                  certificate.intersections_body, certificate.intersections_self,
                  terminal_line(certificate.stop_reason));
  const maps::StrainRange& range = result.studied().maps.strain_range;
  if (!range.crushed.empty() || !range.torn.empty())
    text += fmt::format("{} triangles are crushed and {} torn: read no strain there\n",
                        range.crushed.size(), range.torn.size());
  if (certificate.stable == false) text += "NOT STABLE: at rest on a saddle of the energy\n";
  if (!certificate.worn())
    text += fmt::format("NOT WORN: {}\n", terminal_line(join(certificate.worn_reasons, "; ")));
  else
    text += "worn: " + pipeline::what_worn_says(result) + "\n";
  text += "can be put on: " + terminal_line(pipeline::putting_on_verdict(result.putting_on)) + "\n";
  if (const auto& unsettled = result.studied().drape.unsettled)
    text += fmt::format("because {}\nhint: {}\n", terminal_line(unsettled->why),
                        terminal_line(unsettled->hint));
  return text;
}

/// The same sentences as on the first screen of the page.
std::string answer_text(const std::vector<pipeline::Answer>& answers) {
  std::string text;
  for (const pipeline::Answer& answer : answers)
    text += fmt::format("{}: {}\n", terminal_line(answer.sensor), terminal_line(answer.text()));
  return text;
}

std::string map_table(const std::vector<pipeline::CaseMap>& maps) {
  if (maps.empty()) return {};
  std::string text = fmt::format("{:24} {:>10} {:>10} {:>10}\n", "map", "p5", "median", "p95");
  for (const pipeline::CaseMap& map : maps)
    text += fmt::format("{:24} {} {} {}\n", map.map.array, number_or_dash(map.overall.p5),
                        number_or_dash(map.overall.median), number_or_dash(map.overall.p95));
  return text;
}

std::string load_text(const pipeline::CaseMaps& maps) {
  if (!maps.load) return {};
  const maps::BodyLoad& load = *maps.load;
  const double squeezed = load.weight > 0 ? load.between_arm_and_trunk / load.weight : 0;
  return fmt::format(
      "normal force {:.3g} N: {:.3g} times the weight, {:.3g} of it squeezed between arm and "
      "trunk; "
      "within 1 mm of the skin {:.0f} %\n",
      load.normal_force, load.force_over_weight(), squeezed, 100 * load.near_share[1]);
}

std::string timings(const pipeline::CaseResult& result) {
  double total = 0;
  std::string stages;
  for (const StageClock::Entry& entry : result.seconds) {
    stages += fmt::format("{} {:.1f}  ", entry.stage, entry.seconds);
    total += entry.seconds;
  }
  return fmt::format("seconds: {}total {:.1f}; peak memory {:.0f} MB\n", stages, total,
                     result.peak_memory_mb);
}

}  // namespace

std::string result_text(const pipeline::CaseResult& result) {
  std::string text;
  for (const std::string& warning : result.warnings)
    text += fmt::format("warning: {}\n", terminal_line(warning));
  text += answer_text(result.answers) + certificate_text(result);
  for (const auto& [level, mobility] : result.studied().pattern.fit)
    text += fmt::format("fit {:8} {:+.3f}\n", terminal_line(level), mobility);
  text += load_text(result.studied().maps);
  text += map_table(result.studied().maps.maps);
  if (result.sealed()) text += "sealed: no maps; see log.jsonl, or use --allow-unsettled\n";
  return text + timings(result);
}

}  // namespace loosefit::report
