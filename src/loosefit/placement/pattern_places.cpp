#include "loosefit/placement/pattern_places.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/placement/resample.h"

namespace loosefit::placement {
namespace {

constexpr double kInside = -1e-9;  // a point on an edge must not fall between two triangles
constexpr int kLatticePerSpacing = 8;

/// Barycentric weights in the flat triangle; NaN when it has no area.
Vec3 flat_barycentric(const geometry::FlatCorners& uv, const Vec2& p) {
  const double area = geometry::cross(uv[1] - uv[0], uv[2] - uv[0]);
  const double b = geometry::cross(p - uv[0], uv[2] - uv[0]) / area;
  const double c = geometry::cross(uv[1] - uv[0], p - uv[0]) / area;
  return {1 - b - c, b, c};
}

struct Box {
  Vec2 lower = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 upper = -lower;
  void add(const Vec2& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
};

Box box_of(const std::array<Vec2, 3>& uv) {
  Box box;
  for (const Vec2& p : uv) box.add(p);
  return box;
}

/// Places of one panel that are kept so far, on a grid of cells of one spacing.
class Kept {
 public:
  explicit Kept(double spacing) : spacing_(spacing) {}
  bool room_for(const Vec2& p) const {
    const auto [i, j] = cell(p);
    for (int di = -1; di <= 1; ++di)
      for (int dj = -1; dj <= 1; ++dj) {
        const auto at = cells_.find({i + di, j + dj});
        if (at == cells_.end()) continue;
        for (const Vec2& q : at->second)
          if ((p - q).norm() < spacing_) return false;
      }
    return true;
  }
  void add(const Vec2& p) { cells_[cell(p)].push_back(p); }

 private:
  std::pair<long, long> cell(const Vec2& p) const {
    return {std::lround(std::floor(p.x() / spacing_)), std::lround(std::floor(p.y() / spacing_))};
  }
  double spacing_;
  std::map<std::pair<long, long>, std::vector<Vec2>> cells_;
};

}  // namespace

Vec3 at_place(const garment::Garment& garment, const PatternPlace& place,
              const std::vector<Vec3>& field) {
  const Triangle& corner = garment.triangles[place.triangle];
  Vec3 value = Vec3::Zero();
  for (int k = 0; k < 3; ++k) value += place.barycentric[k] * field[corner[k]];
  return value;
}

PatternLocator::PatternLocator(const garment::Garment& garment)
    : garment_(garment), grids_(garment.panel_names.size()) {
  std::vector<Box> boxes(grids_.size());
  double widest = 1e-4;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const Box box = box_of(garment.triangle_uv[t]);
    boxes[garment.triangle_panel[t]].add(box.lower);
    boxes[garment.triangle_panel[t]].add(box.upper);
    widest = std::max(widest, (box.upper - box.lower).maxCoeff());
  }
  cell_ = widest;
  for (std::size_t p = 0; p < grids_.size(); ++p) {
    if (!(boxes[p].upper.x() >= boxes[p].lower.x())) continue;  // a panel without triangles
    const Vec2 size = boxes[p].upper - boxes[p].lower;
    grids_[p].lower = boxes[p].lower;
    grids_[p].columns = static_cast<int>(size.x() / cell_) + 1;
    grids_[p].rows = static_cast<int>(size.y() / cell_) + 1;
    grids_[p].triangles.resize(static_cast<std::size_t>(grids_[p].columns) * grids_[p].rows);
  }
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    Grid& grid = grids_[garment.triangle_panel[t]];
    const Box box = box_of(garment.triangle_uv[t]);
    const Vec2 low = (box.lower - grid.lower) / cell_, high = (box.upper - grid.lower) / cell_;
    for (int i = static_cast<int>(low.x()); i <= static_cast<int>(high.x()); ++i)
      for (int j = static_cast<int>(low.y()); j <= static_cast<int>(high.y()); ++j)
        grid.triangles[static_cast<std::size_t>(j) * grid.columns + i].push_back(t);
  }
}

