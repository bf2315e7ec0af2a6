#include "loosefit/io/material_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "loosefit/base/paths.h"
#include "loosefit/base/text.h"
#include "loosefit/io/material_curves.h"
#include "loosefit/io/material_kes.h"
#include "loosefit/io/toml_file.h"

namespace loosefit::io {
namespace {

void refuse_bending_in_other_units(ConfigReader& table) {
  for (const char* key : {"bending_warp", "bending_weft"}) {
    const ConfigNode* node = table.node(key);
    const bool is_number =
        node && (node->kind == ConfigNode::Kind::integer || node->kind == ConfigNode::Kind::number);
    if (!is_number) continue;
    const double any = node->number;
    if (any > 1e-3)
      throw table.error(key, "N m from 1e-08 to 0.001",
                        fmt::format("bending rigidity of a sheet is in N m: {:g} µN m is {:g}, "
                                    "{:g} gf cm²/cm is {:g}",
                                    any, any * 1e-6, any, any * 9.80665e-5));
  }
}

// A stiffness in the table, in whatever form, replaces the curve the card had before.
void drop_replaced_curves(const std::set<std::string>& set, scenario::MaterialCard& card) {
  fabric::Material& m = card.material;
  const std::pair<const char*, std::vector<fabric::CurvePoint>*> curves[] = {
      {"stiffness_warp", &m.curve_warp},
      {"stiffness_weft", &m.curve_weft},
      {"stiffness_shear", &m.curve_shear}};
  for (const auto& [key, curve] : curves)
    if (set.count(key) && !curve->empty()) {
      curve->clear();
      card.notes.push_back(std::string(key) + " replaces the measured curve of the card");
    }
}

void read_isotropic_pair(ConfigReader& table, scenario::MaterialCard& card,
                         std::set<std::string>& set) {
  const auto modulus = table.optional_number("youngs_modulus", {1e3, 1e12, "Pa"},
                                             "isotropic preset, with elastic_thickness");
  const auto h = table.optional_number("elastic_thickness", {1e-6, 0.01, "metres"},
                                       "isotropic preset, with youngs_modulus");
  const bool no_thickness = table.lacks("youngs_modulus", "elastic_thickness");
  const bool no_modulus = table.lacks("elastic_thickness", "youngs_modulus");
  for (const char* key : {"stiffness_warp", "stiffness_weft"}) table.clash("youngs_modulus", key);
  if (!modulus && !h) return;
  const std::string why =
      "youngs_modulus and elastic_thickness only have a meaning together: the "
      "sheet stiffness is E h";
  if (no_thickness) throw table.error("elastic_thickness", "metres from 1e-06 to 0.01", why);
  if (no_modulus) throw table.error("youngs_modulus", "Pa from 1000 to 1e+12", why);
  for (const char* key : {"stiffness_warp", "stiffness_weft"})
    if (set.count(key)) throw table.error(key, "either youngs_modulus or " + std::string(key), why);
  fabric::Material& m = card.material;
  const double sheet = *modulus * *h;
  if (sheet < 1 || sheet > 1e6)
    throw table.error("youngs_modulus", fmt::format("E h = {:g} N/m", sheet),
                      "E h from 1 to 1e6 N/m", "check the units: Pa and metres");
  m.stiffness_warp = m.stiffness_weft = sheet;
  card.how["stiffness_warp"] = card.how["stiffness_weft"] = "youngs_modulus × elastic_thickness";
  if (!set.count("stiffness_shear"))
    card.how["stiffness_shear"] = "youngs_modulus × elastic_thickness / (2 (1 + poisson))";
  if (!set.count("stiffness_shear")) m.stiffness_shear = sheet / (2 * (1 + m.poisson));
  set.insert({"stiffness_warp", "stiffness_weft", "stiffness_shear"});
  const double plate = sheet * *h * *h / (12 * (1 - m.poisson * m.poisson));
  card.notes.push_back(fmt::format(
      "E = {:g} Pa with h = {:g} m is E h = {:g} N/m; a homogeneous sheet would bend with "
      "E h³/(12 (1 − ν²)) = {:.3g} N m, the card says {:.3g} N m ({:.3g} times)",
      *modulus, *h, sheet, plate, m.bending_warp, m.bending_warp / plate));
}

/// What a cantilever tells (ISO 9073-7, ASTM D1388): B = w g c³.
void read_bending_lengths(ConfigReader& table, scenario::MaterialCard& card,
                          std::set<std::string>& set) {
  fabric::Material& m = card.material;
  for (const auto& [key, constant, value] :
       {std::tuple{"bending_length_warp", "bending_warp", &fabric::Material::bending_warp},
        std::tuple{"bending_length_weft", "bending_weft", &fabric::Material::bending_weft}}) {
    const auto c = table.optional_number(key, {0.004, 0.06, "metres"},
                                         "half the overhang of a cantilever at 41.5 degrees");
    table.clash(key, constant);
    if (!c) continue;
    if (set.count(constant))
      throw table.error(key, "either " + std::string(key) + " or " + constant,
                        "both are the bending rigidity of one direction");
    m.*value = m.areal_density * kGravity * *c * *c * *c;
    if (m.*value < 1e-8 || m.*value > 1e-3)
      throw table.error(key, fmt::format("w g c³ = {:.3g} N m", m.*value),
                        "w g c³ from 1e-8 to 1e-3 N m",
                        "check the units: the bending length c in metres, the weight w in kg/m²");
    card.how[constant] =
        fmt::format("{} = {} m: {} kg/m² × {} m/s² × ({} m)³", key, shortest(*c),
                    shortest(m.areal_density), shortest(kGravity), shortest(*c));
    set.insert(constant);
  }
}

bool same_curve(const std::vector<fabric::CurvePoint>& a,
                const std::vector<fabric::CurvePoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const fabric::CurvePoint& p, const fabric::CurvePoint& q) {
                      return p.strain == q.strain && p.force == q.force;
                    });
}

