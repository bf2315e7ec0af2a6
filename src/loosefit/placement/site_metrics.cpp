#include "loosefit/placement/site_metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "loosefit/base/error.h"
#include "loosefit/maps/orientation_error.h"
#include "loosefit/maps/statistics.h"

namespace loosefit::placement {
namespace {
using Values = std::vector<double>;
using Read = std::function<double(const SiteState&)>;

/// The known ones of a number over states.
Values read(const std::vector<SiteState>& states, const Read& of) {
  Values values;
  for (const SiteState& s : states)
    if (const double value = of(s); std::isfinite(value)) values.push_back(value);
  return values;
}

double mean(const Values& v) {
  double sum = 0;
  for (double x : v) sum += x;
  return sum / static_cast<double>(v.size());
}

/// Mean direction: −179° and 179° make 180°.
double mean_angle(const Values& v) {
  double sine = 0, cosine = 0;
  for (double x : v) sine += std::sin(x), cosine += std::cos(x);
  return std::atan2(sine, cosine);
}

double least(const Values& v) { return *std::min_element(v.begin(), v.end()); }
double greatest(const Values& v) { return *std::max_element(v.begin(), v.end()); }

/// Share of values that count as contact.
double duty(const Values& v) {
  constexpr double kInContact = 0.9;
  Values counts;
  for (double x : v) counts.push_back(x >= kInContact);
  return mean(counts);
}

double range(const Values& v) {
  constexpr std::size_t kMany = 20;  // below, a percentile is the extreme itself
  const maps::MapStatistics s = maps::statistics(v, Values(v.size(), 1.0));
  return v.size() >= kMany ? s.p95 - s.p5 : s.max - s.min;
}

/// States grouped by donning.
std::map<int, std::vector<SiteState>> by_donning(const std::vector<SiteState>& states) {
  std::map<int, std::vector<SiteState>> groups;
  for (const SiteState& s : states) groups[s.donning].push_back(s);
  return groups;
}

class Summary {
 public:
  Summary(const std::vector<SiteState>& states, int reference) : states_(states) {
    for (const SiteState& s : states) (s.posture == reference ? references_ : others_).push_back(s);
    for (const auto& [donning, own] : by_donning(states))
      if (own.size() > 1) postured_.push_back(own);
  }

  void add(const CatalogueMetric& source) {
    const Read of = [&](const SiteState& s) { return s.readings[source.reading]; };
    switch (source.metric->states) {
      case maps::OverStates::reference:
        return set(source, read(references_, of), mean);
      case maps::OverStates::reference_angle:
        return set(source, read(references_, of), mean_angle);
      case maps::OverStates::mean:
        return set(source, read(states_, of), mean);
      case maps::OverStates::least:
        return set(source, read(states_, of), least);
      case maps::OverStates::greatest:
        return set(source, read(states_, of), greatest);
      case maps::OverStates::swing:
        return set(source, swings(of), mean);
      case maps::OverStates::least_posture:
        if (!postured_.empty()) set(source, read(states_, of), least);
        return;
      case maps::OverStates::contact_duty:
        if (!postured_.empty()) set(source, read(states_, of), duty);
        return;
      case maps::OverStates::greatest_change:
        return set(source, read(others_, of), greatest);
      case maps::OverStates::error_rms:
        return set(source, calibrated_errors(),
                   [](const Values& v) { return maps::summarise(v).rms; });
      case maps::OverStates::error_p95:
        return set(source, calibrated_errors(),
                   [](const Values& v) { return maps::summarise(v).p95; });
      case maps::OverStates::turn_across:
        return set(source, greatest_turn(0), mean);
      case maps::OverStates::turn_along:
        return set(source, greatest_turn(1), mean);
      case maps::OverStates::turn_normal:
        return set(source, greatest_turn(2), mean);
      case maps::OverStates::error_of_donnings:
        return;  // over pairs of donnings, which one donning by itself has not: see below
    }
  }

  std::map<std::string, double> result;

 private:
  void set(const CatalogueMetric& source, const Values& values, double (*sum_up)(const Values&)) {
    if (!values.empty()) result[source.metric->name] = source.array->in_unit(sum_up(values));
  }
  /// Of each donning with several postures.
  Values swings(const Read& of) const {
    Values ranges;
    for (const auto& own : postured_)
      if (const Values values = read(own, of); values.size() > 1) ranges.push_back(range(values));
    return ranges;
  }
  /// Of all states but the references, each against its own reference: visit(now, then).
  template <class Visit>
  void for_each_turn(const Visit& visit) const {
    for (const SiteState& s : others_)
      for (const SiteState& reference : references_)
        if (reference.donning == s.donning && reference.on_skin.allFinite() &&
            s.on_skin.allFinite())
          visit(s.on_skin, reference.on_skin);
  }
  Values calibrated_errors() const {
    Values errors;
    for_each_turn([&](const Mat3& now, const Mat3& then) {
      errors.push_back(maps::calibrated_error(now, then));
    });
    return errors;
  }
  /// One component of the greatest turn; none without turns.
  Values greatest_turn(int axis) const {
    Values component;
    double size = -1;
    for_each_turn([&](const Mat3& now, const Mat3& then) {
      const Vec3 turn = maps::calibrated_turn(now, then);
      if (turn.norm() <= size) return;
      size = turn.norm();
      component = {turn[axis]};
    });
    return component;
  }

