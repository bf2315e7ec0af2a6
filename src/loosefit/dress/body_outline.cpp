#include "loosefit/dress/body_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loosefit::dress {
namespace {

constexpr double kCell = 0.005;        ///< [m]
constexpr int kSmoothingPasses = 200;  ///< of the middle surface
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_trunk(body::Segment s) {
  return s == body::Segment::torso || s == body::Segment::thigh || s == body::Segment::neck;
}

/// Running minimum over ±reach cells along rows, then along columns.
std::vector<double> minimum_filter(const std::vector<double>& field, int columns, int rows,
                                   int reach) {
  std::vector<double> across(field.size()), both(field.size());
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      double least = kInfinity;
      for (int k = std::max(0, i - reach); k <= std::min(columns - 1, i + reach); ++k)
        least = std::min(least, field[j * columns + k]);
      across[j * columns + i] = least;
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      double least = kInfinity;
      for (int k = std::max(0, j - reach); k <= std::min(rows - 1, j + reach); ++k)
        least = std::min(least, across[k * columns + i]);
      both[j * columns + i] = least;
    }
  return both;
}

}  // namespace

BodyOutline::BodyOutline(const body::Body& body, double clearance) : cell_(kCell) {
  const auto& x = body.surface.vertices;
  Vec3 lower = Vec3::Constant(kInfinity), upper = -lower;
  for (const Vec3& p : x) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  const double rim = clearance + 0.25;  // sleeves may reach beyond the hands
  x0_ = lower[0] - rim;
  z0_ = lower[2] - rim;
  columns_ = 2 + static_cast<int>((upper[0] - lower[0] + 2 * rim) / cell_);
  rows_ = 2 + static_cast<int>((upper[2] - lower[2] + 2 * rim) / cell_);
  std::vector<double> least(columns_ * rows_, kInfinity), minus_most(least);
  half_width_left_.assign(rows_, 0);
  half_width_right_.assign(rows_, 0);

  const auto splat = [&](const Vec3& p, bool trunk) {
    const int i = static_cast<int>((p[0] - x0_) / cell_),
              j = static_cast<int>((p[2] - z0_) / cell_);
    least[index(i, j)] = std::min(least[index(i, j)], p[1]);
    minus_most[index(i, j)] = std::min(minus_most[index(i, j)], -p[1]);
    if (!trunk) return;
    half_width_left_[j] = std::max(half_width_left_[j], p[0]);
    half_width_right_[j] = std::max(half_width_right_[j], -p[0]);
  };
  for (const Triangle& t : body.surface.triangles) {
    const body::Segment s = body.segment[t[0]];
    if (s == body::Segment::head) continue;
    const Vec3 &a = x[t[0]], &b = x[t[1]], &c = x[t[2]];
    // Sample densely enough that no cell inside the silhouette stays empty after dilation.
    const int n =
        1 + static_cast<int>(std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) / cell_);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        splat(a + (b - a) * (double(i) / n) + (c - a) * (double(j) / n), is_trunk(s));
  }

  const int reach = static_cast<int>(std::ceil(clearance / cell_));
  front_ = minimum_filter(least, columns_, rows_, reach);
  back_ = minimum_filter(minus_most, columns_, rows_, reach);
  middle_.assign(front_.size(), 0);
  std::vector<char> known(front_.size(), 0);
  std::vector<int> frontier;
  for (std::size_t k = 0; k < front_.size(); ++k) {
    if (!std::isfinite(front_[k])) continue;
    middle_[k] = 0.5 * (front_[k] - back_[k]);
    known[k] = 1;
    frontier.push_back(static_cast<int>(k));
  }
  // Continue the middle outwards, nearest cells first, then smooth it everywhere.
  while (!frontier.empty()) {
    std::vector<int> next;
    for (int k : frontier) {
      const int i = k % columns_, j = k / columns_;
      const int neighbours[4][2] = {{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}};
      for (const auto& [ni, nj] : neighbours) {
        if (ni < 0 || nj < 0 || ni >= columns_ || nj >= rows_ || known[index(ni, nj)]) continue;
        known[index(ni, nj)] = 1;
        middle_[index(ni, nj)] = middle_[k];
        next.push_back(index(ni, nj));
      }
    }
    frontier.swap(next);
  }
  std::vector<double> smooth(middle_.size());
  for (int pass = 0; pass < kSmoothingPasses; ++pass) {
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        smooth[index(i, j)] = 0.25 * (middle_[index(std::max(0, i - 1), j)] +
                                      middle_[index(std::min(columns_ - 1, i + 1), j)] +
                                      middle_[index(i, std::max(0, j - 1))] +
                                      middle_[index(i, std::min(rows_ - 1, j + 1))]);
    middle_.swap(smooth);
  }
  for (std::size_t k = 0; k < front_.size(); ++k) {
    front_[k] = std::isfinite(front_[k]) ? front_[k] - clearance : middle_[k];
    back_[k] = std::isfinite(back_[k]) ? -back_[k] + clearance : middle_[k];
  }
}

double BodyOutline::sample(const std::vector<double>& field, double x, double z) const {
  const double u = std::clamp((x - x0_) / cell_ - 0.5, 0.0, columns_ - 1.001);
  const double v = std::clamp((z - z0_) / cell_ - 0.5, 0.0, rows_ - 1.001);
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const double a = u - i, b = v - j;
  return (1 - b) * ((1 - a) * field[index(i, j)] + a * field[index(i + 1, j)]) +
         b * ((1 - a) * field[index(i, j + 1)] + a * field[index(i + 1, j + 1)]);
}

double BodyOutline::trunk_half_width(double z, int side) const {
  const int j = std::clamp(static_cast<int>((z - z0_) / cell_), 0, rows_ - 1);
  return side > 0 ? half_width_left_[j] : half_width_right_[j];
}

}  // namespace loosefit::dress
