#include "loosefit/io/svg/svg_freesewing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "loosefit/base/text.h"
#include "loosefit/io/pieces/freesewing_piece.h"
#include "loosefit/io/svg/svg_lines.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr double kBeforeAllOthers = 1e6;          // [m²]
constexpr std::string_view kPartMark = "-part-";  // in the id of a part of FreeSewing
constexpr const char* kOtherLines[] = {"sa", "help", "hidden", "dashed", "lashed", "dotted"};

bool has_class(const SvgShape& shape, const std::string& wanted) {
  std::istringstream words(shape.classes);
  for (std::string word; words >> word;)
    if (word == wanted) return true;
  return false;
}

}  // namespace

std::vector<SvgPiece> freesewing_pieces(const SvgDocument& document, double unit,
                                        std::vector<std::string>& unused) {
  std::map<int, FreesewingPart> parts;
  std::map<int, int> line_of;
  std::map<int, double> largest_of;
  std::map<std::string, int> left;
  bool marked = false;
  for (const SvgShape& shape : document.shapes)
    marked = marked || shape.marker.find("cutonfold") != std::string::npos ||
             shape.marker.find("grainline") != std::string::npos;
  const auto is_part = [](const SvgGroup& group) {
    return group.id.find(kPartMark) != std::string::npos;
  };
  const auto part_name = [](const SvgGroup& group) {
    return group.id.substr(group.id.find(kPartMark) + kPartMark.size()).substr(0, 100);
  };
  const auto part_group = [&](const SvgShape& shape) {
    for (std::size_t k = shape.groups.size(); k-- > 0;)
      if (is_part(document.groups[shape.groups[k]])) return shape.groups[k];
    return -1;
  };
  for (const SvgShape& shape : document.shapes) {
    const int g = part_group(shape);
    if (g < 0) {
      if (has_class(shape, "fabric")) ++left["lines of class \"fabric\" in no part"];
      continue;
    }
    FreesewingPart& part = parts[g];
    if (part.name.empty()) {
      const SvgGroup& group = document.groups[g];
      part.name = part_name(group);
      const std::vector<Vec2> middle =
          in_metres({group.place * Vec2(0, 0), group.place * Vec2(0, 1)}, unit);
      part.middle = {middle[0], middle[1]};
      line_of[g] = shape.line;
    }
    if (shape.kind == "notch") {
      part.notches.push_back(in_metres({shape.runs[0].start}, unit)[0]);
      continue;
    }
    const bool fold = shape.marker.find("cutonfold") != std::string::npos;
    if (fold || shape.marker.find("grainline") != std::string::npos) {
      const SampledRun line = sampled_in_metres(shape.runs[0], unit);
      const Axis axis(line.points.front(), line.points.back());
      if ((axis.second - axis.first).norm() > kSamePoint) (fold ? part.fold : part.grain) = axis;
      continue;
    }
    // Some designs leave the class of a part's outline away.
    const bool plain = shape.classes.empty(), fabric = has_class(shape, "fabric");
    const bool other = std::any_of(std::begin(kOtherLines), std::end(kOtherLines),
                                   [&](const char* c) { return has_class(shape, c); });
    if ((!fabric && !plain) || other) {
      ++left[has_class(shape, "sa") ? "seam allowances" : "other lines"];
      continue;
    }
    // Of several the one that encloses most; one of fabric before all others.
    double& largest = largest_of[g];
    for (const SvgRun& run : shape.runs) {
      SampledRun line = sampled_in_metres(run, unit);
      if (line.points.size() < 3) continue;
      const double area =
          std::abs(pattern::signed_area(line.points)) + (fabric ? kBeforeAllOthers : 0);
      if (area <= largest) continue;
      largest = area;
      part.seam.points = std::move(line.points);
      part.nodes = std::move(line.nodes);
    }
  }
  for (const auto& [what, count] : left) unused.push_back(fmt::format("{}: {}", what, count));
  for (std::size_t g = 0; g < document.groups.size(); ++g)
    if (is_part(document.groups[g]) && !parts.contains(static_cast<int>(g)))
      unused.push_back("part " + printable(part_name(document.groups[g])) + ": it is empty");
  std::set<std::string> names;
  for (const auto& [group, part] : parts)
    if (!part.seam.points.empty()) names.insert(part.name);
  std::vector<SvgPiece> pieces;
  for (auto& [group, part] : parts) {
    if (part.seam.points.empty()) {
      unused.push_back("part " + printable(part.name) +
                       ": it has no closed path of class \"fabric\"");
      continue;
    }
    SvgPiece piece;
    piece.line = line_of[group];
    piece.piece = drawn_freesewing(std::move(part), marked, names, piece.count);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace loosefit::io
