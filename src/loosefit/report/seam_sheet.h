#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "loosefit/io/pattern_file.h"
#include "loosefit/pattern/propose_seams.h"

namespace loosefit::report {

/// Files that were written, and what is proposed in them.
struct WrittenProposals {
  std::filesystem::path seams, picture;
  pattern::SeamProposals proposals;
};

/// The flat pieces with the number of a proposed seam in the middle of each of its edges, and a
/// list of the seams below. \throws GeometryError for an invalid pattern.
std::string seam_sheet_svg(const pattern::Pattern& pattern,
                           const pattern::SeamProposals& proposals);

/// Writes NAME.seams.toml and NAME.seams.svg beside a pattern file that has no seams: both or none.
/// \throws InvalidInput when one of them is there already, which is never overwritten, when the
/// file has its seams itself, or when nothing can be proposed; IoError; as the readers.
WrittenProposals write_seam_proposals(const std::filesystem::path& pattern_file,
                                      const io::PatternWish& wish);

}  // namespace loosefit::report
