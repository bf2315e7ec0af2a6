#include "loosefit/io/material_origin.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

/// What makes one cloth another; friction, damping and Poisson's ratio are seldom measured.
const char* const kMechanical[] = {"areal_density",  "thickness",       "stiffness_warp",
                                   "stiffness_weft", "stiffness_shear", "bending_warp",
                                   "bending_weft"};

const std::vector<fabric::CurvePoint>* curve_of(const fabric::Material& m,
                                                double fabric::Material::*value) {
  return value == &fabric::Material::stiffness_warp    ? &m.curve_warp
         : value == &fabric::Material::stiffness_weft  ? &m.curve_weft
         : value == &fabric::Material::stiffness_shear ? &m.curve_shear
                                                       : nullptr;
}

bool same(const fabric::Material& a, const fabric::Material& b, double fabric::Material::*value) {
  const std::vector<fabric::CurvePoint>*p = curve_of(a, value), *q = curve_of(b, value);
  if (p && q &&
      !std::equal(p->begin(), p->end(), q->begin(), q->end(),
                  [](const fabric::CurvePoint& x, const fabric::CurvePoint& y) {
                    return x.strain == y.strain && x.force == y.force;
                  }))
    return false;
  return a.*value == b.*value;
}

std::string card_name(const scenario::MaterialCard& card) {
  return std::filesystem::path(card.key).stem().string();
}

std::vector<std::string> in_order(const scenario::MaterialCard& card, bool own) {
  std::vector<std::string> keys;
  for (const std::string& key : material_keys())
    if (card.own.keys.count(key) == (own ? 1u : 0u)) keys.push_back(key);
  return keys;
}

void name_after_constants(scenario::MaterialCard& card) {
  fabric::Material& m = card.material;
  const scenario::OwnConstants& own = card.own;
  const bool all = std::all_of(std::begin(kMechanical), std::end(kMechanical),
                               [&](const char* key) { return own.keys.count(key) > 0; });
  const std::string of_scenario = own.source.empty() ? "constants of the scenario" : own.source;
  if (!own.keys.empty()) {
    std::vector<std::string> inherited = in_order(card, false);
    std::erase_if(inherited, [&](const std::string& key) { return !card.stated.count(key); });
    const std::string changed = join(in_order(card, true)), rest = join(inherited);
    if (all) {
      m.name = "own constants";
      m.source = of_scenario;
      if (!rest.empty()) m.source += "; inherited from card " + card_name(card) + ": " + rest;
    } else {
      m.name = card_name(card) + ", changed: " + changed;
      m.source =
          changed + ": " + of_scenario + "; the others: card " + card_name(card) + ", " + m.source;
    }
  }
  if (own.keys.empty() && !own.source.empty())
    m.source = own.source + "; all constants: card " + card_name(card) + ", " + m.source;
  if (!own.title.empty()) m.name = own.title;
}

}  // namespace

void read_own_constants(ConfigReader& table, scenario::MaterialCard& card) {
  const scenario::MaterialCard plain = card;
  card.kes.clear();
  const std::set<std::string> set = read_material_constants(table, card);
  scenario::OwnConstants& own = card.own;
  own.kes = card.kes;
  for (const scenario::KesFigure& f : plain.kes)
    if (std::none_of(own.kes.begin(), own.kes.end(),
                     [&](const scenario::KesFigure& o) { return o.key == f.key; }))
      card.kes.push_back(f);
  own.title = table.text("title", "", "what to call cloth of own constants");
  own.source = table.text("source", "", "where own constants come from");
  // A resolved scenario writes out what it took from the card as well; those of earlier versions
  // did so without `given`, and knew neither title nor source.
  std::vector<std::string> known = material_keys();
  known.emplace_back(kRetiredConstant);
  const std::vector<std::string> given = table.choices(
      "given", {}, known, "of a resolved scenario: the constants that the scenario itself gave");
  const bool has_all = std::ranges::all_of(material_constants(), [&](const MaterialConstant& c) {
    return set.count(c.key) || may_be_unstated(c);  // later than the others
  });
  const bool resolved = table.has("given") || (has_all && own.title.empty() && own.source.empty());
  for (const MaterialConstant& c : material_constants()) {
    if (!set.count(c.key)) continue;
    const bool named = std::find(given.begin(), given.end(), c.key) != given.end();
    if (!resolved || named || !same(card.material, plain.material, c.value))
      own.keys.insert(c.key);
    else if (const auto how = plain.how.find(c.key); how != plain.how.end())
      card.how[c.key] = how->second;
  }
  name_after_constants(card);
}

std::string own_constants_toml(const scenario::MaterialCard& card) {
  const scenario::OwnConstants& own = card.own;
  std::string text;
  if (!own.title.empty()) text += "title = " + toml_quoted(own.title) + "\n";
  if (!own.source.empty()) text += "source = " + toml_quoted(own.source) + "\n";
  std::vector<std::string> keys;
  for (const std::string& key : in_order(card, true)) keys.push_back(toml_quoted(key));
  if (!text.empty() || !keys.empty()) text += "given = [" + join(keys) + "]\n";
  for (const scenario::KesFigure& f : own.kes)
    text += fmt::format("kes.{} = {}\n", f.key, shortest(f.value));
  return text;
}

std::vector<ConstantInUse> constants_in_use(const scenario::MaterialCard& card) {
  std::vector<ConstantInUse> all;
  for (const MaterialConstant& c : material_constants()) {
    const std::string of_card =
        card.stated.count(c.key)
            ? (card.own.keys.empty() ? "card " : "inherited from card ") + card_name(card)
            : "default";
    const std::string unit = unit_of(c.range);
    ConstantInUse use{c.key, card.material.*c.value, unit.empty() ? "-" : unit,
                      card.own.keys.count(c.key) ? "scenario" : of_card};
    if (const auto how = card.how.find(c.key); how != card.how.end() && !how->second.empty())
      use.from += ": " + how->second;
    all.push_back(std::move(use));
  }
  return all;
}

}  // namespace loosefit::io
