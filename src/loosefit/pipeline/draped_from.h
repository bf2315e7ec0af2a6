#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "loosefit/scenario/scenario.h"

namespace loosefit::pipeline {

/// What a drape depends on beside body and mesh, as SHA-256 of the resolved text: by section of the
/// scenario ("garment", "material", "simulation", "donning", "attachment"). Maps, sites that are no
/// part of the garment, pictures, threads and budgets are not in it, nor are paths of files.
std::map<std::string, std::string> draped_from(const scenario::Scenario& scenario);

/// Refuses a scenario that asks for another drape than the one whose digests were kept: its
/// certificate does not hold for it. Sections that were not kept are not judged. `file`: of the
/// scenario. \throws InvalidInput with the section.
void check_draped_from(const std::filesystem::path& file,
                       const std::map<std::string, std::string>& kept,
                       const scenario::Scenario& scenario);

}  // namespace loosefit::pipeline
