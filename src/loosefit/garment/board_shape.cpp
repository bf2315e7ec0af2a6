#include "loosefit/garment/board_shape.h"

#include <algorithm>
#include <cmath>

namespace loosefit::garment {
namespace {

constexpr int kSamples = 24;             ///< per direction
constexpr double kPartsOfBreadth = 3;    ///< enough triangles for a board to lie on a body
constexpr double kLeastSpacing = 0.002;  ///< [m]
constexpr int kSides = 12;               ///< of a disc

}  // namespace

double BoardShape::area() const {
  return disc_ ? kPi * board_.radius * board_.radius : board_.size.prod();
}

std::vector<Vec2> BoardShape::samples() const {
  std::vector<Vec2> points;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const Vec2 local =
          half_.cwiseProduct(Vec2((2 * i + 1.0) / kSamples - 1, (2 * j + 1.0) / kSamples - 1));
      if (covers_local(local)) points.push_back(board_.centre + turn_ * local);
    }
  return points;
}

std::vector<Vec2> BoardShape::outline() const {
  std::vector<Vec2> points;
  if (disc_) {
    const double angle = 2 * kPi / kSides;
    const double radius = board_.radius * std::sqrt(angle / std::sin(angle));
    for (int k = 0; k < kSides; ++k)
      points.push_back(board_.centre +
                       turn_ * Vec2(radius * std::cos(k * angle), radius * std::sin(k * angle)));
    return points;
  }
  for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    points.push_back(board_.centre + turn_ * half_.cwiseProduct(corner));
  return points;
}

std::vector<pattern::MeshInset> board_insets(const std::string& panel,
                                             const std::vector<Attachment>& attachments,
                                             double edge_length, int refinements) {
  std::vector<pattern::MeshInset> insets;
  for (const Attachment& attachment : attachments) {
    const auto* board = std::get_if<Board>(&attachment.part);
    if (!board || attachment.panel != panel) continue;
    const BoardShape shape(*board);
    const double finest =
        std::min(edge_length, std::max(kLeastSpacing, shape.breadth() / kPartsOfBreadth));
    const double spacing = finest * (1 << refinements);
    insets.push_back({shape.outline(), spacing});
  }
  return insets;
}

}  // namespace loosefit::garment
