#include "loosefit/body/body_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/body/bounded_least_squares.h"
#include "loosefit/body/plausible_measures.h"

namespace loosefit::body {
namespace {

constexpr double kHeightTolerance = 0.002;  // what counts as one unit of misfit [m]
constexpr double kGirthTolerance = 0.003;
constexpr double kResidualWarning = 0.005;
constexpr double kImpossible = 0.1;  // share of a wish that the nearest body misses
constexpr double kStrainedDetail = 0.6;
constexpr double kHeaviest = 1.6;
constexpr double kAtBound = 1 - 1e-6;
constexpr double kGrownUp = 18;  // years

struct Unknown {
  std::string key;  ///< "height", "weight" or a detail
  double start = 0, low = -1, high = 1, stiffness = 0.3;
};

// Local changes that a measure brings into the fit.
const std::map<std::string, std::vector<std::string>> kDetailsOf = {
    {"neck", {"neck"}},
    {"mid_neck", {"neck"}},
    {"upper_arm", {"upper_arm"}},
    {"forearm", {"forearm"}},
    {"wrist", {"wrist"}},
    {"thigh", {"thigh"}},
    {"knee", {"knee"}},
    {"calf", {"calf"}},
    {"ankle", {"ankle"}},
    {"shoulder_breadth", {"shoulder"}},
    {"arm_length", {"upper_arm_length", "forearm_length"}},
    {"back_length", {"nape_to_waist"}},
    {"crotch_height", {"thigh_length", "shank_length"}}};

void check_spec(const BodySpec& spec) {
  const auto check = [](const std::string& name, double value) {
    const PlausibleMeasure& range = plausible_measure(name);
    if (!(value >= range.low && value <= range.high)) {
      throw InvalidInput({"", 0, name}, fmt::format("{:g} m", value),
                         fmt::format("{:g} to {:g} m", range.low, range.high),
                         "measures are in metres");
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

std::vector<Unknown> unknowns_of(const BodySpec& spec, double heaviest,
                                 const std::set<std::string>& given_up) {
  std::vector<Unknown> unknowns;
  if (spec.height != 0) unknowns.push_back({"height", 0.5, 0, 1, 0.3});
  const bool trunk =
      std::any_of(spec.measurements.begin(), spec.measurements.end(), [](const auto& m) {
        return m.first == "chest" || m.first == "underbust" || m.first == "waist" ||
               m.first == "hip";
      });
  if (trunk) {
    unknowns.push_back({"weight", 0.5, 0, heaviest, 0.5});
    unknowns.push_back({"bust", 0, -1, 1, 0.5});
    unknowns.push_back({"underbust", 0, -1, 1, 0.6});
    unknowns.push_back({"waist", 0, -1, 1, 0.5});
    unknowns.push_back({"hips", 0, -1, 1, 0.5});
    unknowns.push_back({"belly", 0, -0.3, 0.5, 0.6});
  }
  for (const auto& [measure, details] : kDetailsOf) {
    if (!spec.measurements.contains(measure) || given_up.contains(measure)) continue;
    for (const auto& key : details) {
      const bool known = std::any_of(unknowns.begin(), unknowns.end(),
                                     [&](const Unknown& u) { return u.key == key; });
      if (!known) unknowns.push_back({key, 0, -1, 1, 0.3});
    }
  }
  return unknowns;
}

// One bounded least-squares problem over the model's knobs.
class Fitter {
 public:
  Fitter(const BodyModel& model, BodyDetail detail, BodyParameters fixed,
         std::vector<MeasureRow> asked)
      : model_(model), detail_(detail), fixed_(std::move(fixed)), asked_(std::move(asked)) {}

  void solve(const std::vector<Unknown>& unknowns) {
    BoundedProblem problem;
    const auto n = Eigen::Index(unknowns.size());
    problem.start = problem.lower = problem.upper = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Unknown& unknown = unknowns[std::size_t(i)];
      problem.start[i] = unknown.start;
      problem.lower[i] = unknown.low;
      problem.upper[i] = unknown.high;
    }
    problem.residuals = [&](const Eigen::VectorXd& x) { return residuals(unknowns, x); };
    const BoundedSolution found = bounded_gauss_newton(problem);
    evaluations_ += found.evaluations;
    parameters_ = parameters_at(unknowns, found.x);
    const RestBody rest = model_.rest(parameters_, detail_);
    const BodyTape tape(model_.data(), rest);
    for (auto& row : asked_) row.measured = tape.measure(row.name);
  }

  /// Measures that their own local changes cannot reach: these stay at their bounds and the measure
  /// no longer pulls at the rest of the body. True when one was found.
  bool give_up_unreachable() {
    bool any = false;
    for (const auto& row : asked_) {
      const auto details = kDetailsOf.find(row.name);
      if (details == kDetailsOf.end() || off(row) <= kResidualWarning ||
          given_up_.contains(row.name)) {
        continue;
      }
      const auto at_bound = [&](const std::string& key) {
        return std::abs(parameters_.details.at(key)) >= kAtBound;
      };
      if (!std::all_of(details->second.begin(), details->second.end(), at_bound)) continue;
      given_up_.insert(row.name);
      for (const auto& key : details->second) fixed_.details[key] = parameters_.details.at(key);
      any = true;
    }
    return any;
  }

  static double off(const MeasureRow& row) { return std::abs(row.measured - row.asked); }
  bool misses() const {
    return std::any_of(asked_.begin(), asked_.end(),
                       [](const MeasureRow& row) { return off(row) > kResidualWarning; });
  }
  const BodyParameters& parameters() const { return parameters_; }
  const std::vector<MeasureRow>& table() const { return asked_; }
  const std::set<std::string>& given_up() const { return given_up_; }
  int evaluations() const { return evaluations_; }

 private:
  BodyParameters parameters_at(const std::vector<Unknown>& unknowns,
                               const Eigen::VectorXd& x) const {
    BodyParameters p = fixed_;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const double value = x[Eigen::Index(i)];
      if (unknowns[i].key == "height") {
        p.height = value;
      } else if (unknowns[i].key == "weight") {
        p.weight = value;
      } else {
        p.details[unknowns[i].key] = value;
      }
    }
    return p;
  }

  Eigen::VectorXd residuals(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x) const {
    const RestBody rest = model_.rest(parameters_at(unknowns, x), detail_);
    const BodyTape tape(model_.data(), rest);
    std::vector<double> values;
    for (const auto& row : asked_) {
      if (given_up_.contains(row.name)) continue;
      values.push_back((tape.measure(row.name) - row.asked) /
                       (row.name == "height" ? kHeightTolerance : kGirthTolerance));
    }
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      values.push_back(unknowns[i].stiffness * (x[Eigen::Index(i)] - unknowns[i].start));
    }
    return Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(values.size()));
  }

