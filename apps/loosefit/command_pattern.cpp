#include "command_pattern.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/base/types.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pipeline/make_garment_pattern.h"
#include "loosefit/report/fact_documents.h"
#include "loosefit/report/seam_sheet.h"
#include "loosefit/report/write_pattern.h"
#include "print_document.h"
#include "standard_error.h"

namespace loosefit {
namespace {

/// A number that an option of the command line gives.
struct NumberOption {
  std::string name;  ///< of the option, without the dashes
  std::string key;   ///< KindMeasure::name or KindKey::name
  std::string help;
  bool degrees = false;  ///< the key is in radians
};

std::string usual_kind() { return kinds::garment_kinds().front().name; }

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
  pipeline::GarmentPatternWish pattern;
  std::string out;
  bool list_sizes = false, json = false, propose = false;
  std::map<std::string, std::optional<double>> measures, fit;  ///< by name of the option
};

/// Those of the options that were used.
std::vector<pipeline::GivenValue> given(
    const std::vector<NumberOption>& options,
    const std::map<std::string, std::optional<double>>& values) {
  std::vector<pipeline::GivenValue> result;
  for (const NumberOption& option : options)
    if (const auto& value = values.at(option.name))
      result.push_back({option.key, option.degrees ? radians(*value) : *value, "--" + option.name});
  return result;
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
    const double area = pattern::cloth_area(panel);
    total += area;
    fmt::print("{:<18} {:>10.1f} {:>11.1f} {:>10.1f} {:>7}\n", terminal_line(panel.name),
               1000 * (high - low).x(), 1000 * (high - low).y(), 1e4 * area, panel.edges.size());
    for (const pattern::PanelHole& hole : panel.holes)
      fmt::print("{:<18} {:>10} {:>11} {:>10.1f}\n", "  hole " + terminal_line(hole.name), "", "",
                 -1e4 * pattern::signed_area(hole.points));
  }
  fmt::print("{} pieces, {:.4f} m2\n\n", pattern.panels.size(), total);
}

