#pragma once
#include <string>

namespace loosefit::scenario {

/// Whether a key of an error is in a table of a garment that a scenario has beside the pattern,
/// [[garment.elastic]] or [[garment.band]], and not in the pattern's own file.
inline bool is_beside_pattern(const std::string& key) {
  return key.starts_with("elastic[") || key.starts_with("band[");
}

}  // namespace loosefit::scenario
