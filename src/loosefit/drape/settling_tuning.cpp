#include "loosefit/drape/settling_tuning.h"

#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::drape {
namespace {

// Bounds say what makes sense at all, not what works well. Lengths [m], residuals [–], times [s].
constexpr double kLeastLength = 1e-6, kMostLength = 1.0;
constexpr double kLeastResidual = 1e-6, kMostResidual = 1e4;
constexpr double kLeastTime = 1e-6, kMostTime = 1e4;
constexpr double kMostCount = 1e6;

/// Collects the fields of one group after another.
class Fields {
 public:
  explicit Fields(std::string group) : group_(std::move(group)) {}

  Fields& number(const char* name, double& value, double least, double most) {
    fields.push_back({group_ + "." + name, &value, least, most});
    return *this;
  }
  Fields& length(const char* name, double& v) { return number(name, v, kLeastLength, kMostLength); }
  Fields& share(const char* name, double& v) { return number(name, v, 1e-9, 1); }
  Fields& time(const char* name, double& v) { return number(name, v, kLeastTime, kMostTime); }
  Fields& residual(const char* name, double& v) {
    return number(name, v, kLeastResidual, kMostResidual);
  }
  Fields& count(const char* name, int& value, double least = 0) {
    fields.push_back({group_ + "." + name, &value, least, kMostCount});
    return *this;
  }

  std::vector<TuningField> fields;

