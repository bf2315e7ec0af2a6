#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/io/pattern_file.h"
#include "loosefit/pattern/propose_seams.h"

namespace loosefit::io {

/// NAME.seams.toml beside NAME.dxf.
std::filesystem::path seams_path(const std::filesystem::path& pattern_file);

/// The side file that a pattern is read with: `given`, else the one beside it where there is one;
/// empty: none.
std::filesystem::path side_file(const std::filesystem::path& pattern_file,
                                const std::filesystem::path& given);

/// Adds the seams of a side file to a pattern that has none (docs/patterns.md):
///     confirmed = false        # proposed by us, and nobody has looked at it yet
///     leave_out = ["POCKET"]   # pieces that are not taken
///     [pieces]                 # what a piece is, where its name does not say it: words as of
///     names path12 = "front left"
///     [up]                     # which side of a piece in the drawing is its upper one
///     SLEEVE = "left"          # up, down, left, right
///     [[seam]]
///     first = "FRONT.e1"       # panel and edge
///     second = "BACK.e3"
///     reversed = true          # start meets start; usual is that the end meets the start
///     name = "side_L"
///     [[seam]]
///     first = "SLEEVE.e3"      # a run of edges, each where the one before ends
///     second = ["BACK.e2", "FRONT.e8"]
///     begin = 0.25             # of closed runs: share of the second where the first begins
///     [[elastic]]
///     edges = ["FRONT.e4"]     # tape along them
///     ratio = 0.8              # of the edge's length (io/elastic_table.h)
/// Runs are cut so that one edge is sewn to one (pattern/sew_chains.h). A seam whose sides differ
/// in length by more than a tenth is told in the warnings, and so is what is not confirmed. `file`
/// only appears in messages. \throws InvalidInput with file, line and key: text that is no TOML,
/// unknown keys, panels or
///         edges that the pattern has not, an edge in a second seam or with a second elastic.
void parse_seams(const std::string& text, const std::string& file, PatternFile& into);
/// \throws IoError if the file cannot be read, and as parse_seams.
void read_seams(const std::filesystem::path& path, PatternFile& into);

/// The text of a side file with these seams, not confirmed. Each is preceded by a comment with its
/// lengths and what it rests on. Where no name says what is before and what behind the wearer, a
/// table [pieces] says it, of a garment that is not known with lines to fill in. Pieces that are no
/// part of a garment that is known are left out.
std::string seams_text(const pattern::Pattern& pattern, const pattern::SeamProposals& proposals);

}  // namespace loosefit::io
