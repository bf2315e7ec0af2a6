#pragma once
#include <string>

#include "loosefit/io/config_reader.h"
#include "loosefit/placement/sites.h"

namespace loosefit::io {

/// How far a sensor may be shifted along the cloth, each way [m].
inline constexpr double kMostSiteShift = 0.2;

/// One [[site]]: where a sensor is and what it is.
placement::SiteSpec read_site_section(ConfigReader table);
/// The same as TOML, every default written out.
std::string site_toml(const placement::SiteSpec& site);

}  // namespace loosefit::io
