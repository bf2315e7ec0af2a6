#include "loosefit/lines/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "loosefit/body/joint_postures.h"

namespace loosefit::lines {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kRoundOff = 1e-6;  ///< of a signal [–]

using Angles = std::vector<body::JointAngle>;

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? kNan : sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

class Analysis {
 public:
  Analysis(const std::vector<std::string>& postures, const std::vector<LineState>& states,
           const std::vector<double>& signals)
      : postures_(postures) {
    for (std::size_t i = 0; i < states.size(); ++i)
      if (!std::isnan(signals[i])) of_[states[i].posture][states[i].donning] = signals[i];
    for (const std::string& name : postures)
      angles_.push_back(body::joint_angles(name).value_or(Angles{}));
  }

  std::vector<Sensitivity> run() const {
    std::vector<Sensitivity> all;
    for (const body::JointMotion& motion : body::joint_motions()) {
      Sensitivity s;
      s.joint = motion.name;
      std::vector<int> at = swept(motion.name);
      if (at.size() < 3) continue;
      for (const int p : at) s.curve.push_back(point(p));
      s.gain = slope(s.curve);
      find_range(at, s);
      find_cross(s);
      all.push_back(std::move(s));
    }
    return all;
  }

 private:
  /// Postures that turn this joint alone and have a signal, by ascending angle.
  std::vector<int> swept(const std::string& joint) const {
    std::vector<int> at;
    for (int p = 0; p < static_cast<int>(postures_.size()); ++p)
      if (angles_[p].size() == 1 && angles_[p].front().joint == joint && of_.contains(p))
        at.push_back(p);
    std::stable_sort(at.begin(), at.end(), [&](int a, int b) { return degrees(a) < degrees(b); });
    return at;
  }
  double degrees(int posture) const { return angles_[posture].front().degrees; }

  CurvePoint point(int posture) const {
    CurvePoint point;
    point.degrees = degrees(posture);
    for (const auto& [donning, signal] : of_.at(posture)) point.signals.push_back(signal);
    point.mean = mean_of(point.signals);
    point.deviation = deviation_of(point.signals);
    return point;
  }

  static double slope(const std::vector<CurvePoint>& curve) {
    double x = 0, y = 0, xx = 0, xy = 0;
    const auto n = static_cast<double>(curve.size());
    for (const CurvePoint& p : curve) x += p.degrees / n, y += p.mean / n;
    for (const CurvePoint& p : curve) {
      xx += (p.degrees - x) * (p.degrees - x);
      xy += (p.degrees - x) * (p.mean - y);
    }
    return xx > 0 ? xy / xx : 0;
  }

  /// Whether every donning that has both goes up (+1) or down (−1) from a to b; 0: neither.
  int direction(int a, int b) const {
    int found = 0;
    bool any = false;
    for (const auto& [donning, signal] : of_.at(a)) {
      const auto next = of_.at(b).find(donning);
      if (next == of_.at(b).end()) continue;
      const double change = next->second - signal;
      const int way = change > kRoundOff ? 1 : change < -kRoundOff ? -1 : 0;
      if (way == 0 || (any && way != found)) return 0;
      found = way;
      any = true;
    }
    return found;
  }

  void find_range(const std::vector<int>& at, Sensitivity& s) const {
    const int n = static_cast<int>(at.size());
    s.monotone_from = s.monotone_to = degrees(at.front());
    s.angle_error = kNan;
    int best_from = 0, best_to = 0;
    for (int i = 0; i + 1 < n;) {
      const int way = direction(at[i], at[i + 1]);
      int j = i + 1;
      while (way != 0 && j + 1 < n && direction(at[j], at[j + 1]) == way) ++j;
      if (way != 0 &&
          degrees(at[j]) - degrees(at[i]) > degrees(at[best_to]) - degrees(at[best_from])) {
        best_from = i, best_to = j;
        s.rises = way > 0;
      }
      i = way == 0 ? i + 1 : j;
    }
    if (best_to == best_from) return;
    s.monotone_from = degrees(at[best_from]);
    s.monotone_to = degrees(at[best_to]);
    const std::vector<CurvePoint> range(s.curve.begin() + best_from, s.curve.begin() + best_to + 1);
    double square = 0;
    int known = 0;
    for (const CurvePoint& p : range)
      if (p.signals.size() > 1) square += p.deviation * p.deviation, ++known;
    const double steep = std::abs(slope(range));
    if (known > 0 && steep > 0) s.angle_error = std::sqrt(square / known) / steep;
  }

  int find(const Angles& angles) const {
    const auto same = [&](const Angles& other) {
      return other.size() == angles.size() &&
             std::all_of(other.begin(), other.end(), [&](const body::JointAngle& a) {
               return std::find(angles.begin(), angles.end(), a) != angles.end();
             });
    };
    for (int p = 0; p < static_cast<int>(postures_.size()); ++p)
      if (angles.empty() ? postures_[p] == "standing" : same(angles_[p])) return p;
    return -1;
  }

  void find_cross(Sensitivity& s) const {
    for (int p = 0; p < static_cast<int>(postures_.size()); ++p) {
      Angles own;
      for (const body::JointAngle& angle : angles_[p])
        if (angle.joint == s.joint) own.push_back(angle);
      if (!of_.contains(p) || angles_[p].size() == own.size()) continue;
      const int without = find(own);
      if (without < 0 || !of_.contains(without)) continue;
      std::vector<double> changes;
      for (const auto& [donning, signal] : of_.at(p))
        if (const auto at = of_.at(without).find(donning); at != of_.at(without).end())
          changes.push_back(signal - at->second);
      if (changes.empty()) continue;
      const double change = mean_of(changes);
      s.cross.push_back({postures_[p], change, s.gain != 0 ? change / s.gain : kNan});
    }
  }

  const std::vector<std::string>& postures_;
  std::vector<Angles> angles_;               ///< per posture; empty: not of joints
  std::map<int, std::map<int, double>> of_;  ///< posture → donning → signal
};

}  // namespace

std::vector<Sensitivity> sensitivities(const std::vector<std::string>& postures,
                                       const std::vector<LineState>& states,
                                       const std::vector<double>& signals) {
  return Analysis(postures, states, signals).run();
}

std::map<std::string, double> sensitivity_metrics(const Sensitivity& sensitivity) {
  std::map<std::string, double> m;
  m["line_gain_percent_per_deg"] = 100 * std::abs(sensitivity.gain);
  const double swept = sensitivity.curve.back().degrees - sensitivity.curve.front().degrees;
  m["line_monotone_share"] = (sensitivity.monotone_to - sensitivity.monotone_from) / swept;
  if (std::isfinite(sensitivity.angle_error)) m["line_angle_error_deg"] = sensitivity.angle_error;
  return m;
}

}  // namespace loosefit::lines
