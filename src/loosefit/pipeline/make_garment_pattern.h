#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/io/dxf/dxf_write.h"
#include "loosefit/kinds/kind.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::pipeline {

/// A measure of the body or a key of [garment.fit] that somebody gives.
struct GivenValue {
  std::string key;    ///< KindMeasure::name or KindKey::name
  double value = 0;   ///< [SI]
  std::string place;  ///< what a message calls it, e.g. "--shoulder-slope-deg"
};

/// Where one pattern comes from: at most one of file, size, scenario, and measures with a fit.
/// Messages call these as the options of `loosefit pattern` are called.
struct GarmentPatternWish {
  std::string file;      ///< pattern file (io/read_pattern.h); empty: none
  std::string size;      ///< of the kind's table, or of the file; empty: none
  std::string units;     ///< of a DXF file: mm, cm, m, inch; empty: as it says
  std::string seams;     ///< side file with the seams of `file`; empty: the one beside it
  std::string body;      ///< file with measures of the body; empty: none
  std::string scenario;  ///< file that brings body and garment; empty: none
  std::optional<std::string> kind;   ///< of a draft; none: the usual one
  std::vector<GivenValue> measures;  ///< over those of the body
  std::vector<GivenValue> fit;       ///< what is not in it may give way
};

/// A pattern, and how it fits the body it is compared with, if there is one.
struct GarmentPattern {
  pattern::Pattern pattern;
  std::vector<kinds::FitLevel> levels;  ///< of fit, in the order of the kind
  std::string details;                  ///< of the draft; empty without one
  std::vector<std::string> warnings;
  std::vector<std::string> about;   ///< what a pattern file says of itself
  std::vector<std::string> used;    ///< the pieces of a pattern file, each with how it was taken
  std::vector<std::string> unused;  ///< what of a pattern file was not used, and why
  std::vector<pattern::Notch> notches;  ///< of a pattern file
  std::vector<io::PatternMark> marks;   ///< what a scenario fixes to it
};

/// Drafts a garment, or reads it from a pattern file or as a scenario has it. Without `body` and
/// `size` the body is that of a scenario without [body]; a size is compared with its own body, and
/// a pattern file with none, unless `body` or `measures` say otherwise.
/// \throws InvalidInput for several sources, an unknown kind or size, a fit that the kind has not,
/// a file that is not what it should be; GeometryError for what cannot be drafted or sewn; IoError
/// for a file that cannot be read, and without body data.
GarmentPattern make_garment_pattern(const GarmentPatternWish& wish);

}  // namespace loosefit::pipeline
