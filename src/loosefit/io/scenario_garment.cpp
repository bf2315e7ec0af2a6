#include "loosefit/io/scenario_garment.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/io/band_table.h"
#include "loosefit/io/elastic_table.h"
#include "loosefit/io/existing_file.h"
#include "loosefit/kinds/find_size.h"
#include "loosefit/kinds/pattern_file.h"
#include "loosefit/kinds/registry.h"

namespace loosefit::io {
namespace {

std::map<std::string, double> read_fit(ConfigReader table, const kinds::GarmentKind& kind,
                                       bool sized) {
  std::map<std::string, double> fit;
  for (const kinds::KindKey& key : kind.keys) {
    const NumberRange range{key.low, key.high, key.unit};
    std::optional<double> value;
    if (!sized || key.with_size)
      value = table.optional_number(key.name, range, key.meaning, key.usual);
    if (value)
      fit[key.name] = *value;
    else if (key.usual)
      fit[key.name] = *key.usual;
  }
  table.finish();
  return fit;
}

const char* const kPatternAbout =
    "kind of the garment, or a pattern file (GarmentCode, DXF, SVG, FreeSewing), taken at the size "
    "it has";
const char* const kSeamsAbout = "what is sewn to what; NAME.seams.toml beside the file otherwise";
const char* const kPathPattern = "/|.\\.";  // as names_a_file

bool names_a_file(const std::string& pattern) {
  return pattern.find('/') != std::string::npos ||
         !std::filesystem::path(pattern).extension().empty();
}

/// Names of the fit that give way: those that the user did not give, or the ones of `adapt`; in the
/// order of the kind.
std::vector<std::string> read_adapt(ConfigReader& table, const kinds::GarmentKind& kind,
                                    const std::set<std::string>& given) {
  std::vector<std::string> names;
  for (const kinds::KindKey& key : kind.keys) names.push_back(key.name);
  std::set<std::string> yielding;
  const std::vector<std::string> wished = table.choices(
      "adapt", {}, names, "keys of fit that may give way where the body cannot be drafted for");
  if (table.has("adapt")) {
    yielding.insert(wished.begin(), wished.end());
  } else {
    for (const std::string& name : names)
      if (!given.count(name)) yielding.insert(name);
  }
  std::erase_if(names, [&](const std::string& name) { return !yielding.count(name); });
  return names;
}

/// All but its elastics and bands.
std::string cut_toml(const scenario::GarmentSpec& garment, const std::string& section) {
  const bool named = garment.file.empty();
  std::string text = "pattern = " + toml_quoted(named ? garment.kind : garment.file) + "\n";
  if (section == "garment") text = "[garment]\n" + text;
  if (!named) {
    for (const auto& [key, value] :
         {std::pair{"size", garment.size}, std::pair{"units", garment.units},
          std::pair{"seams", garment.seams}})
      if (!value.empty()) text += std::string(key) + " = " + toml_quoted(value) + "\n";
    return text;
  }
  std::vector<std::string> adapt;
  for (const std::string& name : garment.adapt) adapt.push_back(toml_quoted(name));
  text += "adapt = [" + join(adapt) + "]\n";
  const bool sized = !garment.size.empty();
  if (sized) text += "size = " + toml_quoted(garment.size) + "\n";
  const std::vector<kinds::KindKey>& keys = kinds::garment_kind(garment.kind).keys;
  if (sized && std::none_of(keys.begin(), keys.end(), [](const auto& k) { return k.with_size; }))
    return text;
  text += "\n[" + section + ".fit]\n";
  for (const kinds::KindKey& key : keys)
    if (const auto value = garment.fit.find(key.name);
        value != garment.fit.end() && (key.with_size || !sized))
      text += key.name + " = " + shortest(value->second) + "\n";
  return text;
}

}  // namespace

scenario::GarmentSpec read_garment_keys(ConfigReader& table) {
  scenario::GarmentSpec garment;
  if (table.has("file"))
    throw table.error("file", "an unknown key", "a key of garment",
                      "a pattern file is named by pattern = \"PATH\"");
  garment.kind = table.peek_text("pattern", kinds::garment_kinds().front().name);
  if (names_a_file(garment.kind)) {
    garment.file = existing_file(table, "pattern", kPatternAbout, kPathPattern);
    table.require("pattern", "a pattern file");
    garment.kind = kinds::pattern_file().name;
    garment.size =
        table.text("size", "", "of a file that holds several; its sample size otherwise");
    garment.units = table.choice("units", "", {"mm", "cm", "m", "inch"},
                                 "of a file that does not name them, or wrongly");
    if (table.has("seams"))
      garment.seams = existing_file(table, "seams", kSeamsAbout);
    else
      table.text("seams", "", kSeamsAbout);
    for (const char* key : {"fit", "adapt"})
      if (table.has(key))
        throw table.error(key, std::string("no ") + key + " beside a pattern file",
                          "a pattern file is taken at the size it has");
  } else {
    const kinds::GarmentKind& kind = kinds::garment_kind(
        table.choice("pattern", garment.kind, kinds::drafted_kinds(), kPatternAbout));
    garment.kind = kind.name;
    table.only_for("pattern", {kind.name});
    const bool sized = table.has("size");
    if (sized) {
      garment.size = table.choice("size", "", kinds::size_names(kind.sizes),
                                  "a fixed garment, whatever the body");
      table.require("size", "a size");
    }
    const std::vector<std::string> given = table.table("fit").keys();
    for (const kinds::KindKey& key : kind.keys)
      if (!garment.size.empty() && !key.with_size &&
          std::find(given.begin(), given.end(), key.name) != given.end())
        throw table.error("fit", "either fit." + key.name + " or size",
                          "a size fixes the garment; a fit follows the body");
    garment.fit =
        read_fit(table.table("fit", "body-garment mobility per level, and cut"), kind, sized);
    garment.adapt = read_adapt(table, kind, {given.begin(), given.end()});
  }
  for (const ConfigReader& elastic :
       table.tables("elastic", "elastics along edges of its panels, beside those of the pattern"))
    garment.elastics.push_back(read_elastic(elastic));
  std::set<std::string> told;
  for (const ConfigReader& band :
       table.tables("band", "panels of another cloth than the fabric: ribs, folded strips"))
    garment.bands.push_back(read_band(band, told));
  return garment;
}

scenario::GarmentSpec read_garment_section(ConfigReader table) {
  scenario::GarmentSpec garment = read_garment_keys(table);
  table.finish();
  return garment;
}

std::string garment_toml(const scenario::GarmentSpec& garment, const std::string& section) {
  std::string text = cut_toml(garment, section);
  for (const pattern::NamedElastic& elastic : garment.elastics)
    text += "\n[[" + section + ".elastic]]\n" + elastic_toml(elastic);
  for (const pattern::NamedCloth& band : garment.bands)
    text += "\n[[" + section + ".band]]\n" + band_toml(band);
  return text;
}

}  // namespace loosefit::io
