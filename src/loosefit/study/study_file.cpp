#include "loosefit/study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/io/config_reader.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/io/toml_file.h"
#include "loosefit/study/config_patch.h"

namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

fs::path beside(const std::string& file, const std::string& named) {
  const fs::path path(named);
  return path.is_absolute() ? path : fs::absolute(fs::path(file).parent_path() / path);
}

Design design_of(const std::string& word) {
  for (const Design design : {Design::crossed, Design::paired, Design::latin_hypercube})
    if (word == name(design)) return design;
  return Design::crossed;
}

std::vector<std::string> texts(io::ConfigReader& table, const std::string& key) {
  std::vector<std::string> words;
  const io::ConfigNode* node = table.node(key);
  if (!node) return words;
  if (node->kind != io::ConfigNode::Kind::array) throw table.error(key, "an array of texts");
  for (const io::ConfigNode& item : node->items) {
    if (item.kind != io::ConfigNode::Kind::text)
      throw table.error(key, item.describe(), "an array of texts", {});
    words.push_back(item.text);
  }
  return words;
}

/// The plan names scorecards, and is UTF-8.
void check_utf8(const std::string& card, const std::string& word, const InputPlace& place) {
  if (!valid_utf8(card))
    throw InvalidInput(place, "\"" + printable(word) + "\" in a folder that is not UTF-8",
                       "scorecards by paths in UTF-8");
}

void read_head(io::ConfigReader table, StudyFile& study) {
  table.only({"name", "base", "seed", "design", "samples", "modalities", "looseness", "sensors",
              "spacing", "not_at"});
  study.name = table.text("name", fs::path(study.file).stem().string());
  if (!valid_utf8(study.name))
    throw table.error("name", "nothing, and a file whose name is not UTF-8", "a name of the study",
                      {});
  study.seed = static_cast<std::uint64_t>(table.integer("seed", 1, 0, 1LL << 53));
  study.design =
      design_of(table.choice("design", "crossed", {"crossed", "paired", "latin-hypercube"}));
  const bool drawn = study.design == Design::latin_hypercube;
  if (drawn) table.require("samples", "how many cases");
  if (!drawn && table.has("samples"))
    throw table.error("samples", "samples only with design = \"latin-hypercube\"");
  study.samples = drawn ? static_cast<int>(table.integer("samples", 1, 2, 100000)) : 0;
  for (const std::string& word : texts(table, "modalities")) {
    const bool file = fs::path(word).extension() == ".toml";
    const std::string which = file ? beside(study.file, word).string() : word;
    check_utf8(which, word, {study.file, table.node("modalities")->line, "study.modalities"});
    try {
      io::load_scorecard(which);
    } catch (const InvalidInput& error) {
      if (error.place().file.empty())
        throw table.error("modalities",
                          error.found().empty() ? "\"" + printable(word) + "\"" : error.found(),
                          "names of scorecards", error.hint());
      throw;
    }
    // Results bear the name of the scorecard, wherever its file is.
    const auto name = [](const std::string& modality) { return fs::path(modality).stem(); };
    if (std::any_of(study.modalities.begin(), study.modalities.end(),
                    [&](const std::string& other) { return name(other) == name(which); }))
      throw table.error("modalities", "\"" + printable(name(which).string()) + "\" twice",
                        "each name once", {});
    study.modalities.push_back(which);
  }
  study.looseness = table.text("looseness", "");
  study.sensors = static_cast<int>(table.integer("sensors", 3, 1, 20));
  study.spacing = table.number("spacing", 0.05, {0, 2, "metres"});
  study.not_at = texts(table, "not_at");
  if (const io::ConfigNode* node = table.node("not_at")) study.not_at_line = node->line;
  if (const io::ConfigNode* node = table.node("looseness")) study.looseness_line = node->line;
  if (table.has("base")) {
    const fs::path base = beside(study.file, table.text("base", ""));
    study.base = io::read_toml(base.string());
    study.base_file = base.string();
  }
  table.finish();
}

bool has_values(const Axis& axis) {
  return std::all_of(axis.levels.begin(), axis.levels.end(),
                     [](const AxisLevel& level) { return level.value.has_value(); });
}

std::vector<std::string> axes_with_values(const std::vector<Axis>& axes) {
  std::vector<std::string> names;
  for (const Axis& axis : axes)
    if (has_values(axis)) names.push_back(axis.name);
  return names;
}

/// The axis that changes the fit of the garment, if there is one alone.
std::string fit_axis(const std::vector<Axis>& axes) {
  std::vector<std::string> names;
  for (const Axis& axis : axes)
    if (!axis.levels.empty() &&
        (axis.kind == "ease" || value_at(axis.levels.front().patch, "garment.fit")) &&
        has_values(axis))
      names.push_back(axis.name);
  return names.size() == 1 ? names.front() : "";
}

/// Keys of the scenario that the levels of an axis set. A shift of a place is none: it adds to what
/// others say.
std::set<std::string> keys_set_by(const Axis& axis) {
  std::set<std::string> keys;
  for (const AxisLevel& level : axis.levels) {
    keys.merge(keys_of_values(level.patch));
    if (level.chest_ease) keys.insert(axis.keys.begin(), axis.keys.end());
  }
  return keys;
}

