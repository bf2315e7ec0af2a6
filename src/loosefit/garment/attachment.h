#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::garment {

/// What a board is, wherever it is. It is rigid unless it says what it is made of: a material
/// (board_material.h) with its thickness, or measured figures.
struct BoardMake {
  enum class Side { outside, inside };  ///< of the cloth; inside is towards the skin
  double mass = 0;                      ///< [kg]
  double thickness = 0;                 ///< [m]; its centre of mass is half of it off the cloth
  Side side = Side::outside;
  std::string material = {};            ///< empty: none named
  std::optional<double> bending = {};   ///< measured rigidity of the sheet [N m]
  std::optional<double> membrane_factor = {};  ///< measured in-plane stiffness, in fabrics, ≥ 1

  bool is_rigid() const { return material.empty() && !bending && !membrane_factor; }
};

/// A flat stiff part on the cloth, e.g. a sensor board. The footprint is a rectangle of
/// `size` turned by `angle`, or a disc when `radius` > 0.
struct Board : BoardMake {
  Vec2 centre = Vec2::Zero();  ///< pattern coordinates in the panel [m]: u weft, v warp
  Vec2 size = Vec2::Zero();    ///< rectangle: extent along u and v before turning [m]
  double angle = 0;            ///< [rad], counter-clockwise
  double radius = 0;           ///< disc [m]
};

/// A cable, a stretch sensor or an elastic that is sewn along a path on one panel.
struct Cable {
  std::vector<Vec2> path;     ///< polyline in pattern coordinates [m], at least two points
  double linear_density = 0;  ///< [kg/m]
  double bending = 0;   ///< B of the cable [N m²]; adds B / width [N m] on a strip of `width`
  double width = 0.01;  ///< [m]
  double axial_stiffness = 0;  ///< EA: force per elongation, it does not push [N]
  double pre_stretch = 0;      ///< by which it is stretched when it is sewn on [–]
};

/// Something fixed to one panel that changes mass and rigidity locally (Harms et al. 2012: m_i,
/// Γ_i).
struct Attachment {
  std::string name;
  std::string panel;
  std::variant<Board, Cable> part;
};

}  // namespace loosefit::garment
