#include "loosefit/drape/wrapped_leg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "loosefit/drape/band_ring.h"
#include "loosefit/drape/skirt_width.h"

namespace loosefit::drape {
namespace {

constexpr double kLeastWidth = 0.10;   ///< between edges of an inseam [m]
constexpr double kLeastInseam = 0.10;  ///< [m]
constexpr double kClear = 0.025;       ///< of the panel from the body [m]
constexpr double kSlice = 0.02;        ///< of height, by which outlines are compared [m]

int slice(double z) { return static_cast<int>(std::floor(z / kSlice)); }

}  // namespace

std::vector<int> find_wrapped_legs(const garment::OpenSeams& open, const std::vector<int>& side) {
  const garment::Garment& g = open.garment;
  std::map<int, std::pair<double, double>> inseam;  // lowest and highest v, by panel
  for (const std::vector<int>& of : open.partners)
    for (std::size_t i = 1; i < of.size(); ++i) {
      const int k = g.vertex_panel[of[i]];
      if (g.vertex_panel[of[i - 1]] != k || side[k] == 0) continue;
      const auto &a = g.vertex_uv[of[i - 1]], &b = g.vertex_uv[of[i]];
      if (std::hypot(a[0] - b[0], a[1] - b[1]) < kLeastWidth) continue;
      const double v = 0.5 * (a[1] + b[1]);
      const auto [at, is_new] = inseam.try_emplace(k, v, v);
      at->second = {std::min(at->second.first, v), std::max(at->second.second, v)};
    }
  std::vector<int> found;
  for (const auto& [k, reach] : inseam)
    if (reach.second - reach.first > kLeastInseam && !BandRing::find(open, k)) found.push_back(k);
  return found;
}

void wrap_leg(const garment::OpenSeams& open, int panel, int side, double plane,
              const body::PosedBody& body, std::vector<Vec3>& x) {
  std::vector<int> of;
  std::map<int, std::pair<double, double>> across;  // lowest and highest y of the panel by slice
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (int v = 0; v < open.garment.vertex_count; ++v) {
    if (open.garment.vertex_panel[v] != panel) continue;
    of.push_back(v);
    lowest = std::min(lowest, x[v].z()), highest = std::max(highest, x[v].z());
    const auto [at, is_new] = across.try_emplace(slice(x[v].z()), x[v].y(), x[v].y());
    at->second = {std::min(at->second.first, x[v].y()), std::max(at->second.second, x[v].y())};
  }
  // How far the shear has moved it at a height.
  std::map<int, double> sheared;
  for (int v : of) sheared[slice(x[v].z())] = x[v].x() - plane;

  // Half a round of the body's depth, its middle far enough out to be beside it at every height.
  double front = std::numeric_limits<double>::infinity(), back = -front;
  for (std::size_t i = 0; i < body->surface.vertices.size(); ++i) {
    const Vec3& p = body->surface.vertices[i];
    if (is_of_arm(body.body(), i) || p.z() < lowest || p.z() > highest) continue;
    front = std::min(front, p.y()), back = std::max(back, p.y());
  }
  if (!(front < back)) return;
  const double radius = 0.5 * (back - front) + kClear, middle = 0.5 * (front + back);
  double centre = 0;  // to the side of the body's middle
  const double axis = body->joints.at("neck").x();
  for (std::size_t i = 0; i < body->surface.vertices.size(); ++i) {
    const Vec3& p = body->surface.vertices[i];
    const auto shear = sheared.find(slice(p.z()));
    if (is_of_arm(body.body(), i) || shear == sheared.end()) continue;
    centre = std::max(centre, side * (p.x() - axis) + kClear - radius - side * shear->second);
  }
  for (const auto& [at, reach] : across) {
    const double half = 0.5 * (reach.second - reach.first);
    centre = std::max(centre, half - radius * kPi / 2 - side * sheared.at(at) + kClear / 2);
  }
  for (int v : of) {
    const auto& reach = across.at(slice(x[v].z()));
    const double c = x[v].y() - 0.5 * (reach.first + reach.second);
    const double quarter = radius * kPi / 2;
    const double straight = std::max(0.0, std::abs(c) - quarter);
    const double angle = std::clamp(c, -quarter, quarter) / radius;
    const double out = centre + radius * std::cos(angle) - straight;
    x[v].x() = axis + side * out + (x[v].x() - plane);
    x[v].y() = middle + radius * std::sin(angle);
  }
}

}  // namespace loosefit::drape