void print_seams(const pattern::Pattern& pattern) {
  if (pattern.stitches.empty()) {
    fmt::print("no seams: no edge is sewn to another\n");
    return;
  }
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

/// Nothing without lines.
void print_lines(const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  if (!title.empty()) fmt::print("{}\n", title);
  for (const std::string& line : lines)
    fmt::print("{}{}\n", title.empty() ? "" : "  ", terminal_line(line));
  fmt::print("\n");
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

/// All that is told of a pattern, in tables.
void print_words(const pipeline::GarmentPattern& made) {
  fmt::print("{}\n\n", terminal_line(made.pattern.name));
  print_lines("", made.about);
  print_girths(made.levels);
  print_pieces(made.pattern);
  print_seams(made.pattern);
  if (!made.details.empty()) fmt::print("\n{}\n", made.details);
  if (!made.used.empty() || !made.unused.empty()) fmt::print("\n");
  print_lines("used of the file:", made.used);
  print_lines("not used:", made.unused);
}

/// Two files beside the pattern, and in words what is in them.
void propose_seams(const Wish& wish) {
  if (wish.pattern.file.empty() || wish.json || !wish.out.empty() || !wish.pattern.seams.empty())
    throw InvalidInput({{}, 0, "--propose-seams"},
                       "without --file, or beside --json, -o or --seams",
                       "--file FILE beside it, --size and --units if need be");
  const report::WrittenProposals written =
      report::write_seam_proposals(wish.pattern.file, {wish.pattern.size, wish.pattern.units});
  const pattern::SeamProposals& found = written.proposals;
  if (!found.known.kind.empty()) fmt::print("known by its pieces: {}\n", found.known.kind);
  int number = 0;
  for (const pattern::SeamProposal& p : found.seams)
    fmt::print("{:>3} {:<14} {:>8.1f} and {:>8.1f} mm  {}\n", ++number, terminal_line(p.seam.name),
               1000 * p.first, 1000 * p.second, terminal_line(p.why));
  for (const std::string& doubt : found.known.doubts)
    fmt::print("doubt: {}\n", terminal_line(doubt));
  for (const std::string& name : found.unsewn)
    fmt::print("{}: {}\n", found.known.kind.empty() ? "sewn to nothing" : "left out",
               terminal_line(name));
  fmt::print("\nwrote {} and {}\nlook at them, correct the seams, then set confirmed = true\n",
             terminal_line(written.seams.string()), terminal_line(written.picture.string()));
}

void run(Wish wish) {
  if (wish.list_sizes) {
    const kinds::GarmentKind& kind = kinds::garment_kind(wish.pattern.kind.value_or(usual_kind()));
    return wish.json ? print_document(report::sizes_document(kind)) : print_sizes(kind);
  }
  if (wish.propose) return propose_seams(wish);
  wish.pattern.measures = given(measure_options(), wish.measures);
  wish.pattern.fit = given(fit_options(), wish.fit);
  const pipeline::GarmentPattern made = pipeline::make_garment_pattern(wish.pattern);
  for (const std::string& warning : made.warnings)
    to_standard_error(fmt::format("warning: {}\n", terminal_line(warning)));
  if (!wish.json) print_words(made);
  if (!wish.out.empty()) report::write_pattern(wish.out, made.pattern, made.notches, made.marks);
  if (wish.json)
    print_document(report::pattern_document(
        made, wish.out.empty() ? report::WrittenFiles{}
                               : report::WrittenFiles{
                                     wish.out, {"pattern.json", "pattern.svg", "pattern.dxf"}}));
  else if (!wish.out.empty())
    fmt::print("\nwrote {}/pattern.json, pattern.svg, pattern.dxf\n", terminal_line(wish.out));
}

}  // namespace

void add_pattern_command(CLI::App& app) {
  auto* command = app.add_subcommand(
      "pattern", "draft a garment from measures, a body or a size, or read a pattern file");
  auto wish = std::make_shared<Wish>();
  command
      ->add_option_function<std::string>(
          "--pattern", [wish](const std::string& kind) { wish->pattern.kind = kind; },
          join(kinds::drafted_kinds()) + "; default " + usual_kind())
      ->check(CLI::IsMember(kinds::drafted_kinds()));
  command->add_option(
      "--file", wish->pattern.file,
      "pattern file instead of the draft: GarmentCode specification JSON, DXF-AAMA or ASTM D6673, "
      "SVG (FreeSewing, Inkscape, …), FreeSewing JSON, Valentina .val");
  command->add_option("--size", wish->pattern.size,
                      "garment size, e.g. child-142, women-38, men-M; with --file one of the file");
  command->add_option(
      "--seams", wish->pattern.seams,
      "seams of a file that has none; default: NAME.seams.toml beside it, if there is one");
  command->add_option(
      "--units", wish->pattern.units,
      "of a DXF or SVG file: mm, cm, m or inch; default: as it says, if that can be");
  command->add_flag("--propose-seams", wish->propose,
                    "write NAME.seams.toml beside the file, to confirm, and NAME.seams.svg");
  command->add_flag("--list-sizes", wish->list_sizes, "all sizes with their source");
  command->add_option("--body", wish->pattern.body,
                      "body.json of `loosefit body`, or JSON with measures; default: the body of a "
                      "scenario without [body]");
  command->add_option("--scenario", wish->pattern.scenario, "body and garment of a scenario file");
  for (const NumberOption& option : measure_options())
    command->add_option("--" + option.name, wish->measures[option.name], option.help);
  for (const NumberOption& option : fit_options())
    command->add_option("--" + option.name, wish->fit[option.name],
                        option.help + "; as [garment.fit] of a scenario");
  command->add_option("-o,--output", wish->out,
                      "folder for pattern.json, pattern.svg and pattern.dxf");
  add_json_flag(*command, wish->json);
  command->callback([wish] { run(*wish); });
}

}  // namespace loosefit
