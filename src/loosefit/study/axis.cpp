#include "loosefit/study/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/io/material_file.h"
#include "loosefit/scenario/scenario.h"
#include "loosefit/study/config_patch.h"
#include "loosefit/study/draws.h"
#include "loosefit/study/people.h"

namespace loosefit::study {
namespace {

using Kind = io::ConfigNode::Kind;

constexpr int kMostLevels = 100000;
constexpr const char* kPoint = "decimals have a point: 0.1, not 0,1";

bool is_number(const io::ConfigNode& node) {
  return node.kind == Kind::integer || node.kind == Kind::number;
}

/// Four significant digits of a draw: what a study file could say, and a label that can be read.
double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }

io::ConfigNode text_array(const std::vector<std::string>& words, int line) {
  io::ConfigNode node;
  node.kind = Kind::array;
  node.line = line;
  for (const std::string& word : words) node.items.push_back(text_node(word, line));
  return node;
}

/// Texts of an array; anything else is refused as what stands there.
std::vector<std::string> texts_of(const io::ConfigReader& table, const std::string& key,
                                  const io::ConfigNode& array, const std::string& expected) {
  if (array.kind != Kind::array || array.items.empty())
    throw table.error(key, array.describe(), expected, {});
  std::vector<std::string> texts;
  for (const io::ConfigNode& item : array.items) {
    if (item.kind != Kind::text || item.text.empty())
      throw table.error(key, item.describe(), expected, {});
    texts.push_back(item.text);
  }
  return texts;
}

/// The table of an axis while it is read.
class Reading {
 public:
  Reading(io::ConfigReader& table, Axis& axis, std::uint64_t seed, int draws)
      : table_(table), axis_(axis), seed_(seed_for(seed, axis.name)), draws_(draws) {}

  void people() {
    io::ConfigReader wish = table_.table("people");
    std::vector<Person> people;
    if (wish.has("file")) {
      wish.only({"file"});
      const std::filesystem::path named = wish.text("file", "");
      people = read_people_csv(
          named.is_absolute() ? named : std::filesystem::path(table_.file()).parent_path() / named);
    } else {
      wish.only({"statistics", "sex", "age", "count", "within", "stratified"});
      wish.require("statistics", "names of " + join(anthropometry_names()) + ", or file");
      const Anthropometry from = load_anthropometry(
          wish.choice("statistics", "", anthropometry_names(), "anthropometric statistics"));
      PeopleWish asked;
      asked.sex = wish.choice("sex", "both", {"both", "female", "male"});
      if (wish.has("age")) {
        const std::vector<double> range = wish.numbers("age", {0, 120, "years"});
        if (range.size() > 2 || range.front() > range.back())
          throw wish.error("age", "[from, to] in years");
        asked.age = {range.front(), range.back()};
      }
      asked.count = count_of(wish, 12);
      asked.within = wish.number("within", asked.within, {0.5, 0.9999, "a share"});
      asked.stratified = wish.boolean("stratified", false);
      try {
        people = draw_people(from, asked, seed_);
      } catch (const InvalidInput& error) {
        throw table_.error("people", error.found(), error.expected(), error.hint());
      }
      axis_.sampled = true;
      axis_.stratified = asked.stratified;
    }
    wish.finish();
    for (const Person& person : people) add(person);
  }

  void fabrics() {
    const io::ConfigNode& node = *table_.node("fabrics");
    if (node.kind == Kind::array) {
      for (const std::string& name :
           table_.choices("fabrics", {}, io::material_names(), "material cards", 1)) {
        AxisLevel& level = new_level(name);
        set_value(level.patch, "material.name", text_node(name, node.line));
      }
      return;
    }
    io::ConfigReader wish = table_.table("fabrics");
    wish.only({"population", "count"});
    wish.require("population", "\"618-measured\", or a list of material cards");
    wish.choice("population", "", {"618-measured"});
    const int count = count_of(wish, 10);
    wish.finish();
    draw_fabrics(count);
  }

