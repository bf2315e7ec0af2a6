#include "loosefit/pipeline/case_ease.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "loosefit/base/text.h"
#include "loosefit/fabric/stress_curve.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/pipeline/ease_on_mesh.h"

namespace loosefit::pipeline {
namespace {

/// Share of the cloth beyond a range from which on it is said [–]: a triangle or two at a corner
/// say nothing of the garment.
constexpr double kToldShare = 0.001;
constexpr double kUnjudgedStrain = 0.15;  ///< from which on a range that is not stated is missed

/// Skin pressed beyond comfort from which on it is said [m²]: less is a fold in the armpit.
constexpr double kToldPressedArea = 10e-4;

/// Miss of an ease below kLooseEase from which on it is said [–]: less is what bodies are taped to.
constexpr double kToldShortfall = 0.02;

/// Whether a station is not cut as it was asked for. What was asked to be loose may be looser, as
/// pieces are that are cut straight; what was asked to lie close may not.
bool is_missed(const StationEase& s) {
  if (!s.asked) return false;
  if (*s.asked >= kLooseEase) return s.cut < kCutShare * *s.asked;
  return std::abs(s.cut - *s.asked) > kToldShortfall;
}

/// Along trunk, arm and leg the tightest station of each place, by name.
std::map<std::string, const StationFit*> tightest_stations(const CasePattern& pattern) {
  std::map<std::string, const StationFit*> tightest;
  for (const StationFit& s : pattern.fit_along) {
    const std::string piece = s.limb == "arm" ? "sleeve" : s.limb;
    const auto [entry, first] = tightest.insert({piece + " at the " + s.place, &s});
    if (!first && s.cut() < entry->second->cut()) entry->second = &s;
  }
  return tightest;
}

/// The key of the kind that a level is asked for with; nothing where there is none, as of a
/// waistband, or where a file or a size asks for all.
const kinds::KindKey* key_of(const std::string& level, const scenario::GarmentSpec& spec) {
  if (!spec.file.empty() || !spec.size.empty()) return nullptr;
  for (const kinds::KindKey& key : kinds::garment_kind(spec.kind).keys)
    if (key.mobility && key.name == level) return &key;
  return nullptr;
}

/// A level of the draft. What it makes tight by itself, as a waistband, is meant to press; what may
/// be asked for and was not is what came out.
StationEase level_ease(const kinds::FitLevel& level, double cut,
                       const scenario::GarmentSpec& spec) {
  const bool drafted = spec.file.empty() && spec.size.empty();
  StationEase station{.name = level.name, .cut = cut, .body = level.body.value_or(0)};
  if (const kinds::KindKey* key = key_of(level.name, spec)) {
    const auto wished = spec.fit.find(level.name);
    station.asked = wished == spec.fit.end() ? key->usual : wished->second;
  } else {
    station.drawn_in = drafted && cut < 0;
  }
  return station;
}

/// Pull of the cloth along its weft at an elongation, per metre of reference width [N/m].
double weft_pull(const fabric::Material& material, double elongation) {
  if (material.curve_weft.empty()) return material.stiffness_weft * elongation;
  return fabric::MonotoneCubic(material.curve_weft).at(elongation).value;
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

/// "trunk 40 %, upper_arm_L 30 %": the limbs that bear most of the free force.
std::string bearers(const maps::BodyLoad& load) {
  constexpr double kWorthTelling = 0.1;
  std::vector<std::string> told;
  for (const std::string& limb : maps::limb_names())
    if (const double share = load.free_of_limb.at(limb) / load.free_force(); share > kWorthTelling)
      told.push_back(limb + " " + percent(share));
  return join(told);
}

/// Whether nobody asked for any ease, as of a fixed size or a pattern file, and nothing is drawn in
/// by a draft.
bool is_nothing_asked(const std::vector<StationEase>& stations) {
  return std::ranges::none_of(stations, [](const StationEase& s) { return s.asked || s.drawn_in; });
}

/// "; trunk at the hip is cut 8.0 % narrower than the body, where paper-cotton closes with 1.2
/// kPa": of the stations that nobody asked for the one that presses most; nothing where none is
/// narrower.
std::string narrowest(const std::vector<StationEase>& stations, const fabric::Material& material) {
  const StationEase* most = nullptr;
  double pressure = 0;
  for (const StationEase& s : stations)
    if (const double p = pressure_when_closed(s, material); !s.asked && !s.drawn_in && p > pressure)
      most = &s, pressure = p;
  if (!most) return {};
  return fmt::format("; {} is cut {:.1f} % narrower than the body, where {} closes with {:.2g} kPa",
                     printable(most->name), -100 * most->cut, printable(material.name),
                     1e-3 * pressure);
}

}  // namespace

std::vector<StationEase> station_eases(const CasePattern& pattern,
                                       const scenario::GarmentSpec& spec) {
  std::vector<StationEase> stations;
  for (const kinds::FitLevel& level : pattern.levels)
    if (const auto cut = pattern.fit.find(level.name); cut != pattern.fit.end())
      stations.push_back(level_ease(level, cut->second, spec));
  for (const auto& [name, s] : tightest_stations(pattern))
    stations.push_back({.name = name, .cut = s->cut(), .asked = s->asked, .body = s->body});
  return stations;
}

std::vector<StationEase> station_eases(const CaseGarment& garment,
                                       const scenario::GarmentSpec& spec) {
  std::vector<StationEase> stations = station_eases(garment.pattern, spec);
  const auto tightest = tightest_stations(garment.pattern);
  if (garment.hierarchy.levels.empty() ||
      static_cast<int>(garment.drape.positions.size()) != garment.mesh().vertex_count)
    return stations;
  for (StationEase& ease : stations)
    if (const auto found = tightest.find(ease.name); found != tightest.end())
      if (const double girth = worn_girth(garment.mesh(), garment.drape.positions, *found->second);
          girth > 0)
        ease.worn = girth / ease.body - 1;
  return stations;
}

std::optional<StationEase> least_cut_ease(const std::vector<StationEase>& stations) {
  const auto least = std::ranges::min_element(stations, {}, &StationEase::cut);
  return least == stations.end() ? std::nullopt : std::optional(*least);
}

bool is_asked_loose(const std::vector<StationEase>& stations) {
  bool any = false;
  for (const StationEase& s : stations) {
    if (s.drawn_in) return false;
    if (!s.asked) continue;
    if (*s.asked < kLooseEase) return false;
    any = true;
  }
  return any;
}

double pressure_when_closed(const StationEase& station, const fabric::Material& material) {
  if (!(station.cut < 0) || !(station.body > 0)) return 0;
  const double elongation = 1 / (1 + station.cut) - 1;
  return weft_pull(material, elongation) * 2 * std::numbers::pi / station.body;
}

std::vector<std::string> ease_warnings(const std::vector<StationEase>& stations,
                                       const std::optional<maps::BodyLoad>& load,
                                       const fabric::Material& material) {
  std::vector<std::string> lines;
  for (const StationEase& s : stations)
    if (is_missed(s))
      lines.push_back(printable(s.name) + ": " + percent(s.cut) + " of ease where " +
                      percent(*s.asked) + " was asked");
  if (!load || !(load->weight > 0)) return lines;
  const double weights = load->free_force() / load->weight;
  const std::string presses = fmt::format(
      "presses with {:.0f} times its weight, without what is squeezed between arms and "
      "trunk: {}{}",
      weights, bearers(*load), narrowest(stations, material));
  if (is_asked_loose(stations) && weights > kLooseWeights)
    lines.push_back("the garment was asked to be loose, but " + presses);
  if (is_nothing_asked(stations) && weights > kHeldWeights)
    lines.push_back("the garment " + presses +
                    "; one that hangs presses with a few weights: it is too small, caught, or "
                    "meant to be tight");
  return lines;
}

std::vector<std::string> comfort_warnings(const maps::PressureField& field,
                                          const std::vector<body::Region>& regions) {
  const double limit = *std::rbegin(maps::kPressureClasses);
  double area = 0, largest = 0;
  std::map<body::Region, double> force;
  for (std::size_t i = 0; i < field.contact.size(); ++i) {
    if (field.contact[i] < limit) continue;
    area += field.area[i];
    largest = std::max(largest, field.contact[i]);
    force[regions[i]] += field.contact[i] * field.area[i];
  }
  if (area < kToldPressedArea) return {};
  const auto most = std::ranges::max_element(
      force, {}, [](const std::pair<const body::Region, double>& entry) { return entry.second; });
  return {
      fmt::format("presses beyond comfort (over {:g} kPa, up to {:.3g} kPa) on {:.0f} cm² of the "
                  "wearer, most of "
                  "it at {} with {:.3g} N: too tight there, or caught",
                  1e-3 * limit, 1e-3 * largest, 1e4 * area, body::name(most->first), most->second)};
}

std::vector<std::string> beyond_range_warnings(const maps::StrainRange& range,
                                               const scenario::MaterialCard& card) {
  std::vector<std::string> beyond;
  const auto look = [&](const char* name, const maps::DirectionRange& d, double unit,
                        const char* sign) {
    if (d.share_beyond > kToldShare)
      beyond.push_back(
          fmt::format("{} on {:.2g} % of the cloth, up to {:.3g}{} where {:.3g}{} are "
                      "stated",
                      name, 100 * d.share_beyond, unit * d.largest, sign, unit * d.limit, sign));
  };
  look("warp", range.warp, 100, " %");
  look("weft", range.weft, 100, " %");
  look("shear", range.shear, degrees(1.0), "°");
  if (beyond.empty()) return {};
  return {"strained beyond the range in which the constants of " + printable(card.material.name) +
          " hold: " + join(beyond)};
}

double largest_unstated(const maps::StrainRange& range) {
  double largest = 0;
  for (const maps::DirectionRange* d : {&range.warp, &range.weft})
    if (!d->is_stated()) largest = std::max(largest, d->largest);
  return largest;
}

std::vector<std::string> unstated_strain_warnings(const maps::StrainRange& range) {
  std::vector<std::string> lines;
  for (const auto& [name, d] : {std::pair{"warp", &range.warp}, {"weft", &range.weft}})
    if (!d->is_stated() && d->largest > kUnjudgedStrain)
      lines.push_back(fmt::format(
          "strained along the {0} by up to {1:.0f} %, and no range is stated for it "
          "(valid_strain_{0}): whether the constants hold there, or it would tear, is not judged",
          name, 100 * d->largest));
  return lines;
}

std::vector<std::string> strain_range_warnings(const maps::StrainRange& range,
                                               const scenario::MaterialCard& card) {
  std::vector<std::string> lines = unstated_strain_warnings(range);
  for (std::string& line : beyond_range_warnings(range, card)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace loosefit::pipeline
