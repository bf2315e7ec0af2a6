#include "loosefit/io/scenario_place.h"

#include <optional>

#include "loosefit/scenario/garment_tables.h"

namespace loosefit::io {
namespace {

/// "position" of an attachment is `at` in a scenario, and so on.
std::string attachment_key(const std::string& part) {
  if (part == ".position") return ".at";
  if (part == ".width" || part == ".height") return ".size";
  return part == ".angle" ? ".angle_deg" : part;
}

/// The same of a site whose board became an attachment: mass and rigidity stand in its board, the
/// outline in its footprint.
std::string board_key(const std::string& part) {
  if (part == ".position") return ".at";
  if (part == ".radius" || part == ".width" || part == ".height") return ".footprint";
  if (part == ".angle") return ".angle_deg";
  return part == ".panel" ? part : ".board" + part;
}

/// Rest of `key` when it tells of the attachment of this name ("attachment NAME.part").
std::optional<std::string> part_of(const std::string& key, const std::string& name) {
  const std::string start = "attachment " + name + ".";
  if (!key.starts_with(start)) return std::nullopt;
  return key.substr(start.size() - 1);
}

/// Keys of the stages, by their beginning, and how the scenario calls them.
std::string scenario_key(const std::string& key, const scenario::Scenario& scenario) {
  for (std::size_t i = 0; i < scenario.attachments.size(); ++i)
    if (const auto part = part_of(key, scenario.attachments[i].name)) {
      // A cable has a width of its own.
      const bool board = std::holds_alternative<garment::Board>(scenario.attachments[i].part);
      return "attachment[" + std::to_string(i) + "]" + (board ? attachment_key(*part) : *part);
    }
  for (std::size_t i = 0; i < scenario.sites.size(); ++i)
    if (const auto part = part_of(key, scenario.sites[i].name))
      return "site[" + std::to_string(i) + "]" + board_key(*part);
  if (key.starts_with("fit.") || scenario::is_beside_pattern(key)) return "garment." + key;
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

InvalidInput in_scenario(const InvalidInput& error, const scenario::Scenario& scenario) {
  if (!error.place().file.empty()) return error;
  const std::string key = scenario_key(error.place().key, scenario);
  const bool of_pattern = key.starts_with("panel ") || key.starts_with("stitch ");
  if (of_pattern && !scenario.studied().spec.file.empty())
    return error.at({scenario.studied().spec.file, 0, key});
  return error.at({scenario.file, line_of(key, scenario.lines), key});
}

}  // namespace loosefit::io
