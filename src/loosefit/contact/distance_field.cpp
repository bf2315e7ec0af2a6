#include "loosefit/contact/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/check.h"
#include "loosefit/particles/tile.h"

namespace loosefit::contact {
namespace {

constexpr auto kRelaxed = std::memory_order_relaxed;

/// Catmull-Rom weights of the four nodes around t ∈ [0, 1], with first and second derivatives.
struct Weights {
  double w[4], d[4], dd[4];
  explicit Weights(double t) {
    const double t2 = t * t, t3 = t2 * t;
    w[0] = 0.5 * (-t + 2 * t2 - t3);
    w[1] = 0.5 * (2 - 5 * t2 + 3 * t3);
    w[2] = 0.5 * (t + 4 * t2 - 3 * t3);
    w[3] = 0.5 * (-t2 + t3);
    d[0] = 0.5 * (-1 + 4 * t - 3 * t2);
    d[1] = 0.5 * (-10 * t + 9 * t2);
    d[2] = 0.5 * (1 + 8 * t - 9 * t2);
    d[3] = 0.5 * (-2 * t + 3 * t2);
    dd[0] = 2 - 3 * t;
    dd[1] = -5 + 9 * t;
    dd[2] = 4 - 9 * t;
    dd[3] = -1 + 3 * t;
  }
};

/// Whether every edge belongs to two triangles, which run along it in opposite senses, and the
/// inside is inside.
bool closed_outwards(const geometry::TriangleMesh& mesh) {
  std::vector<std::pair<int, int>> there, back;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      there.emplace_back(t[k], t[(k + 1) % 3]);
      back.emplace_back(t[(k + 1) % 3], t[k]);
    }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  return there == back && std::adjacent_find(there.begin(), there.end()) == there.end() &&
         geometry::enclosed_volume(mesh) > 0;
}

}  // namespace

DistanceField::Cover::Cover(const geometry::TriangleMesh& surface) : mesh(surface), tree(mesh) {
  for (const Vec3& p : mesh.vertices) box.extend(p);
}

DistanceField::DistanceField(const geometry::ClosestPointTree& tree, const geometry::Box3& region,
                             double spacing, const std::vector<geometry::TriangleMesh>& covers)
    : tree_(tree), requested_spacing_(spacing), spacing_(spacing) {
  LOOSEFIT_ASSERT(
      closed_outwards(tree.mesh()) &&
      std::all_of(covers.begin(), covers.end(), [](const geometry::TriangleMesh& cover) {
        return cover.triangles.empty() || closed_outwards(cover);
      }));
  const Vec3 margin = Vec3::Constant(4 * spacing_);
  origin_ = region.min() - margin;
  const Vec3 extent = region.sizes() + 2 * margin;
  while (extent.prod() / (spacing_ * spacing_ * spacing_) > kContact.field.max_nodes)
    spacing_ *= kContact.field.coarsening;
  for (int k = 0; k < 3; ++k) size_[k] = 4 + static_cast<int>(extent[k] / spacing_);
  const int count = size_[0] * size_[1] * size_[2];
  value_ = std::vector<std::atomic<float>>(count);
  for (auto& v : value_) v.store(std::numeric_limits<float>::quiet_NaN(), kRelaxed);
  zone_.assign(count, Zone::inside);
  mark_near(tree.mesh());
  for (const geometry::TriangleMesh& cover : covers) {
    if (cover.triangles.empty()) continue;
    mark_near(cover);
    covers_.emplace_back(cover);
  }
  flood_outside();
}

float DistanceField::measure(int x, int y, int z) const {
  // Distance is 1-Lipschitz: a measured neighbour bounds it.
  double bound = std::numeric_limits<double>::infinity();
  const auto bound_by = [&](int i) {
    const float v = value_[i].load(kRelaxed);
    if (!std::isnan(v)) bound = std::min(bound, std::abs(v) + 1.001 * spacing_);
  };
  if (x > 0) bound_by(index(x - 1, y, z));
  if (x + 1 < size_[0]) bound_by(index(x + 1, y, z));
  if (y > 0) bound_by(index(x, y - 1, z));
  if (y + 1 < size_[1]) bound_by(index(x, y + 1, z));
  if (z > 0) bound_by(index(x, y, z - 1));
  if (z + 1 < size_[2]) bound_by(index(x, y, z + 1));
  return static_cast<float>(exact_distance(place(x, y, z), bound));
}

