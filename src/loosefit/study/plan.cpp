#include "loosefit/study/plan.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/base/paths.h"
#include "loosefit/base/sha256.h"
#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_site.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/io/seams_file.h"
#include "loosefit/io/text_file.h"
#include "loosefit/placement/resample.h"
#include "loosefit/placement/site_points.h"
#include "loosefit/study/config_patch.h"
#include "loosefit/study/draws.h"

namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

using Kind = io::ConfigNode::Kind;

constexpr std::size_t kMostCases = 1000000;
/// Without a budget of its own a drape of a study ends by iterations alone: by the clock, the same
/// case would end differently on another machine. What a scenario may say at most [s].
constexpr double kNoTimeBudget = 1e6;
/// Names of files are digested up to this size [bytes].
constexpr std::size_t kLargestInput = 500000000;

/// Differs once a name stands for another file, or its content has been written anew; empty where
/// that cannot be told.
std::string state_of(const std::string& path) {
  struct stat found;
  if (stat(path.c_str(), &found) != 0) return {};
  return fmt::format("{} {} {} {}.{}", found.st_dev, found.st_ino, found.st_size,
                     found.st_ctim.tv_sec, found.st_ctim.tv_nsec);
}

/// A file is read again only when it has changed: a plan names the same ones again and again.
std::string digest_of(const std::string& path) {
  struct Known {
    std::string state, digest;
  };
  static std::map<std::string, Known> all;
  Known& known = all[path];
  if (const std::string state = state_of(path); state.empty() || state != known.state)
    known = {state, "sha256:" + sha256_hex(io::read_text_file(path, kLargestInput))};
  return known.digest;
}

/// Where the file of a scorecard is.
std::string card_file(const std::string& modality) {
  if (fs::path(modality).extension() == ".toml") return modality;
  return (data_directory() / "scorecards" / (modality + ".toml")).string();
}

/// Nothing where there are no body data: who runs the case will say so.
std::string body_digest() {
  const std::string path = default_body_data_path();
  return fs::exists(path) ? digest_of(path) : "none";
}

double chest_of(const io::ConfigNode& root) {
  const io::ConfigNode* chest = value_at(root, "body.measurements.chest");
  if (!chest || !(chest->number > 0))
    throw InvalidInput({"", 0, "body.measurements.chest"}, "nothing",
                       "the chest girth of the wearer, since ease in cm is asked for",
                       value_at(root, "body.file")
                           ? "a scan has no measured chest: give body.measurements.chest in place "
                             "of body.file, or use garment.fit"
                           : "give body.measurements.chest, or use garment.fit");
  return chest->number;
}

/// The error of a scenario, with its place, as that of a case.
InvalidInput of_case(const InvalidInput& error, const Plan& plan, const PlannedCase& one) {
  InputPlace place = error.place();
  if (place.file.empty()) place.file = plan.study.file;
  const std::string who = fmt::format("case {} ({})", one.number, plan.label(one));
  if (error.found().empty())
    return InvalidInput(place.str() + ": " + who + ": " + error.what(), error.hint());
  return {place, error.found() + " in " + who, error.expected(), error.hint()};
}

std::size_t checked(std::size_t cases) {
  if (cases > kMostCases)
    throw InvalidInput(fmt::format("a study of more than {} cases", kMostCases),
                       "fewer levels, or design = \"latin-hypercube\" with samples");
  return cases;
}

/// A site that no case has would be left out of nothing.
void check_not_at(const StudyFile& study, const std::set<std::string>& sites) {
  for (const std::string& site : study.not_at)
    if (!sites.count(site))
      throw InvalidInput({study.file, study.not_at_line, "study.not_at"},
                         "\"" + printable(site) + "\"",
                         "names of a [[site]] of the scenario or of preset sites",
                         did_you_mean(site, {sites.begin(), sites.end()}));
}

/// Each of `size` levels equally often, in random order.
std::vector<int> shuffled_levels(int count, int size, std::uint64_t seed) {
  std::vector<int> column = placement::shuffled(count, seed);
  for (int& level : column) level %= size;
  return column;
}

