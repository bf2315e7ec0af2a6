#pragma once
#include <string>
#include <vector>

namespace loosefit::render {

/// PNG files of one size as one animated PNG that plays for ever, `milliseconds` for each (APNG,
/// in the third edition of the PNG specification, W3C 2025): browsers play it, and what does not
/// know it shows the first. \pre there are frames \throws InvalidInput when they are not PNG files
/// of one size and one kind of pixel.
std::string animated_png(const std::vector<std::string>& frames, int milliseconds);

}  // namespace loosefit::render
