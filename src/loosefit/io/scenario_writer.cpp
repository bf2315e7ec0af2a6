#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/io/scenario_sections.h"

namespace loosefit {
namespace {

std::string posture_text(const Posture& p) {
  return fmt::format(
      "{{ arm_abduction_deg = {}, forward_bend_deg = {}, sitting = {}, arm_flexion_deg = {}, "
      "elbow_extension = {}, slouch = {} }}",
      degrees_text(p.arm_abduction), degrees_text(p.forward_bend), shortest(p.sitting),
      degrees_text(p.arm_flexion), shortest(p.elbow_extension), shortest(p.slouch));
}

std::string point_text(const Vec2& p) {
  return fmt::format("[{}, {}]", shortest(p.x()), shortest(p.y()));
}

std::string list_text(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(toml_quoted(word));
  return "[" + join(quoted) + "]";
}

std::string body_text(const ScenarioBody& body) {
  std::string text = "[body]\n";
  if (!body.file.empty()) {
    text += "file = " + toml_quoted(body.file) + "\n";
    if (!body.units.empty()) text += "units = " + toml_quoted(body.units) + "\n";
    if (!body.up.empty()) text += "up = " + toml_quoted(body.up) + "\n";
    return text;
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
  return text + "posture = " + posture_text(body.posture) +
         "\ndress_posture = " + posture_text(body.dress_posture) + "\n";
}

std::string part_text(const Board& board) {
  return "at = " + point_text(board.centre) + "\n" +
         (board.radius > 0 ? "radius = " + shortest(board.radius)
                           : "size = " + point_text(board.size)) +
         fmt::format("\nangle_deg = {}\nmass = {}\nbending = {}\nmembrane_factor = {}\n",
                     degrees_text(board.angle), shortest(board.mass), shortest(board.bending),
                     shortest(board.membrane_factor));
}

std::string part_text(const Cable& cable) {
  std::vector<std::string> path;
  for (const Vec2& p : cable.path) path.push_back(point_text(p));
  return fmt::format("path = [{}]\nwidth = {}\nlinear_density = {}\nbending = {}\n", join(path),
                     shortest(cable.width), shortest(cable.linear_density),
                     shortest(cable.bending));
}

std::string attachment_text(const Attachment& a) {
  return fmt::format("[[attachment]]\nkind = \"{}\"\nname = {}\npanel = {}\n",
                     std::holds_alternative<Board>(a.part) ? "board" : "cable", toml_quoted(a.name),
                     toml_quoted(a.panel)) +
         std::visit([](const auto& part) { return part_text(part); }, a.part);
}

std::string simulation_text(const ScenarioSimulation& s) {
  return fmt::format(
      "[simulation]\nedge_length = {}\nintegrator = {}\nseed = {}\nrepeats = {}\n"
      "start_perturbation = {}\nresidual_tolerance = {}\ngravity = {}\ntime_budget = {}\n"
      "max_iterations = {}\nthreads = {}\n",
      shortest(s.edge_length), toml_quoted(s.integrator), s.seed, s.repeats,
      shortest(s.start_perturbation), shortest(s.residual_tolerance), shortest(s.gravity),
      shortest(s.time_budget), s.max_iterations, s.threads);
}

std::string output_text(const ScenarioOutput& o) {
  return fmt::format(
      "[output]\nmaps = {}\nviews = {}\nundecorated = {}\npreset_sites = {}\nwidth = {}\n"
      "height = {}\n",
      list_text(o.maps), list_text(o.views), o.undecorated, o.preset_sites, o.width, o.height);
}

std::string ranking_section_text(const ScenarioRanking& r) {
  return fmt::format("\n[ranking]\nmodality = {}\nbest = {}\npartial = {}\n",
                     toml_quoted(r.modality), r.best, r.partial);
}

}  // namespace

// Angles are kept in radians; print the degrees that read back to the same radians.
std::string degrees_text(double angle) {
  for (int digits = 1; digits <= 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", degrees(angle), digits);
    if (radians(std::stod(text)) == angle) return shortest(std::stod(text));
  }
  return shortest(degrees(angle));
}

std::string scenario_toml(const Scenario& scenario) {
  const ScenarioGarment& studied = scenario.studied();
  std::string text = body_text(scenario.body) + "\n" + garment_toml(studied.spec) +
                     "\n[material]\nname = " + toml_quoted(studied.material.key) + "\n" +
                     own_constants_toml(studied.material) +
                     material_toml(studied.material.material);
  for (const ScenarioGarment& under : scenario.worn_under()) text += "\n" + under_toml(under);
  for (const Attachment& a : scenario.attachments) text += "\n" + attachment_text(a);
  for (const SiteSpec& site : scenario.sites) text += "\n" + site_toml(site);
  text += "\n" + simulation_text(scenario.simulation) + "\n" + output_text(scenario.output) +
          wear_toml(scenario);
  return scenario.ranking.modality.empty() ? text : text + ranking_section_text(scenario.ranking);
}

}  // namespace loosefit