/// Beside what the scenario itself, or another axis, shifts the sensor by.
void apply(const SiteShift& shift, io::ConfigNode& root) {
  const std::string site = "site[" + std::to_string(shift.site) + "]";
  const char* const expected = "the number of a [[site]] of the base scenario, from 0";
  if (!value_at(root, site))
    throw InvalidInput({"", 0, "place.site"}, std::to_string(shift.site), expected);
  if (value_at(root, site + ".from"))
    throw InvalidInput({"", 0, "place.site"}, std::to_string(shift.site) + ", a line,", expected);
  io::ConfigNode both;
  both.kind = Kind::array;
  both.items = {number_node(shift.u), number_node(shift.v)};
  if (const io::ConfigNode* own = value_at(root, site + ".shift")) {
    const auto is_number = [](const io::ConfigNode& item) {
      return item.kind == Kind::integer || item.kind == Kind::number;
    };
    // What is no shift is left for the reader of scenarios to refuse.
    if (own->kind != Kind::array || own->items.size() != 2 ||
        !std::ranges::all_of(own->items, is_number))
      return;
    for (std::size_t i = 0; i < 2; ++i) both.items[i].number += own->items[i].number;
    both.line = own->line;
    stands_in(both, own->file);
  }
  set_value(root, site + ".shift", both);
}

}  // namespace

int Plan::drapes() const {
  int sum = 0;
  for (const PlannedCase& one : cases) sum += one.drapes;
  return sum;
}

std::string Plan::label(const PlannedCase& one) const {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < study.axes.size(); ++k) {
    const std::string& label = study.axes[k].levels[one.levels[k]].label;
    words.push_back(study.axes[k].is_people() ? label : study.axes[k].name + " " + label);
  }
  return words.empty() ? "the base scenario" : join(words);
}

std::vector<std::vector<int>> design_matrix(Design design, const std::vector<int>& sizes,
                                            int samples, std::uint64_t seed) {
  std::vector<std::vector<int>> rows;
  if (design == Design::crossed) {
    std::size_t count = 1;
    for (const int size : sizes) count = checked(count * static_cast<std::size_t>(size));
    rows.assign(count, std::vector<int>(sizes.size()));
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t rest = i;
      for (std::size_t k = sizes.size(); k-- > 0; rest /= sizes[k])
        rows[i][k] = static_cast<int>(rest % sizes[k]);
    }
    return rows;
  }
  if (design == Design::paired) {
    const int count = sizes.empty() ? 1 : *std::max_element(sizes.begin(), sizes.end());
    for (const int size : sizes)
      if (size != 1 && size != count)
        throw InvalidInput({"", 0, "study.design"},
                           fmt::format("\"paired\" with axes of {} and {} levels", size, count),
                           "axes of the same length, or of one level");
    for (int i = 0; i < count; ++i) {
      rows.emplace_back();
      for (const int size : sizes) rows.back().push_back(size == 1 ? 0 : i);
    }
    return rows;
  }
  rows.assign(checked(samples), std::vector<int>(sizes.size()));
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const std::vector<int> column =
        shuffled_levels(samples, sizes[k], seed_for(seed, "column " + std::to_string(k)));
    for (int i = 0; i < samples; ++i) rows[i][k] = column[i];
  }
  return rows;
}

namespace {

/// Whether the shifts that the scenario itself has are such as it may have. What a place adds must
/// not hide one that is too far.
bool may_shift(const StudyFile& study, const std::vector<int>& levels, const io::ConfigNode& root) {
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const auto& shift = study.axes[k].levels[levels[k]].shift;
    if (!shift) continue;
    const io::ConfigNode* own = value_at(root, "site[" + std::to_string(shift->site) + "].shift");
    if (own && own->kind == Kind::array &&
        !std::ranges::all_of(own->items, [](const io::ConfigNode& item) {
          return std::abs(item.number) <= io::kMostSiteShift;
        }))
      return false;
  }
  return true;
}

/// The base scenario with what each of these levels changes.
io::ConfigNode composed(const StudyFile& study, const std::vector<int>& levels) {
  io::ConfigNode root = study.base;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    io::ConfigNode patch = study.axes[k].levels[levels[k]].patch;
    stands_in(patch, study.file);
    merge_tables(root, patch);
  }
  // What it refuses is left for the reader of scenarios.
  const bool shifts = may_shift(study, levels, root);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const AxisLevel& level = study.axes[k].levels[levels[k]];
    if (level.shift && shifts) apply(*level.shift, root);
    if (!level.chest_ease) continue;
    const double bgm = std::round(1e4 * *level.chest_ease / chest_of(root)) / 1e4;
    for (const std::string& key : study.axes[k].keys) set_value(root, key, number_node(bgm));
  }
  return root;
}

scenario::Scenario scenario_of(const io::ConfigNode& root, const StudyFile& study) {
  const bool budget = value_at(root, "simulation.time_budget") != nullptr;
  scenario::Scenario scenario = io::scenario_of(root, study.base_file);
  if (!budget) scenario.simulation.time_budget = kNoTimeBudget;
  scenario.simulation.threads = 0;
  scenario.ranking = {};
  return scenario;
}

