#include "loosefit/report/seam_sheet.h"

#include <fmt/format.h>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/pattern_svg.h"
#include "loosefit/io/read_pattern.h"
#include "loosefit/io/seams_file.h"
#include "loosefit/io/whole_file.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::report {
namespace {

namespace fs = std::filesystem;

constexpr double kInwards = 19;  // of a number from its edge [mm]
constexpr double kDisc = 8;      // [mm]

std::string run_words(const pattern::Pattern& pattern,
                      const std::vector<pattern::Stitch::Side>& run) {
  std::vector<std::string> words;
  for (const pattern::Stitch::Side& side : run) {
    const pattern::Panel& panel = pattern.panels[side.panel];
    words.push_back(panel.name + "." + panel.edges[side.edge].name);
  }
  return join(words, " + ");
}

/// The number of a seam inside the piece at the middle of an edge.
std::string number_at(const pattern::Panel& panel, int edge, int number,
                      const io::PanelOnSheet& sheet) {
  const pattern::EdgePath path(panel, edge);
  const Vec2 before = sheet.at(path.at(.48)), after = sheet.at(path.at(.52));
  const Vec2 along = (after - before).normalized();
  const Vec2 at = sheet.at(path.at(.5)) + kInwards * Vec2(along.y(), -along.x());
  // Colours that neighbours in the list do not share.
  static constexpr const char* kColours[] = {"#b3261e", "#1f5fa8", "#1b7a3d",
                                             "#8a4fa3", "#a35b00", "#00707a"};
  return fmt::format(
      "    <circle class=\"seam\" cx=\"{0:.2f}\" cy=\"{1:.2f}\" r=\"{2:g}\" fill=\"{3}\"/>\n"
      "    <text x=\"{0:.2f}\" y=\"{4:.2f}\" font-size=\"9\" font-weight=\"bold\" fill=\"white\" "
      "text-anchor=\"middle\">{5}</text>\n",
      at.x(), at.y(), kDisc, kColours[(number - 1) % 6], at.y() + 3.2, number);
}

void refuse_to_overwrite(const fs::path& path) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(path, ignored)))
    throw InvalidInput({path.string(), 0, {}}, "a file that is there already",
                       "none: what somebody may have confirmed is never overwritten",
                       "move or delete it to have seams proposed anew");
}

}  // namespace

std::string seam_sheet_svg(const pattern::Pattern& pattern,
                           const pattern::SeamProposals& proposals) {
  io::SheetMarks marks;
  marks.title = (pattern.name.empty() ? "pattern" : pattern.name) + ": proposed seams";
  marks.words =
      "equal numbers are proposed to be sewn together; outside of the cloth; print at 100 %";
  marks.over_panel = [&](int panel, const io::PanelOnSheet& sheet) {
    std::string out;
    for (std::size_t s = 0; s < proposals.seams.size(); ++s)
      for (const auto* run : {&proposals.seams[s].seam.first, &proposals.seams[s].seam.second})
        for (const pattern::Stitch::Side& side : *run)
          if (side.panel == panel)
            out += number_at(pattern.panels[panel], side.edge, static_cast<int>(s) + 1, sheet);
    return out;
  };
  for (std::size_t s = 0; s < proposals.seams.size(); ++s) {
    const pattern::SeamProposal& p = proposals.seams[s];
    marks.lines.push_back(fmt::format("{} {}: {} to {}, {:.1f} and {:.1f} mm; {}", s + 1,
                                      p.seam.name, run_words(pattern, p.seam.first),
                                      run_words(pattern, p.seam.second), 1000 * p.first,
                                      1000 * p.second, p.why));
  }
  for (const std::string& doubt : proposals.known.doubts) marks.lines.push_back("doubt: " + doubt);
  if (!proposals.unsewn.empty())
    marks.lines.push_back((proposals.known.kind.empty() ? "sewn to nothing: " : "left out: ") +
                          join(proposals.unsewn));
  return io::pattern_svg(pattern, marks);
}

WrittenProposals write_seam_proposals(const fs::path& pattern_file, const io::PatternWish& wish) {
  WrittenProposals written;
  written.seams = io::seams_path(pattern_file);
  written.picture = fs::path(written.seams).replace_extension(".svg");
  refuse_to_overwrite(written.seams);
  refuse_to_overwrite(written.picture);
  const io::PatternFile file = io::read_unsewn(pattern_file, wish);
  if (file.placed)
    throw InvalidInput({pattern_file.string(), 0, "--propose-seams"}, "a file with seams",
                       "a file that does not say what is sewn: DXF, SVG");
  written.proposals = pattern::propose_seams(file.pattern, file.notches);
  if (written.proposals.seams.empty())
    throw InvalidInput({pattern_file.string(), 0, "--propose-seams"},
                       "no two edges that may be one seam", "edges of like lengths",
                       "write NAME.seams.toml by hand, with the edges that --output draws");
  const std::string picture = seam_sheet_svg(file.pattern, written.proposals);
  io::write_whole_file(written.picture, picture, false);
  try {
    io::write_whole_file(written.seams, io::seams_text(file.pattern, written.proposals), false);
  } catch (...) {
    std::error_code ignored;
    fs::remove(written.picture, ignored);
    throw;
  }
  return written;
}

}  // namespace loosefit::report
