#pragma once
#include <filesystem>
#include <string>

#include "loosefit/base/progress.h"
#include "loosefit/library/outcome.h"

namespace loosefit::library {

/// How a scenario is run, apart from what it says itself.
struct RunSettings {
  bool allow_unsettled = false;  ///< make maps of a drape that did not settle or is not worn
  bool only_drape = false;       ///< no maps
};

/// Runs the scenario of a file (docs/scenario.md): body, garment, drape, maps. Draws and writes
/// nothing and needs no display. Calls from several threads do not disturb each other and give the
/// same bits as one after another. A drape that does not settle is no error: Outcome::verdict says
/// why. `progress` hears of it and can stop it. \throws InvalidInput, GeometryError for a scenario
/// that cannot be used; IoError for files and data that are missing, saying where they were looked
/// for; SolverFailure; std::bad_alloc; Cancelled.
Outcome run(const std::filesystem::path& scenario, const RunSettings& settings, Progress& progress);
Outcome run(const std::filesystem::path& scenario, const RunSettings& settings = {});

/// The same of a scenario's text (TOML). Messages call it `name`; files that it names are taken
/// relative to the folder of `name`.
Outcome run_text(const std::string& text, const std::string& name, const RunSettings& settings,
                 Progress& progress);
Outcome run_text(const std::string& text, const std::string& name = "scenario",
                 const RunSettings& settings = {});

}  // namespace loosefit::library
