#include "loosefit/fabric/kes_units.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/base/types.h"

namespace loosefit::fabric {
namespace {

constexpr double kGramForce = 9.80665e-3;  // [N]
constexpr double kCentimetre = 1e-2;       // [m]
constexpr double kForcePerWidth = kGramForce / kCentimetre;

// Half a unit in the last digit of the shortest decimal text of a number, relative to it.
double rounding_share(double value) {
  std::string text = shortest(std::abs(value));
  int exponent = 0;
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    exponent = std::atoi(text.c_str() + e + 1);
    text.resize(e);
  }
  const std::size_t point = text.find('.');
  const bool whole = point == std::string::npos || text.substr(point) == ".0";
  if (!whole) exponent -= static_cast<int>(text.size() - point - 1);
  return 0.5 * std::pow(10.0, exponent) / std::abs(value);
}

}  // namespace

const std::vector<KesUnit>& kes_units() {
  static const std::vector<KesUnit> kTable = {
      {"B", "bending rigidity", "gf cm2/cm", "N m", kGramForce * kCentimetre},
      {"2HB", "hysteresis of the bending moment", "gf cm/cm", "N", kGramForce},
      {"G", "shear stiffness", "gf/(cm deg)", "N/m per rad", kForcePerWidth * 180 / kPi},
      {"2HG", "hysteresis of the shear force at 0.5 deg", "gf/cm", "N/m", kForcePerWidth},
      {"2HG5", "hysteresis of the shear force at 5 deg", "gf/cm", "N/m", kForcePerWidth},
      {"F", "force per width", "gf/cm", "N/m", kForcePerWidth},
      {"EMT", "elongation at the largest load", "%", "-", 0.01},
      {"LT", "linearity of the load-elongation curve", "-", "-", 1},
      {"WT", "tensile energy", "gf cm/cm2", "J/m2", kGramForce / kCentimetre},
      {"RT", "tensile resilience", "%", "-", 0.01},
      {"LC", "linearity of compression", "-", "-", 1},
      {"WC", "compression energy", "gf cm/cm2", "J/m2", kGramForce / kCentimetre},
      {"RC", "compression resilience", "%", "-", 0.01},
      {"MIU", "surface friction coefficient", "-", "-", 1},
      {"MMD", "mean deviation of MIU", "-", "-", 1},
      {"SMD", "surface roughness", "um", "m", 1e-6},
      {"T", "thickness at 0.5 gf/cm2", "mm", "m", 1e-3},
      {"W", "weight", "mg/cm2", "kg/m2", 0.01},
      {"FAST-B", "bending rigidity of the FAST system", "uN m", "N m", 1e-6},
      {"pressure", "garment pressure", "mmHg", "Pa", 133.322},
  };
  return kTable;
}

const KesUnit& kes_unit(const std::string& quantity) {
  std::vector<std::string> names;
  for (const KesUnit& unit : kes_units()) {
    if (unit.quantity == quantity) return unit;
    names.push_back(unit.quantity);
  }
  throw InvalidInput({"", 0, "quantity"}, "\"" + printable(quantity) + "\"", "a KES quantity",
                     did_you_mean(quantity, names));
}

double kes_to_si(const std::string& quantity, double value) {
  return kes_unit(quantity).factor * value;
}

double tensile_secant(double emt_percent, double load_gf_per_cm) {
  return kes_to_si("F", load_gf_per_cm) / kes_to_si("EMT", emt_percent);
}

bool same_within_rounding(double measured, double converted, double si) {
  if (measured == 0 || si == 0) return converted == si;
  const double allowed = std::min(rounding_share(measured) + rounding_share(si), 0.02);
  return std::abs(converted - si) <= (allowed + 1e-9) * std::abs(si);
}

}  // namespace loosefit::fabric