/// What of `keys` is `key`, lies in it or holds it; empty: nothing.
std::string same_key(const std::set<std::string>& keys, const std::string& key) {
  for (std::string whole = key;; whole.resize(whole.rfind('.'))) {
    if (keys.contains(whole)) return whole;
    if (whole.find('.') == std::string::npos) break;
  }
  const auto within = keys.lower_bound(key + ".");
  return within != keys.end() && within->starts_with(key + ".") ? key : "";
}

/// What both axes set; empty: nothing. The constants of a drawn fabric and another card are both
/// what the cloth is: neither would be what its label says.
std::string key_of_both(const Axis& first, const Axis& second) {
  const std::set<std::string> one = keys_set_by(first), other = keys_set_by(second);
  for (const std::string& key : other)
    if (const std::string both = same_key(one, key); !both.empty()) return both;
  const auto drawn = [](const Axis& axis) { return axis.kind == "fabrics" && axis.sampled; };
  const char* const card = "material.name";
  return (drawn(first) && other.contains(card)) || (drawn(second) && one.contains(card)) ? card
                                                                                         : "";
}

/// Of two axes that set one key the later would win, and inputs would tell what nobody had.
void refuse_keys_of_two_axes(const StudyFile& study) {
  for (std::size_t k = 1; k < study.axes.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (const std::string key = key_of_both(study.axes[j], study.axes[k]); !key.empty())
        throw InvalidInput(
            {study.file, study.axis_nodes[k].line, "axis[" + std::to_string(k) + "]"},
            fmt::format("{} in the axes \"{}\" and \"{}\"", printable(key),
                        printable(study.axes[j].name), printable(study.axes[k].name)),
            "each key in one axis",
            key == "material.name" ? "one axis says what the cloth is"
                                   : "levels = [{ set = … }] of one axis may set several keys");
}

}  // namespace

const char* name(Design design) {
  switch (design) {
    case Design::crossed:
      return "crossed";
    case Design::paired:
      return "paired";
    case Design::latin_hypercube:
      return "latin-hypercube";
  }
  return "?";
}

StudyFile read_study_file(const std::string& path) {
  return parse_study_file(io::read_toml_text(path), path);
}

StudyFile parse_study_file(const std::string& text, const std::string& path) {
  StudyFile study;
  study.file = path;
  study.text = text;
  const io::ConfigNode whole = io::parse_toml(text, path);
  io::ConfigReader root(whole, path);
  root.only({"study", "scenario", "axis"});
  study.base_file = path;
  read_head(root.table("study"), study);
  if (root.has("scenario")) {
    io::ConfigNode scenario = *root.node("scenario");
    if (scenario.kind != io::ConfigNode::Kind::table)
      throw root.error("scenario", "tables of a scenario: [scenario.body], …");
    stands_in(scenario, path);
    merge_tables(study.base, scenario);
  }
  const io::ConfigNode* axes = root.node("axis");
  const std::vector<io::ConfigReader> tables = root.tables("axis", "", 50);
  std::set<std::string> names;
  int people = 0;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    Axis axis = read_axis(tables[i], study.seed, study.samples);
    if (!names.insert(axis.name).second)
      throw root.error("axis", "the name \"" + printable(axis.name) + "\" twice", "each once", {});
    // A ranking is left out of the cases of a study: nothing would come of it.
    for (const AxisLevel& level : axis.levels)
      if (level.patch.find("ranking"))
        throw root.error("axis", "ranking in the axis \"" + printable(axis.name) + "\"",
                         "the scorecards of a study as modalities of [study]", {});
    if (axis.is_people() && ++people > 1)
      throw root.error("axis", "people twice", "one axis of people", {});
    study.axes.push_back(std::move(axis));
    study.axis_nodes.push_back(axes->items[i]);
  }
  root.finish();
  refuse_keys_of_two_axes(study);
  std::map<std::string, std::string> axis_of_input;
  for (const Axis& axis : study.axes)
    for (const AxisLevel& level : axis.levels)
      for (const auto& [input, value] : level.inputs)
        if (const std::string& owner = axis_of_input.emplace(input, axis.name).first->second;
            owner != axis.name)
          throw root.error("axis",
                           "the input \"" + printable(input) + "\" of both \"" + printable(owner) +
                               "\" and \"" + printable(axis.name) + "\"",
                           "another name for one of them", {});
  if (study.looseness.empty()) study.looseness = fit_axis(study.axes);
  const auto loose = std::find_if(study.axes.begin(), study.axes.end(),
                                  [&](const Axis& a) { return a.name == study.looseness; });
  if (!study.looseness.empty() && (loose == study.axes.end() || !has_values(*loose)))
    throw InvalidInput({path, study.looseness_line, "study.looseness"},
                       "\"" + printable(study.looseness) + "\"",
                       "the name of an axis whose levels have a value (a BGM)",
                       did_you_mean(study.looseness, axes_with_values(study.axes)));
  if (study.modalities.empty())
    if (const io::ConfigNode* asked = value_at(study.base, "ranking.modality")) {
      const bool file = fs::path(asked->text).extension() == ".toml";
      study.modalities.push_back(file ? beside(study.base_file, asked->text).string()
                                      : asked->text);
      check_utf8(study.modalities.back(), asked->text,
                 {study.base_file, asked->line, "ranking.modality"});
    }
  return study;
}

}  // namespace loosefit::study