 private:
  std::string group_;
};

Fields cloth_fields(ClothModelTuning& t) {
  return Fields("cloth")
      .number("layer_pressure", t.layer_pressure, 1, 1e7)
      .number("reference_stiffness", t.reference_stiffness, 1, 1e7)
      .length("stick_reach", t.stick_reach)
      .share("wave_share", t.wave_share)
      .number("coarse_thickness", t.coarse_thickness, 1, 100);
}

Fields carry_fields(CarryTuning& t) {
  return Fields("carry")
      .length("field_margin", t.field_margin)
      .number("field_margin_below", t.field_margin_below, 0, 10)
      .length("smoothing_length", t.smoothing_length)
      .count("smoothing_passes", t.smoothing_passes, 1)
      .number("rough_field_spacing", t.rough_field_spacing, 1e-3, 0.05)
      .number("layer_close", t.layer_close, 0, kMostLength)
      .length("layer_apart", t.layer_apart)
      .count("impact_rounds", t.impact_rounds);
}

Fields contract_fields(ContractTuning& t) {
  return Fields("contract")
      .number("pad_thickness", t.pad_thickness, 0, 0.05)
      .share("stiffness_shares[0]", t.stiffness_shares[0])
      .share("stiffness_shares[1]", t.stiffness_shares[1])
      .residual("softened_tolerance", t.softened_tolerance)
      .residual("dressed_tolerance", t.dressed_tolerance)
      .time("first_dt", t.first_dt)
      .count("softened_iterations", t.softened_iterations);
}

Fields disturb_fields(DisturbTuning& t) {
  return Fields("disturb")
      .number("wave_height", t.wave_height, 0, 1000)
      .number("wave_width", t.wave_width, 0, 1000)
      .number("wave_amplitude", t.wave_amplitude, 0, 10)
      .residual("tolerance", t.tolerance)
      .time("first_dt", t.first_dt)
      .count("steps", t.steps, 1)
      .count("iterations", t.iterations);
}

void add_plan(Fields& fields, const std::string& name, StepPlan& plan) {
  fields.number((name + ".turn").c_str(), plan.turn, 1e-3, 3)
      .residual((name + ".tolerance").c_str(), plan.tolerance)
      .count((name + ".iterations").c_str(), plan.iterations);
}

Fields follow_fields(FollowTuning& t) {
  Fields fields("follow");
  add_plan(fields, "plan", t.plan);
  return fields.number("lagging", t.lagging, 1, kMostResidual)
      .share("free_share", t.free_share)
      .share("layers_free_share", t.layers_free_share)
      .length("deepest", t.deepest)
      .number("limb_share", t.limb_share, 0.1, 10)
      .length("shallow", t.shallow)
      .length("deeper", t.deeper)
      .length("caught_depth", t.caught_depth)
      .residual("caught_tolerance", t.caught_tolerance)
      .time("first_dt", t.first_dt)
      .time("finest_first_dt", t.finest_first_dt)
      .number("no_turn", t.no_turn, 0, 0.1)
      .count("longer", t.longer, 1)
      .count("shortest", t.shortest, 1)
      .number("halved_from", t.halved_from, 1, 10)
      .number("taken_along", t.taken_along, 0, 1)
      .count("sampled_skin", t.sampled_skin, 1)
      .count("iterations_factor", t.iterations_factor)
      .count("least_iterations", t.least_iterations);
}

Fields wear_in_fields(WearInTuning& t) {
  return Fields("wear_in")
      .residual("pull_tolerance", t.pull_tolerance)
      .time("first_dt", t.first_dt)
      .count("pull_iterations", t.pull_iterations);
}

Fields level_fields(LevelTuning& t) {
  return Fields("levels")
      .residual("tolerance", t.tolerance)
      .time("first_dt", t.first_dt)
      .count("iterations", t.iterations);
}

Fields penetration_fields(PenetrationTuning& t) {
  Fields fields("penetrations");
  for (std::size_t i = 0; i < t.look_tolerances.size(); ++i)
    fields.residual(fmt::format("look_tolerances[{}]", i).c_str(), t.look_tolerances[i]);
  for (std::size_t i = 0; i < t.look_first_dt.size(); ++i)
    fields.time(fmt::format("look_first_dt[{}]", i).c_str(), t.look_first_dt[i]);
  for (std::size_t i = 0; i < t.look_hardening.size(); ++i)
    fields.number(fmt::format("look_hardening[{}]", i).c_str(), t.look_hardening[i], 0, 1);
  return fields.residual("tolerance", t.tolerance)
      .time("first_dt", t.first_dt)
      .time("near_rest_dt", t.near_rest_dt)
      .length("lattice_spacing", t.lattice_spacing)
      .number("bulge", t.bulge, 0, kMostLength)
      .number("worth_a_point", t.worth_a_point, 0, kMostLength)
      .count("cell_intervals", t.cell_intervals, 2)
      .share("least_step", t.least_step)
      .count("exact_rounds", t.exact_rounds)
      .number("clearance", t.clearance, 0, kMostLength)
      .number("clearance_each_time", t.clearance_each_time, 0, kMostLength)
      .number("near_penetration", t.near_penetration, 0, kMostLength)
      .number("largest_raise", t.largest_raise, 0, kMostLength)
      .number("largest_field_error", t.largest_field_error, 0, kMostLength)
      .length("far", t.far)
      .count("look_iterations", t.look_iterations)
      .count("rounds", t.rounds);
}

Fields certify_fields(CertifyTuning& t) {
  return Fields("certify")
      .share("first_share", t.first_share)
      .share("next_share", t.next_share)
      .share("worth_keeping", t.worth_keeping)
      .count("attempts", t.attempts)
      .count("saddle_attempts", t.saddle_attempts)
      .length("saddle_step", t.saddle_step)
      .count("few_triangles", t.few_triangles)
      .length("restart_perturbation", t.restart_perturbation);
}

Fields stall_fields(StallTuning& t) {
  return Fields("stall")
      .count("iterations", t.iterations, 1)
      .share("progress", t.progress)
      .length("slides", t.slides);
}

Fields fall_fields(FreeFallTuning& t) {
  return Fields("free_fall")
      .number("together", t.together, 0, kMostLength)
      .number("aside", t.aside, 0, 10);
}

Fields integrator_fields(IntegratorTuning& t) {
  return Fields("integrators")
      .time("implicit_dt", t.implicit_dt)
      .count("explicit_steps", t.explicit_steps, 1);
}

}  // namespace

std::vector<TuningField> tuning_fields(SettlingTuning& t) {
  std::vector<TuningField> all;
  for (const Fields& group :
       {cloth_fields(t.cloth), carry_fields(t.carry), contract_fields(t.contract),
        disturb_fields(t.disturb), follow_fields(t.follow), wear_in_fields(t.wear_in),
        level_fields(t.levels), penetration_fields(t.penetrations), certify_fields(t.certify),
        stall_fields(t.stall), fall_fields(t.free_fall), integrator_fields(t.integrators)})
    all.insert(all.end(), group.fields.begin(), group.fields.end());
  return all;
}

void SettlingTuning::validate() const {
  SettlingTuning copy = *this;
  for (const TuningField& field : tuning_fields(copy)) {
    const double value = std::visit([](auto* p) { return static_cast<double>(*p); }, field.value);
    if (!(value >= field.least && value <= field.most))
      throw InvalidInput({"", 0, "tuning." + field.name}, fmt::format("{:g}", value),
                         fmt::format("{:g} … {:g}", field.least, field.most));
  }
  if (carry.layer_close >= carry.layer_apart)
    throw InvalidInput({"", 0, "tuning.carry.layer_close"}, fmt::format("{:g}", carry.layer_close),
                       fmt::format("less than carry.layer_apart ({:g})", carry.layer_apart));
}

}  // namespace loosefit::drape