  void ease() {
    io::ConfigReader wish = table_.table("ease");
    std::vector<std::string> names;
    for (const ChosenEase& known : chosen_ease()) names.push_back(known.garment);
    wish.only({"chosen", "count"});
    wish.require("chosen", "one of " + join(names));
    const std::string chosen = wish.choice("chosen", "", names);
    const int count = count_of(wish, 10);
    wish.finish();
    axis_.keys = keys({"garment.fit.chest"});
    axis_.sampled = true;
    const auto known = std::find_if(chosen_ease().begin(), chosen_ease().end(),
                                    [&](const ChosenEase& e) { return chosen == e.garment; });
    for (const double p : stratified(count, seed_)) {
      const double ease = rounded(known->mean + known->deviation * normal_quantile(p));
      AxisLevel& level = new_level(fmt::format("{:g} cm", 100 * ease), ease);
      level.chest_ease = ease;
    }
  }

  void place() {
    io::ConfigReader wish = table_.table("place");
    wish.only({"site", "shift", "count"});
    const int site = static_cast<int>(wish.integer("site", 0, 0, 199));
    const double most = wish.number("shift", 0.020, {0, 0.2, "metres"});
    const int count = count_of(wish, 5);
    wish.finish();
    axis_.sampled = true;
    const std::vector<double> along = stratified(count, seed_for(seed_, "along"));
    const std::vector<double> around = stratified(count, seed_for(seed_, "around"));
    for (int i = 0; i < count; ++i) {
      const double u = rounded(most * (2 * around[i] - 1)), v = rounded(most * (2 * along[i] - 1));
      AxisLevel& level = new_level(fmt::format("{:+.1f}, {:+.1f} mm", 1e3 * u, 1e3 * v));
      level.inputs = {{axis_.name + ".u", u}, {axis_.name + ".v", v}};
      level.shift = SiteShift{site, u, v};
    }
  }

  void postures() {
    const io::ConfigNode& node = *table_.node("postures");
    if (node.kind != Kind::array) throw table_.error("postures", "[[\"standing\", …], …]");
    for (const io::ConfigNode& list : node.items) {
      const std::vector<std::string> names =
          texts_of(table_, "postures", list, "lists of names of postures");
      AxisLevel& level = new_level(join(names, " + "));
      set_value(level.patch, "postures.list", text_array(names, list.line));
    }
  }

  /// The same draws in every study, so that two can be compared donning by donning.
  void donnings() {
    // No seed is that of a further donning of another level (planned_donnings).
    constexpr int kApart = 10 * scenario::kMostDonnings;
    const int count = static_cast<int>(table_.integer("donnings", 2, 1, 1000));
    for (int k = 1; k <= count; ++k) {
      AxisLevel& level = new_level("donning " + std::to_string(k));
      set_value(level.patch, "donning.first", text_node("drawn"));
      set_value(level.patch, "donning.seed", integer_node(1 + (k - 1) * kApart));
    }
  }

  void levels() {
    const std::vector<io::ConfigReader> all = table_.tables("levels", "", kMostLevels);
    const io::ConfigNode& node = *table_.node("levels");
    for (std::size_t i = 0; i < all.size(); ++i) {
      io::ConfigReader one = all[i];
      one.only({"label", "value", "set"});
      one.require("set", "keys of a scenario, as tables");
      const std::optional<double> value = one.optional_number("value", {});
      const std::string label =
          one.text("label", value ? shortest(*value) : "level " + std::to_string(i + 1));
      one.table("set");  // asked for; what is in it the scenario's reader judges
      one.finish();
      AxisLevel& level = new_level(label, value);
      level.patch = *node.items[i].find("set");
    }
  }

  void values() {
    axis_.keys = keys({});
    const io::ConfigNode& node = *table_.node("values");
    if (node.kind != Kind::array || node.items.empty())
      throw table_.error("values", "an array of values");
    std::vector<std::string> labels;
    if (const io::ConfigNode* given = table_.node("labels")) {
      labels = texts_of(table_, "labels", *given, "one text for each of the values");
      if (labels.size() != node.items.size())
        throw table_.error("labels", "one text for each of the values");
    }
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const io::ConfigNode& value = node.items[i];
      std::string label = value.kind == Kind::text ? value.text : value.describe();
      if (!labels.empty()) label = labels[i];
      std::optional<double> number;
      if (is_number(value)) number = value.number;
      AxisLevel& level = new_level(label, number);
      set_keys(level, value);
    }
  }

