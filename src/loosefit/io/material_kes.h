#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/material_card.h"

namespace loosefit::io {

/// Reads the optional table [kes]: KES figures in KES units. B, 2HB, EMT, LT, WT, RT take _warp or
/// _weft, or stand for both directions without it; G, 2HG, 2HG5, T, W, MIU, MMD, SMD, LC, WC, RC
/// stand alone; EMT_load [gf/cm] is the load of EMT (500).
///
/// B, 2HB (HB = 2HB/2), G, T, W and EMT (secant stiffness load/EMT) are constants of a material:
/// where `table` does not give the SI constant it is converted; where it does, the two must agree
/// within rounding. EMT and G leave a direction alone whose curve `table` gives.
/// Returns, for each SI key that a KES figure gave, the conversion
/// in words: "kes.B = 0.045 gf cm2/cm × 9.80665e-05". Puts the figures into `figures`, in place of
/// those of the same key.
/// \throws InvalidInput that names both keys when they disagree, and the keys per direction where a
/// figure is not one number.
std::map<std::string, std::string> read_material_kes(ConfigReader& table,
                                                     fabric::Material& material,
                                                     std::vector<scenario::KesFigure>& figures);

}  // namespace loosefit::io
