#include "loosefit/io/pieces/file_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

constexpr double kShortest = 0.25, kLongest = 1.7;  // longest side of a garment's largest piece [m]
// Socks, cups and cuffs on one side, trains on the other: beyond them a length in a named unit is
// doubted as well.
constexpr double kLeast = 0.05, kMost = 3;
constexpr double kMostInches = 50;  // of a piece that is as long as one in centimetres

struct Unit {
  std::string name, title;
  double metre = 0;
  bool metric = true;
};
const std::array<Unit, 4> kUnits{{{"mm", "millimetres", 0.001, true},
                                  {"cm", "centimetres", 0.01, true},
                                  {"m", "metres", 1, true},
                                  {"inch", "inches", 0.0254, false}}};
const Unit& kMillimetres = kUnits[0];
const Unit& kCentimetres = kUnits[1];
const Unit& kInches = kUnits[3];

struct Statement {
  Unit unit;
  std::string words;
  bool exact = false;  ///< it names a unit; METRIC and ENGLISH name a system
};

bool usual(const Unit& unit, double extent) {
  return unit.metre * extent >= kShortest && unit.metre * extent <= kLongest;
}

std::string size_in(const Unit& unit, double extent) {
  return fmt::format("{:.3g} m in {}", unit.metre * extent, unit.title);
}

std::string sizes_in_all(double extent) {
  std::vector<std::string> sizes;
  for (const Unit& unit : kUnits) sizes.push_back(size_in(unit, extent));
  return join(sizes);
}

/// What a text "Units" names, by its first letters in any language that is written so.
std::optional<Statement> in_text(const std::string& claimed) {
  std::string word;
  for (const char c : claimed)
    if (std::isalpha(static_cast<unsigned char>(c)) || c == '"')
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::string words = "the file says Units: " + printable(claimed);
  const auto starts = [&](std::initializer_list<const char*> all) {
    return std::any_of(all.begin(), all.end(), [&](const char* c) { return word.starts_with(c); });
  };
  if (starts({"metric"})) return Statement{kMillimetres, words, false};
  if (starts({"english", "imperial"})) return Statement{kInches, words, false};
  if (word == "mm" || starts({"millim", "milim"})) return Statement{kMillimetres, words, true};
  if (word == "cm" || starts({"centim", "zentim"})) return Statement{kCentimetres, words, true};
  if (word == "m" || starts({"meter", "metre", "metro"})) return Statement{kUnits[2], words, true};
  if (word == "in" || word == "\"" || starts({"inch", "zoll", "pulgada", "pouce", "pollic"}))
    return Statement{kInches, words, true};
  return {};
}

/// Units of a DXF header (Autodesk, DXF Reference, $INSUNITS).
std::optional<Statement> in_header(std::optional<int> insunits) {
  const auto says = [](const Unit& unit) {
    return Statement{unit, "the header says " + unit.title + " ($INSUNITS)", true};
  };
  switch (insunits.value_or(0)) {
    case 1:
      return says(kInches);
    case 2:
      return says({"", "feet", 0.3048, false});
    case 4:
      return says(kMillimetres);
    case 5:
      return says(kCentimetres);
    case 6:
      return says(kUnits[2]);
    case 14:
      return says({"", "decimetres", 0.1, true});
    default:
      return {};
  }
}

std::optional<Statement> on_page(const std::optional<PageUnit>& page) {
  if (!page || !page->stated) return {};
  return Statement{{"", fmt::format("a unit of {:.4g} mm", page->mm), page->mm / 1000, true},
                   page->words,
                   page->exact};
}

bool of_clo(const std::string& maker) {
  for (const char* name : {"CLO ", "CLO3D", "Marvelous"})
    if ((maker + " ").find(name) != std::string::npos) return true;
  return false;
}

std::string otherwise(const FileUnits& units, double extent, const std::string& words) {
  return fmt::format(
      "units: {}; taken as {}, in which the largest piece is {:.3g} m (--units says "
      "otherwise)",
      words, units.name, units.metre * extent);
}

FileUnits taken(const Unit& unit, double extent, const std::string& words) {
  FileUnits units{unit.metre, unit.title, {}};
  if (!words.empty()) units.warning = otherwise(units, extent, words);
  return units;
}

