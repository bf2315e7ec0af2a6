#include "loosefit/io/svg/svg_freesewing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "loosefit/base/text.h"
#include "loosefit/io/pieces/freesewing_piece.h"
#include "loosefit/io/svg/svg_labels.h"
#include "loosefit/io/svg/svg_lines.h"

namespace loosefit::io {
namespace {

constexpr std::string_view kPartMark = "-part-";  // in the id of a part of FreeSewing
constexpr const char* kOtherLines[] = {"sa", "help", "hidden", "dashed", "lashed", "dotted"};

bool has_class(const SvgShape& shape, const std::string& wanted) {
  std::istringstream words(shape.classes);
  for (std::string word; words >> word;)
    if (word == wanted) return true;
  return false;
}

}  // namespace

std::vector<CountedPiece> freesewing_pieces(const SvgDocument& document, double unit,
                                            LeftOut& left) {
  std::map<int, FreesewingPart> parts;
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
  const auto part_of = [&](const std::vector<int>& groups) {
    for (std::size_t k = groups.size(); k-- > 0;)
      if (is_part(document.groups[groups[k]])) return groups[k];
    return -1;
  };
  for (const SvgShape& shape : document.shapes) {
    const int g = part_of(shape.groups);
    const std::string place = fmt::format("at line {}", shape.line);
    if (g < 0) {
      if (has_class(shape, "fabric"))
        left.tell("line of class \"fabric\" " + place + ": it stands in no part");
      else if (!shape.classes.empty())
        left.count("lines of class \"" + printable(shape.classes, 60) + "\" in no part");
      continue;
    }
    FreesewingPart& part = parts[g];
    if (part.name.empty()) {
      const SvgGroup& group = document.groups[g];
      part.name = part_name(group);
      part.place = place;
      const std::vector<Vec2> middle =
          in_metres({group.place * Vec2(0, 0), group.place * Vec2(0, 1)}, unit);
      part.middle = {middle[0], middle[1]};
    }
    if (shape.kind == "notch") {
      part.notches.push_back(in_metres({shape.runs[0].start}, unit)[0]);
      continue;
    }
    const bool fold = shape.marker.find("cutonfold") != std::string::npos;
    if (fold || shape.marker.find("grainline") != std::string::npos) {
      const SampledRun line = sampled_in_metres(shape.runs[0], unit);
      const Axis axis(line.points.front(), line.points.back());
      if (fold && line.nodes.size() > 1)
        part.folds.push_back(line.nodes);
      else if (!fold && (axis.second - axis.first).norm() > kSamePoint)
        part.grain = axis;
      continue;
    }
    // Some designs leave the class of a part's outline away.
    const bool plain = shape.classes.empty(), fabric = has_class(shape, "fabric");
    const bool other = std::any_of(std::begin(kOtherLines), std::end(kOtherLines),
                                   [&](const char* c) { return has_class(shape, c); });
    if ((!fabric && !plain) || other) {
      const bool allowance = has_class(shape, "sa");
      left.count(allowance ? std::string("seam allowances")
                           : "lines of class \"" + printable(shape.classes, 60) + '"',
                 "in part " + part.name);
      for (const SvgRun& run : shape.runs)
        if (SampledRun line = sampled_in_metres(run, unit);
            line.closed && !allowance && line.points.size() > 2)
          part.others.push_back({std::move(line.points), shape.classes, place});
      continue;
    }
    for (const SvgRun& run : shape.runs) {
      SampledRun line = sampled_in_metres(run, unit);
      part.lines.push_back({{std::move(line.points), line.closed, true},
                            std::move(line.nodes),
                            own_name(shape.label, shape.id),
                            fabric,
                            place});
    }
  }
  for (const SvgText& text : document.texts)
    if (const auto part = parts.find(part_of(text.groups)); part != parts.end())
      part->second.texts.push_back(text.words);
  for (std::size_t g = 0; g < document.groups.size(); ++g)
    if (is_part(document.groups[g]) && !parts.contains(static_cast<int>(g)))
      left.unused.push_back("part " + printable(part_name(document.groups[g])) + ": it is empty");
  std::set<std::string> names;
  for (const auto& [group, part] : parts)
    if (part.has_outline()) names.insert(part.name);
  std::vector<CountedPiece> pieces;
  for (const auto& [group, part] : parts) {
    for (CountedPiece& piece : drawn_freesewing(part, marked, names, left))
      pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace loosefit::io
