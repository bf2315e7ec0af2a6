#include "loosefit/io/scenario_run.h"

#include <algorithm>
#include <filesystem>

#include "loosefit/base/text.h"
#include "loosefit/io/existing_file.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/io/scorecard_key.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/placement/site_search.h"

// [material], [simulation], [output] and [ranking]: how it is computed and shown.
namespace loosefit::io {

scenario::MaterialCard read_material_section(ConfigReader table) {
  const std::vector<std::string> names = material_names();
  const std::string usual = "paper-cotton", about = "material card, or the path of a .toml card";
  const std::string name = table.peek_text("name", usual);
  scenario::MaterialCard card;
  table.declare("name", about, usual);
  if (std::filesystem::path(name).extension() == ".toml") {
    const std::string file = existing_file(table, "name", about, kTomlFile);
    card = table.recording() ? load_material(usual) : read_material_file(file);
  } else {
    table.choice("name", usual, names, about);
    card = load_material(name);
  }
  read_own_constants(table, card);
  table.finish();
  return card;
}

scenario::ScenarioSimulation read_simulation_section(ConfigReader table) {
  scenario::ScenarioSimulation s;
  s.edge_length = table.number("edge_length", s.edge_length, {0.003, 0.05, "metres"},
                               "wished edge of the triangles");
  s.integrator = table.choice("integrator", s.integrator,
                              {"semi-implicit-euler", "implicit-euler", "quasi-static"},
                              "how the garment comes to rest");
  s.seed =
      static_cast<std::uint64_t>(table.integer("seed", 1, 0, 1LL << 53, "of all that is random"));
  s.repeats =
      static_cast<int>(table.integer("repeats", s.repeats, 1, 100, "drapes from perturbed starts"));
  s.start_perturbation =
      table.number("start_perturbation", s.repeats > 1 ? 0.001 : 0, {0, 0.005, "metres"},
                   "rms shift of the dressed start; 0.001 with repeats");
  s.residual_tolerance =
      table.number("residual_tolerance", s.residual_tolerance, {1e-8, 1e-3, "a fraction"},
                   "net force over weight below which the garment has settled");
  // Scenarios and results of earlier versions have it; A asks for what every drape is judged by.
  if (table.choice("certificate", "A", {"A", "B"}, "of earlier files, without effect") == "B")
    s.notes.push_back("certificate has no effect: every drape is judged alike");
  s.gravity = table.number("gravity", s.gravity, {0.1, 100, "m/s²"}, "acceleration of gravity");
  s.time_budget = table.number("time_budget", s.time_budget, {0.1, 1e6, "seconds"},
                               "wall time that a drape may take");
  s.max_iterations = static_cast<int>(table.integer("max_iterations", s.max_iterations, 1, 1000000,
                                                    "Newton steps that a drape may take"));
  s.threads = static_cast<int>(
      table.integer("threads", s.threads, 0, 256, "0: all cores; results do not depend on it"));
  table.finish();
  return s;
}

scenario::ScenarioOutput read_output_section(ConfigReader table) {
  scenario::ScenarioOutput o;
  o.maps = table.choices("maps", o.maps, maps::map_names(), "maps to make");
  o.views =
      table.choices("views", o.views, {"front", "back", "left", "right"}, "sides of the pictures");
  o.undecorated = table.boolean("undecorated", o.undecorated, "also pictures of the plain drape");
  o.preset_sites =
      table.boolean("preset_sites", o.preset_sites, "also shoulder blades, spine, chest, …");
  o.width = static_cast<int>(table.integer("width", o.width, 200, 4000, "of a picture, in pixels"));
  o.height =
      static_cast<int>(table.integer("height", o.height, 200, 4000, "of a picture, in pixels"));
  table.finish();
  return o;
}

scenario::ScenarioRanking read_ranking_section(ConfigReader table) {
  scenario::ScenarioRanking r;
  const std::string about = "scorecard by which sites are ranked, or the path of a .toml file";
  r.modality = scorecard_of(table, "modality", about, false);
  r.best = static_cast<int>(table.integer("best", r.best, 0, placement::kMostPlaces,
                                          "places to search beside the sites"));
  r.partial = table.boolean("partial", r.partial, "judge by the criteria that the drapes can tell");
  for (const char* key : {"best", "partial"})
    if (table.lacks(key, "modality"))
      throw table.error(key, std::string(key) + " only beside modality",
                        "for example modality = \"imu-inclination\"");
  table.finish();
  return r;
}

}  // namespace loosefit::io
