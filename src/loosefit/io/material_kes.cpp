#include "loosefit/io/material_kes.h"

#include <fmt/format.h>

#include <algorithm>

namespace loosefit {
namespace {

constexpr double kOuterWearLoad = 500;  // [gf/cm]

// How a KES figure becomes a constant of the material.
struct Constant {
  const char* quantity;
  const char* si_key;
  const char* direction;  // "", "warp", "weft"
  double Material::*value;
  NumberRange range;
};

const std::vector<Constant>& constants() {
  static const NumberRange kStiffness{1, 1e6, "N/m"}, kBending{1e-8, 1e-3, "N m"},
      kHysteresis{0, 0.1, "N"};
  static const std::vector<Constant> kTable = {
      {"W", "areal_density", "", &Material::areal_density, {0.01, 5, "kg/m²"}},
      {"T", "thickness", "", &Material::thickness, {5e-5, 0.005, "metres"}},
      {"EMT", "stiffness_warp", "warp", &Material::stiffness_warp, kStiffness},
      {"EMT", "stiffness_weft", "weft", &Material::stiffness_weft, kStiffness},
      {"G", "stiffness_shear", "", &Material::stiffness_shear, {0.1, 1e6, "N/m per rad"}},
      {"B", "bending_warp", "warp", &Material::bending_warp, kBending},
      {"B", "bending_weft", "weft", &Material::bending_weft, kBending},
      {"2HB", "bending_hysteresis_warp", "warp", &Material::bending_hysteresis_warp, kHysteresis},
      {"2HB", "bending_hysteresis_weft", "weft", &Material::bending_hysteresis_weft, kHysteresis},
  };
  return kTable;
}

// Only told, not used by the model; `directed` ones take _warp and _weft.
struct Told {
  const char* quantity;
  bool directed;
};
const Told kTold[] = {{"LT", true},    {"WT", true},   {"RT", true},   {"2HG", false},
                      {"2HG5", false}, {"MIU", false}, {"MMD", false}, {"SMD", false},
                      {"LC", false},   {"WC", false},  {"RC", false}};

bool has_curve(ConfigReader& table, const std::string& si_key) {
  if (si_key.rfind("stiffness_", 0) != 0) return false;
  const ConfigNode* curve = table.node("curve");
  return curve && curve->find(si_key.substr(10)) != nullptr;
}

double in_si(const std::string& quantity, double figure, double load) {
  if (quantity == "EMT") return tensile_secant(figure, load);
  const double si = kes_to_si(quantity, figure);
  return quantity == "2HB" ? si / 2 : si;
}

}  // namespace

std::set<std::string> read_material_kes(ConfigReader& table, Material& material,
                                        std::vector<KesFigure>& figures) {
  std::set<std::string> set;
  if (!table.has("kes")) return set;
  ConfigReader kes = table.table("kes");
  const NumberRange positive{1e-9, 1e6, "a figure above 0"};
  const double load = kes.number("EMT_load", kOuterWearLoad, positive);
  if (kes.has("EMT_load")) figures.push_back({"EMT_load", kes_unit("F"), load});

  const auto tell = [&](const std::string& key, const std::string& quantity) {
    const NumberRange range = quantity[0] == '2' ? NumberRange{0, 1e6, "a figure"} : positive;
    const auto figure = kes.optional_number(key, range);
    if (!figure) return figure;
    const auto same = std::find_if(figures.begin(), figures.end(),
                                   [&](const KesFigure& f) { return f.key == key; });
    if (same == figures.end())
      figures.push_back({key, kes_unit(quantity), *figure});
    else
      same->value = *figure;
    return figure;
  };

  for (const Constant& c : constants()) {
    const std::string quantity = c.quantity, direction = c.direction;
    std::string key = quantity;
    if (!direction.empty() && kes.has(quantity + "_" + direction)) {
      key += "_" + direction;
      if (kes.has(quantity))
        throw kes.error(quantity, "either " + quantity + " for both directions or " + key);
    }
    const auto figure = tell(key, quantity);
    if (!figure || has_curve(table, c.si_key)) continue;
    const double si = in_si(quantity, *figure, load);
    const std::string told = fmt::format("{} {}", *figure, kes_unit(quantity).unit);
    if (!(si >= c.range.low && si <= c.range.high))
      throw kes.error(key, fmt::format("{}, that is {} = {:g}", told, c.si_key, si),
                      fmt::format("{} from {} to {}", c.range.what, c.range.low, c.range.high),
                      "figures of [kes] are in the units of the KES instruments");
    if (const auto given = table.optional_number(c.si_key, {})) {
      if (!same_within_rounding(*figure, si, *given))
        throw table.error(c.si_key, fmt::format("{}", *given),
                          fmt::format("{:.6g}, which is kes.{} = {}", si, key, told),
                          "leave out one of the two, or correct it");
      continue;
    }
    material.*c.value = si;
    set.insert(c.si_key);
  }
  for (const Told& t : kTold) {
    const std::string quantity = t.quantity;
    tell(quantity, quantity);
    if (!t.directed) continue;
    tell(quantity + "_warp", quantity);
    tell(quantity + "_weft", quantity);
  }
  kes.finish();
  return set;
}

}  // namespace loosefit
