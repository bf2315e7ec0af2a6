#include "loosefit/pipeline/fit_along.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "loosefit/kinds/trousers/trousers_measures.h"

namespace loosefit::pipeline {
namespace {

/// A place with its level, for the names of stations.
struct NamedLevel {
  const char* name;
  double along;
};

const char* nearest_name(const std::vector<NamedLevel>& levels, double along) {
  const auto nearer = [&](const NamedLevel& a, const NamedLevel& b) {
    return std::abs(a.along - along) < std::abs(b.along - along);
  };
  return std::min_element(levels.begin(), levels.end(), nearer)->name;
}

double measure(const body::Body& body, const char* name) {
  const auto found = body.measured.find(name);
  return found == body.measured.end() ? 0 : found->second;
}

/// What there is of a body along a limb, from above; empty where it cannot be said.
std::vector<NamedLevel> places_of(const std::string& limb, const body::Body& body) {
  if (limb == "trunk") {
    const double waist = measure(body, "hps_to_waist"), hip = measure(body, "hps_to_hip");
    if (!(waist > 0 && hip > 0)) return {};
    return {{"chest", 0.55 * waist}, {"waist", waist}, {"hip", hip}};
  }
  if (limb == "arm") {
    const double length = measure(body, "arm_length");
    const double known = measure(body, "elbow_length"), elbow = known > 0 ? known : 0.56 * length;
    return {{"upper arm", 0.5 * elbow},
            {"elbow", elbow},
            {"forearm", elbow + 0.35 * (length - elbow)},
            {"wrist", length}};
  }
  const double crotch = measure(body, "crotch_height");
  const auto down = [&](double level) { return (1 - level) * crotch; };
  return {{"thigh", down(kinds::kThighLevel)},
          {"knee", down(kinds::kKneeLevel)},
          {"calf", down(kinds::kCalfLevel)},
          {"ankle", down(kinds::kAnkleLevel)}};
}

}  // namespace

std::vector<StationFit> fit_along(const std::vector<kinds::FitStation>& stations,
                                  const body::Body& body, const kinds::GirthsAlong& girths) {
  std::vector<StationFit> fits;
  for (const kinds::FitStation& s : stations) {
    const kinds::GirthLine& line = s.limb == "trunk" ? girths.trunk
                                   : s.limb == "arm" ? girths.arm
                                                     : girths.leg;
    const std::optional<double> girth = kinds::girth_at(line, s.along);
    const std::vector<NamedLevel> places = places_of(s.limb, body);
    if (!girth || places.empty()) continue;
    fits.push_back({s.limb, nearest_name(places, s.along), s.along, s.garment, *girth, s.asked, s.lines});
  }
  return fits;
}

}  // namespace loosefit::pipeline
