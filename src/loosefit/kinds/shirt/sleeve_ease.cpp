#include "loosefit/kinds/shirt/sleeve_ease.h"

#include <algorithm>
#include <cmath>

namespace loosefit::kinds {
namespace {

constexpr double kApart = 0.01;  ///< between two places of a sleeve, at least [m]

/// The upper arm is taped at 30 % of its length, the forearm at 25 % (docs/theory/body_model.md).
double upper_level(const ShirtMeasures& m) { return 0.3 * m.elbow_length; }
double forearm_level(const ShirtMeasures& m) {
  return m.elbow_length + 0.25 * (m.arm_length - m.elbow_length);
}

GirthLine arm_line(const ShirtMeasures& m) {
  GirthLine line = {{upper_level(m), m.upper_arm}};
  if (m.along.arm.empty()) {
    line.push_back({m.elbow_length, m.elbow});
    line.push_back({forearm_level(m), m.forearm});
  }
  for (const GirthAt& g : m.along.arm)
    if (g.along > line.back().along + 0.5 * kApart && g.along < m.arm_length - 0.5 * kApart)
      line.push_back(g);
  line.push_back({m.arm_length, m.wrist});
  return line;
}

}  // namespace

double arm_girth(const ShirtMeasures& m, double along) {
  const GirthLine line = arm_line(m);
  return *girth_at(line, std::clamp(along, line.front().along, line.back().along));
}

double arm_girth_at(const ShirtMeasures& m, double share) {
  return arm_girth(m, share * m.arm_length);
}

double arm_under_sleeve(const ShirtMeasures& m, const ShirtFit& fit, double underarm) {
  if (m.along.arm.empty()) return m.upper_arm;
  return m.upper_arm +
         fit.sleeve_follow * (std::min(m.upper_arm, arm_girth(m, underarm)) - m.upper_arm);
}

double sleeve_end(const ShirtMeasures& m, const ShirtFit& fit) {
  return fit.sleeve_length * m.arm_length - fit.cuff;
}

bool has_elbow(const ShirtMeasures& m, const ShirtFit& fit, double underarm) {
  return m.elbow_length >= underarm + kApart && forearm_level(m) <= sleeve_end(m, fit) - kApart;
}

std::vector<AskedMobility> sleeve_eases(const ShirtMeasures& m, const ShirtFit& fit,
                                        double underarm) {
  const double end = sleeve_end(m, fit);
  std::vector<AskedMobility> asked = {{underarm, fit.sleeve}};
  const auto add = [&](double along, const std::optional<double>& mobility) {
    if (mobility && along > asked.back().along + kApart && along < end - kApart)
      asked.push_back({along, *mobility});
  };
  add(m.elbow_length, fit.elbow);
  add(forearm_level(m), fit.forearm);
  // A cuff is a tube: it has the asked ease where the arm is thickest under it, at its seam.
  const double held = fit.cuff > 0 ? 1 - fit.cuff_stretch : 1.0;
  asked.push_back({std::max(end, underarm), (1 + fit.wrist) / held - 1});
  return asked;
}

GirthLine sleeve_girths(const ShirtMeasures& m, const ShirtFit& fit, double underarm) {
  const double end = sleeve_end(m, fit);
  const std::vector<AskedMobility> asked = sleeve_eases(m, fit, underarm);
  const auto wished = [&](double along) {
    return (1 + *mobility_at(asked, along)) * arm_girth(m, along);
  };
  const double first = (1 + fit.sleeve) * arm_under_sleeve(m, fit, underarm), last = wished(end);
  std::vector<double> places = {m.elbow_length, forearm_level(m)};
  for (const GirthAt& g : m.along.arm)
    if (std::abs(g.along - m.elbow_length) > kApart &&
        std::abs(g.along - forearm_level(m)) > kApart)
      places.push_back(g.along);
  std::sort(places.begin(), places.end());
  GirthLine line = {{end, last}};
  double taper = last;
  for (std::size_t i = places.size(); i-- > 0;) {
    const double along = places[i];
    if (along > line.back().along - kApart || along < underarm + kApart) continue;
    const double here = wished(along);
    const double even = first + (along - underarm) / (end - underarm) * (last - first);
    // Where an ease is asked for it holds.
    const bool is_asked = std::any_of(asked.begin(), asked.end(), [&](const AskedMobility& a) {
      return std::abs(a.along - along) < 1e-9;
    });
    taper = std::max({is_asked ? here : std::max(here, even), taper});
    line.push_back({along, taper + fit.sleeve_follow * (here - taper)});
  }
  std::reverse(line.begin(), line.end());
  return line;
}

}  // namespace loosefit::kinds