double DistanceField::exact_distance(const Vec3& p, double bound) const {
  // Covered skin may lie beyond the bound, and is then beyond the cover too.
  double distance = tree_.signed_distance(p, nullptr, bound);
  for (const Cover& cover : covers_)
    if (cover.box.exteriorDistance(p) <= std::max(0.0, distance))
      distance = std::min(distance, cover.tree.signed_distance(p));
  return distance;
}

float DistanceField::value(int x, int y, int z) const {
  const int i = index(x, y, z);
  float v = value_[i].load(kRelaxed);
  if (std::isnan(v) && zone_[i] == Zone::band) {
    v = measure(x, y, z);
    value_[i].store(v, kRelaxed);
  }
  return v;
}

void DistanceField::flood_outside() {
  // What can be reached from the rim of the grid without crossing the band is outside.
  std::vector<int> stack;
  const auto visit = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= size_[0] || y >= size_[1] || z >= size_[2]) return;
    const int i = index(x, y, z);
    if (zone_[i] != Zone::inside) return;
    zone_[i] = Zone::outside;
    stack.push_back(i);
  };
  // The rim may cut through the body (legs, head): only rim nodes that are outside seed the flood.
  const auto seed = [&](int x, int y, int z) {
    if (zone_[index(x, y, z)] == Zone::inside && tree_.signed_distance(place(x, y, z)) > 0)
      visit(x, y, z);
  };
  const auto drain = [&] {
    while (!stack.empty()) {
      const int i = stack.back();
      stack.pop_back();
      const int x = i % size_[0], y = i / size_[0] % size_[1], z = i / (size_[0] * size_[1]);
      visit(x - 1, y, z);
      visit(x + 1, y, z);
      visit(x, y - 1, z);
      visit(x, y + 1, z);
      visit(x, y, z - 1);
      visit(x, y, z + 1);
    }
  };
  for (int x : {0, size_[0] - 1})
    for (int y : {0, size_[1] - 1})
      for (int z : {0, size_[2] - 1}) {
        seed(x, y, z);
        drain();
      }
  for (int z = 0; z < size_[2]; ++z)
    for (int y = 0; y < size_[1]; ++y)
      for (int x = 0; x < size_[0]; ++x)
        if (x == 0 || y == 0 || z == 0 || x + 1 == size_[0] || y + 1 == size_[1] ||
            z + 1 == size_[2]) {
          seed(x, y, z);
          drain();
        }
}

void DistanceField::mark_near(const geometry::TriangleMesh& mesh) {
  const double band = kContact.field.band_cells * spacing_;
  for (const Triangle& t : mesh.triangles) {
    geometry::Box3 box;
    for (int v : t) box.extend(mesh.vertices[v]);
    int lower[3], upper[3];
    for (int k = 0; k < 3; ++k) {
      lower[k] =
          std::max(0, static_cast<int>(std::ceil((box.min()[k] - band - origin_[k]) / spacing_)));
      upper[k] =
          std::min(size_[k] - 1,
                   static_cast<int>(std::floor((box.max()[k] + band - origin_[k]) / spacing_)));
    }
    for (int z = lower[2]; z <= upper[2]; ++z)
      for (int y = lower[1]; y <= upper[1]; ++y)
        for (int x = lower[0]; x <= upper[0]; ++x) zone_[index(x, y, z)] = Zone::band;
  }
}

bool DistanceField::measure_round(const std::array<int, 3>& cell) const {
  bool all = true;
  for (int z = cell[2] - 1; z <= cell[2] + 2; ++z)
    for (int y = cell[1] - 1; y <= cell[1] + 2; ++y)
      for (int x = cell[0] - 1; x <= cell[0] + 2; ++x) all &= !std::isnan(value(x, y, z));
  return all;
}

