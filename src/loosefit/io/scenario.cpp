#include "loosefit/io/scenario.h"

#include <set>

#include "loosefit/io/config_reader.h"
#include "loosefit/io/scenario_attachment.h"
#include "loosefit/io/scenario_body.h"
#include "loosefit/io/scenario_garment.h"
#include "loosefit/io/scenario_run.h"
#include "loosefit/io/scenario_site.h"
#include "loosefit/io/scenario_under.h"
#include "loosefit/io/scenario_wear.h"
#include "loosefit/io/toml_file.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostUnder = 3;

// Names become file names, table rows and JSON keys, so two of the same kind must differ.
template <class Spec>
void refuse_equal_names(const std::vector<Spec>& specs, ConfigReader& root, const char* key) {
  std::set<std::string> seen;
  for (const Spec& spec : specs)
    if (!seen.insert(spec.name).second)
      throw root.error(key, "the name \"" + spec.name + "\" twice", "each name once", {});
}

void note_lines(const ConfigNode& node, const std::string& key, std::map<std::string, int>& lines) {
  if (!key.empty()) lines[key] = node.line;
  for (const auto& [name, member] : node.members)
    note_lines(member, key.empty() ? name : key + "." + name, lines);
  for (std::size_t i = 0; i < node.items.size(); ++i)
    note_lines(node.items[i], key + "[" + std::to_string(i) + "]", lines);
}

}  // namespace

scenario::Scenario read_scenario_root(ConfigReader& root) {
  scenario::Scenario scenario;
  scenario.postures =
      read_postures_section(root.table("postures", "postures beside that of the maps"));
  scenario.body = read_body_section(
      root.table("body", "who wears it: a parametric person or a scan"), scenario.postures);
  scenario.studied().spec =
      read_garment_section(root.table("garment", "the garment that is studied"));
  scenario.studied().material =
      read_material_section(root.table("material", "cloth of the garment"));
  if (const ConfigNode* node = root.node("under"); node && node->items.size() > kMostUnder)
    throw root.error("under", std::to_string(node->items.size()) + " garments",
                     "at most " + std::to_string(kMostUnder), {});
  const std::vector<ConfigReader> under =
      root.tables("under", "garments worn under it, the innermost first", kMostUnder);
  for (std::size_t i = 0; i < under.size(); ++i)
    scenario.garments.insert(scenario.garments.end() - 1, read_under_section(under[i]));
  for (const ConfigReader& attachment :
       root.tables("attachment", "boards and cables sewn to the garment"))
    scenario.attachments.push_back(read_attachment_section(attachment));
  for (const ConfigReader& site : root.tables("site", "places where a sensor may sit"))
    scenario.sites.push_back(read_site_section(site));
  scenario.simulation = read_simulation_section(root.table("simulation", "how it is computed"));
  scenario.output = read_output_section(root.table("output", "what is shown"));
  scenario.ranking =
      read_ranking_section(root.table("ranking", "for which sensor sites are ranked"));
  const bool donned = root.has("donning");
  scenario.donning =
      read_donning_section(root.table("donning", "how it is worn in, and putting it on anew"),
                           donned, scenario.simulation);
  root.finish();
  refuse_equal_names(scenario.attachments, root, "attachment");
  refuse_equal_names(scenario.sites, root, "site");
  for (const placement::SiteSpec& site : scenario.sites)
    for (const garment::Attachment& attachment : scenario.attachments)
      if (site.board && site.name == attachment.name)
        throw root.error("site", "the name \"" + site.name + "\" of an attachment",
                         "another name for a site with a board", {});
  return scenario;
}

scenario::Scenario scenario_of(const ConfigNode& table, const std::string& file) {
  ConfigReader root(table, file);
  scenario::Scenario scenario = read_scenario_root(root);
  scenario.file = file;
  note_lines(table, "", scenario.lines);
  return scenario;
}

scenario::Scenario parse_scenario(const std::string& text, const std::string& file) {
  return scenario_of(parse_toml(text, file), file);
}

scenario::Scenario read_scenario(const std::string& path) {
  return parse_scenario(read_toml_text(path), path);
}

scenario::Scenario default_scenario() { return parse_scenario("", ""); }

}  // namespace loosefit::io
