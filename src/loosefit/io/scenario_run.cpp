#include "loosefit/io/scenario_run.h"

#include <algorithm>
#include <filesystem>

#include "loosefit/base/text.h"
#include "loosefit/io/existing_file.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/maps/compute_maps.h"

// [material], [simulation], [output] and [ranking]: how it is computed and shown.
namespace loosefit::io {

scenario::MaterialCard read_material_section(ConfigReader table) {
  const std::vector<std::string> names = material_names();
  const std::string name = table.text("name", "paper-cotton");
  scenario::MaterialCard card;
  if (std::filesystem::path(name).extension() == ".toml") {
    card = read_material_file(existing_file(table, "name"));
  } else {
    table.choice("name", name, names);
    card = load_material(name);
  }
  read_own_constants(table, card);
  table.finish();
  return card;
}

scenario::ScenarioSimulation read_simulation_section(ConfigReader table) {
  scenario::ScenarioSimulation s;
  s.edge_length = table.number("edge_length", s.edge_length, {0.003, 0.05, "metres"});
  s.integrator = table.choice("integrator", s.integrator,
                              {"semi-implicit-euler", "implicit-euler", "quasi-static"});
  s.seed = static_cast<std::uint64_t>(table.integer("seed", 1, 0, 1LL << 53));
  s.repeats = static_cast<int>(table.integer("repeats", s.repeats, 1, 100));
  s.start_perturbation =
      table.number("start_perturbation", s.repeats > 1 ? 0.001 : 0, {0, 0.005, "metres"});
  s.residual_tolerance =
      table.number("residual_tolerance", s.residual_tolerance, {1e-8, 1e-3, "a fraction"});
  s.gravity = table.number("gravity", s.gravity, {0.1, 100, "m/s²"});
  s.time_budget = table.number("time_budget", s.time_budget, {0.1, 1e6, "seconds"});
  s.max_iterations =
      static_cast<int>(table.integer("max_iterations", s.max_iterations, 1, 1000000));
  s.threads = static_cast<int>(table.integer("threads", s.threads, 0, 256));
  table.finish();
  return s;
}

scenario::ScenarioOutput read_output_section(ConfigReader table) {
  scenario::ScenarioOutput o;
  o.maps = table.choices("maps", o.maps, maps::map_names());
  o.views = table.choices("views", o.views, {"front", "back", "left", "right"});
  o.undecorated = table.boolean("undecorated", o.undecorated);
  o.preset_sites = table.boolean("preset_sites", o.preset_sites);
  o.width = static_cast<int>(table.integer("width", o.width, 200, 4000));
  o.height = static_cast<int>(table.integer("height", o.height, 200, 4000));
  table.finish();
  return o;
}

scenario::ScenarioRanking read_ranking_section(ConfigReader table) {
  scenario::ScenarioRanking r;
  r.modality = table.text("modality", r.modality);
  if (std::filesystem::path(r.modality).extension() == ".toml")
    r.modality = existing_file(table, "modality");
  else if (!r.modality.empty())
    table.choice("modality", r.modality, scorecard_names());
  if (!r.modality.empty()) load_scorecard(r.modality);  // what is wrong with it is said now
  r.best = static_cast<int>(table.integer("best", r.best, 0, 1000));
  r.partial = table.boolean("partial", r.partial);
  for (const char* key : {"best", "partial"})
    if (r.modality.empty() && table.has(key))
      throw table.error(key, std::string(key) + " only beside modality",
                        "for example modality = \"imu-inclination\"");
  table.finish();
  return r;
}

}  // namespace loosefit::io
