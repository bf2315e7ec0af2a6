#include "loosefit/garment/board_material.h"

#include <algorithm>

#include "loosefit/base/text.h"

namespace loosefit::garment {
namespace {

constexpr double kStiffestFactor = 100;
constexpr double kUsualBending = 1e-3, kUsualFactor = 10;

}  // namespace

const std::vector<BoardMaterial>& board_materials() {
  static const std::vector<BoardMaterial> all = {{"fr4", 22e9, 0.14, 1.6e-3},
                                                 {"polyimide", 2.5e9, 0.34, 0.11e-3},
                                                 {"silicone", 2e6, 0.48, 2e-3}};
  return all;
}

const BoardMaterial* find_board_material(const std::string& name) {
  for (const BoardMaterial& m : board_materials())
    if (m.name == name) return &m;
  return nullptr;
}

std::string board_material_names() {
  std::vector<std::string> names;
  for (const BoardMaterial& m : board_materials()) names.push_back(m.name);
  return join(names);
}

double plate_rigidity_of(const BoardMaterial& m, double thickness) {
  return m.modulus * thickness * thickness * thickness / (12 * (1 - m.poisson * m.poisson));
}

SheetStiffness sheet_stiffness(const BoardMake& board, const fabric::Material& cloth) {
  SheetStiffness sheet{kUsualBending, kUsualFactor};
  if (const BoardMaterial* m = find_board_material(board.material)) {
    sheet.bending = plate_rigidity_of(*m, board.thickness);
    sheet.membrane_factor = std::clamp(
        m->modulus * board.thickness / std::max(cloth.stiffness_warp, cloth.stiffness_weft), 1.0,
        kStiffestFactor);
  }
  sheet.bending = board.bending.value_or(sheet.bending);
  sheet.membrane_factor = board.membrane_factor.value_or(sheet.membrane_factor);
  return sheet;
}

}  // namespace loosefit::garment
