#include "loosefit/pipeline/draped_from.h"

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/pipeline/recall_summary.h"

namespace loosefit::pipeline {
namespace {

using scenario::Scenario;

bool is_sewn_part(const placement::SiteSpec& site) {
  return site.board.has_value() || (site.line && site.line->is_sewn_part());
}

/// Texts of what draped_from makes digests of.
std::map<std::string, std::string> texts_of(const Scenario& scenario) {
  const std::size_t worn = scenario.garments.size();
  Scenario garment, material, simulation, donning, attachment;
  garment.garments.resize(worn);
  material.garments.resize(worn);
  for (std::size_t g = 0; g < worn; ++g) {
    scenario::ScenarioGarment& cut = garment.garments[g];
    cut.spec = scenario.garments[g].spec;
    cut.spec.file.clear(), cut.spec.seams.clear();  // the mesh tells what they hold
    material.garments[g].material = scenario.garments[g].material;
    material.garments[g].friction = scenario.garments[g].friction;
  }
  simulation.simulation = scenario.simulation;
  const scenario::ScenarioSimulation usual;
  simulation.simulation.repeats = usual.repeats;
  simulation.simulation.threads = usual.threads;
  simulation.simulation.time_budget = usual.time_budget;
  simulation.simulation.max_iterations = usual.max_iterations;
  donning.donning = scenario.donning;
  donning.donning.repeats = 1;
  attachment.attachments = scenario.attachments;
  std::ranges::copy_if(scenario.sites, std::back_inserter(attachment.sites), is_sewn_part);
  std::map<std::string, std::string> texts;
  for (const auto& [section, part] : {std::pair<const char*, const Scenario&>{"garment", garment},
                                      {"material", material},
                                      {"simulation", simulation},
                                      {"donning", donning},
                                      {"attachment", attachment}})
    texts[section] = io::scenario_toml(part);
  return texts;
}

}  // namespace

std::map<std::string, std::string> draped_from(const Scenario& scenario) {
  std::map<std::string, std::string> digests;
  for (const auto& [section, text] : texts_of(scenario)) digests[section] = sha256_hex(text);
  return digests;
}

void check_draped_from(const std::filesystem::path& file,
                       const std::map<std::string, std::string>& kept, const Scenario& scenario) {
  for (const auto& [section, text] : texts_of(scenario)) {
    const auto before = kept.find(section);
    if (before == kept.end() || io::is_digest_of(before->second, text)) continue;
    const bool parts = section == "attachment";
    throw InvalidInput({file.string(), 0, parts ? "attachment, site" : section},
                       parts ? "other parts of the garment than those that it was draped with"
                             : "another one than that which the drape was made with",
                       "what it was made with: its certificate holds for nothing else", kMakeAgain);
  }
}

}  // namespace loosefit::pipeline
