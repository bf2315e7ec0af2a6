#pragma once
#include <string>

#include "loosefit/validate/run_validation.h"

namespace loosefit::validate {

/// Error of a finding as a reader wants it: percent for a relative gate, else with its unit.
std::string error_text(const Finding& finding);
/// The gate in the same form; "reported" without one.
std::string gate_text(const Finding& finding);
/// "pass" or "MISS"; "-" for a figure that is only reported.
std::string verdict_text(const Finding& finding);

/// Table of one benchmark for the terminal: a heading with verdict and seconds, a row per finding.
std::string outcome_table(const BenchmarkOutcome& outcome);
/// "20 of 21 gated benchmarks pass; missed: B7"
std::string verdict_line(const Validation& validation);

}  // namespace loosefit::validate
