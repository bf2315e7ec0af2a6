#include "loosefit/drape/refine_contact.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loosefit::drape {
namespace {

using contact::BodyContact;
using contact::ContactLattice;
using contact::ContactPoint;

Vec3 place(const Triangle& t, const ContactLattice::Weights& w, const std::vector<Vec3>& x) {
  return w[0] * x[t[0]] + w[1] * x[t[1]] + w[2] * x[t[2]];
}

/// Distances to the skin and how they are asked for.
struct Skin {
  const contact::DistanceField& field;
  const PenetrationTuning& tuning;

  /// By the smooth field, up to `reach` [m].
  double smooth(const Vec3& p, double reach) const {
    contact::DistanceField::Sample sample;
    return field.sample(p, reach, false, sample) ? sample.distance : reach;
  }
  /// The exact one, where the smooth one is known [m].
  double exact(const Vec3& p, double smooth) const {
    return field.exact_distance(p, std::abs(smooth) + tuning.largest_field_error);
  }
};

/// Triangles that are near the skin and have no lattice yet, ascending.
std::vector<int> near_triangles(const ContactLattice& lattice, const BodyContact& contact,
                                const std::vector<Vec3>& x, const Skin& skin) {
  const auto& triangles = lattice.triangles();
  const double reach = skin.tuning.far;
  std::vector<char> near(contact.points().size());
  tbb::parallel_for(std::size_t{0}, near.size(), [&](std::size_t i) {
    near[i] = skin.smooth(contact.points()[i].position(x), reach) < reach;
  });
  std::vector<int> found;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    if (lattice.is_refined(t)) continue;
    const std::vector<int> points = lattice.points_of(t);
    if (std::any_of(points.begin(), points.end(), [&](int p) { return near[p]; }))
      found.push_back(t);
  }
  return found;
}

/// A place of a cell at which the cloth is nearer to the skin than at the cell's corners.
struct Nearest {
  int cell;
  ContactLattice::Weights at;
};

std::vector<Nearest> nearest_places(
    const Triangle& t, const std::vector<Vec3>& x,
    const std::vector<std::array<ContactLattice::Weights, 3>>& cells, double offset,
    const Skin& skin) {
  std::vector<Nearest> found;
  const PenetrationTuning& tuning = skin.tuning;
  const auto exact = [&](const ContactLattice::Weights& w) {
    const Vec3 p = place(t, w, x);
    const double smooth = skin.smooth(p, tuning.far);
    return smooth < tuning.far ? skin.exact(p, smooth) : tuning.far;
  };
  // Up to six cells meet at a corner.
  std::vector<std::pair<ContactLattice::Weights, double>> known;
  const auto exact_at_corner = [&](const ContactLattice::Weights& w) {
    for (const auto& [at, distance] : known)
      if (at == w) return distance;
    return known.emplace_back(w, exact(w)).second;
  };
  for (std::size_t c = 0; c < cells.size(); ++c) {
    // Places of the cell by the weights of its first two corners.
    using Place = std::array<double, 2>;
    const auto weights = [&](const Place& at) {
      ContactLattice::Weights w{};
      for (int k = 0; k < 3; ++k)
        w[k] =
            at[0] * cells[c][0][k] + at[1] * cells[c][1][k] + (1 - at[0] - at[1]) * cells[c][2][k];
      return w;
    };
    Place best{};
    double least = std::numeric_limits<double>::infinity();
    const auto try_place = [&](const Place& at) {
      if (std::min({at[0], at[1], 1 - at[0] - at[1]}) < 0) return;
      const double distance = exact(weights(at));
      if (distance < least) least = distance, best = at;
    };
    const std::array<Place, 3> corners = {{{1, 0}, {0, 1}, {0, 0}}};
    for (int k = 0; k < 3; ++k)
      if (const double distance = exact_at_corner(cells[c][k]); distance < least)
        least = distance, best = corners[k];
    const double at_corners = least;
    if (at_corners > offset + tuning.bulge) continue;
    const int n = tuning.cell_intervals;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j <= n; ++j)
        if (j < n && i + j > 0) try_place({double(i) / n, double(j) / n});
    if (!(least < at_corners - tuning.worth_a_point)) continue;
    // The nearest place is at a corner or an edge of the skin: close in on it.
    for (double step = 0.5 / n; step > tuning.least_step; step /= 2) {
      const Place middle = best;
      for (const Place& way :
           {Place{1, 0}, Place{-1, 0}, Place{0, 1}, Place{0, -1}, Place{1, -1}, Place{-1, 1}})
        try_place({middle[0] + step * way[0], middle[1] + step * way[1]});
    }
    if (least < std::min(offset, at_corners - tuning.worth_a_point))
      found.push_back({static_cast<int>(c), weights(best)});
  }
  return found;
}

/// Measures the field's error at all points near the skin; the largest change where it matters.
double measure_field_errors(BodyContact& contact, const std::vector<Vec3>& x, const Skin& skin) {
  std::vector<ContactPoint>& points = contact.change_points();
  const PenetrationTuning& tuning = skin.tuning;
  std::vector<double> change(points.size(), 0.0);
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    ContactPoint& p = points[i];
    const Vec3 at = p.position(x);
    const double smooth = skin.smooth(at, tuning.far);
    if (!(std::abs(smooth) < tuning.far)) return;
    const double error = std::clamp(smooth - skin.exact(at, smooth), -tuning.largest_field_error,
                                    tuning.largest_field_error);
    if (smooth - std::min(error, p.field_error) < p.offset)
      change[i] = std::abs(error - p.field_error);
    p.field_error = error;
  });
  return points.empty() ? 0 : *std::max_element(change.begin(), change.end());
}

}  // namespace

ContactRefinement refine_contact(ClothModel& model, const ContactBody& body,
                                 const std::vector<Vec3>& x, const std::set<int>& cut,
                                 const PenetrationTuning& tuning) {
  ContactRefinement done;
  const Skin skin{*body.field, tuning};
  for (int layer = 0; layer < model.mesh().layers(); ++layer) {
    BodyContact& contact = model.body(layer);
    ContactLattice& lattice = model.lattice(layer);
    std::vector<ContactPoint>& points = contact.change_points();
    for (int t : near_triangles(lattice, contact, x, skin)) {
      lattice.refine(t, points);
      ++done.triangles;
    }
    const auto cells = ContactLattice::cells(lattice.intervals());
    const auto& triangles = lattice.triangles();
    std::vector<std::vector<Nearest>> nearest(triangles.size());
    tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t t) {
      if (lattice.is_refined(static_cast<int>(t)))
        nearest[t] = nearest_places(triangles[t], x, cells, points[0].offset, skin);
    });
    const std::size_t before = points.size();
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const Nearest& n : nearest[t])
        lattice.add_nearest(static_cast<int>(t), n.cell, n.at,
                            cut.count(static_cast<int>(t) + model.mesh().first_triangle[layer]) > 0,
                            points);
    done.places += static_cast<int>(points.size() - before);
    done.largest_change = std::max(done.largest_change, measure_field_errors(contact, x, skin));
  }
  return done;
}

}  // namespace loosefit::drape
