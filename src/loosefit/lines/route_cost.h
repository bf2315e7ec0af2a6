#pragma once
#include <vector>

#include "loosefit/geometry/path_graph.h"
#include "loosefit/lines/course.h"
#include "loosefit/placement/site_state.h"

namespace loosefit::lines {

/// What a lead pays for on its way, told as strain: see find_routes.
struct RoutePrices {
  double own_strain = 0.01;  ///< that a detour of once its length may save [–]
  double bending = 0;        ///< per curvature of the cloth along it, 1/m: half its thickness [m]
  double slip = 0;           ///< per metre by which the cloth slips on the skin [1/m]
  double seam = 0;           ///< way that is as dear as to cross a seam [m]
};

/// The price of ways over a garment, the worst of several states at every place. Refers to
/// everything.
///
///     ∫ (own_strain + max |λ − 1| + bending · max |κ| + slip · max s) ds + own_strain · seam · n
///
/// λ, κ the stretch and the curvature of the draped cloth along the way, s the slip of the cloth
/// since the first state (0 in that), n the seams that are crossed; infinite in what is kept free.
class RouteCost {
 public:
  /// kept_free: per triangle, not 0 where no way may lead; empty: nowhere.
  /// \throws InvalidInput as maps::vertex_slips, when slip has a price.
  RouteCost(const garment::Garment& garment, const std::vector<placement::WornState>& states,
            const RoutePrices& prices, std::vector<char> kept_free = {});

  double of(const geometry::PathPiece& piece) const;
  /// Of crossing an edge of that surface, which is the garment's.
  double of_crossing(const geometry::PathSurface& surface, int edge) const;
  /// Whether the two sides of an edge are sewn together.
  bool is_seam(const geometry::PathSurface& surface, int edge) const;
  void set_own_strain(double own_strain) { prices_.own_strain = own_strain; }

  /// Of a piece, the greatest of all states.
  double strain(const geometry::PathPiece& piece, double cut) const;
  double curvature(const geometry::PathPiece& piece) const;  ///< [1/m]
  double slip(const geometry::PathPiece& piece) const;       ///< [m]
  double cut_length(const geometry::PathPiece& piece) const;
  double worn_length(const geometry::PathPiece& piece, const std::vector<Vec3>& positions) const;

 private:
  const garment::Garment& garment_;
  const std::vector<placement::WornState>& states_;
  RoutePrices prices_;
  std::vector<char> kept_free_;
  std::vector<std::vector<Mat3>> curvature_;  ///< per state and vertex; empty: has no price
  std::vector<double> slip_;                  ///< per vertex, the greatest [m]; empty likewise
};

}  // namespace loosefit::lines
