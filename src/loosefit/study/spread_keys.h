#pragma once
#include <string>

// Under which names CaseResult::repeats and summary.json keep spreads.
namespace loosefit {

inline std::string map_key(const std::string& array) { return "maps." + array + ".area_mean"; }

inline std::string site_key(const std::string& site, const std::string& array) {
  return "sites." + site + "." + array;
}

}  // namespace loosefit
