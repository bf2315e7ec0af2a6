#include "loosefit/kinds/trousers/trousers_measures.h"

#include <algorithm>
#include <array>
#include <utility>

namespace loosefit::kinds {
namespace {

/// What seams take in of each front between hip and waist, at most [m]; of each back in proportion,
/// 37 mm. Fitted trousers take in more behind, by darts and with a fly: these have neither, and
/// are put on over the hip.
constexpr double kFrontIntake = 0.034;

double value(const NamedValues& values, const char* name, double otherwise) {
  const auto found = values.find(name);
  return found == values.end() ? otherwise : found->second;
}

}  // namespace

double leg_girth_at(const BodyMeasures& m, double height) {
  if (const auto known = girth_at(m.along.leg, m.at("crotch_height") - height)) return *known;
  const double hip = m.at("hip"), share = height / m.at("crotch_height");
  const std::array<std::pair<double, double>, 4> levels = {
      {{kAnkleLevel, value(m, "ankle", kAnkleOfHip * hip)},
       {kCalfLevel, value(m, "calf", kCalfOfHip * hip)},
       {kKneeLevel, value(m, "knee", kKneeOfHip * hip)},
       {kThighLevel, value(m, "thigh", kThighOfHip * hip)}}};
  if (share <= levels.front().first) return levels.front().second;
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (share <= levels[i].first) {
      const auto& [low, thin] = levels[i - 1];
      const auto& [high, thick] = levels[i];
      return thin + (share - low) / (high - low) * (thick - thin);
    }
  return levels.back().second;
}

std::vector<AskedMobility> leg_eases(const BodyMeasures& m, const NamedValues& fit) {
  const double crotch = m.at("crotch_height"), hem = hem_height(m, fit);
  std::vector<AskedMobility> asked;
  for (const auto& [key, level] :
       {std::pair{"thigh", kThighLevel}, {"knee", kKneeLevel}, {"calf", kCalfLevel}})
    if (fit.count(key) && level * crotch > hem)
      asked.push_back({(1 - level) * crotch, fit.at(key)});
  asked.push_back({crotch - hem, fit.at("hem")});
  return asked;
}

bool is_ease_asked(const BodyMeasures& m, const NamedValues& fit, double along) {
  const double crotch = m.at("crotch_height");
  const double from = (1 - (fit.count("thigh") ? kThighLevel : kKneeLevel)) * crotch,
               to = fit.count("calf") ? crotch - hem_height(m, fit) : (1 - kKneeLevel) * crotch;
  constexpr double kRounding = 1e-9;
  return along > from - kRounding && along < to + kRounding;
}

double hip_girth(const BodyMeasures& m, const NamedValues& fit) {
  return (1 + fit.at("hip")) * m.at("hip");
}

double waist_edge_height(const BodyMeasures& m, const NamedValues& fit) {
  return m.at("waist_level") - 0.5 * fit.at("waistband_width");
}

double hem_height(const BodyMeasures& m, const NamedValues& fit) {
  return (1 - fit.at("leg_length")) * m.at("crotch_height");
}

double least_waist(const BodyMeasures& m, const NamedValues& fit) {
  // Both pieces are cut in proportion.
  const double front = kFrontShare * hip_girth(m, fit) / 2 - kFrontIntake;
  return 2 * front / kFrontShare / m.at("waist") - 1;
}

double usual_waist(const BodyMeasures& m, const NamedValues& fit) {
  // Not below the waist itself, where hardly anything has to be taken in.
  return std::max(least_waist(m, fit), std::min(0.02, fit.at("hip")));
}

}  // namespace loosefit::kinds
