#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace loosefit::study {

/// What a population of one sex and age measures: percentiles of each measure and correlations of
/// their normal scores. Each measure is log-normal on either side of its median, so that all three
/// percentiles are met.
struct PopulationGroup {
  std::string sex;                          ///< "female", "male": of the people
  double body_sex = 0;                      ///< of the body model: 0 female … 1 male
  double age = 30;                          ///< years
  std::vector<std::string> measures;        ///< "height" and names of body::measure_names()
  std::vector<double> p5, p50, p95;         ///< [m]
  std::vector<std::vector<double>> factor;  ///< Cholesky factor of the correlations, lower
};

/// A file of data/anthropometry.
struct Anthropometry {
  std::string name, title, source, about;
  std::vector<PopulationGroup> groups;
};

/// Somebody who wears the garment: what [body] of a scenario needs.
struct Person {
  std::string name;
  std::optional<double> sex;               ///< of the body model; nothing: as in the scenario
  std::optional<double> age;               ///< years; the same
  std::map<std::string, double> measures;  ///< [m]; "height" is one of them
};

/// Which people are drawn.
struct PeopleWish {
  int count = 12;
  std::string sex = "both";                  ///< female, male, both
  std::pair<double, double> age = {0, 120};  ///< of groups, bounds included, years
  double within = 0.98;     ///< central share of every measure outside of which nobody is drawn
  bool stratified = false;  ///< first measure of all evenly spread: covers more, is no sample
};

/// Names of the shipped statistics, sorted.
std::vector<std::string> anthropometry_names();

/// \throws InvalidInput with a did-you-mean for an unknown name; as parse_anthropometry.
Anthropometry load_anthropometry(const std::string& name);

/// \throws InvalidInput with file, line and key: unknown measures, percentiles that do not ascend,
/// correlations that are none.
Anthropometry parse_anthropometry(const std::string& text, const std::string& file);

/// Draws people: groups that match in blocks, each group once a block in random order; in a group
/// correlated normal scores, drawn again while one is outside `within`. The first k of n people
/// are those that k would be, unless stratified. \throws InvalidInput when no group matches.
std::vector<Person> draw_people(const Anthropometry& from, const PeopleWish& wish,
                                std::uint64_t seed);

/// One person: all measures at normal scores `z` (independent ones, correlated here).
std::map<std::string, double> measures_at(const PopulationGroup& group,
                                          const std::vector<double>& z);

/// Reads people from a table of any spreadsheet (io/csv.h): a line of names (name, sex, age,
/// height, and any tape measures, in any letter case), then one line each; lengths in metres, or in
/// the unit that stands behind the name as in "chest (cm)", within the ranges of [body]; decimals
/// with a point or a comma; sex "female", "male", "f", "m" or 0 … 1. Without a column name people
/// are numbered; sex and age may lack too. \throws IoError; InvalidInput with file, line and
/// column.
std::vector<Person> read_people_csv(const std::filesystem::path& path);

}  // namespace loosefit::study
