#include "loosefit/io/material_kes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

constexpr double kOuterWearLoad = 500;  // [gf/cm]
// Loads of the tensile test [gf/cm]: 50 for knits, 500 for outer wear, with a margin.
constexpr double kLeastLoad = 10, kLargestLoad = 1000;

// How a KES figure becomes a constant of the material.
struct Constant {
  const char* quantity;
  const char* si_key;
  const char* direction;  // "", "warp", "weft"
  double fabric::Material::*value;
  NumberRange range;
};

const std::vector<Constant>& constants() {
  static const NumberRange kStiffness{1, 1e6, "N/m"}, kBending{1e-8, 1e-3, "N m"},
      kHysteresis{0, 0.1, "N"};
  static const std::vector<Constant> kTable = {
      {"W", "areal_density", "", &fabric::Material::areal_density, {0.01, 5, "kg/m²"}},
      {"T", "thickness", "", &fabric::Material::thickness, {5e-5, 0.005, "metres"}},
      {"EMT", "stiffness_warp", "warp", &fabric::Material::stiffness_warp, kStiffness},
      {"EMT", "stiffness_weft", "weft", &fabric::Material::stiffness_weft, kStiffness},
      {"G", "stiffness_shear", "", &fabric::Material::stiffness_shear, {0.1, 1e6, "N/m per rad"}},
      {"B", "bending_warp", "warp", &fabric::Material::bending_warp, kBending},
      {"B", "bending_weft", "weft", &fabric::Material::bending_weft, kBending},
      {"2HB", "bending_hysteresis_warp", "warp", &fabric::Material::bending_hysteresis_warp,
       kHysteresis},
      {"2HB", "bending_hysteresis_weft", "weft", &fabric::Material::bending_hysteresis_weft,
       kHysteresis},
  };
  return kTable;
}

// Only told, not used by the model; `directed` ones take _warp and _weft.
struct RecordedFigure {
  const char* quantity;
  bool directed;
};
const RecordedFigure kRecorded[] = {{"LT", true},    {"WT", true},   {"RT", true},   {"2HG", false},
                                    {"2HG5", false}, {"MIU", false}, {"MMD", false}, {"SMD", false},
                                    {"LC", false},   {"WC", false},  {"RC", false}};

bool is_number(const ConfigNode& node) {
  return node.kind == ConfigNode::Kind::integer || node.kind == ConfigNode::Kind::number;
}

bool has_curve(ConfigReader& table, const std::string& si_key) {
  if (si_key.rfind("stiffness_", 0) != 0) return false;
  const ConfigNode* curve = table.node("curve");
  return curve && curve->find(si_key.substr(10)) != nullptr;
}

double in_si(const std::string& quantity, double figure, double load) {
  if (quantity == "EMT") return fabric::tensile_secant(figure, load);
  const double si = fabric::kes_to_si(quantity, figure);
  return quantity == "2HB" ? si / 2 : si;
}

/// Three significant digits, towards the inside of the range.
double rounded_inwards(double value, bool up) {
  if (value == 0) return 0;
  const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
  const double steps = value / step;
  const double whole = std::abs(steps - std::round(steps)) < 1e-9 ? std::round(steps)
                       : up                                       ? std::ceil(steps)
                                                                  : std::floor(steps);
  return std::stod(fmt::format("{:.3g}", whole * step));
}

/// Figures that give a constant within its range, whatever else the table says.
NumberRange in_kes(const Constant& c) {
  const std::string quantity = c.quantity;
  double low = 0, high = 0;
  if (quantity == "EMT") {  // the stiffer, the less it gives; the load is a key of its own
    low = 100 * fabric::kes_to_si("F", kLargestLoad) / c.range.high;
    high = 100 * fabric::kes_to_si("F", kLeastLoad) / c.range.low;
  } else {
    const double unit = in_si(quantity, 1, kOuterWearLoad);
    low = c.range.low / unit, high = c.range.high / unit;
  }
  return {rounded_inwards(low, true), rounded_inwards(high, false),
          fabric::kes_unit(quantity).unit};
}

/// What a figure may be. One that the model does not use is only a number.
NumberRange range_of(const std::string& quantity) {
  for (const Constant& c : constants())
    if (c.quantity == quantity) return in_kes(c);
  const std::string& unit = fabric::kes_unit(quantity).unit;
  return {quantity[0] == '2' ? 0 : 1e-9, 1e6, unit == "-" ? "a figure" : unit};
}

/// The conversion of one figure in words.
std::string conversion(const std::string& key, const std::string& quantity, double figure,
                       double load) {
  const fabric::KesUnit& unit = fabric::kes_unit(quantity);
  std::string text = fmt::format("kes.{} = {} {}", key, shortest(figure), unit.unit);
  if (quantity == "EMT")
    return text + fmt::format(": {} gf/cm × {} / ({} / 100)", shortest(load),
                              shortest(fabric::kes_unit("F").factor), shortest(figure));
  text += fmt::format(" × {:.6g}", unit.factor);
  return quantity == "2HB" ? text + " / 2" : text;
}

