#include "loosefit/solver/solver_tuning.h"

#include <fmt/format.h>

#include "loosefit/base/error.h"

namespace loosefit::solver {
namespace {

void check_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw InvalidInput(InputPlace{"", 0, name}, fmt::format("{:g}", value),
                     fmt::format("a number from {:g} to {:g}", low, high));
}

void check_order(const char* names, double low, double high) {
  if (low <= high) return;
  throw InvalidInput(InputPlace{"", 0, names}, fmt::format("{:g} and {:g}", low, high),
                     "a first number that is not above the second");
}

constexpr double kLarge = 1e9;  ///< above it a number is a mistake

void validate_precision(const PrecisionTuning& p) {
  check_range("precision.accuracy", p.accuracy, 1e-15, 0.5);
  check_range("precision.max_iterations", p.max_iterations, 1, kLarge);
  check_range("precision.max_breakdowns", p.max_breakdowns, 1, kLarge);
  check_range("precision.max_pause", p.max_pause, 1, kLarge);
}

void validate_matrix(const MatrixTuning& m) {
  check_range("matrix.max_regularisations", m.max_regularisations, 0, 100);
  check_range("matrix.first_regularisation", m.first_regularisation, 1e-12, kLarge);
  check_range("matrix.regularisation_growth", m.regularisation_growth, 1, kLarge);
}

void validate_search(const LineSearchTuning& s) {
  check_range("search.armijo", s.armijo, 1e-12, 0.5);
  check_range("search.max_backtracks", s.max_backtracks, 1, 1000);
  check_range("search.round_off", s.round_off, 0, 1e-6);
  check_range("search.round_off_floor", s.round_off_floor, 0, 1);
  check_range("search.extension_slope_divisor", s.extension_slope_divisor, 1, kLarge);
}

void validate_step(const StepTuning& s) {
  check_range("step.max_move", s.max_move, 1e-9, 10);
  check_range("step.first_extension", s.first_extension, 1, kLarge);
  check_order("step.first_extension, max_extension", s.first_extension, s.max_extension);
  check_range("step.whole", s.whole, 0, 1);
  check_range("step.extension_growth", s.extension_growth, 1, kLarge);
}

void validate_region(const RegionTuning& r) {
  check_range("region.min_particles", r.min_particles, 0, 2147483647);
  check_range("region.force_share", r.force_share, 0, 1);
  check_range("region.max_seeds", r.max_seeds, 0, 1);
  check_range("region.rings", r.rings, 0, kLarge);
  check_range("region.max_extent", r.max_extent, 0, 1);
  check_range("region.max_steps", r.max_steps, 1, kLarge);
  check_range("region.relaxed", r.relaxed, 0, 1);
  validate_matrix(r.matrix);
  validate_search(r.search);
  validate_step(r.step);
}

void validate_quasi_static(const QuasiStaticTuning& q) {
  check_range("quasi_static.newton_per_step", q.newton_per_step, 1, kLarge);
  check_order("quasi_static.newton_per_step, max_newton_per_step", q.newton_per_step,
              q.max_newton_per_step);
  check_range("quasi_static.no_progress", q.no_progress, 1, kLarge);
  check_range("quasi_static.progress", q.progress, 1e-9, 1);
  check_range("quasi_static.step_reduction", q.step_reduction, 0, 1);
  check_range("quasi_static.min_dt", q.min_dt, 1e-12, kLarge);
  check_order("quasi_static.min_dt, inertialess_dt", q.min_dt, q.inertialess_dt);
  check_order("quasi_static.inertialess_dt, max_dt", q.inertialess_dt, q.max_dt);
  check_range("quasi_static.growth", q.growth, 1, kLarge);
  check_range("quasi_static.slow_growth", q.slow_growth, 1, kLarge);
  check_range("quasi_static.whole", q.whole, 0, 1);
  check_order("quasi_static.most, whole", q.most, q.whole);
  check_order("quasi_static.cut_back, most", q.cut_back, q.most);
  check_range("quasi_static.shrink", q.shrink, 1e-9, 1);
  check_range("quasi_static.stall_shrink", q.stall_shrink, 1e-9, 1);
  check_range("quasi_static.cycle", q.cycle, 1, kLarge);
  check_range("quasi_static.damped_dt", q.damped_dt, q.min_dt, q.inertialess_dt);
  check_range("quasi_static.min_growth", q.min_growth, 1, kLarge);
  check_range("quasi_static.stalls_to_plate", q.stalls_to_plate, 0, kLarge);
  check_range("quasi_static.max_stalls", q.max_stalls, 0, kLarge);
}

}  // namespace

void SolverTuning::validate() const {
  validate_precision(precision);
  validate_matrix(matrix);
  validate_search(search);
  validate_step(step);
  validate_region(region);
  validate_quasi_static(quasi_static);
  check_range("implicit_euler.newton_per_step", implicit_euler.newton_per_step, 1, kLarge);
  check_range("implicit_euler.step_reduction", implicit_euler.step_reduction, 0, 1);
  check_range("semi_implicit.watch_interval", semi_implicit.watch_interval, 1, kLarge);
  check_range("semi_implicit.refresh_interval", semi_implicit.refresh_interval, 1, kLarge);
  check_range("semi_implicit.stability_share", semi_implicit.stability_share, 1e-9, 1);
  check_range("semi_implicit.power_iterations", semi_implicit.power_iterations, 1, kLarge);
}

}  // namespace loosefit::solver
