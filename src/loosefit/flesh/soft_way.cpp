#include "loosefit/flesh/soft_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loosefit::flesh {
namespace {

constexpr double kBetweenStops = 0.5;  ///< joint angle [rad]; that of a step on the way of flesh
constexpr double kAtStop = 1e-9;       ///< of the way: round-off of a share

}  // namespace

SoftWay::SoftWay(std::shared_ptr<SoftBody> person, const body::Posture& from,
                 const body::Posture& to)
    : person_(std::move(person)),
      from_(from),
      to_(to),
      stops_(std::max(1, static_cast<int>(std::ceil(turn_between(from, to) / kBetweenStops)))) {}

// The ends to the last bit, so that the person knows them again.
body::Posture SoftWay::posture(double share) const {
  return share == 0 ? from_ : share == 1 ? to_ : body::blend(from_, to_, share);
}

const std::vector<Vec3>& SoftWay::moved(int stop) {
  const auto known = moved_.find(stop);
  if (known != moved_.end()) return known->second;
  const body::Posture there = posture(double(stop) / stops_);
  std::vector<Vec3> moved = person_->in(there)->surface.vertices;
  const std::vector<Vec3> built = person_->built(there);
  for (std::size_t v = 0; v < moved.size(); ++v) moved[v] -= built[v];
  return moved_[stop] = std::move(moved);
}

body::PosedBody SoftWay::at(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * stops_;
  const int nearest = static_cast<int>(std::lround(place));
  if (std::abs(place - nearest) < kAtStop * stops_)
    return person_->in(posture(double(nearest) / stops_));
  const int before = static_cast<int>(place);
  const std::vector<Vec3>&a = moved(before), &b = moved(before + 1);
  std::vector<Vec3> between(a.size());
  for (std::size_t v = 0; v < a.size(); ++v) between[v] = a[v] + (place - before) * (b[v] - a[v]);
  return displaced(person_->as_built(posture(share)), between);
}

}  // namespace loosefit::flesh
