#pragma once
#include <string>

#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// [garment].
scenario::GarmentSpec read_garment_section(ConfigReader table);
/// The keys of [garment], of a table that may have others.
scenario::GarmentSpec read_garment_keys(ConfigReader& table);
/// The same as TOML; `section`: of its fit.
std::string garment_toml(const scenario::GarmentSpec& garment,
                         const std::string& section = "garment");

}  // namespace loosefit::io
