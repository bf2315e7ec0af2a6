#pragma once
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::pattern {

/// A closed line on a panel that is to run along edges of the mesh, e.g. the outline of a board.
struct MeshInset {
  std::vector<Vec2> outline;  ///< corners, counter-clockwise, the first one once [m]
  double spacing = 0;         ///< of mesh points on it and within [m]; from there they get sparser
};

/// Wanted edge length over a panel: that of the panel, finer on insets, and growing from there by
/// kGrowth of the distance.
class MeshSizes {
 public:
  static constexpr double kGrowth = 0.3;
  MeshSizes(double edge_length, std::vector<MeshInset> insets)
      : edge_length_(edge_length), insets_(std::move(insets)) {}
  double largest() const { return edge_length_; }
  double at(const Vec2& p) const;
  /// (largest / wanted edge length)².
  double density(const Vec2& p) const;

 private:
  double edge_length_;
  std::vector<MeshInset> insets_;
};

/// Lines of insets that a mesh is to follow.
struct InsetLines {
  std::vector<Vec2> points;
  std::vector<std::array<int, 2>> segments;  ///< of consecutive points

  /// Distance to the nearest segment; infinite if there is none [m].
  double distance(const Vec2& p) const;
  /// Divides the sides of an inset evenly and adds the parts that keep `gap` times its spacing from
  /// what is there already. room: distance of a point of the cloth from its rims, 0 off it.
  void add(const MeshInset& inset, double gap, const std::function<double(const Vec2&)>& room);
};

}  // namespace loosefit::pattern
