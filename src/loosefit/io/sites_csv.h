#pragma once
#include <filesystem>
#include <vector>

#include "loosefit/placement/sites.h"

namespace loosefit {

/// Writes one row per site: name, panel, u_m, v_m, x_m, y_m, z_m, region, then for every map its
/// footprint mean under the array's name and the footprint's worst 5 % under `<array>_p95`.
/// Undefined values are empty cells. \throws IoError when the file cannot be written in full.
void write_sites_csv(const std::filesystem::path& path, const std::vector<Site>& sites);

}  // namespace loosefit
