#pragma once
#include <optional>
#include <string>

namespace loosefit::io {

/// The length of one file unit and how it was found.
struct FileUnits {
  double metre = 0.001;  ///< [m]
  std::string name;      ///< "millimetres", "a unit of 0.2646 mm", …
  std::string warning;   ///< empty when the file says so itself and nothing speaks against it
};

/// Names of units that may be asked for: mm, cm, m, inch.
extern const char* const kUnitNames;

/// The unit of a drawing with a page.
struct PageUnit {
  double mm = 1;        ///< of one unit of the drawing
  std::string words;    ///< how that is known: "width 400mm over a viewBox of 400 units"
  bool stated = false;  ///< the file or its program says so; false: what is usual without a word
  bool exact = false;   ///< it is a length that the file names, not a program's pixel
};

/// What a file says of its units.
struct SaidUnits {
  std::string claimed;                ///< text "Units": METRIC, ENGLISH, mm, … ; may be empty
  std::optional<int> insunits;        ///< $INSUNITS of the header
  std::string maker = {};             ///< program that wrote it; may be empty
  std::optional<bool> metric = {};    ///< $MEASUREMENT of the header: 1 metric, 0 English
  std::optional<PageUnit> page = {};  ///< of a drawing with a page; all else is empty then
};

/// What is asked for is taken, else what the file states, else what makes a garment.
/// - A statement is kept however large the pieces are by it; where that is unusual a warning names
///   the statement, the size and another unit that would be usual. METRIC means millimetres and
///   ENGLISH inches (ASTM D6673). Of two statements that differ the first holds that makes a
///   garment of usual size, text before header, and the warning names both.
/// - CLO and Marvelous Designer write centimetres under ENGLISH, and centimetres or millimetres
///   under METRIC: there the size tells which, with a warning.
/// - Without a statement the one unit is taken in which the longest side of the largest piece is
///   0.25 to 1.7 m (judgement: garments from a child's to a long coat), with a warning; one of the
///   system that $MEASUREMENT names before others, the usual pixel of a page before all.
/// \param asked  mm, cm, m or inch; empty: to be found
/// \param extent  longest side of the largest piece [file units]
/// \throws InvalidInput for an unknown unit that is asked for, and where the file states none and
/// no
///         unit or several would do, with the sizes they would give.
FileUnits choose_units(const std::string& asked, const SaidUnits& says, double extent,
                       const std::string& file);

}  // namespace loosefit::io
