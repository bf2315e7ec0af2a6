#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/regions.h"

namespace loosefit::validate {

/// One row of validation/air_gap.csv: what a publication says of one region of one garment on one
/// body. Columns and rules: docs/theory/air_gap.md 4.
struct AirGapRow {
  int line = 0;  ///< in the file, from 1
  std::string source, table, garment, fabric, fit, body, posture, region, averaging, read_by;
  std::optional<double> ease_chest, ease_waist;  ///< [m]
  std::optional<double> gap, gap_sd;             ///< [mm]
  std::optional<double> contact, contact_sd;     ///< share of the skin [%]
  std::optional<double> g0;                      ///< gap below which that is contact [mm]
  std::optional<int> donnings;

  /// The person of `body`, "male height=1.80 chest=1.00 waist=0.86": what the gate dresses. Nothing
  /// when `body` only describes.
  struct Person {
    std::string sex;
    std::map<std::string, double> measures;  ///< [m], height among them
  };
  std::optional<Person> person() const;
  /// Can be draped: a kind of garment of ours with ease at the chest, on a person with a chest
  /// girth.
  bool is_gate() const;
};

/// The regions of ours that a region of a table is: by its name, "upper_back", or without the side
/// for both, "upper_arm". Empty for none.
std::vector<body::Region> regions_named(const std::string& name);

/// Rows of the file; none for a header alone. \throws InvalidInput naming file, line and column:
/// not the columns of the header, a number that is none or out of range, an unknown region or
/// posture, neither gap nor contact, contact without g0; IoError when it cannot be read.
std::vector<AirGapRow> read_air_gap_table(const std::filesystem::path& file);

/// The table that the program was installed or built with.
std::filesystem::path air_gap_table_path();

}  // namespace loosefit::validate
