#include "loosefit/io/svg/svg_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/pieces/freesewing_piece.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr double kTolerance = 2e-5;       // of chords [m]
constexpr double kSmallestPiece = 4e-4;   // [m²]
constexpr double kShareOfPiece = 0.5;     // a sew line encloses at least so much of its piece
constexpr double kNearOutline = 0.03;     // of notches and fold lines that have no group [m]
constexpr double kWholePage = 0.95;       // of its width and height
constexpr double kBeforeAllOthers = 1e6;  // [m²]
constexpr std::string_view kPartMark = "-part-";  // in the id of a part of FreeSewing
constexpr const char* kOtherLines[] = {"sa", "help", "hidden", "dashed", "lashed", "dotted"};
constexpr std::size_t kMostClosed = 1000;  // closed lines
constexpr std::size_t kMostPoints = 2'000'000;
constexpr std::size_t kMostOpen = 2000;  // open lines of one group

struct Run {
  const SvgShape* shape;
  SampledRun line;  ///< [m], y up
  double area = 0;
};

std::vector<Vec2> in_metres(std::vector<Vec2> points, double unit) {
  for (Vec2& p : points) p = Vec2(unit * p.x(), -unit * p.y());
  return points;
}

SampledRun sampled_in_metres(const SvgRun& run, double unit) {
  SampledRun line = sampled(run, kTolerance / unit);
  line.points = in_metres(std::move(line.points), unit);
  line.nodes = in_metres(std::move(line.nodes), unit);
  if (!line.closed && line.points.size() > 3 &&
      (line.points.front() - line.points.back()).norm() < kChainGap) {
    line.points.pop_back();
    line.closed = true;
  }
  return line;
}

std::optional<Axis> longest_side(const SvgShape& shape, double unit) {
  std::optional<Axis> best;
  double longest = kSamePoint;
  for (const SvgRun& run : shape.runs) {
    const std::vector<Vec2> nodes = sampled_in_metres(run, unit).nodes;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
      if (const double d = (nodes[i + 1] - nodes[i]).norm(); d > longest)
        longest = d, best = Axis(nodes[i], nodes[i + 1]);
  }
  return best;
}

/// "path3", "rect12-5", "g7": ids that programs give by themselves.
bool given_by_program(const std::string& id) {
  std::size_t letters = 0;
  while (letters < id.size() && std::isalpha(static_cast<unsigned char>(id[letters]))) ++letters;
  const std::string word = id.substr(0, letters);
  const bool counted =
      id.find_first_not_of("0123456789-_.", letters) == std::string::npos && letters < id.size();
  for (const char* known : {"path", "rect", "polygon", "polyline", "ellipse", "circle", "line", "g",
                            "use", "layer", "svg", "shape", "group", "image", "fs"})
    if (word == known && (counted || id == word)) return true;
  return false;
}

std::string own_name(const std::string& label, const std::string& id) {
  if (!label.empty()) return label;
  return given_by_program(id) ? std::string() : id;
}

std::string clean_name(std::string name) {
  if (name.starts_with("panel-")) name.erase(0, 6);  // of our own sheets
  name = name.substr(0, 100);
  return name;
}

bool has_class(const SvgShape& shape, const std::string& wanted) {
  std::istringstream words(shape.classes);
  for (std::string word; words >> word;)
    if (word == wanted) return true;
  return false;
}

/// Whether the extent of one lies in that of the other, which is quickly told.
bool may_lie_inside(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer) {
  Eigen::AlignedBox2d a, b;
  for (const Vec2& p : inner) a.extend(p);
  for (const Vec2& p : outer) b.extend(p);
  return a.min().x() > b.min().x() - kChainGap && a.min().y() > b.min().y() - kChainGap &&
         a.max().x() < b.max().x() + kChainGap && a.max().y() < b.max().y() + kChainGap;
}