/// Where a case lies on the axis of looseness: ease that is asked for in metres is a BGM of its own
/// for each wearer. Nothing without such an axis.
std::optional<double> looseness_of(const StudyFile& study, const std::vector<int>& levels,
                                   const io::ConfigNode& root) {
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const Axis& axis = study.axes[k];
    if (axis.name != study.looseness) continue;
    const AxisLevel& level = axis.levels[levels[k]];
    return level.chest_ease ? value_at(root, axis.keys.front())->number : level.value;
  }
  return {};
}

}  // namespace

scenario::Scenario compose(const StudyFile& study, const std::vector<int>& levels) {
  return scenario_of(composed(study, levels), study);
}

std::string case_address(const scenario::Scenario& scenario,
                         const std::vector<std::string>& modalities) {
  scenario::Scenario content = scenario;
  content.simulation.threads = 0;
  content.ranking = {};
  const scenario::ScenarioOutput usual;
  content.output.views = usual.views;
  content.output.undecorated = usual.undecorated;
  content.output.width = usual.width;
  content.output.height = usual.height;
  if (!content.body.file.empty()) content.body.file = digest_of(content.body.file);
  for (scenario::ScenarioGarment& garment : content.garments) {
    if (garment.spec.file.empty()) continue;
    const fs::path seams = io::side_file(garment.spec.file, fs::path(garment.spec.seams));
    garment.spec.seams = seams.empty() ? "" : digest_of(seams.string());
    garment.spec.file = digest_of(garment.spec.file);
  }
  std::string text =
      "loosefit case 4\n" + version() + "\n" + body_digest() + "\n" + io::scenario_toml(content);
  for (const std::string& modality : modalities) {
    const placement::Scorecard card = io::load_scorecard(modality);
    text += "\nscorecard " + card.name + " " + digest_of(card_file(modality));
  }
  return sha256_hex(text);
}

namespace {

/// What the resolved scenario says of the body: its posture, or all else.
std::string body_lines(const scenario::Scenario& scenario, bool posture) {
  scenario::Scenario content = scenario;
  if (!content.body.file.empty()) content.body.file = digest_of(content.body.file);
  std::istringstream lines(io::scenario_toml(content));
  std::string text, line;
  bool in_body = false;
  while (std::getline(lines, line)) {
    if (line.starts_with("[")) in_body = line == "[body]";
    if (in_body && line.starts_with("posture =") == posture && !line.starts_with("dress_posture ="))
      text += line + "\n";
  }
  return text;
}

std::string short_digest(const std::string& text) {
  constexpr std::size_t kDigits = 16;
  return sha256_hex(text).substr(0, kDigits);
}

}  // namespace

std::string wearer_digest(const scenario::Scenario& scenario) {
  return short_digest(body_lines(scenario, false));
}

std::string wearing_digest(const scenario::Scenario& scenario) {
  std::string text = body_lines(scenario, true);
  // The first of a list is the reference posture, which is told already.
  for (std::size_t k = 1; k < scenario.postures.size(); ++k) text += scenario.postures[k] + "\n";
  if (scenario.donning.first_drawn) text += "drawn\n";
  return short_digest(text + std::to_string(scenario.donning.seed));
}

std::vector<std::string> idle_axes(const Plan& plan) {
  std::vector<std::string> idle;
  for (std::size_t k = 0; k < plan.study.axes.size(); ++k) {
    std::map<std::vector<int>, std::pair<std::set<int>, std::set<std::string>>> alike;
    for (const PlannedCase& one : plan.cases) {
      std::vector<int> others = one.levels;
      others[k] = 0;
      auto& [levels, addresses] = alike[others];
      levels.insert(one.levels[k]);
      addresses.insert(one.address);
    }
    const auto differs = [](const auto& entry) { return entry.second.first.size() > 1; };
    const auto changes = [](const auto& entry) { return entry.second.second.size() > 1; };
    if (std::ranges::any_of(alike, differs) && std::ranges::none_of(alike, changes))
      idle.push_back(plan.study.axes[k].name);
  }
  return idle;
}

std::vector<std::string> left_to_base(const Plan& plan) {
  std::vector<std::string> told;
  for (const char* what : {"sex", "age"}) {
    const auto sets = [&](const AxisLevel& level) {
      return value_at(level.patch, std::string("body.") + what) != nullptr;
    };
    const auto some_set = [&](const Axis& axis) { return std::ranges::any_of(axis.levels, sets); };
    // A file has a column for all its people or for none.
    const auto people = std::ranges::find_if(plan.study.axes, &Axis::is_people);
    if (people != plan.study.axes.end() && std::ranges::none_of(plan.study.axes, some_set))
      told.push_back(fmt::format("people of axis {} have no {}: all take that of [scenario.body]",
                                 people->name, what));
  }
  return told;
}

