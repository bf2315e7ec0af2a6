#include "loosefit/lines/find_routes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/geometry/path_graph.h"

namespace loosefit::lines {
namespace {

constexpr double kAgain = 3;        ///< what cloth near an earlier route costs more
constexpr double kSameRoute = 0.5;  ///< share of a route near earlier ones from which on it is one
constexpr double kDearest = 1e5;    ///< of a length against the wished price: nothing else counts
constexpr double kNarrow = 1.05;    ///< how well the price is found that a length limit asks for

/// The edge between two triangles; −1 where they have none in common.
int shared_edge(const geometry::PathSurface& surface, int a, int b) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (surface.topology().edge(a, i) == surface.topology().edge(b, j))
        return surface.topology().edge(a, i);
  return -1;
}

/// Which triangles lie near a route as worn.
std::vector<char> near(const garment::Garment& garment, const std::vector<Vec3>& positions,
                       const std::vector<Vec3>& route, double apart) {
  std::vector<char> found(garment.triangles.size(), 0);
  for (std::size_t t = 0; t < found.size(); ++t) {
    const Triangle& v = garment.triangles[t];
    const Vec3 middle = (positions[v[0]] + positions[v[1]] + positions[v[2]]) / 3;
    for (const Vec3& p : route)
      if ((p - middle).squaredNorm() < apart * apart) {
        found[t] = 1;
        break;
      }
  }
  return found;
}

/// Share of a course that lies in marked triangles.
double share_in(const LineCourse& course, const std::vector<char>& marked) {
  double length = 0;
  for (const CoursePiece& piece : course.pieces)
    if (marked[piece.triangle]) length += piece.cut;
  return length / course.length;
}

}  // namespace

Route judged(const garment::Garment& garment, const geometry::PathSurface& surface,
             LineCourse course, const std::vector<placement::WornState>& states) {
  Route route;
  route.course = std::move(course);
  const bool partners =
      std::all_of(states.begin(), states.end(), [&](const placement::WornState& state) {
        return state.worn.partners.size() == static_cast<std::size_t>(garment.vertex_count);
      });
  const RouteCost all(garment, states, {.bending = 1, .slip = partners ? 1.0 : 0.0});
  if (!partners) route.slip = std::numeric_limits<double>::quiet_NaN();
  double sharpest = 0;
  const std::vector<CoursePiece>& pieces = route.course.pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    route.mean_strain += pieces[i].cut * all.strain(pieces[i], pieces[i].cut) / route.course.length;
    sharpest = std::max(sharpest, all.curvature(pieces[i]));
    if (partners) route.slip = std::max(route.slip, all.slip(pieces[i]));
    if (i > 0 && pieces[i].triangle != pieces[i - 1].triangle) {
      const int edge = shared_edge(surface, pieces[i - 1].triangle, pieces[i].triangle);
      route.seams += edge >= 0 && all.is_seam(surface, edge);
    }
  }
  route.bend_radius = sharpest > 0 ? 1 / sharpest : std::numeric_limits<double>::infinity();
  for (const placement::WornState& state : states) {
    std::vector<double> worn(route.course.parts, 0.0);
    for (const CoursePiece& piece : pieces)
      worn[piece.part] += all.worn_length(piece, state.positions);
    for (const double length : worn)
      route.strain = std::max(route.strain, std::abs(length / route.course.part_length() - 1));
  }
  return route;
}

std::vector<Route> find_routes(const garment::Garment& garment,
                               const geometry::PathSurface& surface,
                               const std::vector<placement::GarmentPoint>& stops,
                               const std::vector<placement::WornState>& states,
                               const RouteWish& wish) {
  RouteCost prices(garment, states, wish.prices, wish.kept_free);
  std::vector<char> taken(garment.triangles.size(), 0);
  const geometry::PieceCost cost = [&](const geometry::PathPiece& piece) {
    return prices.of(piece) * (taken[piece.triangle] ? kAgain : 1);
  };
  const geometry::CrossingCost crossing = [&](int edge) {
    return prices.of_crossing(surface, edge);
  };
  const auto cheapest = [&](double own_strain) {
    prices.set_own_strain(own_strain);
    geometry::SurfacePath whole;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const auto leg = geometry::cheapest_path(surface, {stops[i].triangle, stops[i].barycentric},
                                               {stops[i + 1].triangle, stops[i + 1].barycentric},
                                               cost, crossing);
      if (!leg)
        throw InvalidInput({"", 0, "to"}, "a place to which no cloth leads",
                           "stops on cloth that hangs together, outside of what is kept free", "");
      const geometry::SurfacePath refined = geometry::refine_crossings(surface, *leg, cost);
      whole.insert(whole.end(), refined.begin(), refined.end());
    }
    return course_along(garment, whole, stops, wish.part);
  };
  const auto fits = [&](const LineCourse& course) {
    return !(wish.longest > 0) || course.length <= wish.longest;
  };
  /// The cheapest one that is not too long; nothing where none is.
  const auto short_enough = [&]() -> std::optional<LineCourse> {
    LineCourse course = cheapest(wish.prices.own_strain);
    if (fits(course)) return course;
    double low = wish.prices.own_strain, high = low * kDearest;
    course = cheapest(high);
    if (!fits(course)) return std::nullopt;
    while (high > kNarrow * low) {
      const double middle = std::sqrt(low * high);
      LineCourse tried = cheapest(middle);
      if (fits(tried)) {
        high = middle;
        course = std::move(tried);
      } else {
        low = middle;
      }
    }
    return course;
  };
  std::vector<Route> routes;
  for (int k = 0; k <= wish.alternatives; ++k) {
    std::optional<LineCourse> course = short_enough();
    if (!course && k == 0)
      throw InvalidInput({"", 0, "longest"}, fmt::format("{:g} m", wish.longest),
                         fmt::format("at least {:.3f} m, the shortest way between the stops",
                                     cheapest(wish.prices.own_strain * kDearest).length),
                         "");
    if (!course || (k > 0 && share_in(*course, taken) > kSameRoute)) continue;
    Route route = judged(garment, surface, std::move(*course), states);
    const std::vector<char> own =
        near(garment, states.front().positions,
             in_space(garment, route.course, states.front().positions), wish.apart);
    for (std::size_t t = 0; t < taken.size(); ++t) taken[t] |= own[t];
    routes.push_back(std::move(route));
  }
  return routes;
}

}  // namespace loosefit::lines
