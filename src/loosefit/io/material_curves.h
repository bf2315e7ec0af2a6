#pragma once
#include <string>

#include "loosefit/fabric/material.h"
#include "loosefit/io/config_reader.h"

namespace loosefit::io {

/// Reads the measured curves of a material, each a table of two arrays of equal length:
///
///   [curve.warp], [curve.weft]   elongation [–] with force [N/m of reference width], or
///                                green_strain [–] with second_piola_kirchhoff [N/m]
///   [curve.shear]                angle [rad] with stress [N/m], or green_shear U·V [–] with
///                                second_piola_kirchhoff [N/m]
///
/// The angle φ between yarns that do not stretch is γ = U·V = sin φ, and the work of the stress is
/// that of S_uv: the two shear forms differ by the sine only. A curve replaces the stiffness of its
/// direction, which becomes the initial slope; giving both in one table is an error. Returns the
/// directions read ("warp").
/// \throws InvalidInput, for points that do not rise as MonotoneCubic.
std::vector<const char*> read_material_curves(ConfigReader& table, fabric::Material& material);

/// TOML lines (dotted keys) of all curves; reading them back gives the same points.
std::string material_curves_toml(const fabric::Material& material);

}  // namespace loosefit::io
