#pragma once
#include <string>

#include "loosefit/io/config_reader.h"

namespace loosefit::io {

/// The scorecard that a key names: a shipped one of places or of lines, or an existing .toml file,
/// looked for beside the document. Empty where the key is missing. \throws InvalidInput as
/// existing_file and load_scorecard: what is wrong with the card is said at once.
std::string scorecard_of(ConfigReader& table, const std::string& key, const std::string& about,
                         bool of_lines);

}  // namespace loosefit::io
