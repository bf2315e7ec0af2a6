#include "loosefit/study/people.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/text.h"
#include "loosefit/body/body_tape.h"
#include "loosefit/io/config_reader.h"
#include "loosefit/io/csv.h"
#include "loosefit/io/scenario_body.h"
#include "loosefit/io/text_encoding.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/toml_file.h"
#include "loosefit/placement/resample.h"
#include "loosefit/study/draws.h"

namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

const io::NumberRange kLength{0.05, 2.5, "metres"};

fs::path folder() { return data_directory() / "anthropometry"; }

/// Of a symmetric matrix given by its upper triangle, with ones on the diagonal; empty when it is
/// not positive definite.
std::vector<std::vector<double>> cholesky_of(const std::vector<double>& triangle, std::size_t n) {
  std::vector<std::vector<double>> r(n, std::vector<double>(n, 0.0));
  std::size_t k = 0;
  for (std::size_t i = 0; i < n; ++i) {
    r[i][i] = 1;
    for (std::size_t j = i + 1; j < n; ++j) r[j][i] = triangle[k++];
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t m = 0; m < j; ++m) r[j][j] -= r[j][m] * r[j][m];
    if (!(r[j][j] > 1e-9)) return {};
    r[j][j] = std::sqrt(r[j][j]);
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t m = 0; m < j; ++m) r[i][j] -= r[i][m] * r[j][m];
      r[i][j] /= r[j][j];
    }
  }
  return r;
}

PopulationGroup read_group(io::ConfigReader table) {
  PopulationGroup group;
  table.only({"sex", "age", "body_sex", "measures", "p5", "p50", "p95", "correlations"});
  for (const char* key : {"sex", "age", "measures", "p5", "p50", "p95", "correlations"})
    table.require(key, "a value");
  group.sex = table.choice("sex", "", {"female", "male"});
  group.age = table.number("age", 30, {3, 90, "years"});
  group.body_sex = table.number("body_sex", group.sex == "male" ? 1 : 0, {0, 1, "a fraction"});
  std::vector<std::string> known = body::measure_names();
  if (std::find(known.begin(), known.end(), "height") == known.end()) known.push_back("height");
  group.measures = table.choices("measures", {}, known, "", 1);
  if (std::find(group.measures.begin(), group.measures.end(), "height") == group.measures.end())
    throw table.error("measures", "height among them");
  const std::size_t n = group.measures.size();
  const auto percentiles = [&](const char* key) {
    std::vector<double> values = table.numbers(key, kLength);
    if (values.size() != n)
      throw table.error(key, std::to_string(values.size()) + " numbers",
                        fmt::format("one for each of {} measures", n), {});
    return values;
  };
  group.p5 = percentiles("p5");
  group.p50 = percentiles("p50");
  group.p95 = percentiles("p95");
  for (std::size_t i = 0; i < n; ++i)
    if (!(group.p5[i] < group.p50[i] && group.p50[i] < group.p95[i]))
      throw table.error("p50", group.measures[i] + " " + shortest(group.p50[i]),
                        "a median between the other two percentiles", {});
  if (n > 1) {
    const std::vector<double> triangle = table.numbers("correlations", {-1, 1, "a correlation"});
    if (triangle.size() != n * (n - 1) / 2)
      throw table.error("correlations", std::to_string(triangle.size()) + " numbers",
                        fmt::format("the {} of the upper triangle, row by row", n * (n - 1) / 2),
                        {});
    group.factor = cholesky_of(triangle, n);
    if (group.factor.empty())
      throw table.error("correlations", "numbers that no distribution can have",
                        "a positive definite matrix", {});
  } else {
    group.factor = {{1.0}};
  }
  table.finish();
  return group;
}

bool fits(const PopulationGroup& group, const PeopleWish& wish) {
  return (wish.sex == "both" || wish.sex == group.sex) && group.age >= wish.age.first &&
         group.age <= wish.age.second;
}

std::vector<double> correlated(const PopulationGroup& group, const std::vector<double>& z) {
  std::vector<double> scores(z.size(), 0.0);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) scores[i] += group.factor[i][j] * z[j];
  return scores;
}

