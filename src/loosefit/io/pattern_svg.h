#pragma once
#include <filesystem>
#include <string>

#include "loosefit/pattern/pattern.h"

namespace loosefit {

/// The flat pieces at 1:1 (user unit = 1 mm), side by side without overlap, seen from the outside
/// of the cloth: outline with true curves, name, size, grain arrow, edge names and lengths, seam
/// numbers (the same number on both sides of a seam) and a 100 mm control square. No seam
/// allowance. \throws GeometryError for an invalid pattern.
std::string pattern_svg(const Pattern& pattern);
/// \throws IoError if the file cannot be written.
void write_pattern_svg(const std::filesystem::path& path, const Pattern& pattern);

}  // namespace loosefit
