#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "loosefit/fabric/kes_units.h"
#include "loosefit/fabric/material.h"

namespace loosefit::scenario {

/// One figure of a card in the unit in which it was measured.
struct KesFigure {
  std::string key;  ///< "B_warp"
  fabric::KesUnit unit;
  double value;
};

/// Constants that a scenario gives itself (io/material_origin.h).
struct OwnConstants {
  std::set<std::string> keys;      ///< SI keys of those that it gives, in whatever form
  std::vector<KesFigure> kes;      ///< the figures of its [kes]
  std::string title, source = {};  ///< what it calls the cloth, and where its numbers come from
};

/// A material card: the constants with where they come from and what to think of them.
struct MaterialCard {
  std::string key;  ///< name of the shipped card or absolute path of its file
  fabric::Material material;
  std::string title;
  std::string status;               ///< how far the numbers can be trusted
  std::string valid_strain_source;  ///< where Material::valid_strain_warp … come from
  std::vector<KesFigure> kes;       ///< as measured, in the units of the KES instruments
  std::vector<std::string> notes;   ///< said to the user: an isotropic E and its contradiction

  std::set<std::string> stated;  ///< constants that the card states; the others have defaults
  /// Of constants that stand for another figure, the conversion: "kes.T = 0.4 mm × 0.001".
  std::map<std::string, std::string> how;
  OwnConstants own;  ///< what a scenario has put in their place
};

}  // namespace loosefit::scenario
