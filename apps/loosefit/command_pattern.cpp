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
#include "loosefit/pattern/garment_size.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/study/case_body.h"
#include "loosefit/study/case_pattern.h"

namespace loosefit {
namespace {

struct Wish {
  std::string file, size, body, scenario, out;
  std::string kind = shirt_kinds().front();
  bool kind_given = false;
  bool list_sizes = false;
  std::map<std::string, std::optional<double>> measures, fit;
};

/// What can be said of a body's measures by option name.
std::map<std::string, double ShirtMeasures::*> measure_fields() {
  return {{"chest", &ShirtMeasures::chest},
          {"waist", &ShirtMeasures::waist},
          {"hip", &ShirtMeasures::hip},
          {"neck", &ShirtMeasures::neck},
          {"upper-arm", &ShirtMeasures::upper_arm},
          {"wrist", &ShirtMeasures::wrist},
          {"shoulder-breadth", &ShirtMeasures::shoulder_breadth},
          {"scye-depth", &ShirtMeasures::scye_depth},
          {"hps-to-waist", &ShirtMeasures::hps_to_waist},
          {"hps-to-hem", &ShirtMeasures::hps_to_hem},
          {"arm-length", &ShirtMeasures::arm_length}};
}

std::map<std::string, double ShirtFit::*> fit_fields() {
  return {{"fit-chest", &ShirtFit::chest},
          {"fit-hip", &ShirtFit::hip},
          {"fit-sleeve", &ShirtFit::sleeve},
          {"fit-wrist", &ShirtFit::wrist},
          {"neck-ease", &ShirtFit::neck_ease},
          {"scye-ease", &ShirtFit::scye_ease},
          {"shoulder-follow", &ShirtFit::shoulder_follow},
          {"cap-ease", &ShirtFit::cap_ease},
          {"sleeve-length", &ShirtFit::sleeve_length}};
}

/// The name in a scenario of what an option sets: "fit-chest" and "neck-ease" are chest, neck_ease.
std::string scenario_name(std::string option) {
  if (option.starts_with("fit-")) option.erase(0, 4);
  std::replace(option.begin(), option.end(), '-', '_');
  return option;
}

bool any(const std::map<std::string, std::optional<double>>& wishes) {
  for (const auto& [name, value] : wishes)
    if (value) return true;
  return false;
}

/// The pattern and the body it is compared with, if there is one.
struct Made {
  Pattern pattern;
  std::optional<ShirtMeasures> body;
  std::optional<ShirtDraftReport> draft;
  std::optional<double> cuff_on;  ///< girth of the arm where a short sleeve ends [m]
  std::vector<std::string> warnings;
};

/// Measures that the user gave over those of a body; their keys go into `asked`.
void override_measures(const Wish& wish, ShirtMeasures& measures, std::set<std::string>& asked) {
  for (const auto& [name, field] : measure_fields())
    if (const auto& value = wish.measures.at(name)) {
      measures.*field = *value;
      asked.insert("measures." + scenario_name(name));
    }
  if (const auto& slope = wish.measures.at("shoulder-slope-deg")) {
    measures.shoulder_slope = radians(*slope);
    asked.insert("measures.shoulder_slope");
  }
}

/// What a scenario with these options would ask for.
GarmentSpec garment_of(const Wish& wish) {
  GarmentSpec garment;
  garment.pattern = wish.kind;
  garment.fit = usual_fit(wish.kind);
  garment.size = wish.size;
  garment.adapt = shirt_fit_names();
  const auto given = [&](const std::string& option) {
    std::erase(garment.adapt, scenario_name(option));
  };
  for (const auto& [name, field] : fit_fields())
    if (const auto& value = wish.fit.at(name)) garment.fit.*field = *value, given(name);
  garment.fit.waist = wish.fit.at("fit-waist");
  if (garment.fit.waist) given("fit-waist");
  return garment;
}

Made make(const Wish& wish) {
  Made made;
  const int sources = !wish.file.empty() + !wish.size.empty() + !wish.scenario.empty();
  const bool fixed = !wish.file.empty() || !wish.scenario.empty();
  if (sources > 1 || (sources == 1 && any(wish.fit)) || (fixed && wish.kind_given))
    throw InvalidInput({{}, 0, "pattern"}, "several sources of the pattern",
                       "one of --file, --size, --scenario, or measures with a fit");
  const GarmentSpec garment = garment_of(wish);
  if (!wish.size.empty() && !garment_size(wish.size))
    throw InvalidInput({{}, 0, "--size"}, '"' + printable(wish.size) + '"', "a garment size",
                       did_you_mean(wish.size, garment_size_names()));
  const bool has_body = !wish.body.empty() || any(wish.measures);
  ShirtMeasures measures;
  std::set<std::string> asked;
  if (!wish.body.empty())
    measures = read_measures(wish.body);
  else if (wish.scenario.empty() && wish.size.empty() && (wish.file.empty() || has_body))
    measures = shirt_measures(make_body(default_scenario().body).body);
  override_measures(wish, measures, asked);

  if (!wish.file.empty()) {
    PatternFile file = read_garmentcode(wish.file);
    made.pattern = std::move(file.pattern);
    made.warnings = std::move(file.warnings);
    if (has_body) made.body = measures;
    return made;
  }
  if (!wish.scenario.empty()) {
    const Scenario scenario = read_scenario(wish.scenario);
    try {
      const Body body = make_body(scenario.body).body;
      CasePattern result = make_pattern(scenario.studied().spec, body);
      made.pattern = std::move(result.pattern);
      made.warnings = std::move(result.warnings);
      made.body = shirt_measures(body);
    } catch (const InvalidInput& error) {
      throw in_scenario(error, scenario);
    }
    return made;
  }
  AdaptedShirt shirt = draft_garment(garment, measures, asked);
  made.pattern = std::move(shirt.pattern);
  made.warnings = std::move(shirt.notes);
  made.draft = shirt.report;
  if (wish.size.empty())
    made.body = measures;
  else
    made.body = has_body ? measures : garment_size(wish.size)->body;
  if (shirt.fit.sleeve_length < 1) made.cuff_on = arm_girth_at(*made.body, shirt.fit.sleeve_length);
  return made;
}

void print_girths(const Made& made) {
  const auto girths = shirt_girths(made.pattern, made.body ? made.body->hps_to_waist : 0);
  if (girths.empty()) return;
  fmt::print("{:<10} {:>9} {:>11} {:>8}\n", "level", "body [m]", "garment [m]", "BGM");
  const std::map<std::string, double ShirtMeasures::*> body_girth = {
      {"chest", &ShirtMeasures::chest},
      {"waist", &ShirtMeasures::waist},
      {"hip", &ShirtMeasures::hip},
      {"sleeve", &ShirtMeasures::upper_arm},
      {"wrist", &ShirtMeasures::wrist}};
  for (const char* level : {"chest", "waist", "hip", "sleeve", "wrist"}) {
    const auto girth = girths.find(level);
    if (girth == girths.end()) continue;
    if (!made.body) {
      if (std::string(level) == "waist") continue;  // its level is a measure of the body
      fmt::print("{:<10} {:>9} {:>11.4f} {:>8}\n", level, "", girth->second, "");
      continue;
    }
    const bool cuff = std::string(level) == "wrist" && made.cuff_on;
    const double body = cuff ? *made.cuff_on : *made.body.*body_girth.at(level);
    fmt::print("{:<10} {:>9.4f} {:>11.4f} {:>+8.4f}\n", cuff ? "cuff" : level, body, girth->second,
               girth->second / body - 1);
  }
  fmt::print("\n");
}

void print_pieces(const Pattern& pattern) {
  fmt::print("{:<18} {:>10} {:>11} {:>10} {:>7}\n", "piece", "width [mm]", "height [mm]",
             "area [cm2]", "edges");
  double total = 0;
  for (const Panel& panel : pattern.panels) {
    const std::vector<Vec2> outline = outline_polygon(panel);
    Vec2 low = outline[0], high = outline[0];
    for (const Vec2& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double area = signed_area(outline);
    total += area;
    fmt::print("{:<18} {:>10.1f} {:>11.1f} {:>10.1f} {:>7}\n", terminal_line(panel.name),
               1000 * (high - low).x(), 1000 * (high - low).y(), 1e4 * area, panel.edges.size());
  }
  fmt::print("{} pieces, {:.4f} m2\n\n", pattern.panels.size(), total);
}

void print_seams(const Pattern& pattern) {
  fmt::print("{:>2} {:<18} {:<32} {:<32} {:>11} {:>9}\n", "", "seam", "first side", "second side",
             "length [mm]", "diff [mm]");
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    const auto side = [&](const Stitch::Side& end) {
      const Panel& panel = pattern.panels[end.panel];
      return std::make_pair(terminal_line(panel.name + "." + panel.edges[end.edge].name),
                            1000 * EdgePath(panel, end.edge).length());
    };
    const auto [first, length_a] = side(stitch.first);
    const auto [second, length_b] = side(stitch.second);
    fmt::print("{:>2} {:<18} {:<32} {:<32} {:>11.2f} {:>9.3f}{}\n", s + 1,
               terminal_line(stitch.name), first, second, length_a, length_b - length_a,
               stitch.right_wrong ? "  right to wrong" : "");
  }
}

void print_sizes() {
  for (const std::string& name : garment_size_names()) {
    const GarmentSize size = *garment_size(name);
    const auto girths = shirt_girths(draft_shirt(size.body, size.fit), size.body.hps_to_waist);
    fmt::print("{:<10} body {:.2f}/{:.2f}/{:.2f} m, garment {:.3f}/{:.3f}/{:.3f} m\n", name,
               size.body.chest, size.body.waist, size.body.hip, girths.at("chest"),
               girths.at("waist"), girths.at("hip"));
    fmt::print("           {}\n", size.source);
  }
}

void run(const Wish& wish) {
  if (wish.list_sizes) return print_sizes();
  const Made made = make(wish);
  for (const std::string& warning : made.warnings)
    fmt::print(stderr, "warning: {}\n", terminal_line(warning));
  fmt::print("{}\n\n", terminal_line(made.pattern.name));
  print_girths(made);
  print_pieces(made.pattern);
  print_seams(made.pattern);
  if (made.draft)
    fmt::print(
        "\narmhole {:.1f} mm, depth {:.1f} mm, cap height {:.1f} mm (ratio {:.2f}), underarm "
        "lowered {:.1f} mm, shoulder dropped {:.1f} mm\n",
        1000 * made.draft->armhole, 1000 * made.draft->armhole_depth, 1000 * made.draft->cap_height,
        made.draft->cap_ratio, 1000 * made.draft->deepened, 1000 * made.draft->dropped);
  if (wish.out.empty()) return;
  RunFolder folder = RunFolder::add(wish.out, "pattern");
  write_garmentcode(folder.path() / "pattern.json", made.pattern);
  write_pattern_svg(folder.path() / "pattern.svg", made.pattern);
  folder.commit();
  fmt::print("\nwrote {}/pattern.json, pattern.svg\n", terminal_line(wish.out));
}

}  // namespace

void add_pattern_command(CLI::App& app) {
  auto* command = app.add_subcommand(
      "pattern", "draft the shirt from measures, a body or a size, or read a pattern file");
  auto wish = std::make_shared<Wish>();
  command
      ->add_option_function<std::string>(
          "--pattern",
          [wish](const std::string& kind) { wish->kind = kind, wish->kind_given = true; },
          join(shirt_kinds()) + "; default " + shirt_kinds().front())
      ->check(CLI::IsMember(shirt_kinds()));
  command->add_option("--file", wish->file, "GarmentCode specification JSON instead of the draft");
  command->add_option("--size", wish->size, "garment size, e.g. child-142, women-38, men-M");
  command->add_flag("--list-sizes", wish->list_sizes, "all sizes with their source");
  command->add_option("--body", wish->body,
                      "body.json of `loosefit body`, or JSON with measures; default: the body of a "
                      "scenario without [body]");
  command->add_option("--scenario", wish->scenario, "body and garment of a scenario file");
  for (const auto& [name, field] : measure_fields())
    command->add_option("--" + name, wish->measures[name], "of the body [m]");
  command->add_option("--shoulder-slope-deg", wish->measures["shoulder-slope-deg"],
                      "of the body [degrees]");
  for (const auto& [name, field] : fit_fields()) wish->fit[name];
  const char* mobility =
      "body-garment mobility: garment girth / body girth - 1; as [garment.fit] of a scenario";
  for (const char* name : {"fit-chest", "fit-waist", "fit-hip", "fit-sleeve", "fit-wrist"})
    command->add_option(std::string("--") + name, wish->fit[name], mobility);
  command->add_option("--neck-ease", wish->fit["neck-ease"], "share added to the neck width");
  command->add_option("--scye-ease", wish->fit["scye-ease"], "underarm below the armpit [m]");
  command->add_option("--shoulder-follow", wish->fit["shoulder-follow"],
                      "share of a loose chest that widens the shoulders");
  command->add_option("--cap-ease", wish->fit["cap-ease"], "cap longer than the armhole, share");
  command->add_option("--sleeve-length", wish->fit["sleeve-length"],
                      "from the shoulder point to the hem of the sleeve, as a share of the arm");
  command->add_option("-o,--output", wish->out, "folder for pattern.json and pattern.svg");
  command->callback([wish] { run(*wish); });
}

}  // namespace loosefit
