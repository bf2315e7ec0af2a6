#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/dress/body_outline.h"
#include "loosefit/garment/garment.h"

namespace loosefit::kinds {

/// Where the corner points of a shirt go, seen from the front, in the (x, z) plane [m]. Each half
/// is stored for one side of the wearer.
struct ShirtFrame {
  struct Half {
    Vec2 neck, shoulder, armpit, hem;
    std::vector<Vec2> armhole;       ///< armpit → shoulder
    std::vector<Vec2> sleeve_top;    ///< shoulder → cuff, outer side of the arm
    std::vector<Vec2> sleeve_under;  ///< armpit → cuff, inner side of the arm
  };
  Half left, right;
  std::vector<Vec2> front_neck;  ///< left → right, below the chin
};

/// Frame round a body that stands with the arms away from the trunk.
/// \throws GeometryError when the body has no arms, or they hang too close to the trunk.
ShirtFrame shirt_frame(const garment::Garment& shirt, const body::Body& body,
                       const dress::BodyOutline& outline, double clearance);

/// Flat length of the free edge of the neck in front [m], of its neckband if it has one; 0 without
/// either.
double front_neck_length(const garment::Garment& shirt);
/// Flat length of a sleeve along its top with its cuff [m]; of an arm for what has no sleeves.
/// `side`: +1 left, −1 right.
double sleeve_length(const garment::Garment& shirt, int side);

}  // namespace loosefit::kinds
