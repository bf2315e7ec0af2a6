#include "loosefit/lines/find_routes.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/geometry/path_graph.h"

namespace loosefit::lines {
namespace {

constexpr double kAgain = 3;        ///< what cloth near an earlier route costs more
constexpr double kSameRoute = 0.5;  ///< share of a route near earlier ones from which on it is one

/// |stretch − 1| along a piece, the greatest of all states.
class WorstStrain {
 public:
  WorstStrain(const garment::Garment& garment, const std::vector<placement::WornState>& states)
      : garment_(garment), states_(states) {}

  double cut_length(const geometry::PathPiece& piece) const {
    const Vec3 way = piece.to - piece.from;
    Vec2 flat = Vec2::Zero();
    for (int k = 0; k < 3; ++k) flat += way[k] * garment_.triangle_uv[piece.triangle][k];
    return flat.norm();
  }
  double of(const geometry::PathPiece& piece, double cut) const {
    if (!(cut > 0)) return 0;
    double worst = 0;
    for (const placement::WornState& state : states_)
      worst = std::max(worst, std::abs(worn_length(piece, state) / cut - 1));
    return worst;
  }
  static double worn_length(const garment::Garment& garment, const geometry::PathPiece& piece,
                            const placement::WornState& state) {
    const Vec3 way = piece.to - piece.from;
    Vec3 worn = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      worn += way[k] * state.positions[garment.triangles[piece.triangle][k]];
    return worn.norm();
  }

 private:
  double worn_length(const geometry::PathPiece& piece, const placement::WornState& state) const {
    return worn_length(garment_, piece, state);
  }
  const garment::Garment& garment_;
  const std::vector<placement::WornState>& states_;
};

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

Route judged(const garment::Garment& garment, LineCourse course,
             const std::vector<placement::WornState>& states) {
  Route route;
  route.course = std::move(course);
  const WorstStrain strain(garment, states);
  for (const CoursePiece& piece : route.course.pieces)
    route.mean_strain += piece.cut * strain.of(piece, piece.cut) / route.course.length;
  for (const placement::WornState& state : states) {
    std::vector<double> worn(route.course.parts, 0.0);
    for (const CoursePiece& piece : route.course.pieces)
      worn[piece.part] += WorstStrain::worn_length(garment, piece, state);
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
  const WorstStrain strain(garment, states);
  std::vector<char> taken(garment.triangles.size(), 0);
  const geometry::PieceCost cost = [&](const geometry::PathPiece& piece) {
    const double cut = strain.cut_length(piece);
    return cut * (wish.own_strain + strain.of(piece, cut)) * (taken[piece.triangle] ? kAgain : 1);
  };
  std::vector<Route> routes;
  for (int k = 0; k <= wish.alternatives; ++k) {
    geometry::SurfacePath whole;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const auto leg =
          geometry::cheapest_path(surface, {stops[i].triangle, stops[i].barycentric},
                                  {stops[i + 1].triangle, stops[i + 1].barycentric}, cost);
      if (!leg)
        throw InvalidInput({"", 0, "to"}, "a place to which no cloth leads",
                           "stops on cloth that hangs together", "");
      const geometry::SurfacePath refined = geometry::refine_crossings(surface, *leg, cost);
      whole.insert(whole.end(), refined.begin(), refined.end());
    }
    Route route = judged(garment, course_along(garment, whole, stops, wish.part), states);
    if (k > 0 && share_in(route.course, taken) > kSameRoute) continue;
    const std::vector<char> own =
        near(garment, states.front().positions,
             in_space(garment, route.course, states.front().positions), wish.apart);
    for (std::size_t t = 0; t < taken.size(); ++t) taken[t] |= own[t];
    routes.push_back(std::move(route));
  }
  return routes;
}

}  // namespace loosefit::lines