std::vector<std::string> directed_quantities() {
  std::vector<std::string> names;
  for (const Constant& c : constants())
    if (*c.direction && (names.empty() || names.back() != c.quantity))
      names.emplace_back(c.quantity);
  for (const RecordedFigure& t : kRecorded)
    if (t.directed) names.emplace_back(t.quantity);
  return names;
}

std::optional<double> figure_of(ConfigReader& kes, const std::string& key,
                                const std::string& quantity) try {
  return kes.optional_number(key, range_of(quantity), fabric::kes_unit(quantity).meaning);
} catch (const InvalidInput& error) {  // most often figures in other units
  throw InvalidInput(error.place(), error.found(), error.expected(),
                     "figures of [kes] are in the units of the KES instruments");
}

/// A figure is one number, that of a direction has a key of its own.
void check_shapes(const ConfigReader& kes, const ConfigNode& table) {
  const std::vector<std::string> directed = directed_quantities();
  for (const auto& [key, node] : table.members) {
    const std::size_t end = std::min(key.find("_warp"), key.find("_weft"));
    const std::string quantity = key.substr(0, end);
    const bool known =
        std::any_of(fabric::kes_units().begin(), fabric::kes_units().end(),
                    [&](const fabric::KesUnit& unit) { return unit.quantity == quantity; });
    if (!known) continue;
    const bool takes = std::find(directed.begin(), directed.end(), quantity) != directed.end();
    if (end != std::string::npos && !takes)
      throw kes.error(key, "a key of its own", quantity + " alone, for both directions",
                      quantity + " has no warp and weft; give the mean of the two");
    if (node.kind == ConfigNode::Kind::integer || node.kind == ConfigNode::Kind::number) continue;
    throw kes.error(key, "one number in " + fabric::kes_unit(quantity).unit,
                    takes && end == std::string::npos
                        ? fmt::format("{0} stands for both directions; where they differ give "
                                      "{0}_warp and {0}_weft",
                                      quantity)
                        : std::string());
  }
}

}  // namespace

std::map<std::string, std::string> read_material_kes(ConfigReader& table,
                                                     fabric::Material& material,
                                                     std::vector<scenario::KesFigure>& figures) {
  std::map<std::string, std::string> set;
  const auto given = table.optional_table("kes", "figures in the units of the KES instruments");
  if (!given) return set;
  ConfigReader kes = *given;
  check_shapes(kes, *table.node("kes"));
  const double load =
      kes.number("EMT_load", kOuterWearLoad, {kLeastLoad, kLargestLoad, fabric::kes_unit("F").unit},
                 "load of EMT");
  // Records a figure for the card; a key that the card had already is replaced.
  const auto put = [&](const std::string& key, const std::string& quantity, double figure) {
    const auto same = std::find_if(figures.begin(), figures.end(),
                                   [&](const scenario::KesFigure& f) { return f.key == key; });
    if (same == figures.end())
      figures.push_back({key, fabric::kes_unit(quantity), figure});
    else
      same->value = figure;
  };
  if (kes.has("EMT_load")) put("EMT_load", "F", load);
  // Reads a figure and records it; empty when the key is absent.
  const auto record = [&](const std::string& key, const std::string& quantity) {
    const auto figure = figure_of(kes, key, quantity);
    if (figure) put(key, quantity, *figure);
    return figure;
  };

  // Figures from which a constant of the material follows.
  for (const Constant& c : constants()) {
    const std::string quantity = c.quantity, direction = c.direction;
    // One key for both directions, or one for each, never both.
    std::string key = quantity;
    if (kes.recording() && !direction.empty()) record(quantity + "_" + direction, quantity);
    if (!direction.empty() && kes.has(quantity + "_" + direction)) {
      key += "_" + direction;
      if (kes.has(quantity))
        throw kes.error(quantity, "either " + quantity + " for both directions or " + key);
    }
    // A measured curve says more than a single figure.
    const auto figure = record(key, quantity);
    if (!figure || has_curve(table, c.si_key)) continue;
    set[c.si_key] = conversion(key, quantity, *figure, load);
    const double si = in_si(quantity, *figure, load);
    const std::string measured = fmt::format("{} {}", *figure, fabric::kes_unit(quantity).unit);
    // The card may state the SI value too; then both must agree.
    if (const ConfigNode* node = table.node(c.si_key); node && is_number(*node)) {
      const double stated = node->number;
      if (!fabric::same_within_rounding(*figure, si, stated))
        throw table.error(c.si_key, fmt::format("{}", stated),
                          fmt::format("{:.6g}, which is kes.{} = {}", si, key, measured),
                          "leave out one of the two, or correct it");
      if (stated != si) set.erase(c.si_key);
      continue;
    }
    material.*c.value = si;
  }
  // Figures that are recorded but not used.
  for (const RecordedFigure& t : kRecorded) {
    const std::string quantity = t.quantity;
    record(quantity, quantity);
    if (!t.directed) continue;
    record(quantity + "_warp", quantity);
    record(quantity + "_weft", quantity);
  }
  kes.finish();
  return set;
}

}  // namespace loosefit::io
