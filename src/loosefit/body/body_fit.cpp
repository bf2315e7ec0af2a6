#include "loosefit/body/body_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/body/person_search.h"
#include "loosefit/body/plausible_measures.h"

namespace loosefit::body {
namespace {

constexpr double kStrainedDetail = 0.6;
constexpr double kGrownUp = 18;      // years
constexpr double kInch = 0.0254;     // [m]
constexpr double kWholeInch = 0.02;  // how far from a whole number of inches is one [inches]
constexpr double kNearInches = 0.1;  // share by which a measure in inches may be off what is usual

/// "; inches? 33 in are 0.838 m" for each unit in which the number is plausible.
std::string other_unit(double value, const PlausibleMeasure& range) {
  std::string units;
  for (const auto& [name, symbol, metres] :
       {std::tuple("centimetres", "cm", 0.01), std::tuple("inches", "in", kInch)})
    if (value * metres >= range.low && value * metres <= range.high)
      units += fmt::format("; {}? {:g} {} are {:.3f} m", name, value, symbol, value * metres);
  return units;
}

void check_spec(const BodySpec& spec) {
  const auto check = [](const std::string& name, double value) {
    const PlausibleMeasure& range = plausible_measure(name);
    if (!(value >= range.low && value <= range.high)) {
      throw InvalidInput({"", 0, name}, fmt::format("{:g} m", value),
                         fmt::format("{:g} to {:g} m", range.low, range.high),
                         "measures are in metres" + other_unit(value, range));
    }
  };
  if (spec.height != 0) check("height", spec.height);
  for (const auto& [name, value] : spec.measurements) {
    if (name == "height") {
      throw InvalidInput({"", 0, "measurements"}, "\"height\"", "the stature as its own entry");
    }
    check(name, value);
  }
}

std::string named(const MeasureRow& row) {
  return fmt::format("{} {:.3f} m", row.name, row.measured);
}

/// "; inches? 13 in are 0.330 m" where a number of inches fits the wish, or nothing: 0.23 m of a
/// thigh that would usually be 23 in, or 0.33 m, which are 13 in.
std::string perhaps_inches(double asked, double usual) {
  const double digits = 100 * asked, same = asked / kInch;
  const bool meant = std::abs(digits * kInch / usual - 1) < kNearInches;
  if (!meant && std::abs(same - std::round(same)) > kWholeInch) return "";
  const double inches = meant ? digits : std::round(same);
  return fmt::format("; inches? {:.4g} in are {:.3f} m", inches, inches * kInch);
}

/// The rows but one.
std::vector<MeasureRow> without(std::vector<MeasureRow> rows, const std::string& name) {
  std::erase_if(rows, [&](const MeasureRow& row) { return row.name == name; });
  return rows;
}

/// A wish that is missed, and what the body has there that the other wishes make.
struct OddWish {
  MeasureRow row;
  double usual = 0;  ///< [m]
  bool others_are_met = false;
};

/// The wish that is most at odds with the others: left out, they are met, by a body that is
/// farthest from it. Where leaving out one is not enough, the one missed most.
OddWish odd_one_out(PersonSearch& search, const std::vector<MeasureRow>& table) {
  const auto worst = std::ranges::max_element(table, {}, miss);
  OddWish odd{*worst, worst->measured};
  double farthest = 0;
  for (const MeasureRow& row : table) {
    if (off(row) <= kResidual) continue;
    const FoundPerson others = search.nearest(without(table, row.name));
    const double usual = search.measure(others.parameters, row.name);
    if (misses(others) || std::abs(std::log(usual / row.asked)) <= farthest) continue;
    farthest = std::abs(std::log(usual / row.asked));
    odd = {row, usual, true};
  }
  return odd;
}

std::string at_most_or_least(const MeasureRow& row) {
  return fmt::format("at {} about {:.3f} m", row.measured < row.asked ? "most" : "least",
                     row.measured);
}

/// The wishes beside `name` that the nearest body misses as well, which are at odds with it; where
/// it misses none of them, all others.
std::string beside_others(const std::vector<MeasureRow>& table, const std::string& name) {
  std::vector<std::string> missed, all;
  for (const MeasureRow& row : without(table, name)) {
    all.push_back(fmt::format("{} {:.3f} m", row.name, row.asked));
    if (off(row) > kResidual) missed.push_back(all.back());
  }
  if (all.empty()) return "";
  return " beside " + join(missed.empty() ? all : missed);
}

/// A body that misses a wish by more than kMostMiss is somebody else. Told is which wish, how far a
/// body goes towards it beside which others, whether the model ends there, and who is nearest.
void refuse_misses(PersonSearch& search, const FoundPerson& found) {
  if (std::ranges::all_of(found.table,
                          [](const MeasureRow& row) { return miss(row) <= kMostMiss; }))
    return;
  const OddWish odd = odd_one_out(search, found.table);
  const std::string& name = odd.row.name;
  const auto row_of = [&](const std::vector<MeasureRow>& rows) {
    return *std::ranges::find(rows, name, &MeasureRow::name);
  };
  // By itself at this stature the wish shows whether the model ends before it.
  std::vector<MeasureRow> alone = found.table;
  std::erase_if(alone, [&](const MeasureRow& r) { return r.name != name && r.name != "height"; });
  const MeasureRow end = row_of(search.farthest(alone, name).table);
  const std::string model_ends =
      off(end) <= kResidual
          ? ""
          : fmt::format("the body model ends at about {} for this {}", named(end),
                        alone.size() > 1 ? "stature, sex and age" : "sex and age");
  std::string expected, hint = "the nearest body has ";
  if (odd.others_are_met)
    expected = at_most_or_least(row_of(search.farthest(found.table, name).table)) +
               beside_others(found.table, name);
  else
    expected = model_ends.empty() ? "measures that one body has together" : at_most_or_least(end);
  for (const MeasureRow& row : found.table)
    hint += (&row == &found.table.front() ? "" : ", ") + named(row);
  if (!model_ends.empty()) hint = model_ends + "; " + hint;
  throw InvalidInput({"", 0, name}, fmt::format("{:g} m", odd.row.asked), expected,
                     hint + perhaps_inches(odd.row.asked, odd.usual));
}

void add_warnings(const BodySpec& spec, BodyFit& fit) {
  if (spec.height == 0 && spec.age < kGrownUp) {
    fit.warnings.push_back("no height given: the model's own height for this age is too small");
  }
  if (fit.parameters.weight > 1) {
    fit.warnings.push_back(
        fmt::format("weight {:.2f}: the body model is extrapolated beyond its heaviest shape",
                    fit.parameters.weight));
  }
  for (const auto& row : fit.table) {
    if (off(row) > kResidual) {
      fit.warnings.push_back(
          fmt::format("{}: asked {:.3f} m, got {:.3f} m", row.name, row.asked, row.measured));
    }
  }
  for (const auto& [key, value] : fit.parameters.details) {
    if (std::abs(value) > kStrainedDetail) {
      fit.warnings.push_back(
          fmt::format("{}: local change {:+.2f} is beyond ±{:g}; look at the body", key, value,
                      kStrainedDetail));
    }
  }
}

}  // namespace

BodyFit fit_body(const BodyModel& model, const BodySpec& spec, BodyDetail detail,
                 Progress* progress) {
  check_spec(spec);
  BodyParameters fixed;
  fixed.sex = spec.sex;
  fixed.age = spec.age;
  fixed.muscle = spec.muscle;
  fixed.proportions = spec.proportions;
  fixed.cup = spec.cup;
  fixed.firmness = spec.firmness;
  check_parameters(fixed);

  std::vector<MeasureRow> asked;
  if (spec.height != 0) asked.push_back({"height", spec.height, 0});
  for (const auto& name : measure_names()) {
    const auto found = spec.measurements.find(name);
    if (found != spec.measurements.end()) asked.push_back({name, found->second, 0});
  }

  PersonSearch search(model, detail, fixed, progress);
  FoundPerson found = search.nearest(asked);
  refuse_misses(search, found);
  BodyFit fit;
  fit.parameters = std::move(found.parameters);
  fit.table = std::move(found.table);
  fit.evaluations = search.evaluations();
  add_warnings(spec, fit);
  return fit;
}

}  // namespace loosefit::body