/// Of a unit that the file states: why somebody may doubt it; empty when nobody does.
std::string doubt_of(const Statement& said, double extent) {
  const double size = said.unit.metre * extent;
  if (said.exact ? size < kLeast || size > kMost : !usual(said.unit, extent)) {
    std::vector<std::string> others;
    for (const Unit& unit : kUnits)
      if (usual(unit, extent) && std::abs(unit.metre / said.unit.metre - 1) > 0.01)
        others.push_back(size_in(unit, extent));
    return fmt::format(
        "what the file states is kept although {:.3g} m is unusual for the largest "
        "piece of a garment{}",
        size, others.empty() ? "" : "; it would be " + join(others, " or "));
  }
  // Inches of a garment that would be one in centimetres as well, the longer the more likely.
  if (!said.exact && said.unit.name == kInches.name && usual(kCentimetres, extent))
    return fmt::format(
        "some programs write centimetres under that{}, which would make the largest "
        "piece {}",
        extent > kMostInches ? ", and here it is as likely" : "", size_in(kCentimetres, extent));
  return {};
}

/// What CLO may mean by a system of units.
FileUnits of_clo_file(const Statement& said, const SaidUnits& says, double extent) {
  const std::string maker =
      said.words + ", under which the program that wrote it, " + printable(says.maker, 60) + ", ";
  if (!said.unit.metric) return taken(kCentimetres, extent, maker + "writes centimetres");
  if (!usual(said.unit, extent) && usual(kCentimetres, extent))
    return taken(kCentimetres, extent, maker + "writes centimetres too");
  const std::string doubt = doubt_of(said, extent);
  return taken(said.unit, extent, doubt.empty() ? "" : said.words + "; " + doubt);
}

FileUnits as_stated(const std::vector<Statement>& all, double extent) {
  const auto differs = [&](const Statement& other) {
    return std::abs(other.unit.metre / all[0].unit.metre - 1) > 1e-6;
  };
  const auto contrary = std::find_if(all.begin(), all.end(), differs);
  if (contrary == all.end()) {
    const std::string doubt = doubt_of(all[0], extent);
    return taken(all[0].unit, extent, doubt.empty() ? "" : all[0].words + "; " + doubt);
  }
  const Statement& held =
      usual(contrary->unit, extent) && !usual(all[0].unit, extent) ? *contrary : all[0];
  return taken(held.unit, extent, all[0].words + " and " + contrary->words);
}

}  // namespace

const char* const kUnitNames = "mm, cm, m or inch";

FileUnits choose_units(const std::string& asked, const SaidUnits& says, double extent,
                       const std::string& file) {
  if (!asked.empty()) {
    for (const Unit& unit : kUnits)
      if (asked == unit.name) return {unit.metre, unit.title, {}};
    throw InvalidInput({{}, 0, "units"}, '"' + printable(asked) + '"', kUnitNames);
  }
  const std::optional<Statement> text = in_text(says.claimed);
  if (text && !text->exact && of_clo(says.maker)) return of_clo_file(*text, says, extent);
  std::vector<Statement> stated;
  for (const auto& one : {text, in_header(says.insunits), on_page(says.page)})
    if (one) stated.push_back(*one);
  if (!stated.empty()) {
    FileUnits units = as_stated(stated, extent);
    // Every program has a pixel of its own, so how it was told is said in any case.
    if (says.page && says.page->stated && !says.page->exact && units.warning.empty())
      units.warning = otherwise(units, extent, says.page->words);
    return units;
  }
  std::string words = says.claimed.empty() ? std::string("the file does not name its units")
                                           : "the file says Units: " + printable(says.claimed) +
                                                 ", which is no unit that is known";
  if (says.page) {
    const Unit pixel{"", says.page->words, says.page->mm / 1000, true};
    if (usual(pixel, extent)) return taken(pixel, extent, words);
  }
  std::vector<Unit> fitting;
  for (const bool same : {true, false}) {
    if (!fitting.empty()) break;
    for (const Unit& unit : kUnits)
      if ((!same || (says.metric && unit.metric == *says.metric)) && usual(unit, extent))
        fitting.push_back(unit);
  }
  if (fitting.size() != 1)
    throw InvalidInput(
        {file, 0, "units"},
        fmt::format("a largest piece of {:.6g} file units, {}", extent, sizes_in_all(extent)),
        fmt::format("{:g} to {:g} m in one of them", kShortest, kLongest),
        words + "; name the unit: --units " + kUnitNames + ", in a scenario garment.units");
  if (says.metric)
    words += std::string(", only that it is ") + (*says.metric ? "metric" : "English") +
             " ($MEASUREMENT)";
  return taken(fitting[0], extent, words);
}

}  // namespace loosefit::io
