#include "loosefit/validate/drape_coefficient.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::validate {
namespace {

/// Where the line y = const crosses the projected triangle; empty when it does not.
bool cut(const std::array<Vec2, 3>& p, double y, double& from, double& to) {
  from = 1e300, to = -1e300;
  for (int k = 0; k < 3; ++k) {
    const Vec2 &a = p[k], &b = p[(k + 1) % 3];
    if ((a[1] <= y) == (b[1] <= y)) continue;
    const double x = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]);
    from = std::min(from, x), to = std::max(to, x);
  }
  return from < to;
}

double union_length(std::vector<std::array<double, 2>>& pieces) {
  std::sort(pieces.begin(), pieces.end());
  double length = 0, reached = -1e300;
  for (const auto& [from, to] : pieces) {
    length += std::max(0.0, to - std::max(from, reached));
    reached = std::max(reached, to);
  }
  return length;
}

}  // namespace

double shadow_area(const std::vector<Vec3>& x, const std::vector<Triangle>& triangles,
                   double spacing) {
  if (triangles.empty()) return 0;
  double low = 1e300, high = -1e300;
  for (const Triangle& t : triangles)
    for (int v : t) low = std::min(low, x[v][1]), high = std::max(high, x[v][1]);
  const int lines = std::max(1, static_cast<int>(std::ceil((high - low) / spacing)));
  const double step = (high - low) / lines;
  std::vector<std::vector<std::array<double, 2>>> pieces(lines);
  for (const Triangle& t : triangles) {
    const std::array<Vec2, 3> p = {x[t[0]].head<2>(), x[t[1]].head<2>(), x[t[2]].head<2>()};
    const double bottom = std::min({p[0][1], p[1][1], p[2][1]});
    const double top = std::max({p[0][1], p[1][1], p[2][1]});
    const int first = std::max(0, static_cast<int>(std::floor((bottom - low) / step - 0.5)));
    for (int i = first; i < lines && low + (i + 0.5) * step <= top; ++i) {
      double from = 0, to = 0;
      if (cut(p, low + (i + 0.5) * step, from, to)) pieces[i].push_back({from, to});
    }
  }
  double area = 0;
  for (auto& line : pieces) area += step * union_length(line);
  return area;
}

double drape_coefficient(double shadow, double disc, double specimen) {
  if (!(disc > 0) || !(specimen > disc))
    throw InvalidInput(fmt::format("disc of {} and specimen of {} m²", disc, specimen),
                       "a specimen larger than the disc that carries it");
  return (shadow - disc) / (specimen - disc);
}

Folds count_folds(const std::vector<Vec3>& rim, const std::vector<double>& angle) {
  constexpr int kHighest = 20;
  Folds folds;
  const std::size_t n = rim.size();
  double power = 0, strongest = 0;
  for (int h = 1; h <= kHighest; ++h) {
    double c = 0, s = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double before = i > 0 ? angle[i - 1] : angle[n - 1] - 2 * kPi;
      const double after = i + 1 < n ? angle[i + 1] : angle[0] + 2 * kPi;
      const double weighted = rim[i].head<2>().norm() * 0.5 * (after - before) / kPi;
      c += weighted * std::cos(h * angle[i]);
      s += weighted * std::sin(h * angle[i]);
    }
    power += c * c + s * s;
    if (c * c + s * s <= strongest) continue;
    strongest = c * c + s * s;
    folds.count = h;
  }
  folds.amplitude = std::sqrt(strongest);
  folds.share = power > 0 ? strongest / power : 0;
  return folds;
}

}  // namespace loosefit::validate
