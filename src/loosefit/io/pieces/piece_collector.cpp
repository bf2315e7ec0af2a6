#include "loosefit/io/pieces/piece_collector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/garmentcode_frame.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostPoints = 50'000;
constexpr double kGap = 0.05;  // between pieces laid side by side [m]

/// "Sleeve 2X".
bool ends_as_size_or_count(const std::string& name) {
  if (name.size() < 3 || name.back() != 'X') return false;
  const std::size_t last = name.find_last_not_of("0123456789", name.size() - 2);
  return last != std::string::npos && last + 2 < name.size() &&
         std::isalnum(static_cast<unsigned char>(name[last])) == 0;
}

}  // namespace

void PieceCollector::add(DrawnPiece drawn, const PieceCount& count, const std::string& place) {
  const std::string called = "piece " + printable(drawn.name);
  if (count.as_drawn + count.mirrored == 0) {
    result_.unused.push_back(called + ": its quantity is 0, it is optional");
    return;
  }
  const std::string drawn_name = drawn.name;
  PiecePanel made = panel_of_piece(std::move(drawn));
  if (!made.fault.empty()) {
    warn(fmt::format("{} ({}): left out, {}", called, place, printable(made.fault, 300)));
    result_.unused.push_back(fmt::format("{} ({}): {}", called, place, printable(made.fault, 300)));
    return;
  }
  if (count.said.empty() && ends_as_size_or_count(drawn_name))
    warn(called +
         ": the end of its name may be a size or a count; it is read as a size, and the "
         "piece is not counted by it");
  for (const std::string& note : made.notes) warn(called + ": " + note);
  (made.on_sew_line ? on_sew_line_ : on_cut_line_) += 1;
  unfolded_ += made.unfolded > 0;
  const std::string said =
      count.said.empty() ? std::string() : " (\"" + printable(count.said, 100) + "\")";
  if (!count.doubt.empty())
    warn(fmt::format("{}: its count \"{}\" is read as {}", called, printable(count.said, 100),
                     count.doubt));
  for (const pattern::PanelEdge& edge : made.panel.edges) points_ += edge.curves.size();
  if (points_ > kMostPoints)
    throw InvalidInput(called, fmt::format("at most {} points in all pieces", kMostPoints));
  std::vector<std::string> names;
  if (count.as_drawn > 0) names.push_back(lay_beside(made));
  if (count.mirrored > 0) {
    PiecePanel twin = mirrored_piece(made);
    if (count.as_drawn > 0) twin.panel.name += "_mirrored", ++twins_;
    names.push_back(lay_beside(std::move(twin)));
  }
  tell(place, made, count, names);
  const int more = count.as_drawn + count.mirrored - static_cast<int>(names.size());
  if (more > 0) {
    const std::string line = fmt::format(
        "{}: it is cut {} times{}; {} taken, {} more ({} as drawn, {} mirrored) {} left out: draw "
        "them as pieces of their own if they are sewn to others",
        called, count.as_drawn + count.mirrored, said,
        printable(join(names, " and "), 200) + (names.size() == 1 ? " is" : " are"), more,
        std::max(count.as_drawn - 1, 0), std::max(count.mirrored - 1, 0), more == 1 ? "is" : "are");
    warn(line);
    result_.unused.push_back(line);
  }
  if (made.half_without_fold)
    result_.doubts.push_back(printable(names[0]) +
                             " may be half a piece, no line on its outline marks its fold");
}

void PieceCollector::tell(const std::string& place, const PiecePanel& made, const PieceCount& count,
                          const std::vector<std::string>& names) {
  std::vector<std::string> how{made.on_sew_line ? "its sew line" : "its outline"};
  if (made.unfolded > 0)
    how.push_back(made.unfolded == 1 ? "unfolded at its fold line"
                                     : fmt::format("unfolded at {} fold lines", made.unfolded));
  if (made.half_without_fold) how.push_back("not unfolded, no line on it marks its fold");
  for (const pattern::PanelHole& hole : made.panel.holes)
    how.push_back("hole \"" + printable(hole.name) + "\" cut");
  if (!made.notches.empty()) how.push_back(fmt::format("{} notches", made.notches.size()));
  how.push_back(names.size() > 1     ? "once as drawn, once mirrored"
                : count.mirrored > 0 ? "once mirrored"
                                     : "once");
  if (!count.said.empty()) how.back() += " (\"" + printable(count.said, 100) + "\")";
  result_.used.push_back(fmt::format("piece {} ({}): {}", printable(names[0]), place, join(how)));
}

void PieceCollector::finish(const std::string& file, const std::string& sew_line) {
  if (result_.pattern.panels.empty())
    throw GeometryError(
        {file, 0, "pieces"},
        result_.warnings.empty() ? "no piece that is cut at all" : result_.warnings.back(),
        "at least one sound piece");
  if (unfolded_ > 0)
    result_.about.push_back(fmt::format("{} half pieces unfolded at their mirror line", unfolded_));
  if (twins_ > 0)
    result_.about.push_back(
        fmt::format("{} pieces cut twice: once as drawn, once mirrored", twins_));
  if (on_sew_line_ > 0)
    result_.about.push_back(fmt::format("{} pieces along their sew line", on_sew_line_));
  if (on_cut_line_ > 0)
    warn(
        fmt::format("{} pieces have no {}: taken as they are cut; where that includes seam "
                    "allowances, the garment is that much too wide",
                    on_cut_line_, sew_line));
}

std::string PieceCollector::lay_beside(PiecePanel piece) {
  pattern::Panel& panel = piece.panel;
  const std::string name = panel.name;
  for (int k = 2; result_.pattern.find_panel(panel.name) >= 0; ++k)
    panel.name = fmt::format("{}_{}", name, k);
  Vec2 low = Vec2::Constant(1e9), high = -low;
  for (const Vec2& p : pattern::outline_polygon(panel))
    low = low.cwiseMin(p), high = high.cwiseMax(p);
  panel.translation = frame_from_y_up() * Vec3(right_ - low.x(), 0, 0);
  panel.rotation = frame_from_y_up();
  right_ += high.x() - low.x() + kGap;
  const int index = static_cast<int>(result_.pattern.panels.size());
  for (pattern::Notch& notch : piece.notches) {
    notch.panel = index;
    result_.notches.push_back(notch);
  }
  result_.pattern.panel_order.push_back(index);
  result_.pattern.panels.push_back(std::move(panel));
  return result_.pattern.panels.back().name;
}

}  // namespace loosefit::io
