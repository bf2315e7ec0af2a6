#include "loosefit/io/scenario.h"

namespace loosefit {
namespace {

/// Keys of the stages, by their beginning, and how the scenario calls them.
std::string scenario_key(const std::string& key, const Scenario& scenario) {
  for (std::size_t i = 0; i < scenario.attachments.size(); ++i) {
    const std::string start = "attachment " + scenario.attachments[i].name;
    if (key.starts_with(start))
      return "attachment[" + std::to_string(i) + "]" + key.substr(start.size());
  }
  if (key.starts_with("fit.")) return "garment." + key;
  if (key.starts_with("measures.")) return "body.measurements" + key.substr(key.find('.'));
  if (scenario.body.measurements.contains(key)) return "body.measurements." + key;
  for (const char* section : {"body.", "body.posture.", "simulation."})
    if (scenario.lines.contains(section + key)) return section + key;
  return key;
}

/// Line of a key, or of the table or array it stands in; 0 when the file does not have it.
int line_of(std::string key, const std::map<std::string, int>& lines) {
  for (;;) {
    if (const auto found = lines.find(key); found != lines.end()) return found->second;
    const std::size_t end = key.find_last_of(".[");
    if (end == std::string::npos) return 0;
    key.resize(end);
  }
}

}  // namespace

InvalidInput in_scenario(const InvalidInput& error, const Scenario& scenario) {
  if (!error.place().file.empty()) return error;
  const std::string key = scenario_key(error.place().key, scenario);
  const bool of_pattern = key.starts_with("panel ") || key.starts_with("stitch ");
  if (of_pattern && !scenario.garment.file.empty())
    return error.at({scenario.garment.file, 0, key});
  return error.at({scenario.file, line_of(key, scenario.lines), key});
}

}  // namespace loosefit
