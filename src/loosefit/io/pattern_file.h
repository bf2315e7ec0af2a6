#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/notch.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// A pattern read from a file and what had to be assumed for it.
struct PatternFile {
  pattern::Pattern pattern;
  std::vector<std::string> warnings;
  std::vector<pattern::Notch> notches;  ///< that the file has; seams are proposed by them
  std::vector<std::string> about;       ///< what the file says of itself: format, units, sizes
  std::vector<std::string> unused;      ///< what stands in the file and was not used
  bool placed = true;                   ///< the file says where its panels start
};

}  // namespace loosefit::io
