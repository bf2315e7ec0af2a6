#pragma once
#include <filesystem>
#include <string>

namespace loosefit {

/// Folder of the shipped data (materials, sizes): $LOOSEFIT_SHARE if set, else `share/loosefit`
/// beside the folder of the binary (an installed copy), else `data` of the source tree it was
/// built from.
std::filesystem::path data_directory();

/// Where the baked body lives: $LOOSEFIT_DATA (a folder holding body.lfb, or the file itself) or
/// var/body/body.lfb of the source tree.
std::string default_body_data_path();

}  // namespace loosefit
