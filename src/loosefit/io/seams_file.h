#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// NAME.seams.toml beside NAME.dxf.
std::filesystem::path seams_path(const std::filesystem::path& pattern_file);

/// Adds the seams of a side file to a pattern that has none (docs/patterns.md):
///     [[seam]]
///     first = "FRONT.e1"       # panel and edge
///     second = "BACK.e3"
///     reversed = true          # start meets start; usual is that the end meets the start
///     name = "side_L"
/// A seam whose sides differ in length by more than a tenth is told in `warnings`.
/// `file` only appears in messages.
/// \throws InvalidInput with file, line and key: text that is no TOML, unknown keys, panels or
///         edges that the pattern has not, an edge in a second seam.
void parse_seams(const std::string& text, const std::string& file, pattern::Pattern& pattern,
                 std::vector<std::string>& warnings);
/// \throws IoError if the file cannot be read, and as parse_seams.
void read_seams(const std::filesystem::path& path, pattern::Pattern& pattern,
                std::vector<std::string>& warnings);

}  // namespace loosefit::io
