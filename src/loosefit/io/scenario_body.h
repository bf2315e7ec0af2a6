#pragma once
#include <string>
#include <vector>

#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// What the age of a person and one of body::measure_names() may be, wherever somebody asks for it:
/// in a scenario, a table of people, an option of the command line.
NumberRange age_range();
NumberRange measure_range(const std::string& name);

/// [body]; reads all keys of its table, fills in defaults and refuses the keys it does not know, as
/// all readers of sections do. `postures`: those of [postures]; the first is the default of
/// body.posture.
scenario::ScenarioBody read_body_section(ConfigReader table,
                                         const std::vector<std::string>& postures);

}  // namespace loosefit::io
