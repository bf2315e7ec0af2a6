#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/body/body.h"

namespace loosefit::drape {

/// What pulls at a vertex, in the order of UnbalancedVertex::force.
inline constexpr std::array<const char*, 7> kForceNames = {"membrane",
                                                           "bending",
                                                           "gravity",
                                                           "body contact",
                                                           "self contact",
                                                           "friction on the body",
                                                           "friction of cloth on cloth"};

/// A vertex on which the forces do not balance.
struct UnbalancedVertex {
  int vertex = 0;
  std::string panel;
  Vec2 at = Vec2::Zero();  ///< in the pattern [m]
  Vec3 position = Vec3::Zero();
  std::string near;  ///< part of the body: "torso", "left upper arm", …
  double net = 0;    ///< norm of the sum of all forces [N]
  std::array<double, kForceNames.size()> force{};  ///< norm of each kind [N]
};

/// A triangle of the garment that cuts the body or another triangle of the garment.
struct CutTriangle {
  int triangle = 0;
  std::string panel;
  Vec2 at = Vec2::Zero();  ///< its centre in the pattern [m]
  Vec3 position = Vec3::Zero();
  std::string with;  ///< part of the body, or panel
  bool body = false;
  std::optional<body::Segment> segment = {};  ///< of the body, where that knows its segments
};

/// Why a drape is not settled.
struct Unsettled {
  std::string why;           ///< one line: what is out of balance or cuts, where, and which forces
  std::string hint;          ///< what to try; the study fills it in, for it knows the case's keys
  double times_allowed = 0;  ///< residual over that of a certificate [–]
  int vertices_of_most = 0;  ///< fewest vertices that carry 90 % of ‖F‖²
  double lagging_share = 0;  ///< of ‖F‖² that friction in flux makes, not a force on a vertex
  std::vector<UnbalancedVertex> worst;  ///< largest net force first, at most 10
  std::vector<CutTriangle> cuts;        ///< at most 20 of them
};

}  // namespace loosefit::drape
