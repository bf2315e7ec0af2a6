#pragma once
#include <string>

#include "loosefit/validate/run_validation.h"

namespace loosefit::validate {

/// Error of a finding as a reader wants it: percent for a relative gate, else with its unit.
std::string error_text(const Finding& finding);
/// The gate in the same form, "at most 0.25" or "0 to 1.02" for a range; "reported" without one.
std::string gate_text(const Finding& finding);
/// What the source says; "-" where it says no more than the range.
std::string expected_text(const Finding& finding, int digits);
/// "DC of …: known to miss by up to 0.15: why"; empty for other findings.
std::string known_miss_text(const Finding& finding);

/// Table of one benchmark for the terminal: a heading with verdict and seconds, a row per finding,
/// then the reasons of known misses.
std::string outcome_table(const BenchmarkOutcome& outcome);
/// "20 of 22 gated benchmarks pass; known misses: D2; missed: B7"
std::string verdict_line(const Validation& validation);

}  // namespace loosefit::validate
