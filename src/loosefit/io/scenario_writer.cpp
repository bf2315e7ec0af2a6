#include "loosefit/io/scenario_writer.h"

#include <fmt/format.h>

#include "loosefit/base/sha256.h"
#include "loosefit/base/text.h"
#include "loosefit/io/degrees_text.h"
#include "loosefit/io/material_file.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/io/scenario_attachment.h"
#include "loosefit/io/scenario_garment.h"
#include "loosefit/io/scenario_site.h"
#include "loosefit/io/scenario_under.h"
#include "loosefit/io/scenario_wear.h"

namespace loosefit::io {
namespace {

std::string posture_text(const body::Posture& p) {
  std::string text = fmt::format(
      "arm_abduction_deg = {}, forward_bend_deg = {}, sitting = {}, arm_flexion_deg = {}, "
      "elbow_extension = {}, slouch = {}, relaxed_arms = {}",
      degrees_text(p.arm_abduction), degrees_text(p.forward_bend), shortest(p.sitting),
      degrees_text(p.arm_flexion), shortest(p.elbow_extension), shortest(p.slouch),
      shortest(p.relaxed_arms));
  for (const auto& [key, turn] :
       {std::pair("elbow_flexion", p.elbow_flexion), std::pair("wrist_flexion", p.wrist_flexion),
        std::pair("hip_flexion", p.hip_flexion), std::pair("knee_flexion", p.knee_flexion),
        std::pair("left_hip_flexion", p.left_hip_flexion),
        std::pair("right_hip_flexion", p.right_hip_flexion),
        std::pair("left_knee_flexion", p.left_knee_flexion),
        std::pair("right_knee_flexion", p.right_knee_flexion),
        std::pair("trunk_rotation", p.trunk_rotation), std::pair("side_bend", p.side_bend)})
    if (turn != 0) text += fmt::format(", {}_deg = {}", key, degrees_text(turn));
  return "{ " + text + " }";
}

std::string list_text(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(toml_quoted(word));
  return "[" + join(quoted) + "]";
}

std::string stance_text(const scenario::ScenarioBody& body) {
  return "posture = " + posture_text(body.posture) +
         "\ndress_posture = " + posture_text(body.dress_posture) + "\n";
}

std::string body_text(const scenario::ScenarioBody& body) {
  std::string text = "[body]\n";
  if (!body.file.empty()) {
    text += "file = " + toml_quoted(body.file) + "\n";
    if (!body.units.empty()) text += "units = " + toml_quoted(body.units) + "\n";
    if (!body.up.empty()) text += "up = " + toml_quoted(body.up) + "\n";
    return body.as_scanned ? text : text + stance_text(body);
  }
  std::vector<std::string> wishes;
  for (const auto& [name, value] : body.measurements)
    wishes.push_back(name + " = " + shortest(value));
  text += fmt::format("sex = {}\nage = {}\nheight = {}\n", shortest(body.sex), shortest(body.age),
                      shortest(body.height));
  if (!wishes.empty()) text += "measurements = { " + join(wishes) + " }\n";
  text +=
      fmt::format("muscle = {}\nproportions = {}\ncup = {}\nfirmness = {}\n", shortest(body.muscle),
                  shortest(body.proportions), shortest(body.cup), shortest(body.firmness));
  return text + stance_text(body);
}

std::string simulation_text(const scenario::ScenarioSimulation& s) {
  return fmt::format(
      "[simulation]\nedge_length = {}\nintegrator = {}\nseed = {}\nrepeats = {}\n"
      "start_perturbation = {}\nresidual_tolerance = {}\ngravity = {}\ntime_budget = {}\n"
      "max_iterations = {}\nthreads = {}\n",
      shortest(s.edge_length), toml_quoted(s.integrator), s.seed, s.repeats,
      shortest(s.start_perturbation), shortest(s.residual_tolerance), shortest(s.gravity),
      shortest(s.time_budget), s.max_iterations, s.threads);
}

std::string output_text(const scenario::ScenarioOutput& o) {
  return fmt::format(
      "[output]\nmaps = {}\nviews = {}\nundecorated = {}\npreset_sites = {}\nwidth = {}\n"
      "height = {}\n",
      list_text(o.maps), list_text(o.views), o.undecorated, o.preset_sites, o.width, o.height);
}

std::string ranking_section_text(const scenario::ScenarioRanking& r) {
  return fmt::format("\n[ranking]\nmodality = {}\nbest = {}\npartial = {}\n",
                     toml_quoted(r.modality), r.best, r.partial);
}

}  // namespace

std::string scenario_toml(const scenario::Scenario& scenario) {
  const scenario::ScenarioGarment& studied = scenario.studied();
  std::string text = body_text(scenario.body) + "\n" + garment_toml(studied.spec) +
                     "\n[material]\nname = " + toml_quoted(studied.material.key) + "\n" +
                     own_constants_toml(studied.material) +
                     material_toml(studied.material.material);
  for (const scenario::ScenarioGarment& under : scenario.worn_under())
    text += "\n" + under_toml(under);
  for (const garment::Attachment& a : scenario.attachments) text += "\n" + attachment_toml(a);
  for (const placement::SiteSpec& site : scenario.sites) text += "\n" + site_toml(site);
  text += "\n" + simulation_text(scenario.simulation) + "\n" + output_text(scenario.output) +
          wear_toml(scenario);
  return scenario.ranking.modality.empty() ? text : text + ranking_section_text(scenario.ranking);
}

bool is_digest_of(const std::string& digest, const std::string& toml) {
  if (digest == sha256_hex(toml)) return true;
  const std::size_t at = toml.find("gravity = ", toml.find("\n[simulation]\n"));
  for (const char* line : {"certificate = \"A\"\n", "certificate = \"B\"\n"})
    if (at != std::string::npos && digest == sha256_hex(std::string(toml).insert(at, line)))
      return true;
  return false;
}

}  // namespace loosefit::io
