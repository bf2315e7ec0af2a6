#pragma once
#include <string>
#include <vector>

namespace loosefit::fabric {

/// A quantity of the Kawabata system, its customary unit, and the factor to SI.
struct KesUnit {
  std::string quantity;  ///< "B"
  std::string meaning;
  std::string unit;     ///< as measured: "gf cm2/cm"
  std::string si_unit;  ///< "N m"
  double factor;        ///< SI = factor · KES
};

/// 1 gf is the weight of a gram at standard gravity, 9.80665 m/s²: 9.80665e-3 N. From it follow
///
///   B     1 gf cm²/cm    = 9.80665e-3 N · 1e-4 m² / 1e-2 m = 9.80665e-5 N m
///   2HB   1 gf cm/cm     = 9.80665e-3 N · 1e-2 m / 1e-2 m  = 9.80665e-3 N
///   F     1 gf/cm        = 9.80665e-3 N / 1e-2 m           = 0.980665 N/m      (2HG, 2HG5 too)
///   G     1 gf/(cm deg)  = 0.980665 N/m · 180/π            = 56.1880 N/m per rad
///   WT    1 gf cm/cm²    = 9.80665e-3 N · 1e-2 m / 1e-4 m² = 0.980665 J/m²     (WC too)
///   W     1 mg/cm²       = 1e-6 kg / 1e-4 m²               = 0.01 kg/m²
///   FAST  1 µN m = 1e-6 N m;  1 mmHg = 133.322 Pa
///
/// Sources: Kawabata 1980; docs/theory/materials.md 5. Quantities without a unit have the factor 1.
const std::vector<KesUnit>& kes_units();

/// \throws InvalidInput with a did-you-mean for an unknown quantity.
const KesUnit& kes_unit(const std::string& quantity);
double kes_to_si(const std::string& quantity, double value);

/// Largest load of the KES tensile test for outer wear: 500 gf/cm. The mean (secant) stiffness up
/// to it is F_max / (EMT/100) [N/m].
double tensile_secant(double emt_percent, double load_gf_per_cm = 500);

/// Whether a measured figure, converted to `converted`, and the SI figure printed beside it are the
/// same number: they differ by at most half a unit in the last digit of the one plus half a unit in
/// that of the other, and never by more than 2 %.
bool same_within_rounding(double measured, double converted, double si);

}  // namespace loosefit::fabric
