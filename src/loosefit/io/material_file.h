#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/material_card.h"

namespace loosefit::io {

/// One constant of Material as a key of cards and scenarios.
struct MaterialConstant {
  const char* key;
  double fabric::Material::*value;
  NumberRange range;
  bool required;      ///< of a card
  const char* about;  ///< in a few words
};
/// In the order of the cards.
const std::vector<MaterialConstant>& material_constants();
/// Whether a card may leave it unstated: how far the cloth was measured, and how far it stretches.
bool may_be_unstated(const MaterialConstant& constant);

/// Names of the shipped cards (data/materials/NAME.toml), sorted.
std::vector<std::string> material_names();

/// Shipped card by name. \throws InvalidInput with a did-you-mean if there is none.
scenario::MaterialCard load_material(const std::string& name);

/// Reads a card. Every constant of Material is a key of the same name (SI) and required, except
/// those of bending_poisson and bending hysteresis. A constant may instead
/// come from the table [kes] (material_kes.h), a stiffness from a measured curve [curve.warp],
/// [curve.weft], [curve.shear] (material_curves.h). Instead of stiffness_warp/_weft a card may give
/// the isotropic pair youngs_modulus [Pa] and elastic_thickness h [m]: K = E h, and
/// G = E h / (2 (1 + ν)) unless the shear stiffness is given too.
/// \throws IoError, InvalidInput; one that names all that a card lacks.
scenario::MaterialCard read_material_file(const std::filesystem::path& path);

/// Overwrites the constants that stand in `table` (same keys as a card). A stiffness that stands
/// there replaces the measured curve of the card in its direction. The isotropic pair is reported
/// with E h and E h³ / (12 (1 − ν²)) in `notes`, beside the bending rigidity in use. The caller
/// calls table.finish(). Returns the SI keys that were set, and tells in card.how how.
/// \throws InvalidInput for values outside their range; bending above 1e-3 N m gets a unit hint.
std::set<std::string> read_material_constants(ConfigReader& table, scenario::MaterialCard& card);

/// Keys of all constants, in the order of the cards.
std::vector<std::string> material_keys();
/// A key of earlier files that is read without effect.
inline constexpr const char* kRetiredConstant = "compression_factor";

/// TOML lines `key = value` of all constants and curves; a stiffness with a curve is left out.
std::string material_toml(const fabric::Material& material);

/// Bending length c = (B / (w g))^(1/3) [m] of the mean bending rigidity: how stiff it looks.
double bending_length(const fabric::Material& material);
/// The same of one direction with bending rigidity B [N m].
double bending_length(const fabric::Material& material, double bending);

}  // namespace loosefit::io
