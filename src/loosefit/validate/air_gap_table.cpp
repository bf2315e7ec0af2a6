#include "loosefit/validate/air_gap_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/text.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/io/csv.h"
#include "loosefit/io/material_file.h"
#include "loosefit/io/text_encoding.h"
#include "loosefit/io/text_file.h"
#include "loosefit/kinds/registry.h"

namespace loosefit::validate {
namespace {

constexpr const char* kColumns[] = {
    "source",        "table",          "garment", "fabric",    "fit",      "ease_chest_cm",
    "ease_waist_cm", "body",           "posture", "region",    "gap_mm",   "gap_sd_mm",
    "contact_pct",   "contact_sd_pct", "g0_mm",   "averaging", "donnings", "read_by"};
constexpr std::size_t kLargestFile = 10'000'000;  ///< bytes

/// The fields of one row by their columns.
class Row {
 public:
  Row(const std::string& file, int line, std::vector<std::string> fields)
      : file_(file), line_(line), fields_(std::move(fields)) {
    if (fields_.size() != std::size(kColumns))
      throw InvalidInput(
          {file_, line_, kColumns[std::min(fields_.size(), std::size(kColumns)) - 1]},
          fmt::format("{} fields", fields_.size()), fmt::format("{}", std::size(kColumns)),
          "a text with commas in it stands in quotes");
  }
  std::string text(const char* column) const { return fields_[index(column)]; }
  std::string needed(const char* column) const {
    if (text(column).empty()) fail(column, "nothing", "a text");
    return text(column);
  }
  std::optional<double> number(const char* column, double low, double high) const {
    const std::string field = text(column);
    if (field.empty()) return {};
    double value = 0;
    if (!io::number_in(field, value) || !(value >= low && value <= high))
      fail(column, "\"" + printable(field) + "\"",
           fmt::format("a number from {:g} to {:g}, or nothing", low, high));
    return value;
  }
  [[noreturn]] void fail(const char* column, const std::string& found, const std::string& expected,
                         const std::string& hint = "") const {
    throw InvalidInput({file_, line_, column}, found, expected, hint);
  }

 private:
  static std::size_t index(const char* column) {
    return static_cast<std::size_t>(
        std::find_if(std::begin(kColumns), std::end(kColumns),
                     [&](const char* known) { return std::string(known) == column; }) -
        std::begin(kColumns));
  }
  const std::string& file_;
  int line_;
  std::vector<std::string> fields_;
};

/// Of a person every word behind the sex is a measure; other bodies are described as one likes.
void check_body(const Row& row, const std::string& body) {
  std::istringstream words(body);
  std::string word;
  words >> word;
  if (word != "male" && word != "female") return;
  std::vector<std::string> known = body::measure_names();
  known.push_back("height");
  while (words >> word) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) return;
    const std::string name = word.substr(0, equals);
    if (std::find(known.begin(), known.end(), name) == known.end())
      row.fail("body", "\"" + printable(word) + "\"", "a measure, as in height=1.80",
               did_you_mean(name, known));
    double metres = 0;
    const char* const stop = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data() + equals + 1, stop, metres);
    constexpr double kShortest = 0.05, kLongest = 2.5;  // [m]
    if (error != std::errc{} || end != stop || !(metres >= kShortest && metres <= kLongest))
      row.fail("body", "\"" + printable(word) + "\"",
               fmt::format("metres from {:g} to {:g}, with a point", kShortest, kLongest));
  }
}

