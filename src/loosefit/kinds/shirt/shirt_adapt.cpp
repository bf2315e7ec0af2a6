#include "loosefit/kinds/shirt/shirt_adapt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "loosefit/base/text.h"
#include "loosefit/kinds/shirt/shirt_blocks.h"
#include "loosefit/kinds/shirt/shirt_refusal.h"
#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/kinds/shirt/sleeve_ease.h"

namespace loosefit::kinds {
namespace {

constexpr int kMostRounds = 60;  // every round moves a value towards its end
constexpr int kHalvings = 16;
constexpr double kBeyond = 1e-6;      // further than needed [m]
constexpr double kVisible = 0.002;    // smaller changes are not told
constexpr double kFirstSleeve = 0.0;  // sleeves become no tighter than the arm at first

const std::map<std::string, double ShirtFit::*>& fit_values() {
  static const std::map<std::string, double ShirtFit::*> kTable = [] {
    std::map<std::string, double ShirtFit::*> table;
    for (const ShirtFitValue& v : shirt_fit_list()) table[std::string("fit.") + v.name] = v.field;
    return table;
  }();
  return kTable;
}

/// The fits that a rule depends on, the likeliest to be at fault first.
std::vector<std::string> fits_of(ShirtRule rule) {
  switch (rule) {
    case ShirtRule::sleeve_width:
      return {"fit.sleeve", "fit.chest", "fit.scye_ease", "fit.cap_ease"};
    case ShirtRule::shoulder_level:
      return {"fit.chest", "fit.shoulder_follow", "fit.scye_ease"};
    case ShirtRule::hem_level:
      return {"fit.scye_ease", "fit.sleeve"};
    case ShirtRule::waist_level:
      return {};
    case ShirtRule::neck:
      return {"fit.neck_ease", "fit.neckband_width", "fit.chest"};
    case ShirtRule::sleeve_length:
      return {"fit.sleeve_length", "fit.cuff_width", "fit.chest", "fit.shoulder_follow",
              "fit.sleeve"};
    case ShirtRule::torso_outline:
      return {"fit.chest",      "fit.waist",     "fit.hip",
              "fit.back_waist", "fit.neck_ease", "fit.scye_ease"};
    case ShirtRule::sleeve_outline:
      return {"fit.wrist", "fit.sleeve", "fit.sleeve_length"};
    case ShirtRule::range:
      return {};
  }
  return {};
}

const char* reason_of(ShirtRule rule) {
  switch (rule) {
    case ShirtRule::range:
      return "the body's own is beyond what the draft knows";
    case ShirtRule::sleeve_width:
      return "the sleeve would be too wide for the armhole";
    case ShirtRule::shoulder_level:
      return "the shoulder would hang down to the underarm";
    case ShirtRule::hem_level:
      return "the hem would end at the underarm";
    case ShirtRule::waist_level:
      return "the waist must lie between underarm and hem";
    case ShirtRule::neck:
      return "the neck would leave no shoulder seam";
    case ShirtRule::sleeve_length:
      return "the sleeve would end at the armhole";
    case ShirtRule::torso_outline:
    case ShirtRule::sleeve_outline:
      return "the piece would cross itself";
  }
  return "";
}

class Adapter {
 public:
  Adapter(const ShirtMeasures& measures, const ShirtFit& fit, const std::set<std::string>& yielding)
      : first_m_(measures), first_fit_(fit), yielding_(yielding) {
    shirt_.measures = measures;
    shirt_.fit = fit;
  }

  AdaptedShirt run() {
    for (int round = 0;; ++round) try {
        shirt_.pattern = draft_shirt(shirt_.measures, shirt_.fit, &shirt_.report);
        tell();
        return shirt_;
      } catch (const ShirtRefusal& refusal) {
        rule_ = refusal.rule();
        const bool moved = round < kMostRounds &&
                           (relieve_by_fit(refusal) ||
                            (!asked_of(refusal.rule()).size() && relieve_by_measures(refusal)));
        if (!moved) refuse(refusal);
      }
  }