/// A curve is valid up to its last point, and the secant to EMT up to EMT, unless the table says
/// otherwise; another law in place of that of `before` without a range of its own has none, nor the
/// stretch of `before`. Adds to `set` what was found.
void find_valid_strains(const fabric::Material& before, scenario::MaterialCard& card,
                        std::set<std::string>& set) {
  fabric::Material& m = card.material;
  struct Direction {
    const char* stiffness;
    const char* key;
    double fabric::Material::*value;
    const char* stretch_key;
    double fabric::Material::*stretch;
    double fabric::Material::*law;
    std::vector<fabric::CurvePoint> fabric::Material::*curve;
    const char* emt;
    bool shear;
  };
  using M = fabric::Material;
  const Direction directions[] = {
      {"stiffness_warp", "valid_strain_warp", &M::valid_strain_warp, "stretch_warp",
       &M::stretch_warp, &M::stiffness_warp, &M::curve_warp, "EMT_warp", false},
      {"stiffness_weft", "valid_strain_weft", &M::valid_strain_weft, "stretch_weft",
       &M::stretch_weft, &M::stiffness_weft, &M::curve_weft, "EMT_weft", false},
      {"stiffness_shear", "valid_shear", &M::valid_shear, "", nullptr, &M::stiffness_shear,
       &M::curve_shear, "", true}};
  for (const Direction& d : directions) {
    const auto& curve = m.*d.curve;
    const bool same = m.*d.law == before.*d.law && same_curve(curve, before.*d.curve);
    if (d.stretch && !same && !set.count(d.stretch_key)) {
      m.*d.stretch = 0;
      card.stated.erase(d.stretch_key);
    }
    // What the law itself says of its range.
    double found = 0;
    std::string how;
    if (!curve.empty()) {
      const double last = curve.back().strain;
      found = d.shear ? std::asin(std::min(last, 1.0)) : last;
      how = "last point of the curve";
    } else if (const auto of = card.how.find(d.stiffness);
               of != card.how.end() && of->second.find("kes.EMT") != std::string::npos) {
      for (const scenario::KesFigure& f : card.kes)
        if (f.key == "EMT" || f.key == d.emt) found = f.value / 100;
      how = "the elongation of kes.EMT";
    }
    if (set.count(d.key)) {  // the table has a range
      if (found > 0 && m.*d.value == found) card.how[d.key] = how;
      continue;
    }
    if (!set.count(d.stiffness) || (same && before.*d.value > 0)) continue;
    m.*d.value = found;
    card.how.erase(d.key);
    card.stated.erase(d.key);
    if (!(found > 0)) continue;
    card.how[d.key] = how;
    set.insert(d.key);
  }
}

