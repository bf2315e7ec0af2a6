#include "loosefit/lines/route_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/maps/skin_partner.h"
#include "loosefit/maps/surface_curvature.h"

namespace loosefit::lines {

RouteCost::RouteCost(const garment::Garment& garment,
                     const std::vector<placement::WornState>& states, const RoutePrices& prices,
                     std::vector<char> kept_free)
    : garment_(garment), states_(states), prices_(prices), kept_free_(std::move(kept_free)) {
  if (prices.bending > 0)
    for (const placement::WornState& state : states)
      curvature_.push_back(maps::vertex_curvatures({state.positions, garment.triangles}));
  if (prices.slip > 0) {
    slip_.assign(garment.vertex_count, 0.0);
    const auto dressed = [](const placement::WornState& s) {
      return maps::DressedState{s.positions, s.body, s.worn};
    };
    for (std::size_t i = 1; i < states.size(); ++i) {
      const std::vector<maps::Slip> slips =
          maps::vertex_slips(garment, dressed(states.front()), dressed(states[i]));
      for (std::size_t v = 0; v < slips.size(); ++v)
        slip_[v] = std::max(slip_[v], slips[v].distance);
    }
  }
}

double RouteCost::cut_length(const geometry::PathPiece& piece) const {
  const Vec3 way = piece.to - piece.from;
  Vec2 flat = Vec2::Zero();
  for (int k = 0; k < 3; ++k) flat += way[k] * garment_.triangle_uv[piece.triangle][k];
  return flat.norm();
}

double RouteCost::worn_length(const geometry::PathPiece& piece,
                              const std::vector<Vec3>& positions) const {
  const Vec3 way = piece.to - piece.from;
  Vec3 worn = Vec3::Zero();
  for (int k = 0; k < 3; ++k) worn += way[k] * positions[garment_.triangles[piece.triangle][k]];
  return worn.norm();
}

double RouteCost::strain(const geometry::PathPiece& piece, double cut) const {
  if (!(cut > 0)) return 0;
  double worst = 0;
  for (const placement::WornState& state : states_)
    worst = std::max(worst, std::abs(worn_length(piece, state.positions) / cut - 1));
  return worst;
}

double RouteCost::curvature(const geometry::PathPiece& piece) const {
  double worst = 0;
  const Triangle& corners = garment_.triangles[piece.triangle];
  const Vec3 middle = 0.5 * (piece.from + piece.to), way = piece.to - piece.from;
  for (std::size_t s = 0; s < curvature_.size(); ++s) {
    Vec3 worn = Vec3::Zero();
    Mat3 tensor = Mat3::Zero();
    for (int k = 0; k < 3; ++k) {
      worn += way[k] * states_[s].positions[corners[k]];
      tensor += middle[k] * curvature_[s][corners[k]];
    }
    const Vec3 along = worn.stableNormalized();
    worst = std::max(worst, std::abs(along.dot(tensor * along)));
  }
  return worst;
}

double RouteCost::slip(const geometry::PathPiece& piece) const {
  if (slip_.empty()) return 0;
  const Vec3 middle = 0.5 * (piece.from + piece.to);
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += middle[k] * slip_[garment_.triangles[piece.triangle][k]];
  return sum;
}

double RouteCost::of(const geometry::PathPiece& piece) const {
  if (!kept_free_.empty() && kept_free_[piece.triangle])
    return std::numeric_limits<double>::infinity();
  const double cut = cut_length(piece);
  return cut * (prices_.own_strain + strain(piece, cut) +
                (curvature_.empty() ? 0 : prices_.bending * curvature(piece)) +
                prices_.slip * slip(piece));
}

bool RouteCost::is_seam(const geometry::PathSurface& surface, int edge) const {
  const auto sides = surface.topology().sides(edge);
  if (sides.size() < 2) return false;
  // Sewn together where the two triangles do not lie side by side in the pattern.
  const auto at = [&](const geometry::MeshTopology::Side& side, int vertex) {
    for (int k = 0; k < 3; ++k)
      if (garment_.triangles[side.triangle][k] == vertex)
        return garment_.triangle_uv[side.triangle][k];
    return Vec2(0, 0);
  };
  const geometry::MeshTopology::Edge& ends = surface.topology().edges()[edge];
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (garment_.triangle_panel[sides[0].triangle] != garment_.triangle_panel[sides[i].triangle])
      return true;
    for (const int vertex : ends)
      if (at(sides[0], vertex) != at(sides[i], vertex)) return true;
  }
  return false;
}

double RouteCost::of_crossing(const geometry::PathSurface& surface, int edge) const {
  return prices_.seam > 0 && is_seam(surface, edge) ? prices_.own_strain * prices_.seam : 0;
}

}  // namespace loosefit::lines
