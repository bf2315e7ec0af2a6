#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::report {

/// Finds room for the words beside the sensors of one piece: not over its lines, outline, sensors
/// or other words as far as there is room. All points are those of the sheet [mm], y down.
class SewingLabels {
 public:
  explicit SewingLabels(std::vector<Vec2> outline) : taken_(std::move(outline)) {}
  void keep_off(const std::vector<Vec2>& points);
  /// SVG of a block of lines near `centre`, a sensor of this radius [mm]; the first line is larger,
  /// empty ones are passed over. Words that had to go away from their sensor get a line to it.
  std::string place(const Vec2& centre, double radius, std::vector<std::string> lines);

 private:
  struct Box {
    Vec2 low, high;
  };
  double cost(const Box& box) const;
  std::vector<Vec2> taken_;
  std::vector<Box> boxes_;
};

}  // namespace loosefit::report
