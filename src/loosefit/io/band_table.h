#pragma once
#include <string>

#include "loosefit/io/config_reader.h"
#include "loosefit/pattern/named_cloth.h"

namespace loosefit::io {

/// A [[band]]: `panels`, `layers`, `stiffness`. \throws InvalidInput with file, line and key.
pattern::NamedCloth read_band(ConfigReader table);

/// The same as TOML, below its head.
std::string band_toml(const pattern::NamedCloth& band);

}  // namespace loosefit::io