AirGapRow read_row(const Row& row, int line) {
  AirGapRow r;
  r.line = line;
  r.source = row.needed("source"), r.table = row.text("table");
  r.garment = row.needed("garment"), r.fabric = row.text("fabric"), r.fit = row.text("fit");
  r.body = row.text("body"), r.posture = row.text("posture");
  r.averaging = row.text("averaging"), r.read_by = row.needed("read_by");
  const auto metres = [](std::optional<double> cm) {
    return cm ? std::optional(*cm / 100) : std::nullopt;
  };
  r.ease_chest = metres(row.number("ease_chest_cm", -50, 200));
  r.ease_waist = metres(row.number("ease_waist_cm", -50, 200));
  r.gap = row.number("gap_mm", 0, 500), r.gap_sd = row.number("gap_sd_mm", 0, 500);
  r.contact = row.number("contact_pct", 0, 100),
  r.contact_sd = row.number("contact_sd_pct", 0, 100);
  r.g0 = row.number("g0_mm", 0, 20);
  if (const auto donnings = row.number("donnings", 1, 1000))
    r.donnings = static_cast<int>(std::lround(*donnings));
  if (!r.gap && !r.contact) row.fail("gap_mm", "neither gap nor contact", "one of the two");
  if (r.contact && !r.g0)
    row.fail("g0_mm", "nothing", "the gap that the source calls contact", "scans: about 1 mm");
  r.region = row.needed("region");
  if (regions_named(r.region).empty())
    row.fail("region", "\"" + printable(r.region) + "\"", "a region of the body",
             did_you_mean(r.region, body::region_names()));
  check_body(row, r.body);
  if (!r.fabric.empty()) {
    const std::vector<std::string> known = io::material_names();
    if (std::find(known.begin(), known.end(), r.fabric) == known.end())
      row.fail("fabric", "\"" + printable(r.fabric) + "\"", "a material card, or nothing",
               did_you_mean(r.fabric, known));
  }
  if (!r.posture.empty()) {
    const std::vector<std::string> known = body::posture_names();
    if (std::find(known.begin(), known.end(), r.posture) == known.end())
      row.fail("posture", "\"" + printable(r.posture) + "\"", "the name of a posture, or nothing",
               did_you_mean(r.posture, known));
  }
  return r;
}

}  // namespace

std::optional<AirGapRow::Person> AirGapRow::person() const {
  std::istringstream words(body);
  Person person;
  if (!(words >> person.sex) || (person.sex != "male" && person.sex != "female")) return {};
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) return {};
    double metres = 0;
    const char* const begin = word.data() + equals + 1;
    const char* const stop = word.data() + word.size();
    const auto [end, error] = std::from_chars(begin, stop, metres);
    if (error != std::errc{} || end != stop || !(metres > 0)) return {};
    person.measures[word.substr(0, equals)] = metres;
  }
  return person;
}

bool AirGapRow::is_gate() const {
  const std::optional<Person> who = person();
  const std::vector<std::string> kinds = kinds::drafted_kinds();
  return ease_chest && who && who->measures.contains("chest") &&
         std::find(kinds.begin(), kinds.end(), garment) != kinds.end();
}

std::vector<body::Region> regions_named(const std::string& name) {
  if (const auto one = body::find_region(name)) return {*one};
  std::vector<body::Region> both;
  for (const char* side : {"_L", "_R"}) {
    std::string sided = name + side;
    if (name == "upper_arm") sided = std::string("upper_sleeve") + side;
    if (name == "forearm") sided = std::string("forearm_sleeve") + side;
    if (const auto one = body::find_region(sided)) both.push_back(*one);
  }
  return both;
}

std::vector<AirGapRow> read_air_gap_table(const std::filesystem::path& file) {
  const std::string name = file.string();
  const io::CsvTable table = io::read_csv(io::read_plain_text(name, kLargestFile), name);
  if (table.rows.empty())
    throw InvalidInput({name, 1, kColumns[0]}, "an empty file", "the line of columns");
  const std::vector<std::string>& head = table.rows[0].fields;
  for (std::size_t k = 0; k < std::size(kColumns); ++k)
    if (k >= head.size() || head[k] != kColumns[k])
      throw InvalidInput({name, table.rows[0].line, kColumns[k]},
                         k < head.size() ? "\"" + printable(head[k]) + "\"" : "no column",
                         fmt::format("\"{}\" as column {}", kColumns[k], k + 1));
  std::vector<AirGapRow> rows;
  for (std::size_t r = 1; r < table.rows.size(); ++r)
    rows.push_back(
        read_row(Row(name, table.rows[r].line, table.rows[r].fields), table.rows[r].line));
  return rows;
}

std::filesystem::path air_gap_table_path() {
  const std::filesystem::path data = data_directory(), installed = data / "air_gap.csv";
  return std::filesystem::exists(installed) ? installed
                                            : data.parent_path() / "validation" / "air_gap.csv";
}

}  // namespace loosefit::validate
