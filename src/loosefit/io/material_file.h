#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/io/config_reader.h"
#include "loosefit/io/material_kes.h"

namespace loosefit {

/// Constants that a scenario gives itself (material_origin.h).
struct OwnConstants {
  std::set<std::string> keys;      ///< SI keys of those that it gives, in whatever form
  std::vector<KesFigure> kes;      ///< the figures of its [kes]
  std::string title, source = {};  ///< what it calls the cloth, and where its numbers come from
};

/// A material card: the constants with where they come from and what to think of them.
struct MaterialCard {
  std::string key;  ///< name of the shipped card or absolute path of its file
  Material material;
  std::string title;
  std::string status;              ///< how far the numbers can be trusted
  std::vector<KesFigure> kes;      ///< as measured, in the units of the KES instruments
  std::vector<std::string> notes;  ///< said to the user: an isotropic E and its contradiction

  std::set<std::string> stated;  ///< constants that the card states; the others have defaults
  /// Of constants that stand for another figure, the conversion: "kes.T = 0.4 mm × 0.001".
  std::map<std::string, std::string> how;
  OwnConstants own;  ///< what a scenario has put in their place
};

/// One constant of Material as a key of cards and scenarios.
struct MaterialConstant {
  const char* key;
  double Material::*value;
  NumberRange range;
  bool required = true;  ///< of a card
};
/// In the order of the cards.
const std::vector<MaterialConstant>& material_constants();

/// Names of the shipped cards (data/materials/NAME.toml), sorted.
std::vector<std::string> material_names();

/// Shipped card by name. \throws InvalidInput with a did-you-mean if there is none.
MaterialCard load_material(const std::string& name);

/// Reads a card. Every constant of Material is a key of the same name (SI) and required, except
/// compression_factor and those of bending_poisson and bending hysteresis. A constant may instead
/// come from the table [kes] (material_kes.h), a stiffness from a measured curve [curve.warp],
/// [curve.weft], [curve.shear] (material_curves.h). Instead of stiffness_warp/_weft a card may give
/// the isotropic pair youngs_modulus [Pa] and elastic_thickness h [m]: K = E h, and
/// G = E h / (2 (1 + ν)) unless the shear stiffness is given too.
/// \throws IoError, InvalidInput; one that names all that a card lacks.
MaterialCard read_material_file(const std::filesystem::path& path);

/// Overwrites the constants that stand in `table` (same keys as a card). A stiffness that stands
/// there replaces the measured curve of the card in its direction. The isotropic pair is reported
/// with E h and E h³ / (12 (1 − ν²)) in `notes`, beside the bending rigidity in use. The caller
/// calls table.finish(). Returns the SI keys that were set, and tells in card.how how.
/// \throws InvalidInput for values outside their range; bending above 1e-3 N m gets a unit hint.
std::set<std::string> read_material_constants(ConfigReader& table, MaterialCard& card);

/// Keys of all constants, in the order of the cards.
std::vector<std::string> material_keys();

/// TOML lines `key = value` of all constants and curves; a stiffness with a curve is left out.
std::string material_toml(const Material& material);

/// Bending length c = (B / (w g))^(1/3) [m] of the mean bending rigidity: how stiff it looks.
double bending_length(const Material& material);
/// The same of one direction with bending rigidity B [N m].
double bending_length(const Material& material, double bending);

}  // namespace loosefit
