#include "loosefit/kinds/shirt/side_seams.h"

#include <algorithm>
#include <string>

namespace loosefit::kinds {

SideSeams::SideSeams(const pattern::Panel& piece)
    : left_(parts_of(piece, "side_L")), right_(parts_of(piece, "side_R")) {}

Vec2 SideSeams::Part::at(double down) const {
  const double share = std::min(1.0, down / path.length());
  return path.at(upwards ? 1 - share : share);
}

std::vector<SideSeams::Part> SideSeams::parts_of(const pattern::Panel& piece, const char* side) {
  std::vector<Part> parts;
  for (const std::string& name : {std::string(side), std::string(side) + "_below"})
    if (const int e = pattern::find_edge_part(piece, name); e >= 0) {
      const pattern::EdgePath path(piece, e);
      parts.push_back({path, path.at(1).y() > path.at(0).y()});
    }
  return parts;
}

Vec2 SideSeams::place(const std::vector<Part>& seam, double down) {
  for (const Part& part : seam) {
    if (down <= part.path.length() || &part == &seam.back()) return part.at(down);
    down -= part.path.length();
  }
  return Vec2::Zero();
}

double SideSeams::length(const std::vector<Part>& seam) {
  double sum = 0;
  for (const Part& part : seam) sum += part.path.length();
  return sum;
}

double SideSeams::down_to(double y) const {
  double low = 0, high = length(left_);
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (place(left_, middle).y() > y ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double SideSeams::level(double down) const {
  if (left_.empty() || right_.empty()) return 0;
  const double share = down / length(left_);
  return 0.5 * (place(left_, down).y() + place(right_, share * length(right_)).y());
}

double SideSeams::apart(double down) const {
  if (left_.empty() || right_.empty()) return 0;
  // Two unequal seams of somebody's file: as far down each as a share of its length.
  const double share = down / length(left_);
  return (place(left_, down) - place(right_, share * length(right_))).norm();
}

}  // namespace loosefit::kinds