bool lies_inside(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer) {
  if (!may_lie_inside(inner, outer)) return false;
  return std::all_of(inner.begin(), inner.end(), [&](const Vec2& p) {
    return pattern::inside_polygon(outer, p) ||
           (pattern::closest_on_polygon(outer, p) - p).norm() < kChainGap;
  });
}

class Sorter {
 public:
  Sorter(const SvgDocument& document, double unit, const std::string& file)
      : document_(document), unit_(unit), file_(file) {}

  std::vector<SvgPiece> sort(std::vector<std::string>& unused) {
    gather();
    drop_frames();
    find_inner();
    std::vector<SvgPiece> pieces;
    std::map<int, int> pieces_of_group;
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (within_[i] < 0) ++pieces_of_group[innermost(*closed_[i].shape)];
    int within = 0;
    for (std::size_t i = 0; i < closed_.size(); ++i) {
      if (within_[i] >= 0) {
        ++within;
        continue;
      }
      SvgPiece piece;
      const SvgShape& shape = *closed_[i].shape;
      piece.line = shape.line;
      piece.piece.name = name_of(shape, pieces_of_group, pieces.size());
      const Run* outline = &closed_[i];
      if (const Run* seam = sew_line(i)) outline = seam, piece.piece.on_sew_line = true, --within;
      if (words(*outline->shape).seam) piece.piece.on_sew_line = true;
      set_outline(piece.piece, outline->line.points, outline->line.nodes);
      groups_.push_back(pieces_of_group[innermost(shape)] == 1 ? innermost(shape) : -1);
      outlines_.push_back(closed_[i].line.points);
      pieces.push_back(std::move(piece));
    }
    chain_groups(pieces, pieces_of_group);
    const int marks = give_marks(pieces);
    const int open = static_cast<int>(open_.size()) - chained_;
    const auto tell = [&](int count, const char* what) {
      if (count > 0) unused.push_back(fmt::format("{}: {}", what, count));
    };
    tell(within, "closed lines within pieces");
    tell(small_, "closed lines of less than 4 cm2");
    tell(open, "open lines that are no grain, fold or notch");
    tell(marks, "marks that belong to no piece");
    tell(sheets_, "frames, legends and test squares");
    return pieces;
  }

 private:
  int innermost(const SvgShape& shape) const {
    return shape.groups.empty() ? -1 : shape.groups.back();
  }

  /// What its label, id, class and the group round it say.
  pattern::PieceWords words(const SvgShape& shape) const {
    std::string all = own_name(shape.label, shape.id) + " " + shape.classes;
    return pattern::words_of(all);
  }
  pattern::PieceWords group_words(const SvgShape& shape) const {
    const int g = innermost(shape);
    if (g < 0) return {};
    return pattern::words_of(own_name(document_.groups[g].label, document_.groups[g].id));
  }

  bool encloses_a_piece(const SvgShape& shape) const {
    return std::any_of(shape.runs.begin(), shape.runs.end(), [&](const SvgRun& run) {
      const SampledRun line = sampled_in_metres(run, unit_);
      return line.closed && std::abs(pattern::signed_area(line.points)) >= kSmallestPiece;
    });
  }

  void gather() {
    for (const SvgShape& shape : document_.shapes) {
      const pattern::PieceWords own = words(shape), group = group_words(shape);
      if (own.sheet || group.sheet) {
        ++sheets_;
        continue;
      }
      const bool mark = own.grain || own.fold || own.notch;
      // A group may be called after its piece, whatever else its name says.
      if (mark || ((group.grain || group.fold || group.notch) && !encloses_a_piece(shape))) {
        marks_.push_back(&shape);
        continue;
      }
      for (const SvgRun& run : shape.runs) {
        Run one{&shape, sampled_in_metres(run, unit_), 0};
        if (one.line.points.size() < 2) continue;
        points_ += one.line.points.size();
        if (points_ > kMostPoints)
          throw InvalidInput({file_, shape.line, {}},
                             fmt::format("lines with more than {} points", kMostPoints),
                             "a pattern");
        if (one.line.closed && one.line.points.size() > 2) {
          // Letters drawn as paths are many and small.
          one.area = std::abs(pattern::signed_area(one.line.points));
          if (one.area < kSmallestPiece)
            ++small_;
          else
            closed_.push_back(std::move(one));
        } else {
          open_.push_back(std::move(one));
        }
      }
    }
    if (closed_.size() > kMostClosed)
      throw InvalidInput({file_, 0, {}}, fmt::format("{} closed lines", closed_.size()),
                         fmt::format("a pattern of at most {}", kMostClosed));
  }

