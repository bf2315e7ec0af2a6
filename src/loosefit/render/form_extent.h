#pragma once
#include <optional>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::render {

/// The edges of a garment round trunk and legs that are no waist or neck, along the trunk's axis.
struct Hem {
  double mean = 0, lowest = 0;  ///< [m]
};

/// How much of a dress form the clothes on it need.
struct FormExtent {
  Vec3 hips, nape;    ///< ends of the trunk's axis
  Vec3 axis;          ///< from hips to nape, unit
  bool legs = false;  ///< cloth reaches more than 4 cm below the crotch
  bool arms = true;   ///< cloth reaches above the middle of the trunk: not with trousers and skirts
  bool head = false;  ///< cloth goes round the head: a hood
  std::optional<Hem> hem;
};

/// `skin`: of the body's surface. `under`: positions of all that is worn under the garment. A body
/// without joints has neither legs nor a head of its own.
FormExtent form_extent(const body::Body& body, const geometry::ClosestPointTree& skin,
                       const garment::Garment& garment, const std::vector<Vec3>& positions,
                       const std::vector<Vec3>& under);

}  // namespace loosefit::render