  void range() {
    axis_.keys = keys({});
    const std::vector<double> ends = table_.numbers("range", {});
    const std::string meaning = "the ends, or for normal laws the 5th and 95th percentile";
    const std::string law = table_.choice("distribution", "uniform",
                                          {"uniform", "log-uniform", "normal", "log-normal"});
    if (ends.size() != 2)
      throw table_.error("range", "[low, high]: " + meaning, ends.size() == 4 ? kPoint : "");
    if (!(ends[0] < ends[1]))
      throw table_.error("range", shortest(ends[0]) + ", " + shortest(ends[1]),
                         "low < high: " + meaning, {});
    const bool logarithmic = law == "log-uniform" || law == "log-normal";
    if (logarithmic && ends[0] <= 0) throw table_.error("range", "a range above 0 for " + law);
    const int count = count_of(table_, 10);
    axis_.sampled = true;
    const double low = logarithmic ? std::log(ends[0]) : ends[0];
    const double high = logarithmic ? std::log(ends[1]) : ends[1];
    const bool normal = law == "normal" || law == "log-normal";
    for (const double p : stratified(count, seed_)) {
      const double share = normal ? 0.5 + 0.5 * normal_quantile(p) / normal_quantile(0.95) : p;
      const double x = low + share * (high - low);
      const double value = rounded(logarithmic ? std::exp(x) : x);
      AxisLevel& level = new_level(shortest(value), value);
      set_keys(level, number_node(value, table_.node("range")->line));
    }
  }

 private:
  std::vector<std::string> keys(const std::vector<std::string>& usual) {
    if (const std::string one = table_.text("key", ""); !one.empty()) return {one};
    const io::ConfigNode* node = table_.node("keys");
    if (!node) {
      if (usual.empty()) throw table_.error("key", "a key of the scenario, with dots");
      return usual;
    }
    return texts_of(table_, "keys", *node, "an array of keys of the scenario");
  }

  /// Of all keys of the axis. A level is laid over the base, so it cannot reach into its arrays.
  void set_keys(AxisLevel& level, const io::ConfigNode& value) {
    for (const std::string& key : axis_.keys) {
      const char* const from = table_.has("key") ? "key" : "keys";
      if (key.find('[') != std::string::npos)
        throw table_.error(from, "\"" + printable(key) + "\"", "a key that is in no array",
                           "levels = [{ set = … }] replaces a whole array");
      try {
        set_value(level.patch, key, value);
      } catch (const InvalidInput& error) {
        throw table_.error(from, "\"" + printable(key) + "\" with " + error.found(),
                           error.expected(), {});
      }
    }
  }

  int count_of(io::ConfigReader& table, int usual) {
    const bool said = table.has("count");
    const int count = static_cast<int>(table.integer("count", usual, 1, kMostLevels));
    if (said && draws_ > 0 && count != draws_)
      throw table.error("count", std::to_string(count),
                        "no count: there are as many draws as cases, " + std::to_string(draws_),
                        {});
    return draws_ > 0 ? draws_ : count;
  }

  AxisLevel& new_level(const std::string& label, std::optional<double> value = {}) {
    AxisLevel& level = axis_.levels.emplace_back();
    level.label = label;
    level.value = value;
    if (value) level.inputs[axis_.name] = *value;
    return level;
  }

  void add(const Person& person) {
    AxisLevel& level = new_level(person.name);
    for (const auto& [name, value] : {std::pair("sex", person.sex), {"age", person.age}})
      if (value) {
        set_value(level.patch, std::string("body.") + name, number_node(*value));
        level.inputs[axis_.name + "." + name] = *value;
      }
    for (const auto& [name, value] : person.measures) {
      set_value(level.patch, name == "height" ? "body.height" : "body.measurements." + name,
                number_node(value));
      level.inputs[axis_.name + "." + name] = value;
    }
  }

