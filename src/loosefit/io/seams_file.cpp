#include "loosefit/io/seams_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/band_table.h"
#include "loosefit/io/config_reader.h"
#include "loosefit/io/elastic_table.h"
#include "loosefit/io/toml_file.h"
#include "loosefit/pattern/named_cloth.h"
#include "loosefit/pattern/named_edges.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr double kGathered = 0.1;        // difference of lengths that is told, of the longer side
constexpr std::size_t kLongestRun = 50;  // edges

/// An edge that is not sewn yet.
pattern::Stitch::Side side_named(const ConfigReader& seam, const std::string& key,
                                 const std::string& text, const pattern::Pattern& pattern,
                                 std::set<std::pair<int, int>>& sewn) try {
  const pattern::Stitch::Side side = pattern::named_edge(pattern, text);
  if (!sewn.insert({side.panel, side.edge}).second)
    throw seam.error(key, "an edge that is not sewn yet", "each edge is in at most one seam");
  return side;
} catch (const InvalidInput& error) {
  if (!error.place().key.empty()) throw;
  throw seam.error(key, error.expected(), error.hint());
}

/// One edge, or a run of them.
std::vector<pattern::Stitch::Side> read_run(ConfigReader& seam, const std::string& key,
                                            const pattern::Pattern& pattern,
                                            std::set<std::pair<int, int>>& sewn) {
  const ConfigNode* node = seam.node(key);
  if (!node || node->kind != ConfigNode::Kind::array)
    return {side_named(seam, key, seam.text(key, ""), pattern, sewn)};
  if (node->items.empty() || node->items.size() > kLongestRun)
    throw seam.error(key, fmt::format("1 to {} edges", kLongestRun));
  std::vector<pattern::Stitch::Side> run;
  for (const ConfigNode& item : node->items) {
    if (item.kind != ConfigNode::Kind::text) throw seam.error(key, "a list of texts");
    run.push_back(side_named(seam, key, item.text, pattern, sewn));
  }
  return run;
}

/// Takes these pieces away from a pattern without seams.
void leave_out(PatternFile& file, const std::vector<std::string>& names,
               const ConfigReader& reader) {
  if (names.empty()) return;
  pattern::Pattern& pattern = file.pattern;
  if (names.size() >= pattern.panels.size())
    throw reader.error("leave_out", "some of the pieces, not all");
  if (!pattern.stitches.empty()) throw reader.error("leave_out", "a pattern without seams");
  std::vector<int> now(pattern.panels.size(), -1);
  std::vector<pattern::Panel> kept;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    if (std::find(names.begin(), names.end(), pattern.panels[p].name) != names.end()) {
      const std::string called = "piece " + printable(pattern.panels[p].name);
      file.unused.push_back(called + ": left out as asked");
      std::erase_if(file.used,
                    [&](const std::string& line) { return line.starts_with(called + " ("); });
      continue;
    }
    now[p] = static_cast<int>(kept.size());
    kept.push_back(std::move(pattern.panels[p]));
  }
  file.warnings.push_back("left out, as the side file asks: piece " + printable(join(names), 300));
  pattern.panels = std::move(kept);
  for (int& p : pattern.panel_order) p = now[p];
  std::erase(pattern.panel_order, -1);
  for (pattern::Notch& notch : file.notches) notch.panel = now[notch.panel];
  std::erase_if(file.notches, [](const pattern::Notch& notch) { return notch.panel < 0; });
}

int piece_named(const ConfigReader& table, const std::string& name,
                const pattern::Pattern& pattern) {
  const int p = pattern.find_panel(name);
  if (p >= 0) return p;
  std::vector<std::string> names;
  for (const pattern::Panel& panel : pattern.panels) names.push_back(panel.name);
  throw table.error(name, "no piece of this name", "a piece that the pattern has",
                    did_you_mean(name, names));
}