double number_of(const std::string& text, const io::NumberRange& range, double unit,
                 const InputPlace& place) {
  double value = 0;
  const bool number = io::number_in(text, value);
  value *= unit;
  if (!number || !(value >= range.low && value <= range.high))
    throw InvalidInput(place, "\"" + printable(text) + "\"",
                       fmt::format("{} from {:g} to {:g}", range.what, range.low, range.high),
                       number && unit == 1 ? io::unit_hint(value, range) : "");
  return value;
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// A column of a table of people.
struct Column {
  std::string name;  ///< of what is known, or as the table has it
  double unit = 1;   ///< [m]
};

/// "Upper arm (cm)": the name in small letters, with a unit behind it.
Column column_of(const std::string& head) {
  Column column{head};
  if (const std::size_t open = head.find_last_of("([");
      open != std::string::npos && (head.back() == ')' || head.back() == ']')) {
    const std::string unit = lower(head.substr(open + 1, head.size() - open - 2));
    for (const auto& [name, metres] :
         {std::pair{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"years", 1.0}})
      if (unit == name) column = {head.substr(0, open), metres};
  }
  while (!column.name.empty() && column.name.back() == ' ') column.name.pop_back();
  column.name = lower(column.name);
  for (char& c : column.name)
    if (c == ' ' || c == '-') c = '_';
  if (column.name == "stature") column.name = "height";
  if (column.name == "gender") column.name = "sex";
  return column;
}

/// Of the body model. Letters that mean a woman in one language and a man in another have no
/// meaning here.
double sex_in(const std::string& text, const InputPlace& place) {
  const std::string word = lower(text);
  for (const char* known : {"female", "f", "woman", "w", "weiblich", "femme", "mujer", "donna"})
    if (word == known) return 0;
  for (const char* known : {"male", "m", "man", "männlich", "maennlich", "homme", "hombre", "uomo"})
    if (word == known) return 1;
  return number_of(text, {0, 1, "female, male or a number"}, 1, place);
}

}  // namespace

std::vector<std::string> anthropometry_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder(), error))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Anthropometry load_anthropometry(const std::string& name) {
  const std::vector<std::string> names = anthropometry_names();
  if (names.empty())
    throw IoError(folder().string() + ": found no anthropometric statistics", looked_in());
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InvalidInput({"", 0, "statistics"}, "\"" + printable(name) + "\"",
                       "the name of anthropometric statistics", did_you_mean(name, names));
  const fs::path path = folder() / (name + ".toml");
  return parse_anthropometry(io::read_toml_text(path.string()), path.string());
}

Anthropometry parse_anthropometry(const std::string& text, const std::string& file) {
  const io::ConfigNode node = io::parse_toml(text, file);
  io::ConfigReader table(node, file);
  table.only({"title", "source", "about", "group"});
  table.require("source", "where the numbers come from");
  Anthropometry data;
  data.name = fs::path(file).stem().string();
  data.title = table.text("title", data.name);
  data.source = table.text("source", "");
  data.about = table.text("about", "");
  table.require("group", "[[group]]");
  for (const io::ConfigReader& group : table.tables("group"))
    data.groups.push_back(read_group(group));
  table.finish();
  return data;
}

std::map<std::string, double> measures_at(const PopulationGroup& group,
                                          const std::vector<double>& z) {
  static const double kScore95 = normal_quantile(0.95);
  const std::vector<double> scores = correlated(group, z);
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const double spread = scores[i] > 0 ? std::log(group.p95[i] / group.p50[i])
                                        : std::log(group.p50[i] / group.p5[i]);
    // A tenth of a millimetre: nobody is measured closer, and tables stay readable.
    values[group.measures[i]] =
        std::round(1e4 * group.p50[i] * std::exp(spread * scores[i] / kScore95)) / 1e4;
  }
  return values;
}

