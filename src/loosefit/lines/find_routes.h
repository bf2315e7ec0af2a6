#pragma once
#include <vector>

#include "loosefit/lines/course.h"
#include "loosefit/lines/line_state.h"
#include "loosefit/lines/route_cost.h"

namespace loosefit::lines {

/// A way that a lead may take, and what it would bear there.
struct Route {
  LineCourse course;
  double strain = 0;       ///< greatest of any of its parts in any state, either way [–]
  double mean_strain = 0;  ///< of the worst of all states at each place, mean along it [–]
  double bend_radius = 0;  ///< least to which the cloth bends along it [m]; ∞: straight
  double slip = 0;         ///< greatest slip of the cloth under it since the first state [m]; NaN: skin not known
  int seams = 0;           ///< that it crosses
};

/// What routes are wished for.
struct RouteWish {
  double part = 0.010;   ///< wished length of the parts in which they are told [m]
  int alternatives = 2;  ///< beside the best one
  double apart = 0.03;   ///< cloth this near to an earlier route costs more to the next one [m]
  RoutePrices prices = {};
  double longest = 0;                ///< in the flat cloth [m]; 0: any length
  std::vector<char> kept_free = {};  ///< per triangle, as RouteCost
};

/// The routes between stops that cost least by RouteCost, best first: where the cloth is stretched
/// least, and bends, slips and is sewn least as far as these have a price. Found on a graph over
/// the mesh (geometry/path_graph.h) and then moved along the edges that they cross until nothing is
/// gained. A route longer than `longest` is sought again with a dearer length, the least (within a
/// twentieth) with which it is short enough. Each further one pays three times as much within
/// `apart` of the earlier ones, as worn in the first state, and is left out where more than half of
/// it lies there all the same, or where none is short enough.
/// \throws InvalidInput, key "to", for stops with no way between them; key "longest" where even the
/// shortest way is longer. \pre there are states
std::vector<Route> find_routes(const garment::Garment& garment,
                               const geometry::PathSurface& surface,
                               const std::vector<placement::GarmentPoint>& stops,
                               const std::vector<placement::WornState>& states,
                               const RouteWish& wish = {});

/// What a given way would bear.
Route judged(const garment::Garment& garment, const geometry::PathSurface& surface,
             LineCourse course, const std::vector<placement::WornState>& states);

}  // namespace loosefit::lines