/// What pieces are, where their names do not say it.
void read_pieces(ConfigReader& reader, pattern::Pattern& pattern) {
  ConfigReader pieces = reader.table("pieces");
  for (const std::string& name : pieces.keys()) {
    const int p = piece_named(pieces, name, pattern);
    const std::string what = pieces.text(name, "");
    const pattern::PieceWords w = pattern::words_of(what);
    if (!(w.front || w.back || w.left || w.right || w.sleeve || w.leg || w.skirt || w.hood ||
          w.neck || w.armhole || w.cuff || w.waist || w.hem))
      throw pieces.error(name, "what the piece is",
                         "front, back, left, right, sleeve, leg, skirt, hood, collar, cuff, "
                         "waistband, or several of them: \"front left\"");
    pattern.panels[p].part = what;
  }
}

/// Which side of a piece in the drawing is its upper one.
void read_up(ConfigReader& reader, PatternFile& into) {
  ConfigReader up = reader.table("up");
  for (const std::string& name : up.keys()) {
    const int p = piece_named(up, name, into.pattern);
    // Quarter turns counter-clockwise that bring it up.
    static const std::vector<std::string> kSides = {"up", "right", "down", "left"};
    const std::string side = up.choice(name, "up", kSides);
    into.turns[p] = static_cast<int>(std::ranges::find(kSides, side) - kSides.begin());
  }
}

/// Errors about what is named by `key` get their place.
template <class Add>
void each_table(ConfigReader& reader, const std::string& section, const std::string& key, Add add) {
  for (const ConfigReader& table : reader.tables(section)) try {
      add(table);
    } catch (const InvalidInput& error) {
      if (!error.place().key.empty()) throw;
      throw table.error(key, error.found(), error.expected(), error.hint());
    }
}

std::string run_text(const pattern::Pattern& pattern,
                     const std::vector<pattern::Stitch::Side>& run) {
  std::vector<std::string> texts;
  for (const pattern::Stitch::Side& side : run) {
    const pattern::Panel& panel = pattern.panels[side.panel];
    texts.push_back(toml_quoted(panel.name + "." + panel.edges[side.edge].name));
  }
  return texts.size() == 1 ? texts[0] : "[" + join(texts) + "]";
}

/// Which pieces are before and which behind, where no name says it.
std::string pieces_text(const pattern::Pattern& pattern, const pattern::KnownGarment& known) {
  const bool told = std::ranges::any_of(pattern.panels, [](const pattern::Panel& panel) {
    const pattern::PieceWords w = pattern::words_of(panel);
    return w.front || w.back;
  });
  if (told || (!known.kind.empty() && !known.unnamed)) return {};
  std::string text =
      "\n[pieces]  # what each is: front, back, left, right, sleeve, waistband, ...\n";
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    using Role = pattern::PieceRole;
    const Role role = known.pieces[p].role;
    const char* what = role == Role::front_skirt  ? "front"
                       : role == Role::back_skirt ? "back"
                                                  : nullptr;
    if (known.unnamed && !what) continue;
    text += fmt::format("{}{} = \"{}\"\n", what ? "" : "# ", toml_quoted(pattern.panels[p].name),
                        what ? what : "front");
  }
  return text;
}

}  // namespace

std::filesystem::path seams_path(const std::filesystem::path& pattern_file) {
  std::filesystem::path path = pattern_file;
  return path.replace_extension(".seams.toml");
}

std::filesystem::path side_file(const std::filesystem::path& pattern_file,
                                const std::filesystem::path& given) {
  if (!given.empty()) return given;
  std::error_code ignored;
  const std::filesystem::path beside = seams_path(pattern_file);
  return std::filesystem::exists(beside, ignored) ? beside : std::filesystem::path();
}