bool DistanceField::interpolate(const std::array<int, 3>& cell, const Vec3& q, bool with_hessian,
                                Sample& out) const {
  const Weights wx(q[0] - cell[0]), wy(q[1] - cell[1]), wz(q[2] - cell[2]);
  // Contracted over y and z first, four nodes of a row at a time.
  particles::Quad in_y[4][3] = {};  // rows at c, contracted over y with w, d, dd
  for (int c = 0; c < 4; ++c)
    for (int b = 0; b < 4; ++b) {
      const int x = cell[0] - 1, y = cell[1] - 1 + b, z = cell[2] - 1 + c;
      const std::atomic<float>* node = &value_[index(x, y, z)];
      const particles::Quad row = {node[0].load(kRelaxed), node[1].load(kRelaxed),
                                   node[2].load(kRelaxed), node[3].load(kRelaxed)};
      in_y[c][0] += wy.w[b] * row;
      in_y[c][1] += wy.d[b] * row;
      if (with_hessian) in_y[c][2] += wy.dd[b] * row;
    }
  particles::Quad r{}, ry{}, rz{}, ryy{}, rzz{}, ryz{};
  for (int c = 0; c < 4; ++c) {
    r += wz.w[c] * in_y[c][0];
    ry += wz.w[c] * in_y[c][1];
    rz += wz.d[c] * in_y[c][0];
    if (!with_hessian) continue;
    ryy += wz.w[c] * in_y[c][2];
    rzz += wz.dd[c] * in_y[c][0];
    ryz += wz.d[c] * in_y[c][1];
  }
  const auto in_x = [](const double* w, const particles::Quad& n) {
    return (w[0] * n[0] + w[1] * n[1]) + (w[2] * n[2] + w[3] * n[3]);
  };
  const double f = in_x(wx.w, r);
  if (!std::isfinite(f)) return false;
  out.distance = f;
  out.gradient = Vec3(in_x(wx.d, r), in_x(wx.w, ry), in_x(wx.w, rz)) / spacing_;
  if (!with_hessian) return true;
  const double fxx = in_x(wx.dd, r), fxy = in_x(wx.d, ry), fxz = in_x(wx.d, rz);
  const double fyy = in_x(wx.w, ryy), fzz = in_x(wx.w, rzz), fyz = in_x(wx.w, ryz);
  out.hessian << fxx, fxy, fxz, fxy, fyy, fyz, fxz, fyz, fzz;
  out.hessian /= spacing_ * spacing_;
  return true;
}

bool DistanceField::covers(const geometry::Box3& box) const {
  const Vec3 rim = Vec3::Constant(kContact.field.rim_cells * spacing_);
  const Vec3 end = origin_ + spacing_ * Vec3(size_[0] - 1, size_[1] - 1, size_[2] - 1);
  return geometry::Box3(origin_ + rim, end - rim).contains(box);
}

double DistanceField::smooth_reach() const {
  return (kContact.field.band_cells - kContact.field.rim_cells) * spacing_;
}

bool DistanceField::sample(const Vec3& p, double reach, bool with_hessian, Sample& out) const {
  const Vec3 q = (p - origin_) / spacing_;
  std::array<int, 3> cell;
  bool on_grid = true;
  for (int k = 0; k < 3; ++k) {
    cell[k] = static_cast<int>(std::floor(q[k]));
    on_grid &= cell[k] >= 1 && cell[k] + 2 < size_[k];
  }
  if (on_grid) {
    const int nearest[3] = {static_cast<int>(std::lround(q[0])),
                            static_cast<int>(std::lround(q[1])),
                            static_cast<int>(std::lround(q[2]))};
    const Zone zone = zone_[index(nearest[0], nearest[1], nearest[2])];
    // The nearest node is at most √3/2 cells away, and its value is the interpolant's.
    if (zone != Zone::inside) {
      const bool far = zone == Zone::outside;
      const double least =
          (far ? kContact.field.band_cells * spacing_ : value(nearest[0], nearest[1], nearest[2])) -
          kContact.field.largest_fall * spacing_;
      if (far || least > reach) {
        out.distance = std::max(least, reach);
        return false;
      }
    }
    if (interpolate(cell, q, with_hessian, out) ||
        (measure_round(cell) && interpolate(cell, q, with_hessian, out)))
      return out.distance < reach;
  }
  // Off the band: deep inside the body, at the rim of the band, or off the grid. Ask the surface.
  geometry::ClosestPoint hit;
  const double d = tree_.signed_distance(p, &hit);
  out.distance = d;
  if (!(d < reach)) return false;
  out.gradient = d == 0 ? Vec3(Vec3::Zero()) : Vec3((p - hit.point) / d);
  out.hessian.setZero();
  return true;
}

}  // namespace loosefit::contact