// All that a card lacks, at once.
void refuse_gaps(const ConfigReader& table, const scenario::MaterialCard& card) {
  std::vector<std::string> lacking, wanted;
  const auto lack = [&](const std::string& key, const std::string& what) {
    lacking.push_back(key);
    wanted.push_back(what);
  };
  if (card.material.source.empty()) lack("source", "where the numbers come from");
  for (const MaterialConstant& c : material_constants())
    if (c.required && !card.stated.count(c.key))
      lack(c.key, fmt::format("{} from {} to {}", c.range.what, c.range.low, c.range.high));
  if (lacking.empty()) return;
  const std::string hint = "a card states every constant";
  if (lacking.size() == 1) throw table.error(lacking[0], wanted[0], hint);
  std::vector<std::string> list;
  for (std::size_t i = 0; i < lacking.size(); ++i)
    list.push_back(lacking[i] + " (" + wanted[i] + ")");
  throw InvalidInput({table.file(), 0, join(lacking)}, "nothing", "all of them",
                     hint + ": " + join(list));
}

}  // namespace

// The one table from which reading, writing and documentation follow.
const std::vector<MaterialConstant>& material_constants() {
  static const std::vector<MaterialConstant> kTable = {
      {"areal_density",
       &fabric::Material::areal_density,
       {0.01, 5, "kg/m²"},
       true,
       "mass per area"},
      {"thickness",
       &fabric::Material::thickness,
       {5e-5, 0.005, "metres"},
       true,
       "half of it is the contact offset"},
      {"stiffness_warp",
       &fabric::Material::stiffness_warp,
       {1, 1e6, "N/m"},
       true,
       "membrane stiffness along the grain"},
      {"stiffness_weft",
       &fabric::Material::stiffness_weft,
       {1, 1e6, "N/m"},
       true,
       "membrane stiffness across the grain"},
      {"poisson",
       &fabric::Material::poisson,
       {-0.9, 0.9, "a number"},
       true,
       "Poisson's ratio of the membrane"},
      {"stiffness_shear",
       &fabric::Material::stiffness_shear,
       {0.1, 1e6, "N/m per rad"},
       true,
       "shear stiffness"},
      {"bending_warp",
       &fabric::Material::bending_warp,
       {1e-8, 1e-3, "N m"},
       true,
       "sheet rigidity along the grain"},
      {"bending_weft",
       &fabric::Material::bending_weft,
       {1e-8, 1e-3, "N m"},
       true,
       "sheet rigidity across the grain"},
      {"bending_poisson",
       &fabric::Material::bending_poisson,
       {-0.9, 0.9, "a number"},
       false,
       "Poisson's ratio of bending"},
      {"bending_hysteresis_warp",
       &fabric::Material::bending_hysteresis_warp,
       {0, 0.1, "N"},
       false,
       "HB: half of the loop width 2HB along the grain"},
      {"bending_hysteresis_weft",
       &fabric::Material::bending_hysteresis_weft,
       {0, 0.1, "N"},
       false,
       "HB: half of the loop width 2HB across the grain"},
      {"friction_body",
       &fabric::Material::friction_body,
       {0, 3, "a coefficient"},
       true,
       "Coulomb coefficient on skin"},
      {"friction_self",
       &fabric::Material::friction_self,
       {0, 3, "a coefficient"},
       true,
       "Coulomb coefficient on itself"},
      {"damping",
       &fabric::Material::damping,
       {0, 10, "seconds"},
       true,
       "of the two integrators with a time axis"},
      {"valid_strain_warp",
       &fabric::Material::valid_strain_warp,
       {1e-4, 10, "a number"},
       false,
       "largest elongation along the grain for which the constants hold"},
      {"valid_strain_weft",
       &fabric::Material::valid_strain_weft,
       {1e-4, 10, "a number"},
       false,
       "largest elongation across the grain for which the constants hold"},
      {"valid_shear",
       &fabric::Material::valid_shear,
       {1e-4, 1.5, "rad"},
       false,
       "largest trellis shear angle for which the constants hold"},
      {"stretch_warp",
       &fabric::Material::stretch_warp,
       {1e-4, 10, "a number"},
       false,
       "elongation along the grain to which a hand pulls it without harm, of a knit"},
      {"stretch_weft",
       &fabric::Material::stretch_weft,
       {1e-4, 10, "a number"},
       false,
       "the same across the grain"},
  };
  return kTable;
}

