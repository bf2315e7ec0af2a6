#pragma once
#include <set>
#include <string>

#include "loosefit/io/config_reader.h"
#include "loosefit/pattern/named_cloth.h"

namespace loosefit::io {

/// A [[band]]: `panels`, `layers`, `stiffness`; `told` are the panels of bands before it, to which
/// its own are added. \throws InvalidInput with file, line and key; for a panel that is in `told`.
pattern::NamedCloth read_band(ConfigReader table, std::set<std::string>& told);

/// The same as TOML, below its head.
std::string band_toml(const pattern::NamedCloth& band);

}  // namespace loosefit::io
