#include "loosefit/io/svg/svg_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/svg/svg_labels.h"
#include "loosefit/io/svg/svg_lines.h"
#include "loosefit/io/svg/svg_sizes.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr double kSmallestPiece = 4e-4;  // [m²]
constexpr double kShareOfPiece = 0.5;    // of a piece, what its sew line and its next sizes enclose
constexpr double kNearOutline = 0.03;    // of notches and fold lines that have no group [m]
constexpr double kWholePage = 0.95;      // of its width and height
constexpr std::size_t kMostClosed = 1000;  // closed lines
constexpr std::size_t kMostPoints = 2'000'000;
constexpr std::size_t kMostOpen = 2000;  // open lines of one group

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

std::string clean_name(std::string name) {
  if (name.starts_with("panel-")) name.erase(0, 6);  // of our own sheets
  name = name.substr(0, 100);
  return name;
}

class Sorter {
 public:
  Sorter(const SvgDocument& document, double unit, const std::string& file, const std::string& size)
      : document_(document), unit_(unit), file_(file), size_(size) {}

  std::vector<SvgPiece> sort(std::vector<std::string>& unused) {
    gather();
    drop_frames();
    find_inner();
    std::vector<SvgPiece> pieces;
    std::map<int, int> pieces_of_group;
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (within_[i] < 0) ++pieces_of_group[innermost(*closed_[i].shape)];
    int within = 0, other_sizes = 0;
    for (std::size_t i = 0; i < closed_.size(); ++i) {
      if (within_[i] >= 0) {
        ++within;
        continue;
      }
      const std::vector<std::size_t> sizes = outlines_within(i);
      const std::size_t cut = size_.empty() || sizes.empty() ? i : of_asked_size(i, sizes);
      std::vector<std::size_t> others{i};
      others.insert(others.end(), sizes.begin(), sizes.end());
      others.erase(std::find(others.begin(), others.end(), cut));
      SvgPiece piece;
      const SvgShape& shape = *closed_[cut].shape;
      piece.line = shape.line;
      piece.of_size = !size_.empty() && !sizes.empty();
      piece.piece.name = name_of(shape, others, pieces_of_group, pieces.size());
      const SvgLine* outline = &closed_[cut];
      if (const SvgLine* seam = sew_line(cut, others, piece.piece.notes))
        outline = seam, piece.piece.on_sew_line = true, --within;
      if (words(*outline->shape).seam) piece.piece.on_sew_line = true;
      set_outline(piece.piece, outline->line.points, outline->line.nodes);
      if (piece.of_size) {
        within -= static_cast<int>(sizes.size());
        other_sizes += static_cast<int>(sizes.size());
      } else if (!sizes.empty()) {
        piece.piece.notes.push_back(fmt::format(
            "the largest of {} outlines that lie in each other is taken, not {}: a word of its "
            "label picks one of another size (--size, in a scenario garment.size), and a sew line "
            "is one that is called \"seam\"",
            sizes.size() + 1, labels_of(sizes)));
      }
      groups_.push_back(pieces_of_group[innermost(shape)] == 1 ? innermost(shape) : -1);
      outlines_.push_back(closed_[cut].line.points);
      pieces.push_back(std::move(piece));
    }
    chain_groups(pieces, pieces_of_group);
    const int marks = give_marks(pieces);
    for (SvgPiece& piece : pieces)
      if (!piece.piece.fold && pattern::words_of(piece.piece.name).fold)
        piece.piece.notes.push_back(
            "its name speaks of a fold, but no line called \"fold\" says where: not unfolded");
    const int open = static_cast<int>(open_.size()) - chained_;
    const auto tell = [&](int count, const char* what) {
      if (count > 0) unused.push_back(fmt::format("{}: {}", what, count));
    };
    tell(within, "closed lines within pieces");
    tell(other_sizes, "outlines of other sizes");
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

  /// A group called "front on fold" holds the piece, one called "front fold" a line of it.
  bool holds_a_piece(int group) {
    if (!groups_with_pieces_) {
      groups_with_pieces_.emplace();
      for (const SvgShape& shape : document_.shapes) {
        const pattern::PieceWords own = words(shape);
        if ((!(own.grain || own.fold || own.notch) || names_a_piece(own)) &&
            encloses_a_piece(shape))
          groups_with_pieces_->insert(shape.groups.begin(), shape.groups.end());
      }
    }
    return groups_with_pieces_->count(group) > 0;
  }

  void gather() {
    std::vector<const SvgShape*> large_marks;
    for (const SvgShape& shape : document_.shapes) {
      const pattern::PieceWords own = words(shape), group = group_words(shape);
      if (own.sheet || group.sheet) {
        ++sheets_;
        continue;
      }
      // A piece, or the group round it, may be called "front on fold" or "notched collar".
      const bool mark = own.grain || own.fold || own.notch;
      const bool of_marks = (group.grain || group.fold || group.notch) &&
                            !(names_a_piece(group) && holds_a_piece(innermost(shape)));
      if (!mark && !of_marks)
        take(shape);
      else if (!encloses_a_piece(shape))
        marks_.push_back(&shape);
      else if (mark)
        large_marks.push_back(&shape);
      else
        take(shape);
    }
    const std::size_t certain = closed_.size();
    for (const SvgShape* shape : large_marks) take(*shape);
    part_large_marks(certain);
    // In the order of the file.
    std::stable_sort(closed_.begin(), closed_.end(),
                     [](const SvgLine& a, const SvgLine& b) { return a.shape < b.shape; });
  }

  /// Sorts the lines of a shape.
  void take(const SvgShape& shape) {
    for (const SvgRun& run : shape.runs) {
      SvgLine one{&shape, sampled_in_metres(run, unit_), 0};
      if (one.line.points.size() < 2) continue;
      points_ += one.line.points.size();
      if (points_ > kMostPoints)
        throw InvalidInput({file_, shape.line, {}},
                           fmt::format("lines with more than {} points", kMostPoints), "a pattern");
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
    if (closed_.size() > kMostClosed)
      throw InvalidInput({file_, 0, {}}, fmt::format("more than {} closed lines", kMostClosed),
                         "a pattern");
  }

  /// Arrows and brackets drawn as closed lines: they lie at least with a part of them in a piece
  /// that is much larger.
  void part_large_marks(std::size_t certain) {
    std::vector<SvgLine> pieces(closed_.begin(),
                                closed_.begin() + static_cast<std::ptrdiff_t>(certain));
    for (std::size_t i = certain; i < closed_.size(); ++i) {
      const SvgLine& run = closed_[i];
      const bool mark = std::any_of(closed_.begin(), closed_.end(), [&](const SvgLine& piece) {
        if (run.area >= kShareOfPiece * piece.area) return false;
        const Eigen::AlignedBox2d box = box_of(piece.line.points);
        return std::any_of(run.line.points.begin(), run.line.points.end(), [&](const Vec2& p) {
          return box.contains(p) && pattern::inside_polygon(piece.line.points, p);
        });
      });
      if (!mark)
        pieces.push_back(run);
      else if (marks_.empty() || marks_.back() != run.shape)
        marks_.push_back(run.shape);
    }
    closed_ = std::move(pieces);
  }

  bool is_rectangle(const SvgLine& run) const {
    return run.shape->kind == "rect" || (run.line.points.size() == 4 && run.line.nodes.size() <= 5);
  }

  /// Rectangles that cover the page, or several other closed lines.
  void drop_frames() {
    const Vec2 page = unit_ * (document_.high - document_.low);
    std::vector<SvgLine> kept;
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
      // Nearly as large are only other sizes of it, which lie in each other.
      int others = 0, nearly_as_large = 0;
      for (std::size_t j = 0; j < closed_.size() && others + nearly_as_large < 2; ++j) {
        if (j == i || closed_[j].area >= closed_[i].area ||
            words(*closed_[j].shape).seam != words(*closed_[i].shape).seam ||
            !lies_inside(closed_[j].line.points, closed_[i].line.points))
          continue;
        if (closed_[j].area > kShareOfPiece * closed_[i].area)
          nearly_as_large = 1;
        else
          ++others;
      }
      frame[i] = others + nearly_as_large >= 2;
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

  /// Lines within an outline that enclose nearly as much and are not called its sew line: other
  /// sizes, as a rule.
  std::vector<std::size_t> outlines_within(std::size_t outer) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (i != outer && outermost(i) == outer &&
          closed_[i].area > kShareOfPiece * closed_[outer].area && !words(*closed_[i].shape).seam)
        found.push_back(i);
    return found;
  }

  std::size_t outermost(std::size_t line) const {
    while (within_[line] >= 0) line = static_cast<std::size_t>(within_[line]);
    return line;
  }

  std::string labels_round(std::size_t line) const {
    return all_labels(document_, *closed_[line].shape);
  }

  std::string labels_of(const std::vector<std::size_t>& lines) const {
    std::vector<std::string> labels;
    for (const std::size_t i : lines) labels.push_back(described(document_, *closed_[i].shape));
    return printable(join(labels), 300);
  }

  std::size_t of_asked_size(std::size_t outer, std::vector<std::size_t> outlines) const {
    outlines.insert(outlines.begin(), outer);
    std::vector<std::size_t> fitting;
    for (const std::size_t i : outlines)
      if (has_words(labels_round(i), size_)) fitting.push_back(i);
    if (fitting.size() == 1) return fitting[0];
    throw InvalidInput(
        {file_, closed_[outer].shape->line, "size"}, '"' + printable(size_) + '"',
        fmt::format("a word in the labels of just one of {} outlines that lie in each "
                    "other ({}); it is in those of {}",
                    outlines.size(), labels_of(outlines), fitting.size()),
        "label the outlines, or the groups round them, with their sizes");
  }

  /// The sew line within a cut line.
  /// \param others  outlines of other sizes
  const SvgLine* sew_line(std::size_t cut, const std::vector<std::size_t>& others,
                          std::vector<std::string>& notes) const {
    std::vector<const SvgLine*> of_others, seams;
    for (const std::size_t i : others) of_others.push_back(&closed_[i]);
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (outermost(i) == outermost(cut) && words(*closed_[i].shape).seam &&
          closed_[i].area > kShareOfPiece * closed_[cut].area)
        seams.push_back(&closed_[i]);
    return seam_of_size(document_, closed_[cut], of_others, seams, size_, notes);
  }

  /// How many pieces have a closed line in a group, or in groups in it.
  std::ptrdiff_t pieces_in(int group) const {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < closed_.size(); ++i)
      count += within_[i] < 0 && stands_in(*closed_[i].shape, group);
    return count;
  }

  /// The label, else that of a group round it. A label that says of several outlines in each other
  /// which one this is, as sizes do, gives way to one that they share.
  std::string name_of(const SvgShape& shape, const std::vector<std::size_t>& others,
                      const std::map<int, int>& pieces_of_group, std::size_t number) const {
    std::vector<std::pair<std::string, int>> names;  // and the group; the innermost first
    const std::string own = own_name(shape.label, shape.id);
    // "cut" and "seam" are what the line is, its group is what the piece is.
    if (!own.empty() && own != "cut" && own != "cutline" && !pattern::words_of(own).seam)
      names.emplace_back(own, -1);
    for (std::size_t k = shape.groups.size(); k-- > 0;) {
      const SvgGroup& group = document_.groups[shape.groups[k]];
      const auto count = pieces_of_group.find(shape.groups[k]);
      if (group.layer && count != pieces_of_group.end() && count->second > 1) break;
      const std::string name = own_name(group.label, group.id);
      if (!name.empty()) names.emplace_back(name, shape.groups[k]);
    }
    const auto shared = [&](const std::string& name) {
      return std::any_of(others.begin(), others.end(),
                         [&](std::size_t i) { return has_words(labels_round(i), name); });
    };
    const auto is_piece = [](const std::string& name) {
      return names_a_piece(pattern::words_of(name));
    };
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::string& name = names[k].first;
      const bool is_size = !size_.empty() && in_words(name) == in_words(size_);
      const bool better_round_it = !others.empty() && !shared(name) &&
                                   std::any_of(names.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                                               names.end(), [&](const auto& round) {
                                                 return shared(round.first) &&
                                                        pieces_in(round.second) == 1 &&
                                                        (is_piece(round.first) || !is_piece(name));
                                               });
      if (!is_size && !better_round_it) return clean_name(name);
    }
    return names.empty() ? fmt::format("piece_{}", number + 1) : clean_name(names[0].first);
  }

