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

/// What a file says of its units.
struct SaidUnits {
  std::string claimed;          ///< text "Units", METRIC or ENGLISH in any case; may be empty
  std::optional<int> insunits;  ///< $INSUNITS of the header, used without `claimed`
  std::string maker;            ///< program that wrote it; may be empty
};

/// What pattern files say about their units is often wrong (centimetres under METRIC, which means
/// millimetres; centimetres under ENGLISH, which means inches), so it is checked: the longest side
/// of the largest piece of a garment lies between 0.25 and 1.7 m. What the file says is taken when
/// it passes; else the only other unit that does, of the same system first, with a warning.
/// Inches that pass as centimetres too are taken with a warning up to a length of 50 inches, beyond
/// which both are as likely (judgement: 0.5 m is a T-shirt, 1.27 m a dress). Where CLO or Marvelous
/// Designer wrote the file, which write centimetres under ENGLISH, it is not taken as inches.
/// \param asked  mm, cm, m or inch; empty: to be found
/// \param extent  longest side of the largest piece [file units]
/// \throws InvalidInput where no unit or several would do, with the sizes they would give.
FileUnits choose_units(const std::string& asked, const SaidUnits& says, double extent,
                       const std::string& file);

}  // namespace loosefit::io