  const BodyModel& model_;
  BodyDetail detail_;
  BodyParameters fixed_, parameters_;
  std::vector<MeasureRow> asked_;
  std::set<std::string> given_up_;
  int evaluations_ = 0;
};

// A body whose stature or trunk is this far from what was asked for is somebody else. A limb or
// neck out of reach is only reported: it spoils nothing else.
void refuse_impossible(const std::vector<MeasureRow>& table) {
  std::string nearest;
  for (const auto& row : table)
    nearest += fmt::format("{}{} {:.3f} m", nearest.empty() ? "" : ", ", row.name, row.measured);
  for (const auto& row : table) {
    if (kDetailsOf.contains(row.name) || Fitter::off(row) <= kImpossible * row.asked) continue;
    throw InvalidInput({"", 0, row.name}, fmt::format("{:g} m", row.asked),
                       fmt::format("at {} about {:.3f} m beside the other wishes",
                                   row.measured < row.asked ? "most" : "least", row.measured),
                       "the nearest body has " + nearest);
  }
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
    if (Fitter::off(row) > kResidualWarning) {
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

BodyFit fit_body(const BodyModel& model, const BodySpec& spec, BodyDetail detail) {
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

  Fitter fitter(model, detail, fixed, asked);
  double heaviest = 1;
  fitter.solve(unknowns_of(spec, heaviest, {}));
  if (fitter.misses() && fitter.give_up_unreachable()) {
    fitter.solve(unknowns_of(spec, heaviest, fitter.given_up()));
  }
  // Beyond weight 1 the model extrapolates; only bodies that need it go there.
  if (fitter.misses() && fitter.parameters().weight >= kAtBound) {
    heaviest = kHeaviest;
    fitter.solve(unknowns_of(spec, heaviest, fitter.given_up()));
  }
  BodyFit fit;
  fit.parameters = fitter.parameters();
  fit.table = fitter.table();
  fit.evaluations = fitter.evaluations();
  refuse_impossible(fit.table);
  add_warnings(spec, fit);
  return fit;
}

}  // namespace loosefit::body
