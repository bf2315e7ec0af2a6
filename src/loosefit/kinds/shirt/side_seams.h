#pragma once
#include <vector>

#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {

/// Both side seams of a body piece, from the underarm down to the hem, over the mouth of a dart:
/// what lies equally far down front and back is sewn together.
class SideSeams {
 public:
  explicit SideSeams(const pattern::Panel& piece);
  /// How far down the left seam reaches the level y [m]; 0 without seams.
  double down_to(double y) const;
  /// Distance between the two seams so far down [m]; 0 without seams.
  double apart(double down) const;
  /// Mean level of both so far down [m]; 0 without seams.
  double level(double down) const;

 private:
  /// A part of a seam, travelled downwards.
  struct Part {
    pattern::EdgePath path;
    bool upwards;
    Vec2 at(double down) const;
  };
  static std::vector<Part> parts_of(const pattern::Panel& piece, const char* side);
  static Vec2 place(const std::vector<Part>& seam, double down);
  static double length(const std::vector<Part>& seam);
  std::vector<Part> left_, right_;
};

}  // namespace loosefit::kinds