void parse_seams(const std::string& text, const std::string& file, PatternFile& into) {
  const ConfigNode root = parse_toml(text, file);
  ConfigReader reader(root, file);
  reader.only({"seam", "elastic", "band", "pieces", "up", "confirmed", "leave_out"});
  pattern::Pattern& pattern = into.pattern;
  const bool confirmed = reader.boolean("confirmed", true);
  std::vector<std::string> all;
  for (const pattern::Panel& panel : pattern.panels) all.push_back(panel.name);
  leave_out(into, reader.choices("leave_out", {}, all), reader);
  read_pieces(reader, pattern);
  read_up(reader, into);
  each_table(reader, "elastic", "edges", [&](const ConfigReader& table) {
    pattern::add_elastic(pattern, read_elastic(table));
  });
  std::set<std::string> told;
  each_table(reader, "band", "panels", [&](const ConfigReader& table) {
    pattern::set_cloth(pattern, read_band(table, told));
  });
  std::set<std::pair<int, int>> sewn;
  for (const pattern::Stitch& stitch : pattern.stitches)
    for (const auto& side : {stitch.first, stitch.second}) sewn.insert({side.panel, side.edge});
  std::set<std::string> names;
  std::vector<pattern::ChainSeam> seams;
  for (ConfigReader& seam : reader.tables("seam")) {
    seam.only({"first", "second", "reversed", "begin", "name"});
    pattern::ChainSeam sewing;
    sewing.first = read_run(seam, "first", pattern, sewn);
    sewing.second = read_run(seam, "second", pattern, sewn);
    sewing.reversed = seam.boolean("reversed", false);
    sewing.begin = seam.number("begin", 0, {0, 1, "a fraction"},
                               "of closed runs: of the second, where the first begins");
    sewing.name =
        seam.text("name", fmt::format("seam_{}", pattern.stitches.size() + seams.size() + 1));
    if (!names.insert(sewing.name).second)
      throw seam.error("name", "a name that no other seam has");
    seam.finish();
    const double a = pattern::chain_length(pattern, sewing.first),
                 b = pattern::chain_length(pattern, sewing.second);
    if (std::abs(a - b) > kGathered * std::max(a, b))
      into.warnings.push_back(fmt::format(
          "seam {}: its sides are {:.1f} and {:.1f} mm long, the longer one is gathered",
          printable(sewing.name), 1000 * a, 1000 * b));
    seams.push_back(std::move(sewing));
  }
  reader.finish();
  try {
    pattern::sew_chains(pattern, std::move(seams), into.notches);
  } catch (const GeometryError& error) {
    throw GeometryError(error.at({file, 0, "seam " + printable(error.place().key)}));
  }
  if (!confirmed)
    into.warnings.push_back(
        "the seams are a proposal that nobody has confirmed: look at them, correct them, then set "
        "confirmed = true in " +
        file);
}

void read_seams(const std::filesystem::path& path, PatternFile& into) {
  parse_seams(read_toml_text(path.string()), path.string(), into);
}

std::string seams_text(const pattern::Pattern& pattern, const pattern::SeamProposals& proposals) {
  std::string text =
      "# Proposed seams. Numbers are those of the picture beside this file. Look at each, change "
      "or\n"
      "# delete what is wrong, then say so:\n"
      "confirmed = false\n";
  if (!proposals.known.kind.empty() && !proposals.unsewn.empty()) {
    std::vector<std::string> names;
    for (const std::string& name : proposals.unsewn) names.push_back(toml_quoted(name));
    text += "leave_out = [" + join(names) + "]  # pieces that are not taken\n";
  }
  text += pieces_text(pattern, proposals.known);
  int number = 0;
  for (const pattern::SeamProposal& proposal : proposals.seams) {
    text += fmt::format("\n# {}: {:.1f} and {:.1f} mm; {}\n[[seam]]\nname = {}\n", ++number,
                        1000 * proposal.first, 1000 * proposal.second, proposal.why,
                        toml_quoted(proposal.seam.name));
    text += "first = " + run_text(pattern, proposal.seam.first) + "\n";
    text += "second = " + run_text(pattern, proposal.seam.second) + "\n";
    if (proposal.seam.reversed) text += "reversed = true\n";
    if (proposal.seam.begin > 0) text += fmt::format("begin = {:.4f}\n", proposal.seam.begin);
  }
  return text;
}

}  // namespace loosefit::io
