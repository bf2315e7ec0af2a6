#pragma once
#include <optional>
#include <string>

namespace loosefit::io {

/// The length of one file unit and how it was found.
struct FileUnits {
  double metre = 0.001;  ///< [m]
  std::string name;      ///< "millimetres", …
  std::string warning;   ///< empty when the file says so itself and its pieces agree
};

/// Names of units that may be asked for: mm, cm, m, inch.
extern const char* const kUnitNames;

/// What pattern files say about their units is often wrong (centimetres under METRIC, which means
/// millimetres; centimetres under ENGLISH, which means inches), so it is checked: the longest side
/// of the largest piece of a garment lies between 0.25 and 1.7 m. What the file says is taken when
/// it passes; else the only other unit that does, of the same system first, with a warning. \param
/// asked   mm, cm, m or inch; empty: to be found \param claimed text "Units" of the file, METRIC or
/// ENGLISH in any case; may be empty \param insunits $INSUNITS of the header, used without
/// `claimed` \param extent  longest side of the largest piece [file units] \throws InvalidInput
/// where no unit or several would do, with the sizes they would give.
FileUnits choose_units(const std::string& asked, const std::string& claimed,
                       std::optional<int> insunits, double extent, const std::string& file);

}  // namespace loosefit::io