int same_as_others(const Plan& plan) {
  std::set<std::string> addresses;
  for (const PlannedCase& one : plan.cases) addresses.insert(one.address);
  return static_cast<int>(plan.cases.size() - addresses.size());
}

int drapes_of(const scenario::Scenario& scenario) {
  const int postures = std::max<int>(1, static_cast<int>(scenario.postures.size()));
  return postures * scenario.donning.repeats;
}

Plan make_plan(const StudyFile& study) {
  Plan plan;
  plan.study = study;
  std::vector<int> sizes;
  // A Latin hypercube draws every axis anew for each case anyway.
  const auto anew = [&](const Axis& axis) {
    return axis.each_case && study.design != Design::latin_hypercube;
  };
  for (const Axis& axis : study.axes)
    sizes.push_back(anew(axis) ? 1 : static_cast<int>(axis.levels.size()));
  const std::vector<std::vector<int>> rows = [&] {
    try {
      return design_matrix(study.design, sizes, study.samples, seed_for(study.seed, "design"));
    } catch (const InvalidInput& error) {
      throw error.at({study.file, 0, "study.design"});
    }
  }();
  const int count = static_cast<int>(rows.size());
  std::vector<std::vector<int>> columns(study.axes.size());
  for (std::size_t k = 0; k < study.axes.size(); ++k)
    if (anew(study.axes[k])) {
      plan.study.axes[k] =
          read_axis_for_each_case(study.axis_nodes[k], study.file, study.seed, count);
      columns[k] =
          placement::shuffled(count, seed_for(study.seed, "each case " + study.axes[k].name));
    }
  std::set<std::string> sites;
  bool presets = false;
  for (int i = 0; i < count; ++i) {
    PlannedCase one;
    one.number = i + 1;
    one.levels = rows[i];
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (!columns[k].empty()) one.levels[k] = columns[k][i];
    try {
      const io::ConfigNode root = composed(plan.study, one.levels);
      const scenario::Scenario scenario = scenario_of(root, plan.study);
      if (scenario.simulation.repeats > 1)
        throw InvalidInput({study.file, 0, "simulation.repeats"},
                           std::to_string(scenario.simulation.repeats),
                           "1: drapes of a study that differ are those of donning.repeats");
      one.looseness = looseness_of(plan.study, one.levels, root);
      one.toml = io::scenario_toml(scenario);
      // As who runs it reads it: what is written may differ in the last bit of an angle.
      one.address = case_address(io::parse_scenario(one.toml, study.base_file), study.modalities);
      one.drapes = drapes_of(scenario);
      one.edge_length = scenario.simulation.edge_length;
      one.wearer = wearer_digest(scenario);
      one.wearing = wearing_digest(scenario);
      one.several_postures = scenario.postures.size() > 1;
      one.several_donnings = scenario.donning.repeats > 1;
      for (const std::string& note : scenario.simulation.notes)
        plan.notes.insert("simulation: " + note);
      for (const placement::SiteSpec& site : scenario.sites) sites.insert(site.name);
      presets |= scenario.output.preset_sites;
    } catch (const InvalidInput& error) {
      throw of_case(error, plan, one);
    }
    plan.cases.push_back(std::move(one));
  }
  if (presets)
    for (const std::string& preset : placement::preset_names()) sites.insert(preset);
  check_not_at(study, sites);
  for (const std::string& modality : study.modalities)
    plan.cards.push_back(io::read_text_file(card_file(modality), kLargestInput));
  return plan;
}

namespace {

double estimated_core_seconds(const PlannedCase& one) {
  // Measured on shirts of adults (docs/scaling.md): body, pattern and measuring of a case; of a
  // drape what is done with bodies and coarse meshes whatever the edge (putting on, wearing in),
  // and the finest one at 10 mm, whose time grows with the number of vertices to the power of 1.25.
  constexpr double kCase = 4, kCoarse = 4, kFine = 16, kEdge = 0.010, kPower = 2.5;
  return kCase + one.drapes * (kCoarse + kFine * std::pow(kEdge / one.edge_length, kPower));
}

}  // namespace

std::map<std::string, double> estimated_work(const Plan& plan) {
  std::map<std::string, double> work;
  for (const PlannedCase& one : plan.cases) work[one.address] = estimated_core_seconds(one);
  return work;
}

}  // namespace loosefit::study
