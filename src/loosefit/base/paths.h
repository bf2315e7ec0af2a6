#pragma once
#include <filesystem>

namespace loosefit {

/// Folder of the shipped data (materials, sizes): $LOOSEFIT_SHARE if set, else `share/loosefit`
/// beside the folder of the binary (an installed copy), else `data` of the source tree it was
/// built from.
std::filesystem::path data_directory();

}  // namespace loosefit