  /// Groups without a closed line whose open ones close together.
  void chain_groups(std::vector<SvgPiece>& pieces, const std::map<int, int>& pieces_of_group) {
    std::map<int, std::vector<const SvgLine*>> open;
    for (const SvgLine& run : open_) open[innermost(*run.shape)].push_back(&run);
    for (const auto& [group, runs] : open) {
      if (pieces_of_group.count(group) || runs.size() > kMostOpen || runs.size() < 2) continue;
      std::vector<DrawnLine> lines;
      for (const SvgLine* run : runs) lines.push_back({run->line.points, false, true});
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
  const std::string &file_, &size_;
  std::vector<SvgLine> closed_, open_;
  std::vector<int> within_;  ///< index of a closed line round it; −1
  std::vector<const SvgShape*> marks_;
  std::vector<int> groups_;                  ///< per piece: the group that is its own; −1
  std::vector<std::vector<Vec2>> outlines_;  ///< per piece
  std::optional<std::set<int>> groups_with_pieces_;
  int sheets_ = 0, chained_ = 0, small_ = 0;
  std::size_t points_ = 0;
};

}  // namespace

std::vector<SvgPiece> drawn_pieces(const SvgDocument& document, double unit,
                                   const std::string& file, const std::string& size,
                                   std::vector<std::string>& unused) {
  return Sorter(document, unit, file, size).sort(unused);
}

}  // namespace loosefit::io