std::optional<PatternPlace> PatternLocator::find(int panel, const Vec2& at) const {
  if (panel < 0 || panel >= static_cast<int>(grids_.size())) return std::nullopt;
  const Grid& grid = grids_[panel];
  if (grid.triangles.empty()) return std::nullopt;
  const Vec2 place = (at - grid.lower) / cell_;
  // A point that rounding puts just outside the panel's box still belongs to the first cell.
  if (!(place.x() > -1e-6 && place.y() > -1e-6 && place.x() < grid.columns &&
        place.y() < grid.rows))
    return std::nullopt;
  const int i = static_cast<int>(place.x()), j = static_cast<int>(place.y());
  for (int t : grid.triangles[static_cast<std::size_t>(j) * grid.columns + i]) {
    const Vec3 weights = flat_barycentric(garment_.triangle_uv[t], at);
    if (weights.minCoeff() >= kInside) return PatternPlace{panel, at, t, weights};
  }
  return std::nullopt;
}

std::vector<PatternPlace> poisson_places(const PatternLocator& locator, double spacing,
                                         std::uint64_t seed) {
  if (!(spacing >= 0.001 && spacing <= 1))
    throw InvalidInput("candidate spacing: found " + shortest(spacing) +
                       ", expected metres from 0.001 to 1");
  const garment::Garment& garment = locator.garment();
  const double pitch = spacing / kLatticePerSpacing;
  std::vector<PatternPlace> pool, places;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const int panel = garment.triangle_panel[t];
    const Box box = box_of(garment.triangle_uv[t]);
    const auto first = [&](double low) { return std::lround(std::ceil(low / pitch)); };
    for (long i = first(box.lower.x()); i * pitch <= box.upper.x(); ++i)
      for (long j = first(box.lower.y()); j * pitch <= box.upper.y(); ++j) {
        // To the nanometre: 0.0875, not 0.08750000000000001, when it is written out.
        const Vec2 at(std::round(i * pitch * 1e9) / 1e9, std::round(j * pitch * 1e9) / 1e9);
        const auto place = locator.find(panel, at);
        if (place && place->triangle == static_cast<int>(t)) pool.push_back(*place);
      }
  }
  std::vector<Kept> kept(garment.panel_names.size(), Kept(spacing));
  for (int k : shuffled(static_cast<int>(pool.size()), seed)) {
    if (!kept[pool[k].panel].room_for(pool[k].at)) continue;
    kept[pool[k].panel].add(pool[k].at);
    places.push_back(pool[k]);
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.panel < b.panel; });
  return places;
}

PanelBorders::PanelBorders(const garment::Garment& garment)
    : seams_(garment.panel_names.size()), free_(garment.panel_names.size()) {
  // An edge of the flat panel belongs to one of its triangles; so does a seam's, but the sewn mesh
  // has a second triangle at the same two vertices.
  using FlatEdge = std::array<double, 4>;
  const auto flat = [](const Vec2& a, const Vec2& b) {
    const bool swap = std::pair(a.x(), a.y()) > std::pair(b.x(), b.y());
    const Vec2 &p = swap ? b : a, &q = swap ? a : b;
    return FlatEdge{p.x(), p.y(), q.x(), q.y()};
  };
  std::map<std::pair<int, FlatEdge>, int> in_panel;
  const geometry::MeshTopology topology(garment.triangles);
  const auto each = [&](const auto& visit) {
    for (std::size_t t = 0; t < garment.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const auto& uv = garment.triangle_uv[t];
        visit(std::pair(garment.triangle_panel[t], flat(uv[k], uv[next])),
              topology.edge(static_cast<int>(t), k), Segment(uv[k], uv[next]));
      }
  };
  each([&](const auto& edge, int, const Segment&) { ++in_panel[edge]; });
  each([&](const auto& edge, int sewn, const Segment& segment) {
    if (in_panel[edge] == 1)
      (topology.sides(sewn).size() > 1 ? seams_ : free_)[edge.first].push_back(segment);
  });
}

double PanelBorders::distance(const std::vector<Segment>& segments, const Vec2& at) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : segments) {
    const Vec2 along = b - a;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((at - a).dot(along) / length2, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (a + share * along - at).norm());
  }
  return nearest;
}

}  // namespace loosefit::placement
