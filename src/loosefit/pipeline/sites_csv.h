#pragma once
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// Sites as CSV (RFC 4180), one row per site: name, region, panel, u_m, v_m, x_m, y_m, z_m,
/// angle_deg, address_columns(), footprint in words, then all site_values() by name, then for some
/// of them `uncertainty.<name>`, a standard deviation (Uncertainty::whole), then `covered` (yes,
/// no) and why not. edge_length: of the mesh [m]. Same columns in every row; of what is in
/// `uncovered`, presets left out, only the name and these two are known. With lines there are the
/// columns `kind` (place, line), length_cut_m, length_worn_m, elongation (reference state) and
/// elongation_largest besides, and a row for each line.
std::string sites_csv(const std::vector<placement::Site>& sites, double edge_length,
                      const std::vector<placement::UncoveredSite>& uncovered = {},
                      const std::vector<CaseLine>& lines = {});

}  // namespace loosefit::pipeline
