#pragma once
#include "loosefit/validate/benchmark.h"

namespace loosefit::validate {

// One function per benchmark, each in a file of benchmarks/; catalogue.cpp puts them in order.

BenchmarkResult benchmark_homogeneous_strain(Effort effort, Progress& progress);
BenchmarkResult benchmark_derivatives(Effort effort, Progress& progress);
BenchmarkResult benchmark_off_axis(Effort effort, Progress& progress);
BenchmarkResult benchmark_heavy_cantilever(Effort effort, Progress& progress);
BenchmarkResult benchmark_overhang(Effort effort, Progress& progress);
BenchmarkResult benchmark_tip_load(Effort effort, Progress& progress);
BenchmarkResult benchmark_self_buckling(Effort effort, Progress& progress);
BenchmarkResult benchmark_loops(Effort effort, Progress& progress);
BenchmarkResult benchmark_twist_plate(Effort effort, Progress& progress);
BenchmarkResult benchmark_lateral_buckling(Effort effort, Progress& progress);
BenchmarkResult benchmark_bending_direction(Effort effort, Progress& progress);
BenchmarkResult benchmark_residual_curvature(Effort effort, Progress& progress);
BenchmarkResult benchmark_incline(Effort effort, Progress& progress);
BenchmarkResult benchmark_capstan(Effort effort, Progress& progress);
BenchmarkResult benchmark_stick_slip(Effort effort, Progress& progress);
BenchmarkResult benchmark_ruck(Effort effort, Progress& progress);
BenchmarkResult benchmark_sleeve(Effort effort, Progress& progress);
BenchmarkResult benchmark_close_bands(Effort effort, Progress& progress);
BenchmarkResult benchmark_eccentric_tube(Effort effort, Progress& progress);
BenchmarkResult benchmark_free_fall(Effort effort, Progress& progress);
BenchmarkResult benchmark_hanging_swing(Effort effort, Progress& progress);
BenchmarkResult benchmark_cusick_drape(Effort effort, Progress& progress);
BenchmarkResult benchmark_measured_fabrics(Effort effort, Progress& progress);
BenchmarkResult benchmark_back_sensors(Effort effort, Progress& progress);
BenchmarkResult benchmark_arm_sleeve(Effort effort, Progress& progress);
BenchmarkResult benchmark_reference_shirt(Effort effort, Progress& progress);
BenchmarkResult benchmark_shirt_fit(Effort effort, Progress& progress);
BenchmarkResult benchmark_shirts_on_men(Effort effort, Progress& progress);
BenchmarkResult benchmark_ease_ladder(Effort effort, Progress& progress);
BenchmarkResult benchmark_raised_arm(Effort effort, Progress& progress);
BenchmarkResult benchmark_collar(Effort effort, Progress& progress);
BenchmarkResult benchmark_air_gap_tables(Effort effort, Progress& progress);

}  // namespace loosefit::validate
