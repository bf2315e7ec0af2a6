#pragma once
#include <vector>

#include "loosefit/garment/attachment.h"
#include "loosefit/pattern/mesher.h"

namespace loosefit::garment {

/// Footprint of a board on its panel. Keeps a reference to it.
class BoardShape {
 public:
  explicit BoardShape(const Board& board)
      : board_(board),
        disc_(board.radius > 0),
        half_(disc_ ? Vec2(board.radius, board.radius) : Vec2(board.size / 2)),
        turn_(board.angle) {}

  bool covers(const Vec2& p) const { return covers_local(turn_.inverse() * (p - board_.centre)); }
  /// Looks ahead at the box of one triangle: false if it lies outside.
  bool may_cover(const Vec2& low, const Vec2& high) const {
    return (board_.centre - board_.centre.cwiseMax(low).cwiseMin(high)).norm() <= half_.norm();
  }
  double area() const;  ///< [m²]
  /// Points of equal footing all over it.
  std::vector<Vec2> samples() const;
  /// Its outline for a mesh, counter-clockwise; of a disc a polygon of twelve sides and its area.
  std::vector<Vec2> outline() const;
  /// Shorter side, or diameter [m].
  double breadth() const { return 2 * half_.minCoeff(); }

 private:
  bool covers_local(const Vec2& p) const {
    return disc_ ? p.norm() <= board_.radius
                 : std::abs(p.x()) <= half_.x() && std::abs(p.y()) <= half_.y();
  }
  const Board& board_;
  bool disc_;
  Vec2 half_;
  Eigen::Rotation2Dd turn_;
};

/// The boards of a panel for its mesher. At the finest level of the hierarchy the spacing is
/// `edge_length` or a third of a board's breadth, whichever is less, but at least 2 mm; the mesh
/// that is asked for is coarser by 2^refinements.
std::vector<pattern::MeshInset> board_insets(const std::string& panel,
                                             const std::vector<Attachment>& attachments,
                                             double edge_length, int refinements);

}  // namespace loosefit::garment
