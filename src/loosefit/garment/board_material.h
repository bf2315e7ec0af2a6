#pragma once
#include <string>
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/garment/attachment.h"

namespace loosefit::garment {

/// Thickest board outside the cloth, and between cloth and skin, whose distance is known so far
/// [m].
inline constexpr double kThickest = 0.1, kThickestInside = 0.010;

/// What flexible boards are made of (docs/theory/boards.md tells the sources).
struct BoardMaterial {
  std::string name;
  double modulus = 0;  ///< E [Pa]
  double poisson = 0;  ///< ν [–]
  double usual = 0;    ///< thickness where none is given [m]
};
const std::vector<BoardMaterial>& board_materials();
/// nullptr if there is none of that name.
const BoardMaterial* find_board_material(const std::string& name);
/// "fr4, polyimide, silicone".
std::string board_material_names();

/// D = E t³/(12 (1 − ν²)) of a plate [N m]. Timoshenko and Woinowsky-Krieger 1959, (3).
double plate_rigidity_of(const BoardMaterial& material, double thickness);

/// What a flexible board adds to the cloth under it.
struct SheetStiffness {
  double bending = 0;          ///< [N m]
  double membrane_factor = 1;  ///< of the cloth's in-plane stiffness, ≥ 1
};
/// Raw figures go before those of the material; of raw figures the one that is not given is what
/// version 0.3 took, 1e-3 N m and 10. The factor of a material is E t over the stiffer yarn of the
/// cloth, at most 100: against cloth it does not stretch beyond that either. \pre not rigid
SheetStiffness sheet_stiffness(const BoardMake& board, const fabric::Material& cloth);

}  // namespace loosefit::garment