  /// Log-normal population of 618 measured fabrics (ClothDrapeTester 24a980c, dataset.csv): mass,
  /// bending along warp and weft.
  void draw_fabrics(int count) {
    constexpr double kMean[3] = {-1.789, -11.285, -11.691};
    constexpr double kDeviation[3] = {0.806, 1.405, 1.249};
    PopulationGroup group;  // for its correlated scores
    const double r[3][3] = {{1, 0.72, 0.72}, {0.72, 1, 0.85}, {0.72, 0.85, 1}};
    group.factor.assign(3, std::vector<double>(3, 0.0));
    for (int j = 0; j < 3; ++j)
      for (int i = j; i < 3; ++i) {
        double sum = r[i][j];
        for (int m = 0; m < j; ++m) sum -= group.factor[i][m] * group.factor[j][m];
        group.factor[i][j] = i == j ? std::sqrt(sum) : sum / group.factor[j][j];
      }
    const char* const kKeys[3] = {"areal_density", "bending_warp", "bending_weft"};
    // What a scenario takes, and the 1st and 99th percentile.
    const double limit = normal_quantile(0.99);
    axis_.sampled = true;
    for (int k = 0; k < count; ++k) {
      Draws draws(seed_for(seed_, "fabric " + std::to_string(k)));
      double score[3];
      do {
        double z[3];
        for (double& one : z) one = draws.normal();
        for (int i = 0; i < 3; ++i) {
          score[i] = 0;
          for (int j = 0; j <= i; ++j) score[i] += group.factor[i][j] * z[j];
        }
      } while (std::any_of(score, score + 3, [&](double s) { return std::abs(s) > limit; }));
      AxisLevel& level = new_level("fabric " + std::to_string(k + 1));
      for (int i = 0; i < 3; ++i) {
        const double value = rounded(std::exp(kMean[i] + kDeviation[i] * score[i]));
        set_value(level.patch, std::string("material.") + kKeys[i], number_node(value));
        level.inputs[axis_.name + "." + kKeys[i]] = value;
      }
    }
  }

  io::ConfigReader& table_;
  Axis& axis_;
  const std::uint64_t seed_;
  const int draws_;
};

/// One of them was hardly meant so. Draws may fall together, and people may be alike.
void refuse_same_levels(const io::ConfigReader& table, const Axis& axis) {
  if (axis.sampled || axis.is_people()) return;
  std::set<std::string> known;
  for (const AxisLevel& level : axis.levels) {
    if (known.insert(value_text(level.patch)).second) continue;
    const bool number = axis.kind == "values" && level.value;
    throw table.error(
        axis.kind,
        "the level " + (number ? shortest(*level.value) : printable(level.label)) + " twice",
        "each level once",
        number && *level.value == std::round(*level.value) ? kPoint : std::string());
  }
}

constexpr const char* kKinds =
    "one of people, fabrics, ease, place, postures, donnings, levels, "
    "values, range";

}  // namespace

Axis read_axis(io::ConfigReader table, std::uint64_t study_seed, int draws) {
  table.only({"name", "each_case", "people", "fabrics", "ease", "place", "postures", "donnings",
              "levels", "values", "labels", "range", "distribution", "count", "key", "keys"});
  table.require("name", "a name for the axis");
  Axis axis;
  axis.name = table.text("name", "");
  if (axis.name.empty()) throw table.error("name", "a name for the axis");
  axis.each_case = table.boolean("each_case", false);
  for (const char* kind :
       {"people", "fabrics", "ease", "place", "postures", "donnings", "levels", "values", "range"})
    if (table.has(kind)) {
      if (!axis.kind.empty()) throw table.error(kind, std::string(kKinds) + " alone");
      axis.kind = kind;
    }
  if (axis.kind.empty()) throw table.error("name", "an axis of nothing", kKinds, {});
  Reading reading(table, axis, study_seed, draws);
  if (axis.kind == "people") reading.people();
  if (axis.kind == "fabrics") reading.fabrics();
  if (axis.kind == "ease") reading.ease();
  if (axis.kind == "place") reading.place();
  if (axis.kind == "postures") reading.postures();
  if (axis.kind == "donnings") reading.donnings();
  if (axis.kind == "levels") reading.levels();
  if (axis.kind == "values") reading.values();
  if (axis.kind == "range") reading.range();
  table.finish();
  if (axis.levels.empty()) throw table.error(axis.kind, "at least one level");
  if (axis.each_case && !axis.sampled)
    throw table.error("each_case", "an axis of chosen values", "an axis that is drawn", {});
  refuse_same_levels(table, axis);
  std::set<std::string> labels;
  for (AxisLevel& level : axis.levels)
    while (!labels.insert(level.label).second) level.label += "'";
  return axis;
}

Axis read_axis_for_each_case(const io::ConfigNode& node, const std::string& file,
                             std::uint64_t study_seed, int count) {
  return read_axis(io::ConfigReader(node, file, "axis"), study_seed, count);
}

const std::vector<ChosenEase>& chosen_ease() {
  static const std::vector<ChosenEase> kKnown = {{"blouse", 0.073, 0.037},
                                                 {"polo-shirt", 0.089, 0.081},
                                                 {"pullover", 0.022, 0.055},
                                                 {"sweater", -0.122, 0.057},
                                                 {"sweatshirt", 0.314, 0.064}};
  return kKnown;
}

}  // namespace loosefit::study
