#pragma once
#include <vector>

#include "loosefit/lines/course.h"
#include "loosefit/lines/line_state.h"

namespace loosefit::lines {

/// A way that a lead may take, and what it would bear there.
struct Route {
  LineCourse course;
  double strain = 0;       ///< greatest of any of its parts in any state, either way [–]
  double mean_strain = 0;  ///< of the worst of all states at each place, mean along it [–]
};

/// What routes are wished for.
struct RouteWish {
  double part = 0.010;       ///< wished length of the parts in which they are told [m]
  int alternatives = 2;      ///< beside the best one
  double apart = 0.03;       ///< cloth this near to an earlier route costs more to the next one [m]
  double own_strain = 0.01;  ///< strain that a detour of once its length may save [–]
};

/// The routes between stops that are stretched least: paths over the flat cloth of which
///
///     ∫ (own_strain + max over states |λ − 1|) ds
///
/// is least, λ the stretch of the cloth along the path. Found on a graph over the mesh
/// (geometry/path_graph.h) and then moved along the edges that they cross until nothing is gained;
/// best first. Each further one pays three times as much within `apart` of the earlier ones, as
/// worn in the first state, and is left out where more than half of it lies there all the same.
/// \throws InvalidInput, key "to", for stops with no way between them. \pre there are states
std::vector<Route> find_routes(const garment::Garment& garment,
                               const geometry::PathSurface& surface,
                               const std::vector<placement::GarmentPoint>& stops,
                               const std::vector<placement::WornState>& states,
                               const RouteWish& wish = {});

/// What a given way would bear.
Route judged(const garment::Garment& garment, LineCourse course,
             const std::vector<placement::WornState>& states);

}  // namespace loosefit::lines
