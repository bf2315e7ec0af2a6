#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace loosefit::study {

/// Told at once of the name that something has now, so also when what follows fails.
using SetAside = std::function<void(const std::filesystem::path&)>;

/// Moves what has this name to the first free name NAME.WHY-1, NAME.WHY-2 …; so too what has the
/// name with one of these endings behind it. Returns the new name. \throws IoError
std::filesystem::path set_aside(const std::filesystem::path& file, const std::string& why,
                                const std::vector<std::string>& endings = {});

}  // namespace loosefit::study
