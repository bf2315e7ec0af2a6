#include "command_pattern.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/measures_file.h"
#include "loosefit/io/pattern_svg.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_place.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/find_size.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/study/case_body.h"
#include "loosefit/study/case_pattern.h"

namespace loosefit {
namespace {

/// A number that an option of the command line gives.
struct NumberOption {
  std::string name;  ///< of the option, without the dashes
  std::string key;   ///< KindMeasure::name or KindKey::name
  std::string help;
  bool degrees = false;  ///< the key is in radians
};

std::string dashed(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

void add_once(std::vector<NumberOption>& options, const NumberOption& option) {
  for (const NumberOption& other : options)
    if (other.name == option.name) return;
  options.push_back(option);
}

/// Measures of the body that any kind of garment asks for.
std::vector<NumberOption> measure_options() {
  std::vector<NumberOption> options;
  for (const kinds::GarmentKind& kind : kinds::garment_kinds())
    for (const kinds::KindMeasure& m : kind.measures) {
      const bool angle = m.unit == "rad";
      add_once(options, {dashed(m.name) + (angle ? "-deg" : ""), m.name,
                         angle ? "of the body [degrees]" : "of the body [m]", angle});
    }
  return options;
}

/// Keys of [garment.fit] of any kind of garment.
std::vector<NumberOption> fit_options() {
  std::vector<NumberOption> options;
  for (const kinds::GarmentKind& kind : kinds::garment_kinds())
    for (const kinds::KindKey& key : kind.keys)
      add_once(options, {(key.mobility ? "fit-" : "") + dashed(key.name), key.name,
                         key.meaning + (key.mobility ? ": garment girth / body girth - 1"
                                                     : " (" + key.unit + ")")});
  return options;
}

struct Wish {
  std::string file, size, body, scenario, out;
  std::string kind = kinds::garment_kinds().front().name;
  bool kind_given = false;
  bool list_sizes = false;
  std::map<std::string, std::optional<double>> measures, fit;  ///< by name of the option
};

bool any(const std::map<std::string, std::optional<double>>& wishes) {
  for (const auto& [name, value] : wishes)
    if (value) return true;
  return false;
}

/// The pattern and how it fits the body it is compared with, if there is one.
struct Made {
  pattern::Pattern pattern;
  std::vector<kinds::FitLevel> levels;
  std::string details;  ///< of the draft
  std::vector<std::string> warnings;
};

/// Measures that the user gave over those of a body; their keys go into `asked`.
void override_measures(const Wish& wish, kinds::NamedValues& measures,
                       std::set<std::string>& asked) {
  for (const NumberOption& option : measure_options())
    if (const auto& value = wish.measures.at(option.name)) {
      measures[option.key] = option.degrees ? radians(*value) : *value;
      asked.insert("measures." + option.key);
    }
}

/// What a scenario with these options would ask for.
scenario::GarmentSpec garment_of(const Wish& wish, const kinds::GarmentKind& kind) {
  scenario::GarmentSpec garment;
  garment.kind = wish.kind;
  garment.size = wish.size;
  for (const kinds::KindKey& key : kind.keys) garment.adapt.push_back(key.name);
  for (const NumberOption& option : fit_options()) {
    const auto& value = wish.fit.at(option.name);
    if (!value) continue;
    if (std::erase(garment.adapt, option.key) == 0)
      throw InvalidInput({{}, 0, "--" + option.name}, "an option that a " + kind.title + " has not",
                         "keys of its fit: " + join(garment.adapt));
    garment.fit[option.key] = *value;
  }
  return garment;
}

Made make(const Wish& wish) {
  Made made;
  const int sources = !wish.file.empty() + !wish.size.empty() + !wish.scenario.empty();
  const bool fixed = !wish.file.empty() || !wish.scenario.empty();
  if (sources > 1 || (sources == 1 && any(wish.fit)) || (fixed && wish.kind_given))
    throw InvalidInput({{}, 0, "pattern"}, "several sources of the pattern",
                       "one of --file, --size, --scenario, or measures with a fit");
  // A scenario brings body and garment.
  if (!wish.scenario.empty()) {
    const scenario::Scenario scenario = io::read_scenario(wish.scenario);
    try {
      study::CasePattern result =
          study::make_pattern(scenario.studied().spec, study::make_body(scenario.body).body);
      return {std::move(result.pattern), std::move(result.levels), {}, std::move(result.warnings)};
    } catch (const InvalidInput& error) {
      throw io::in_scenario(error, scenario);
    }
  }
  // A pattern file tells its kind, which tells the measures that it is compared with.
  std::string kind_name = wish.kind;
  if (!wish.file.empty()) {
    io::PatternFile file = io::read_garmentcode(wish.file);
    made.pattern = std::move(file.pattern);
    made.warnings = std::move(file.warnings);
    kind_name = made.pattern.kind;
  }
  const kinds::GarmentKind& kind = kinds::garment_kind(kind_name);
  const bool has_body = !wish.body.empty() || any(wish.measures);
  kinds::NamedValues measures;
  std::set<std::string> asked;
  if (!wish.body.empty())
    measures = io::read_measures(wish.body, kind.measures);
  else if (wish.size.empty() && (wish.file.empty() || has_body))
    measures =
        kinds::draft_measures(kind, study::make_body(io::default_scenario().body).body->measured);
  override_measures(wish, measures, asked);
  if (!wish.file.empty()) {
    made.levels = kind.levels(made.pattern, measures, {});
    return made;
  }
  // A draft; a size is compared with its own body unless there is another one.
  if (!wish.size.empty()) try {
      const kinds::KindSize& size = kinds::find_size(kind.sizes, wish.size);
      if (!has_body) measures = size.measures;
    } catch (const InvalidInput& error) {
      throw error.at({{}, 0, "--size"});
    }
  kinds::DraftedGarment drafted = study::draft_garment(garment_of(wish, kind), measures, asked);
  made.pattern = std::move(drafted.pattern);
  made.levels = kind.levels(made.pattern, measures, drafted.fit);
  made.details = std::move(drafted.details);
  made.warnings = std::move(drafted.notes);
  return made;
}

void print_girths(const std::vector<kinds::FitLevel>& levels) {
  if (levels.empty()) return;
  fmt::print("{:<10} {:>9} {:>11} {:>8}\n", "level", "body [m]", "garment [m]", "BGM");
  for (const kinds::FitLevel& level : levels)
    if (level.body)
      fmt::print("{:<10} {:>9.4f} {:>11.4f} {:>+8.4f}\n", level.name, *level.body, level.garment,
                 level.garment / *level.body - 1);
    else
      fmt::print("{:<10} {:>9} {:>11.4f} {:>8}\n", level.name, "", level.garment, "");
  fmt::print("\n");
}

void print_pieces(const pattern::Pattern& pattern) {
  fmt::print("{:<18} {:>10} {:>11} {:>10} {:>7}\n", "piece", "width [mm]", "height [mm]",
             "area [cm2]", "edges");
  double total = 0;
  for (const pattern::Panel& panel : pattern.panels) {
    const std::vector<Vec2> outline = pattern::outline_polygon(panel);
    Vec2 low = outline[0], high = outline[0];
    for (const Vec2& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double area = pattern::signed_area(outline);
    total += area;
    fmt::print("{:<18} {:>10.1f} {:>11.1f} {:>10.1f} {:>7}\n", terminal_line(panel.name),
               1000 * (high - low).x(), 1000 * (high - low).y(), 1e4 * area, panel.edges.size());
  }
  fmt::print("{} pieces, {:.4f} m2\n\n", pattern.panels.size(), total);
}

void print_seams(const pattern::Pattern& pattern) {
  fmt::print("{:>2} {:<18} {:<32} {:<32} {:>11} {:>9}\n", "", "seam", "first side", "second side",
             "length [mm]", "diff [mm]");
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const pattern::Stitch& stitch = pattern.stitches[s];
    const auto side = [&](const pattern::Stitch::Side& end) {
      const pattern::Panel& panel = pattern.panels[end.panel];
      return std::make_pair(terminal_line(panel.name + "." + panel.edges[end.edge].name),
                            1000 * pattern::EdgePath(panel, end.edge).length());
    };
    const auto [first, length_a] = side(stitch.first);
    const auto [second, length_b] = side(stitch.second);
    fmt::print("{:>2} {:<18} {:<32} {:<32} {:>11.2f} {:>9.3f}{}\n", s + 1,
               terminal_line(stitch.name), first, second, length_a, length_b - length_a,
               stitch.right_wrong ? "  right to wrong" : "");
  }
}

/// Body and garment at the levels of fit that a size has both for.
void print_sizes(const kinds::GarmentKind& kind) {
  for (const kinds::KindSize& size : kind.sizes) {
    const kinds::DraftedGarment garment = kind.draft({{}, size.name, {}, {}});
    std::vector<std::string> names, bodies, girths;
    for (const kinds::FitLevel& level : kind.levels(garment.pattern, size.measures, garment.fit)) {
      if (!level.body) continue;
      names.push_back(level.name);
      bodies.push_back(fmt::format("{:.2f}", *level.body));
      girths.push_back(fmt::format("{:.3f}", level.garment));
    }
    fmt::print("{:<10} {}: body {} m, garment {} m\n", size.name, join(names, "/"),
               join(bodies, "/"), join(girths, "/"));
    fmt::print("           {}\n", size.source);
  }
}

void run(const Wish& wish) {
  if (wish.list_sizes) return print_sizes(kinds::garment_kind(wish.kind));
  const Made made = make(wish);
  for (const std::string& warning : made.warnings)
    fmt::print(stderr, "warning: {}\n", terminal_line(warning));
  fmt::print("{}\n\n", terminal_line(made.pattern.name));
  print_girths(made.levels);
  print_pieces(made.pattern);
  print_seams(made.pattern);
  if (!made.details.empty()) fmt::print("\n{}\n", made.details);
  if (wish.out.empty()) return;
  io::RunFolder folder = io::RunFolder::add(wish.out, "pattern");
  io::write_garmentcode(folder.path() / "pattern.json", made.pattern);
  io::write_pattern_svg(folder.path() / "pattern.svg", made.pattern);
  folder.commit();
  fmt::print("\nwrote {}/pattern.json, pattern.svg\n", terminal_line(wish.out));
}

}  // namespace

void add_pattern_command(CLI::App& app) {
  auto* command = app.add_subcommand(
      "pattern", "draft a garment from measures, a body or a size, or read a pattern file");
  auto wish = std::make_shared<Wish>();
  command
      ->add_option_function<std::string>(
          "--pattern",
          [wish](const std::string& kind) { wish->kind = kind, wish->kind_given = true; },
          join(kinds::drafted_kinds()) + "; default " + wish->kind)
      ->check(CLI::IsMember(kinds::drafted_kinds()));
  command->add_option("--file", wish->file, "GarmentCode specification JSON instead of the draft");
  command->add_option("--size", wish->size, "garment size, e.g. child-142, women-38, men-M");
  command->add_flag("--list-sizes", wish->list_sizes, "all sizes with their source");
  command->add_option("--body", wish->body,
                      "body.json of `loosefit body`, or JSON with measures; default: the body of a "
                      "scenario without [body]");
  command->add_option("--scenario", wish->scenario, "body and garment of a scenario file");
  for (const NumberOption& option : measure_options())
    command->add_option("--" + option.name, wish->measures[option.name], option.help);
  for (const NumberOption& option : fit_options())
    command->add_option("--" + option.name, wish->fit[option.name],
                        option.help + "; as [garment.fit] of a scenario");
  command->add_option("-o,--output", wish->out, "folder for pattern.json and pattern.svg");
  command->callback([wish] { run(*wish); });
}

}  // namespace loosefit