 private:
  bool yields(const std::string& key) const { return yielding_.count(key) > 0; }
  double& value(const std::string& key) {
    const auto found = fit_values().find(key);
    if (found != fit_values().end()) return shirt_.fit.*found->second;
    for (const ShirtMeasure& measure : shirt_measure_list())
      if (std::string("measures.") + measure.name == key) return shirt_.measures.*measure.field;
    throw Error("no value " + key);
  }

  /// Sets a value that yields, held between two ends; false if that changes nothing.
  bool set(const std::string& key, double wanted, double low, double high) {
    if (!yields(key) || !std::isfinite(wanted)) return false;
    double& now = value(key);
    // A value beyond an end stays there.
    const double next = std::clamp(wanted, std::min(low, now), std::max(high, now));
    if (std::abs(next - now) < 1e-9) return false;
    now = next;
    why_.insert({key, rule_});
    return true;
  }

  /// Moves a value that yields towards `end`, just far enough for `quick`, or to the end. Where
  /// that holds already, and yet the rule is broken, only drafting can tell.
  bool move(const std::string& key, double end, const std::function<bool()>& quick) {
    if (!yields(key) || std::abs(value(key) - end) < 1e-9) return false;
    const bool tells = !quick();
    const auto holds = [&] { return tells ? quick() : drafts(); };
    double &now = value(key), bad = now, good = end;
    now = end;
    if (holds())
      for (int i = 0; i < kHalvings; ++i) {
        now = 0.5 * (bad + good);
        (holds() ? good : bad) = now;
      }
    now = good;
    why_.insert({key, rule_});
    return true;
  }
  bool move(const std::string& key, double end) {
    return move(key, end, [] { return true; });
  }

  bool drafts() const {
    try {
      draft_shirt(shirt_.measures, shirt_.fit);
    } catch (const ShirtRefusal& refusal) {
      return refusal.rule() != rule_;
    }
    return true;
  }

  bool follow_less(double metres) {
    const ShirtFit& fit = shirt_.fit;
    if (!(fit.chest > 0)) return false;
    const double wider = fit.chest * shoulder_half_width(shirt_.measures);
    return set("fit.shoulder_follow", fit.shoulder_follow - metres / wider, 0, 1);
  }

  bool relieve_by_fit(const ShirtRefusal& refusal) {
    const ShirtMeasures& m = shirt_.measures;
    ShirtFit& fit = shirt_.fit;
    const double missing = refusal.shortfall() + kBeyond;
    switch (rule_) {
      case ShirtRule::sleeve_width: {
        const auto fits = [&] { return sleeve_fits_armhole(m, fit); };
        if (fit.sleeve > kFirstSleeve && move("fit.sleeve", kFirstSleeve, fits)) return true;
        if (fit.scye_ease < 0.15 && move("fit.scye_ease", 0.15, fits)) return true;
        return fit.sleeve > -0.35 && move("fit.sleeve", -0.35, fits);
      }
      case ShirtRule::shoulder_level: {
        const double slope = std::tan(seam_slope(m));
        return (slope > 0 && follow_less(missing / slope)) ||
               set("fit.scye_ease", fit.scye_ease + missing, -0.02, 0.15);
      }
      case ShirtRule::hem_level:
        return !yields("measures.hps_to_hem") &&
               set("fit.scye_ease", fit.scye_ease - missing, -0.02, 0.15);
      case ShirtRule::neck:
        return set("fit.neck_ease", fit.neck_ease - 2 * missing / m.neck_width, -0.2, 1);
      case ShirtRule::sleeve_length:
        return set("fit.sleeve_length", fit.sleeve_length + missing / m.arm_length, 0.25, 1) ||
               follow_less(missing);
      case ShirtRule::torso_outline:
        return move("fit.shoulder_follow", 0) || move("fit.scye_ease", 0);
      case ShirtRule::sleeve_outline: {
        // A straight tube never crosses itself.
        const double tube = (1 + fit.sleeve) * m.upper_arm / arm_girth_at(m, fit.sleeve_length) - 1;
        return move("fit.wrist", tube);
      }
      case ShirtRule::waist_level:
      case ShirtRule::range:
        return false;
    }
    return false;
  }