bool may_be_unstated(const MaterialConstant& constant) {
  const std::string key = constant.key;
  return key.starts_with("valid_") || key.starts_with("stretch_");
}

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(data_directory() / "materials", error))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

scenario::MaterialCard load_material(const std::string& name) {
  const std::vector<std::string> names = material_names();
  if (names.empty())
    throw IoError((data_directory() / "materials").string() + ": found no material cards",
                  looked_in() + "; set LOOSEFIT_DATA to the folder that holds materials/");
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InvalidInput({"", 0, "material"}, "\"" + printable(name) + "\"",
                       "the name of a material card", did_you_mean(name, names));
  scenario::MaterialCard card =
      read_material_file(data_directory() / "materials" / (name + ".toml"));
  card.key = name;
  return card;
}

scenario::MaterialCard read_material_file(const std::filesystem::path& path) {
  const ConfigNode root = read_toml(path.string());
  ConfigReader table(root, path.string());
  scenario::MaterialCard card;
  card.key = std::filesystem::weakly_canonical(path).string();
  card.material.name = path.stem().string();
  card.title = table.text("title", card.material.name);
  card.status = table.text("status", "not stated");
  card.material.source = table.text("source", "");
  card.valid_strain_source = table.text("valid_strain_source", "");
  card.stated = read_material_constants(table, card);
  table.finish();
  refuse_gaps(table, card);
  return card;
}

std::set<std::string> read_material_constants(ConfigReader& table, scenario::MaterialCard& card) {
  refuse_bending_in_other_units(table);
  fabric::Material& m = card.material;
  const fabric::Material before = m;
  const std::map<std::string, std::string> converted = read_material_kes(table, m, card.kes);
  std::set<std::string> set;
  for (const auto& entry : converted) set.insert(entry.first);
  for (const MaterialConstant& c : material_constants()) {
    const auto value = table.optional_number(c.key, c.range, c.about);
    if (!value) continue;
    m.*c.value = *value;
    set.insert(c.key);
  }
  // Scenarios and results of earlier versions have it.
  if (const auto value = table.optional_number(kRetiredConstant, {1e-3, 1, "a fraction"},
                                               "of earlier files, without effect");
      value && *value < 1)
    card.notes.push_back(std::string(kRetiredConstant) +
                         " has no effect: compressed cloth buckles");
  for (const std::string& key : set) {
    const auto conversion = converted.find(key);
    card.how[key] = conversion == converted.end() ? "" : conversion->second;
  }
  read_bending_lengths(table, card, set);
  read_isotropic_pair(table, card, set);
  drop_replaced_curves(set, card);
  for (const char* direction : read_material_curves(table, m)) {
    set.insert(std::string("stiffness_") + direction);
    card.how[std::string("stiffness_") + direction] =
        std::string("initial slope of curve.") + direction;
  }
  find_valid_strains(before, card, set);
  return set;
}

std::vector<std::string> material_keys() {
  std::vector<std::string> keys;
  for (const MaterialConstant& c : material_constants()) keys.emplace_back(c.key);
  return keys;
}

std::string material_toml(const fabric::Material& material) {
  std::string text;
  const auto has_curve = [&](double fabric::Material::*value) {
    return (value == &fabric::Material::stiffness_warp && !material.curve_warp.empty()) ||
           (value == &fabric::Material::stiffness_weft && !material.curve_weft.empty()) ||
           (value == &fabric::Material::stiffness_shear && !material.curve_shear.empty());
  };
  const auto is_unstated = [&](const MaterialConstant& c) {
    return may_be_unstated(c) && material.*c.value == 0;
  };
  for (const MaterialConstant& c : material_constants())
    if (!has_curve(c.value) && !is_unstated(c))
      text += fmt::format("{} = {}\n", c.key, shortest(material.*c.value));
  return text + material_curves_toml(material);
}

double bending_length(const fabric::Material& material) {
  return bending_length(material, std::sqrt(material.bending_warp * material.bending_weft));
}

double bending_length(const fabric::Material& material, double bending) {
  return std::cbrt(bending / (material.areal_density * kGravity));
}

}  // namespace loosefit::io