  const std::vector<SiteState>& states_;
  std::vector<SiteState> references_, others_;
  std::vector<std::vector<SiteState>> postured_;  ///< donnings with several postures
};

/// Angles between the sensor's orientations in the reference posture of one donning and of the
/// others.
Values donning_errors(const std::vector<SiteState>& states, int reference, int donning) {
  Values errors;
  for (std::size_t i = 0; i < states.size(); ++i)
    for (std::size_t j = i + 1; j < states.size(); ++j) {
      const SiteState &a = states[i], &b = states[j];
      if (a.posture == reference && b.posture == reference && a.donning != b.donning &&
          (a.donning == donning || b.donning == donning) && a.garment_frame.allFinite() &&
          b.garment_frame.allFinite())
        errors.push_back(maps::rotation_angle(a.garment_frame.transpose() * b.garment_frame));
    }
  return errors;
}

std::map<std::string, double> summarised(const std::vector<SiteState>& states, int reference) {
  Summary of(states, reference);
  for (const CatalogueMetric& source : catalogue_metrics()) of.add(source);
  return of.result;
}

}  // namespace

std::vector<std::map<std::string, double>> site_metrics_by_donning(
    const std::vector<SiteState>& states, int reference_posture) {
  std::vector<std::map<std::string, double>> all;
  for (const auto& [donning, own] : by_donning(states)) {
    all.push_back(summarised(own, reference_posture));
    const Values errors = donning_errors(states, reference_posture, donning);
    if (!errors.empty()) all.back()["donning_coe_deg"] = degrees(maps::summarise(errors).rms);
  }
  return all;
}

std::map<std::string, double> site_metrics_of_state(const std::vector<SiteState>& states,
                                                    std::size_t index, int reference_posture) {
  const SiteState& state = states.at(index);
  std::map<std::string, double> own = summarised({state}, state.posture);
  if (state.posture == reference_posture) return own;
  // Turn and slip are those since the reference posture of the same donning.
  for (const SiteState& reference : states) {
    if (reference.posture != reference_posture || reference.donning != state.donning) continue;
    const std::map<std::string, double> change = summarised({reference, state}, reference_posture);
    for (const CatalogueMetric& source : catalogue_metrics()) {
      const bool compares =
          source.reading < 0 || source.metric->states == maps::OverStates::greatest_change;
      const auto found = change.find(source.metric->name);
      if (compares && found != change.end()) own.insert(*found);
    }
  }
  return own;
}

SiteMeter::SiteMeter(const garment::Garment& garment, const fabric::Material& material,
                     const std::vector<WornState>& states, int reference_posture)
    : reference_posture_(reference_posture) {
  if (states.empty()) throw InvalidInput("site metrics need at least one state");
  std::map<std::pair<int, int>, int> index;  // (posture, donning)
  for (std::size_t i = 0; i < states.size(); ++i) {
    const WornState& state = states[i];
    if (!index.emplace(std::make_pair(state.posture, state.donning), static_cast<int>(i)).second)
      throw InvalidInput("site metrics: found posture " + std::to_string(state.posture) +
                         " of donning " + std::to_string(state.donning) +
                         " twice, expected it once");
    body::require_same_wearer(states[0].body, state.body);
    meters_.emplace_back(garment, material, state);
  }
  for (const WornState& state : states) {
    const auto found = index.find({reference_posture, state.donning});
    reference_of_.push_back(found == index.end() ? -1 : found->second);
  }
}

std::vector<SiteState> SiteMeter::measure(const SensorPatch& patch) const {
  std::map<int, SkinUnderSensor> skin;  // per reference state
  std::vector<SiteState> states;
  for (std::size_t i = 0; i < meters_.size(); ++i) {
    const int reference = reference_of_[i];
    if (reference >= 0 && !skin.count(reference))
      skin.emplace(reference, meters_[reference].skin_under(patch));
    states.push_back(meters_[i].measure(patch, reference >= 0 ? &skin.at(reference) : nullptr));
  }
  return states;
}

}  // namespace loosefit::placement
