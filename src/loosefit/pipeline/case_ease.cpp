#include "loosefit/pipeline/case_ease.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "loosefit/base/text.h"
#include "loosefit/kinds/registry.h"

namespace loosefit::pipeline {
namespace {

/// Share of the cloth beyond a range from which on it is said [–]: a triangle or two at a corner
/// say nothing of the garment.
constexpr double kToldShare = 0.001;
constexpr double kUnjudgedStrain = 0.15;  ///< from which on a range that is not stated is missed

/// Skin pressed beyond comfort from which on it is said [m²]: less is a fold in the armpit.
constexpr double kToldPressedArea = 10e-4;

/// Ease missing where hardly any was asked for, 0 to kLooseEase, from which on it is said [–]: a
/// share of so little is less than what bodies are taped to.
constexpr double kToldShortfall = 0.02;

/// Whether a station is cut tighter than it was asked for. What was asked to be tight presses
/// anyway, and is not judged.
bool is_short_of_asked(const StationEase& s) {
  if (!s.asked || *s.asked < 0) return false;
  return s.cut < (*s.asked >= kLooseEase ? kCutShare * *s.asked : *s.asked - kToldShortfall);
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
StationEase level_ease(const std::string& level, double cut, const scenario::GarmentSpec& spec) {
  const bool drafted = spec.file.empty() && spec.size.empty();
  const kinds::KindKey* key = key_of(level, spec);
  if (!key) return {level, cut, std::nullopt, drafted && cut < 0};
  const auto wished = spec.fit.find(level);
  return {level, cut, wished == spec.fit.end() ? key->usual : wished->second};
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

}  // namespace

std::vector<StationEase> station_eases(const CasePattern& pattern,
                                       const scenario::GarmentSpec& spec) {
  std::vector<StationEase> stations;
  for (const kinds::FitLevel& level : pattern.levels)
    if (const auto cut = pattern.fit.find(level.name); cut != pattern.fit.end())
      stations.push_back(level_ease(level.name, cut->second, spec));
  // Along trunk and arm, the tightest of each place.
  std::map<std::string, StationEase> tightest;
  for (const StationFit& s : pattern.fit_along) {
    const std::string name =
        s.limb == "arm" ? "sleeve at the " + s.place : "trunk at the " + s.place;
    const auto [entry, first] = tightest.insert({name, {name, s.cut(), s.asked}});
    if (!first && s.cut() < entry->second.cut) entry->second = {name, s.cut(), s.asked};
  }
  for (auto& entry : tightest) stations.push_back(std::move(entry.second));
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

std::vector<std::string> ease_warnings(const std::vector<StationEase>& stations,
                                       const std::optional<maps::BodyLoad>& load) {
  std::vector<std::string> lines;
  for (const StationEase& s : stations)
    if (is_short_of_asked(s))
      lines.push_back(printable(s.name) + ": " + percent(s.cut) + " of ease where " +
                      percent(*s.asked) + " was asked");
  if (!load || !is_asked_loose(stations) || !(load->weight > 0)) return lines;
  if (load->free_force() > kLooseWeights * load->weight)
    lines.push_back(fmt::format(
        "the garment was asked to be loose, but presses with {:.0f} times its weight, without what "
        "is squeezed between arms and trunk: {}",
        load->free_force() / load->weight, bearers(*load)));
  return lines;
}

std::vector<std::string> comfort_warnings(const CaseMaps& maps) {
  const maps::PressureField& field = maps.pressure.field;
  const double limit = *std::rbegin(maps::kPressureClasses);
  double area = 0, largest = 0;
  std::map<body::Region, double> force;
  for (std::size_t i = 0; i < field.contact.size(); ++i) {
    if (field.contact[i] < limit) continue;
    area += field.area[i];
    largest = std::max(largest, field.contact[i]);
    force[maps.worn.regions[i]] += field.contact[i] * field.area[i];
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

std::vector<std::string> strain_range_warnings(const maps::StrainRange& range,
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
  std::vector<std::string> lines;
  for (const auto& [name, d] : {std::pair{"warp", &range.warp}, {"weft", &range.weft}})
    if (!d->is_stated() && d->largest > kUnjudgedStrain)
      lines.push_back(fmt::format(
          "strained along the {0} by up to {1:.0f} %, and no range is stated for it "
          "(valid_strain_{0}): whether the constants hold there, or it would tear, is not judged",
          name, 100 * d->largest));
  if (!beyond.empty())
    lines.push_back("strained beyond the range in which the constants of " +
                    printable(card.material.name) + " hold: " + join(beyond));
  return lines;
}

}  // namespace loosefit::pipeline