std::vector<Person> draw_people(const Anthropometry& from, const PeopleWish& wish,
                                std::uint64_t seed) {
  std::vector<const PopulationGroup*> groups;
  for (const PopulationGroup& group : from.groups)
    if (fits(group, wish)) groups.push_back(&group);
  if (groups.empty())
    throw InvalidInput({"", 0, "people"},
                       fmt::format("no group of {} of sex {} and age {:g} to {:g}", from.name,
                                   wish.sex, wish.age.first, wish.age.second),
                       "people that the statistics know");
  const double limit = normal_quantile(0.5 + 0.5 * wish.within);
  const std::vector<double> first = wish.stratified
                                        ? stratified(wish.count, seed_for(seed, "first measure"))
                                        : std::vector<double>{};
  std::vector<Person> people;
  for (int i = 0; i < wish.count; ++i) {
    const int size = static_cast<int>(groups.size());
    const std::string block = "block " + std::to_string(i / size);
    const PopulationGroup& group =
        *groups[placement::shuffled(size, seed_for(seed, block))[i % size]];
    Draws draws(seed_for(seed, "person " + std::to_string(i)));
    std::vector<double> z(group.measures.size());
    do {
      for (double& score : z) score = draws.normal();
      if (wish.stratified) {
        const double p = 0.5 + wish.within * (first[i] - 0.5);
        z[0] = normal_quantile(p);
      }
      const std::vector<double> scores = correlated(group, z);
      if (std::all_of(scores.begin(), scores.end(), [&](double s) { return std::abs(s) <= limit; }))
        break;
    } while (true);
    people.push_back(
        {fmt::format("person {}", i + 1), group.body_sex, group.age, measures_at(group, z)});
  }
  return people;
}

std::vector<Person> read_people_csv(const fs::path& path) {
  const std::string file = path.string();
  const io::CsvTable table = io::read_csv(io::read_plain_text(file, 10000000), file);
  if (table.rows.empty()) throw InvalidInput({file, 0, ""}, "nobody", "a line of names and people");
  std::vector<std::string> known = body::measure_names();
  known.insert(known.end(), {"name", "sex", "age", "height"});
  std::vector<Column> head;
  for (const std::string& written : table.rows[0].fields) {
    const InputPlace place{file, table.rows[0].line, printable(written)};
    const Column column = column_of(written);
    if (std::find(known.begin(), known.end(), column.name) == known.end())
      throw InvalidInput(place, "an unknown column", "name, sex, age, height or a measure",
                         did_you_mean(column.name, known));
    for (const Column& other : head)
      if (other.name == column.name) throw InvalidInput(place, "the column twice", "each once");
    head.push_back(column);
  }
  if (std::none_of(head.begin(), head.end(), [](const Column& c) { return c.name == "height"; }))
    throw InvalidInput({file, table.rows[0].line, ""}, "no column height", "height in metres");
  std::vector<Person> people;
  std::set<std::string> names;
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    const auto& [line, fields] = table.rows[r];
    if (fields.size() != head.size())
      throw InvalidInput({file, line, ""}, fmt::format("{} fields", fields.size()),
                         fmt::format("{}, as in the first line", head.size()),
                         io::row_hint(table, table.rows[r]));
    Person person;
    person.name = fmt::format("person {}", people.size() + 1);
    for (std::size_t i = 0; i < head.size(); ++i) {
      const auto& [name, unit] = head[i];
      const InputPlace place{file, line, name};
      if (name == "name") {
        if (!valid_utf8(fields[i]))
          throw InvalidInput({file, line, ""}, "a name that is not UTF-8",
                             "UTF-8 (save as CSV UTF-8)");
        person.name = fields[i];
      } else if (name == "sex") {
        person.sex = sex_in(fields[i], place);
      } else if (name == "age") {
        person.age = number_of(fields[i], io::age_range(), 1, place);
      } else if (name == "height" || !fields[i].empty()) {
        person.measures[name] = number_of(fields[i], io::measure_range(name), unit, place);
      }
    }
    if (person.name.empty() || !names.insert(person.name).second)
      throw InvalidInput({file, line, "name"}, "\"" + printable(person.name) + "\"",
                         "a name of their own for everybody");
    people.push_back(std::move(person));
  }
  if (people.empty()) throw InvalidInput({file, 0, ""}, "nobody", "a line of names and people");
  return people;
}

}  // namespace loosefit::study
