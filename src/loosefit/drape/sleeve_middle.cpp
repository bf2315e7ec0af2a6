#include "loosefit/drape/sleeve_middle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loosefit::drape {
namespace {

constexpr double kSlice = 0.03;  ///< of the length [m]

int slice(double s) { return static_cast<int>(std::floor(s / kSlice)); }

}  // namespace

SleeveMiddle::SleeveMiddle(const std::vector<int>& of, const std::vector<Vec3>& x, const Vec3& from,
                           const Vec3& axis, const Vec3& sideways) {
  std::map<int, std::pair<double, double>> breadth;
  for (int v : of) {
    const double s = (x[v] - from).dot(axis), b = (x[v] - from).dot(sideways);
    auto& [least, most] = breadth.try_emplace(slice(s), b, b).first->second;
    least = std::min(least, b), most = std::max(most, b);
  }
  double widest = 0;
  for (const auto& [k, b] : breadth) {
    if (b.second - b.first > widest) widest = b.second - b.first, foot_ = k;
    middle_[k] = 0.5 * (b.first + b.second);
  }
}

double SleeveMiddle::of(int k) const {
  auto found = middle_.lower_bound(std::max(k, foot_));
  if (found == middle_.end()) --found;
  return found->second;
}

double SleeveMiddle::at(double s) const {
  // Between the middles of slices, so that nothing jumps.
  const double place = s / kSlice - 0.5;
  const int k = static_cast<int>(std::floor(place));
  return of(k) + (place - k) * (of(k + 1) - of(k));
}

}  // namespace loosefit::drape
