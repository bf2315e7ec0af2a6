#pragma once
#include <filesystem>

#include "loosefit/pattern/shirt_draft.h"

namespace loosefit {

/// Measures for the shirt draft from JSON: the "measured" object of a body.json, or an object with
/// the names themselves [m, rad]: chest, waist, hip, neck, upper_arm, wrist, shoulder_breadth,
/// shoulder_slope, scye_depth, hps_to_waist, hps_to_hem (or hps_to_hip), arm_length. Other names
/// are ignored. \throws IoError; InvalidInput naming what is missing or no number.
ShirtMeasures read_measures(const std::filesystem::path& path);

}  // namespace loosefit