  bool is_rectangle(const Run& run) const {
    return run.shape->kind == "rect" || (run.line.points.size() == 4 && run.line.nodes.size() <= 5);
  }

  /// Rectangles that cover the page, or several other closed lines.
  void drop_frames() {
    const Vec2 page = unit_ * (document_.high - document_.low);
    std::vector<Run> kept;
    std::vector<char> frame(closed_.size(), 0);
    for (std::size_t i = 0; i < closed_.size(); ++i) {
      if (!is_rectangle(closed_[i])) continue;
      Vec2 low = Vec2::Constant(1e9), high = -low;
      for (const Vec2& p : closed_[i].line.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
      const Vec2 size = high - low;
      if (page.minCoeff() > 0 && size.x() > kWholePage * page.x() &&
          size.y() > kWholePage * page.y()) {
        frame[i] = 1;
        continue;
      }
      int others = 0;
      for (std::size_t j = 0; j < closed_.size() && others < 2; ++j)
        others += j != i && closed_[j].area >= kSmallestPiece &&
                  closed_[j].area < closed_[i].area &&
                  words(*closed_[j].shape).seam == words(*closed_[i].shape).seam &&
                  lies_inside(closed_[j].line.points, closed_[i].line.points);
      frame[i] = others >= 2;
    }
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (frame[i])
        ++sheets_;
      else
        kept.push_back(std::move(closed_[i]));
    closed_ = std::move(kept);
  }

  void find_inner() {
    within_.assign(closed_.size(), -1);
    for (std::size_t i = 0; i < closed_.size(); ++i)
      for (std::size_t j = 0; j < closed_.size() && within_[i] < 0; ++j)
        if (i != j && closed_[j].area >= kSmallestPiece &&
            (closed_[i].area < closed_[j].area || (closed_[i].area == closed_[j].area && i > j)) &&
            lies_inside(closed_[i].line.points, closed_[j].line.points))
          within_[i] = static_cast<int>(j);
  }

  /// The sew line within a cut line.
  const Run* sew_line(std::size_t outer) const {
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (within_[i] == static_cast<int>(outer) && words(*closed_[i].shape).seam &&
          closed_[i].area > kShareOfPiece * closed_[outer].area)
        return &closed_[i];
    return nullptr;
  }

  std::string name_of(const SvgShape& shape, const std::map<int, int>& pieces_of_group,
                      std::size_t number) const {
    std::string name = own_name(shape.label, shape.id);
    // "cut" and "seam" are what the line is, its group is what the piece is.
    if (name == "cut" || name == "cutline" || pattern::words_of(name).seam) name.clear();
    for (std::size_t k = shape.groups.size(); name.empty() && k-- > 0;) {
      const SvgGroup& group = document_.groups[shape.groups[k]];
      const auto count = pieces_of_group.find(shape.groups[k]);
      const bool several = count != pieces_of_group.end() && count->second > 1;
      if (group.layer && several) break;
      name = own_name(group.label, group.id);
    }
    name = clean_name(name);
    return name.empty() ? fmt::format("piece_{}", number + 1) : name;
  }

  /// Groups without a closed line whose open ones close together.
  void chain_groups(std::vector<SvgPiece>& pieces, const std::map<int, int>& pieces_of_group) {
    std::map<int, std::vector<const Run*>> open;
    for (const Run& run : open_) open[innermost(*run.shape)].push_back(&run);
    for (const auto& [group, runs] : open) {
      if (pieces_of_group.count(group) || runs.size() > kMostOpen || runs.size() < 2) continue;
      std::vector<DrawnLine> lines;
      for (const Run* run : runs) lines.push_back({run->line.points, false, true});
      Chained chained = chain_lines(lines, {});
      int made = 0;
      for (Outline& loop : chained.loops) {
        if (std::abs(outline_area(loop)) < kSmallestPiece) continue;
        SvgPiece piece;
        piece.line = runs[0]->shape->line;
        const std::string name =
            group < 0 ? std::string()
                      : own_name(document_.groups[group].label, document_.groups[group].id);
        piece.piece.name =
            name.empty() ? fmt::format("piece_{}", pieces.size() + 1) : clean_name(name);
        std::vector<Vec2> points;
        for (const OutlinePoint& p : loop) points.push_back(p.at);
        piece.piece.outline = cleaned(std::move(loop));
        pieces.push_back(std::move(piece));
        groups_.push_back(made++ == 0 ? group : -1);
        outlines_.push_back(std::move(points));
      }
      if (made > 0) chained_ += static_cast<int>(runs.size());
    }
  }

  /// Index of the piece that a mark lies in, or next to.
  int piece_of(const SvgShape& mark, const Vec2& at) const {
    for (std::size_t k = mark.groups.size(); k-- > 0;)
      for (std::size_t p = 0; p < groups_.size(); ++p)
        if (groups_[p] == mark.groups[k] && groups_[p] >= 0) return static_cast<int>(p);
    int nearest = -1;
    double least = kNearOutline;
    for (std::size_t p = 0; p < outlines_.size(); ++p) {
      if (pattern::inside_polygon(outlines_[p], at)) return static_cast<int>(p);
      const double d = (pattern::closest_on_polygon(outlines_[p], at) - at).norm();
      if (d < least) least = d, nearest = static_cast<int>(p);
    }
    return nearest;
  }

  /// \return how many belong nowhere
  int give_marks(std::vector<SvgPiece>& pieces) const {
    int lost = 0;
    for (const SvgShape* mark : marks_) {
      const pattern::PieceWords own = words(*mark), group = group_words(*mark);
      const bool grain = own.grain || (!own.fold && !own.notch && group.grain);
      const bool fold = own.fold || (!own.grain && !own.notch && group.fold);
      const std::optional<Axis> axis = longest_side(*mark, unit_);
      const Vec2 start = in_metres({mark->runs[0].start}, unit_)[0];
      const Vec2 at = (grain || fold) && axis ? Vec2((axis->first + axis->second) / 2) : start;
      const int p = piece_of(*mark, at);
      if (p < 0 || ((grain || fold) && !axis)) {
        ++lost;
      } else if (grain) {
        pieces[p].piece.grain = axis;
      } else if (fold) {
        pieces[p].piece.fold = axis;
      } else {
        pieces[p].piece.notches.push_back(at);
      }
    }
    return lost;
  }

  const SvgDocument& document_;
  double unit_;
  const std::string& file_;
  std::vector<Run> closed_, open_;
  std::vector<int> within_;  ///< index of a closed line round it; −1
  std::vector<const SvgShape*> marks_;
  std::vector<int> groups_;                  ///< per piece: the group that is its own; −1
  std::vector<std::vector<Vec2>> outlines_;  ///< per piece
  int sheets_ = 0, chained_ = 0, small_ = 0;
  std::size_t points_ = 0;
};

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
  std::vector<SvgPiece> pieces;
  for (auto& [group, part] : parts) {
    if (part.seam.points.empty()) {
      unused.push_back("part " + printable(part.name) +
                       ": it has no closed path of class \"fabric\"");
      continue;
    }
    SvgPiece piece;
    piece.line = line_of[group];
    piece.piece = drawn_freesewing(std::move(part), marked, piece.count);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<SvgPiece> drawn_pieces(const SvgDocument& document, double unit,
                                   const std::string& file, std::vector<std::string>& unused) {
  return Sorter(document, unit, file).sort(unused);
}

}  // namespace loosefit::io
