#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/placement/scorecard.h"

namespace loosefit::io {

/// Names of the shipped scorecards (data/scorecards/NAME.toml), sorted.
std::vector<std::string> scorecard_names();
/// The same of those for lines (data/scorecards/lines/NAME.toml).
std::vector<std::string> line_scorecard_names();

/// A shipped scorecard by name, or a user's by its path when it ends in ".toml"; of places, or of
/// lines. \throws InvalidInput with a did-you-mean for an unknown name, for one of the other kind;
/// as read_scorecard_file.
placement::Scorecard load_scorecard(const std::string& name_or_path, bool of_lines = false);

/// Reads a scorecard; the name is the file's without its ending. Keys: docs/scorecards.md.
/// \throws IoError; InvalidInput with file, line and key for an unknown key or metric (with a
/// did-you-mean), a unit that is not the metric's, limits that make no ramp, and a derived metric
/// without the parameters it needs.
placement::Scorecard read_scorecard_file(const std::filesystem::path& path);

/// The same from text; `file` is for messages and the name.
placement::Scorecard parse_scorecard(const std::string& text, const std::string& file);

}  // namespace loosefit::io
