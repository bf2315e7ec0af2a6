#pragma once
#include <filesystem>
#include <vector>

#include "loosefit/kinds/kind.h"

namespace loosefit::io {

/// Measures for a draft from JSON: the "measured" object of a body.json, or an object with the
/// names themselves [m, rad]; KindMeasure::name or KindMeasure::of_body. Other names are ignored.
/// A number may stand in quotes, with a decimal comma too.
/// \throws IoError; InvalidInput naming what is missing, no number, or so far from what people
/// measure that it is in another unit.
kinds::NamedValues read_measures(const std::filesystem::path& path,
                                 const std::vector<kinds::KindMeasure>& measures);

}  // namespace loosefit::io
