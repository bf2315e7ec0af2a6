#pragma once
#include <string>
#include <vector>

#include "loosefit/io/material_file.h"

namespace loosefit::io {

/// Reads a section [material] over its card: constants as read_material_constants, `title` and
/// `source` of the scenario's own numbers, and `given`, which the resolved scenario holds: the
/// constants that the scenario gave, as far as others stand there too. Name and source of the
/// material follow: those of the card as long as nothing is replaced; the scenario's title, or "own
/// constants", when all of weight, thickness, stiffness and bending is; between the two "CARD,
/// changed: …". The caller calls table.finish(). \throws as read_material_constants.
void read_own_constants(ConfigReader& table, scenario::MaterialCard& card);

/// What read_own_constants needs to find card.own again, as TOML lines; empty for a card as it is.
std::string own_constants_toml(const scenario::MaterialCard& card);

/// One constant in use.
struct ConstantInUse {
  std::string key;
  double value;
  std::string unit;  ///< "N/m"; "-" for a pure number
  std::string from;  ///< "card wool", "scenario: kes.T = …", "inherited from card wool", "default"
};
/// All of them, in the order of the cards.
std::vector<ConstantInUse> constants_in_use(const scenario::MaterialCard& card);

}  // namespace loosefit::io