  bool relieve_by_measures(const ShirtRefusal& refusal) {
    const ShirtMeasures& m = shirt_.measures;
    const ShirtFit& fit = shirt_.fit;
    const double missing = refusal.shortfall() + kBeyond;
    switch (rule_) {
      case ShirtRule::range:
        for (const ShirtMeasure& measure : shirt_measure_list()) {
          const std::string key = std::string("measures.") + measure.name;
          if (key != refusal.place().key || !yields(key) || std::isnan(m.*measure.field)) continue;
          value(key) = std::clamp(m.*measure.field, measure.low, measure.high);
          why_.insert({key, rule_});
          return true;
        }
        return false;
      case ShirtRule::sleeve_width:
        return move("measures.upper_arm", 0.08, [&] { return sleeve_fits_armhole(m, fit); });
      case ShirtRule::shoulder_level:
        return move("measures.shoulder_slope", 0);
      case ShirtRule::hem_level:
        return set("measures.hps_to_hem", m.hps_to_hem + missing, 0.2, 1.6);
      case ShirtRule::waist_level: {
        const double lower = refusal.shortfall();
        return set("measures.hps_to_waist", m.hps_to_waist + lower + std::copysign(kBeyond, lower),
                   0.15, 0.8);
      }
      case ShirtRule::neck:
        return set("measures.neck_width", m.neck_width - 2 * missing / (1 + fit.neck_ease), 0.04,
                   0.35);
      case ShirtRule::sleeve_length:
        return set("measures.arm_length", m.arm_length + missing / fit.sleeve_length, 0.15, 1);
      case ShirtRule::torso_outline:
        return move("measures.shoulder_length", 0.03);
      case ShirtRule::sleeve_outline:
        return false;
    }
    return false;
  }

  /// What the user asked for and the rule depends on.
  std::vector<std::string> asked_of(ShirtRule rule) const {
    std::vector<std::string> asked;
    const ShirtFit& fit = shirt_.fit;
    const auto absent = [&](const std::string& key) {
      return (key == "fit.waist" && !fit.waist) ||
             (key == "fit.back_waist" && fit.back_waist == 0) ||
             (key == "fit.neckband_width" && fit.neckband == 0) ||
             (key == "fit.cuff_width" && fit.cuff == 0);
    };
    for (const std::string& key : fits_of(rule))
      if (!yields(key) && !absent(key)) asked.push_back(key);
    return asked;
  }

  [[noreturn]] void refuse(const ShirtRefusal& refusal) {
    const std::vector<std::string> asked = asked_of(refusal.rule());
    const std::string& key = refusal.place().key;
    if (!yields(key) || asked.empty()) throw InvalidInput(refusal);
    const double found = asked[0] == "fit.waist" ? *shirt_.fit.waist : value(asked[0]);
    throw InvalidInput({{}, 0, asked[0]}, shortest(found),
                       std::string("a value that can be drafted: ") + reason_of(refusal.rule()),
                       refusal.hint());
  }

  void tell() {
    const auto tell_of = [&](const std::string& key, double before, double after) {
      if (std::abs(after - before) < kVisible) return;
      shirt_.changes.push_back({key, before, after, reason_of(why_.at(key))});
    };
    for (const auto& [key, field] : fit_values())
      tell_of(key, first_fit_.*field, shirt_.fit.*field);
    for (const ShirtMeasure& measure : shirt_measure_list())
      tell_of(std::string("measures.") + measure.name, first_m_.*measure.field,
              shirt_.measures.*measure.field);
  }

  const ShirtMeasures first_m_;
  const ShirtFit first_fit_;
  const std::set<std::string> yielding_;
  std::map<std::string, ShirtRule> why_;
  ShirtRule rule_ = ShirtRule::range;
  AdaptedShirt shirt_;
};

}  // namespace

std::string ShirtChange::told() const {
  return fmt::format("{}: {:.3g} instead of {:.3g}, since otherwise {}", key, after, before,
                     reason);
}

AdaptedShirt draft_adapted_shirt(const ShirtMeasures& measures, const ShirtFit& fit,
                                 const std::set<std::string>& yielding) {
  return Adapter(measures, fit, yielding).run();
}

}  // namespace loosefit::kinds
