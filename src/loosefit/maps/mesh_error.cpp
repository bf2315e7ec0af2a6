#include "loosefit/maps/mesh_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace loosefit::maps {
namespace {

constexpr std::array<double, 4> kEdges = {0.007, 0.010, 0.014, 0.020};  // [m]

struct ArrayError {
  std::string_view array;
  std::array<double, 4> relative;  ///< at kEdges, of two thirds of the regions [–]
  double least;  ///< difference of 7 and 5 mm, of two thirds of the regions [unit]
};

// validation/convergence/results.json; tests/maps/mesh_error_test.cpp holds them against it.
constexpr ArrayError kErrors[] = {
    {"strain_warp", {0.11, 0.17, 0.14, 0.33}, 1.2e-4},
    {"strain_weft", {0.20, 0.24, 0.38, 0.63}, 0.8e-4},
    {"shear_angle_deg", {0.13, 0.18, 0.25, 0.45}, 0.10},
    {"strain_max", {0.11, 0.16, 0.18, 0.63}, 2.8e-4},
    {"distance_mm", {0.05, 0.04, 0.07, 0.14}, 0.51},
    {"angular_deviation_deg", {0.09, 0.13, 0.16, 0.29}, 1.1},
    {"angular_deviation_total_deg", {0.09, 0.12, 0.11, 0.25}, 1.1},
};

}  // namespace

std::optional<double> mesh_error(const std::string& array, double value, double edge_length) {
  std::string_view measured = array;
  if (array == "gap_mm") measured = "distance_mm";
  if (array == "rotation_deg" || array.starts_with("tilt_")) measured = "angular_deviation_deg";
  const auto known = std::find_if(std::begin(kErrors), std::end(kErrors),
                                  [&](const ArrayError& e) { return e.array == measured; });
  if (known == std::end(kErrors) || !std::isfinite(value) || edge_length > kEdges.back() + 1e-9)
    return std::nullopt;
  const auto above = std::lower_bound(kEdges.begin() + 1, kEdges.end() - 1, edge_length);
  const auto i = static_cast<std::size_t>(above - kEdges.begin());
  const double share =
      std::clamp((edge_length - kEdges[i - 1]) / (kEdges[i] - kEdges[i - 1]), 0.0, 1.0);
  const double relative = std::lerp(known->relative[i - 1], known->relative[i], share);
  return std::max(relative * std::abs(value), known->least);
}

}  // namespace loosefit::maps
