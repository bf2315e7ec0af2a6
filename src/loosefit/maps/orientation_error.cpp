#include "loosefit/maps/orientation_error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/maps/orientation.h"
#include "loosefit/maps/statistics.h"

namespace loosefit::maps {

double calibrated_error(const Mat3& now, const Mat3& reference) {
  return rotation_angle(now * reference.transpose());
}

Vec3 calibrated_turn(const Mat3& now, const Mat3& reference) {
  const Eigen::AngleAxisd turn(Mat3(reference.transpose() * now));
  return turn.angle() * turn.axis();
}

ErrorSummary summarise(const std::vector<double>& errors) {
  if (errors.empty())
    throw InvalidInput("an orientation error needs one state besides the reference");
  double squares = 0;
  for (double e : errors) squares += e * e;
  const MapStatistics s = statistics(errors, std::vector<double>(errors.size(), 1.0));
  return {std::sqrt(squares / static_cast<double>(errors.size())), s.p95};
}

std::vector<ErrorSummary> vertex_orientation_errors(const garment::Garment& garment,
                                                    const DressedState& reference,
                                                    const std::vector<DressedState>& states,
                                                    const Vec2& direction) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  require_fit(garment, reference);
  const std::vector<body::SkinPoint> partners = skin_partners(reference);
  /// R = F_bᵀ F_g of every vertex in one state.
  const auto relative = [&](const DressedState& state) {
    std::vector<Mat3> r = vertex_frames(garment, state.positions, state.worn.normals, direction);
    for (std::size_t v = 0; v < r.size(); ++v)
      r[v] = body::frame_of(partners[v], state.body).axes.transpose() * r[v];
    return r;
  };
  std::vector<std::vector<double>> errors(garment.vertex_count);
  const std::vector<Mat3> calibrated = relative(reference);
  for (const DressedState& state : states) {
    require_fit(garment, state);
    body::require_same_wearer(reference.body, state.body);
    const std::vector<Mat3> now = relative(state);
    for (std::size_t v = 0; v < now.size(); ++v)
      errors[v].push_back(calibrated_error(now[v], calibrated[v]));
  }
  std::vector<ErrorSummary> summaries;
  for (const std::vector<double>& own : errors) {
    const bool whole = std::all_of(own.begin(), own.end(), [](double e) { return !std::isnan(e); });
    const ErrorSummary summary = summarise(own);
    summaries.push_back(whole ? summary : ErrorSummary{kNan, kNan});
  }
  return summaries;
}

}  // namespace loosefit::maps
