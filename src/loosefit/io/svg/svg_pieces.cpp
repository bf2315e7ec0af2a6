#include "loosefit/io/svg/svg_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/pieces/cloth_words.h"
#include "loosefit/io/svg/svg_labels.h"
#include "loosefit/io/svg/svg_lines.h"
#include "loosefit/io/svg/svg_marks.h"
#include "loosefit/io/svg/svg_nested.h"
#include "loosefit/io/svg/svg_sizes.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostClosed = 1000;  // closed lines
constexpr std::size_t kMostPoints = 2'000'000;
constexpr std::size_t kMostOpen = 2000;  // open lines of one group

constexpr double kClosedGap = 2e-3;     // between ends of a line that was meant to be closed [m]
constexpr double kNearlyClosed = 0.05;  // of its length is the gap of a line that may be a piece
constexpr std::size_t kMostInner = 8;   // lines that one warning names

/// Without what says how often it is cut; empty: it says nothing else.
std::string clean_name(std::string name) {
  if (name.starts_with("panel-")) name.erase(0, 6);  // of our own sheets
  name = name.substr(0, 100);
  std::string rest;
  return find_quantity(name, &rest) ? rest : name;
}

class Sorter {
 public:
  Sorter(const SvgDocument& document, double unit, const std::string& file, const std::string& size)
      : document_(document), unit_(unit), file_(file), size_(size) {}

  std::vector<CountedPiece> sort(LeftOut& left) {
    gather(left);
    closed_ = without_frames(document_, std::move(closed_), unit_, left);
    within_ = lines_round(document_, closed_);
    hole_names_ = holes_by_text(document_, unit_, closed_, within_, left);
    std::vector<CountedPiece> pieces;
    std::map<int, int> pieces_of_group;
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (is_outline(i)) ++pieces_of_group[innermost_group(*closed_[i].shape)];
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (is_outline(i))
        pieces.push_back(piece_of_outline(i, pieces_of_group, pieces.size(), left));
    chain_groups(pieces, pieces_of_group, left);
    cut_lone_holes(pieces, left);
    give_marks(document_, unit_, marks_, places_, pieces, left);
    give_counts(document_, unit_, shapes_, places_, pieces, left);
    for (const SvgLine& open : open_)
      if (!chained_groups_.count(innermost_group(*open.shape)))
        left.count("open lines that are no grain, fold or notch", called_line(*open.shape));
    return pieces;
  }

 private:
  /// In no other line, and called no hole: "keyhole back" is the piece.
  bool is_outline(std::size_t i) const {
    if (within_[i] >= 0) return false;
    const pattern::PieceWords words = words_of_shape(*closed_[i].shape);
    return !is_called_hole(document_, *closed_[i].shape) || words.front || words.back ||
           words.sleeve || words.leg || words.skirt || words.yoke || words.hood || words.top;
  }

  /// Holes of pieces that are drawn by open lines.
  void cut_lone_holes(std::vector<CountedPiece>& pieces, LeftOut& left) const {
    for (std::size_t i = 0; i < closed_.size(); ++i) {
      if (within_[i] >= 0 || is_outline(i)) continue;
      const SvgShape& shape = *closed_[i].shape;
      const int p = places_.piece_of(shape.groups, closed_[i].line.points[0]);
      const std::string name = own_name(shape.label, shape.id);
      if (p >= 0)
        pieces[p].piece.holes.push_back({name.empty() ? "hole" : name, closed_[i].line.points});
      else
        left.tell("closed line " + called_line(shape) +
                  ": it is called a hole and lies in no piece, nothing is cut");
    }
  }

  CountedPiece piece_of_outline(std::size_t i, const std::map<int, int>& pieces_of_group,
                                std::size_t number, LeftOut& left) {
    const std::vector<std::size_t> sizes = outlines_within(i);
    const std::size_t cut = size_.empty() || sizes.empty() ? i : of_asked_size(i, sizes);
    std::vector<std::size_t> others{i};
    others.insert(others.end(), sizes.begin(), sizes.end());
    others.erase(std::find(others.begin(), others.end(), cut));
    CountedPiece made;
    DrawnPiece& piece = made.piece;
    const SvgShape& shape = *closed_[cut].shape;
    made.place = fmt::format("at line {}", shape.line);
    made.of_size = !size_.empty() && !sizes.empty();
    piece.name = name_of(shape, others, pieces_of_group, number);
    const SvgLine* outline = &closed_[cut];
    if (const SvgLine* seam = sew_line(cut, others, piece.notes))
      outline = seam, piece.on_sew_line = true;
    if (words_of_shape(*outline->shape).seam) piece.on_sew_line = true;
    set_outline(piece, outline->line.points, outline->line.nodes);
    tell_unseen(piece, shape, *outline);
    for (const std::size_t k : others)
      left.count("outlines of other sizes", called_line(*closed_[k].shape));
    if (!made.of_size && !sizes.empty())
      piece.notes.push_back(fmt::format(
          "the largest of {} outlines that lie in each other is taken, not {}: a word of its "
          "label picks one of another size (--size, in a scenario garment.size), and a sew line "
          "is one that is called \"seam\"",
          sizes.size() + 1, labels_of(sizes)));
    cut_holes(piece, i, cut, outline, others, left);
    const int group = innermost_group(shape);
    const auto pieces_in_group = pieces_of_group.find(group);
    const bool own = pieces_in_group != pieces_of_group.end() && pieces_in_group->second == 1;
    places_.groups.push_back(own ? group : -1);
    places_.outlines.push_back(closed_[cut].line.points);
    shapes_.push_back(&shape);
    return made;
  }

  /// What nobody sees in a viewer is sewn all the same, which is told.
  void tell_unseen(DrawnPiece& piece, const SvgShape& shape, const SvgLine& outline) const {
    if (!shape.unseen.empty())
      piece.notes.push_back("its line is not to be seen (" + printable(shape.unseen, 80) +
                            "): taken all the same; `display: none` leaves it out");
    const Vec2 a = unit_ * document_.low, b = unit_ * document_.high;
    const Eigen::AlignedBox2d page(Vec2(a.x(), -b.y()), Vec2(b.x(), -a.y()));
    if ((b - a).minCoeff() > 0 && !page.intersects(box_of(outline.line.points)))
      piece.notes.push_back("it stands outside of the page: taken all the same");
  }

  /// Lines within a piece: holes where they are called so, or are drawn in one path with its
  /// outline; of several sizes those of the one that is taken. All others are told.
  void cut_holes(DrawnPiece& piece, std::size_t outer, std::size_t cut, const SvgLine* outline,
                 const std::vector<std::size_t>& others, LeftOut& left) const {
    std::vector<std::size_t> holes;
    std::vector<std::string> told;
    for (std::size_t k = 0; k < closed_.size(); ++k) {
      const SvgLine& line = closed_[k];
      const bool outline_of_size =
          std::find(others.begin(), others.end(), k) != others.end() || k == cut;
      if (k == outer || outermost(k) != outer || &line == outline || outline_of_size) continue;
      const pattern::PieceWords words = words_of_shape(*line.shape);
      const bool one_path =
          line.shape == closed_[cut].shape && line.area <= kShareOfPiece * closed_[cut].area;
      if (is_called_hole(document_, *line.shape) || one_path || !hole_names_[k].empty()) {
        holes.push_back(k);
      } else if (words.seam) {
        left.count("sew lines that are not used", called_line(*line.shape));
      } else {
        left.count("closed lines within pieces", called_line(*line.shape));
        told.push_back(called_line(*line.shape));
      }
    }
    const auto of_size = [&](std::size_t k) { return has_words(labels_round(k), size_); };
    if (!size_.empty() && !others.empty() && std::any_of(holes.begin(), holes.end(), of_size))
      std::erase_if(holes, [&](std::size_t k) {
        if (of_size(k)) return false;
        left.count("holes of other sizes", called_line(*closed_[k].shape));
        return true;
      });
    for (const std::size_t k : holes) {
      std::string name = hole_names_[k];
      if (name.empty() && closed_[k].shape != closed_[cut].shape)
        name = own_name(closed_[k].shape->label, closed_[k].shape->id);
      piece.holes.push_back({name.empty() ? "hole" : name, closed_[k].line.points});
    }
    if (told.empty()) return;
    const std::size_t more = told.size() > kMostInner ? told.size() - kMostInner : 0;
    told.resize(told.size() - more);
    piece.notes.push_back(fmt::format(
        "closed lines within it are drawn on it and not cut: {}{}; one that is called \"hole\", or "
        "is drawn in one path with the outline, is cut",
        join(told), more > 0 ? fmt::format(" and {} more", more) : std::string()));
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
        const pattern::PieceWords own = words_of_shape(shape);
        if ((!(own.grain || own.fold || own.notch) || names_a_piece(own)) &&
            encloses_a_piece(shape))
          groups_with_pieces_->insert(shape.groups.begin(), shape.groups.end());
      }
    }
    return groups_with_pieces_->count(group) > 0;
  }

  /// "Front 1:1 scale" is a front; a layer that is called "Page 2" holds pieces.
  bool is_of_sheet(const SvgShape& shape, const pattern::PieceWords& own,
                   const pattern::PieceWords& group) const {
    if (names_cloth(own)) return false;
    if (own.sheet || !group.sheet) return own.sheet;
    const SvgGroup& round = document_.groups[innermost_group(shape)];
    const std::vector<std::string> words = words_in(own_name(round.label, round.id));
    return !names_cloth(group) && words != std::vector<std::string>{"page"};
  }

  /// Lines that nearly close, and others with the name of a piece, are cloth that was lost.
  void tell_open(LeftOut& left) const {
    for (const SvgLine& open : open_) {
      const std::vector<Vec2>& points = open.line.points;
      const double gap = (points.front() - points.back()).norm();
      double length = 0;
      for (std::size_t k = 0; k + 1 < points.size(); ++k)
        length += (points[k + 1] - points[k]).norm();
      const bool named = gap < kNearlyClosed * length || names_cloth(words_of_shape(*open.shape)) ||
                         names_cloth(words_of_group(document_, *open.shape)) ||
                         !own_name(open.shape->label, open.shape->id).empty();
      const bool within = std::any_of(closed_.begin(), closed_.end(), [&](const SvgLine& piece) {
        return lies_inside(points, piece.line.points);
      });
      if (named && !within && !chained_groups_.count(innermost_group(*open.shape)) &&
          points.size() > 2 && std::abs(pattern::signed_area(points)) >= kSmallestPiece)
        left.warnings.push_back(fmt::format(
            "open line {}: left out, its ends are {:.3g} mm apart; close it if it is a piece",
            called_line(*open.shape), 1e3 * gap));
    }
  }

  void gather(LeftOut& left) {
    std::vector<const SvgShape*> large_marks;
    for (const SvgShape& shape : document_.shapes) {
      const pattern::PieceWords own = words_of_shape(shape),
                                group = words_of_group(document_, shape);
      if (is_of_sheet(shape, own, group)) {
        const std::string name = own_name(shape.label, shape.id);
        left.count("frames, legends and test squares", called_line(shape));
        if (!name.empty() && (!own.sheet || words_in(name).size() > 1) && encloses_a_piece(shape))
          left.warnings.push_back("closed line " + called_line(shape) +
                                  ": left out, it or its group is called after a page, a frame, a "
                                  "scale or a title; called after a piece (front, back) it is one");
        continue;
      }
      // A piece, or the group round it, may be called "front on fold" or "notched collar".
      const bool mark = !own.hole && (own.grain || own.fold || own.notch);
      const bool of_marks = (group.grain || group.fold || group.notch) &&
                            !(names_a_piece(group) && holds_a_piece(innermost_group(shape)));
      if (!mark && !of_marks)
        take(shape, left);
      else if (!encloses_a_piece(shape))
        marks_.push_back(&shape);
      else if (mark)
        large_marks.push_back(&shape);
      else
        take(shape, left);
    }
    const std::size_t certain = closed_.size();
    for (const SvgShape* shape : large_marks) take(*shape, left);
    part_large_marks(certain);
    // In the order of the file.
    std::stable_sort(closed_.begin(), closed_.end(),
                     [](const SvgLine& a, const SvgLine& b) { return a.shape < b.shape; });
  }

  /// Sorts the lines of a shape.
  void take(const SvgShape& shape, LeftOut& left) {
    for (const SvgRun& run : shape.runs) {
      SvgLine one{&shape, sampled_in_metres(run, unit_), 0};
      if (one.line.points.size() < 2) continue;
      points_ += one.line.points.size();
      if (points_ > kMostPoints)
        throw InvalidInput({file_, shape.line, {}},
                           fmt::format("lines with more than {} points", kMostPoints), "a pattern");
      const double gap = (one.line.points.front() - one.line.points.back()).norm();
      if (!one.line.closed && one.line.points.size() > 2 && gap <= kClosedGap &&
          std::abs(pattern::signed_area(one.line.points)) >= kSmallestPiece) {
        one.line.closed = true;
        left.warnings.push_back(fmt::format("open line {}: closed, its ends are {:.3g} mm apart",
                                            called_line(shape), 1e3 * gap));
      }
      if (one.line.closed && one.line.points.size() > 2) {
        // Letters drawn as paths are many and small.
        one.area = std::abs(pattern::signed_area(one.line.points));
        if (one.area >= kSmallestPiece)
          closed_.push_back(std::move(one));
        else if (is_called_hole(document_, shape))
          left.tell(
              "closed line " + called_line(shape) +
              ": not cut, it has less than 4 cm2, for which the mesh of a garment has no room");
        else
          left.count("closed lines of less than 4 cm2", called_line(shape));
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

  /// Lines within an outline that enclose nearly as much and are not called its sew line: other
  /// sizes, as a rule.
  std::vector<std::size_t> outlines_within(std::size_t outer) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (i != outer && outermost(i) == outer &&
          closed_[i].area > kShareOfPiece * closed_[outer].area &&
          !words_of_shape(*closed_[i].shape).seam && !is_called_hole(document_, *closed_[i].shape))
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
      if (outermost(i) == outermost(cut) && words_of_shape(*closed_[i].shape).seam &&
          closed_[i].area > kShareOfPiece * closed_[cut].area)
        seams.push_back(&closed_[i]);
    return seam_of_size(document_, closed_[cut], of_others, seams, size_, notes);
  }

  /// How many pieces have a closed line in a group, or in groups in it.
  std::ptrdiff_t pieces_in(int group) const {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < closed_.size(); ++i)
      count += is_outline(i) && stands_in(*closed_[i].shape, group);
    return count;
  }

  /// The label, else that of a group round it. A label that says of several outlines in each other
  /// which one this is, as sizes do, gives way to one that they share.
  std::string name_of(const SvgShape& shape, const std::vector<std::size_t>& others,
                      const std::map<int, int>& pieces_of_group, std::size_t number) const {
    std::vector<std::pair<std::string, int>> names;  // and the group; the innermost first
    const std::string own = clean_name(own_name(shape.label, shape.id));
    // "cut" and "seam" are what the line is, its group is what the piece is.
    if (!own.empty() && own != "cut" && own != "cutline" && !pattern::words_of(own).seam)
      names.emplace_back(own, -1);
    for (std::size_t k = shape.groups.size(); k-- > 0;) {
      const SvgGroup& group = document_.groups[shape.groups[k]];
      const auto count = pieces_of_group.find(shape.groups[k]);
      if (group.layer && count != pieces_of_group.end() && count->second > 1) break;
      const std::string name = clean_name(own_name(group.label, group.id));
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
      if (!is_size && !better_round_it) return name;
    }
    return names.empty() ? fmt::format("piece_{}", number + 1) : names[0].first;
  }

  /// Groups without a closed line whose open ones close together.
  void chain_groups(std::vector<CountedPiece>& pieces, const std::map<int, int>& pieces_of_group,
                    LeftOut& left) {
    std::map<int, std::vector<const SvgLine*>> open;
    for (const SvgLine& run : open_) open[innermost_group(*run.shape)].push_back(&run);
    for (const auto& [group, runs] : open) {
      if (pieces_of_group.count(group) || runs.size() > kMostOpen || runs.size() < 2) continue;
      std::vector<DrawnLine> lines;
      for (const SvgLine* run : runs) lines.push_back({run->line.points, false, true});
      Chained chained = chain_lines(lines, {});
      int made = 0;
      for (Outline& loop : chained.loops) {
        if (std::abs(outline_area(loop)) < kSmallestPiece) continue;
        CountedPiece piece;
        piece.place = fmt::format("at line {}", runs[0]->shape->line);
        const std::string name =
            group < 0 ? std::string()
                      : own_name(document_.groups[group].label, document_.groups[group].id);
        piece.piece.name =
            name.empty() ? fmt::format("piece_{}", pieces.size() + 1) : clean_name(name);
        std::vector<Vec2> points;
        for (const OutlinePoint& p : loop) points.push_back(p.at);
        piece.piece.outline = cleaned(std::move(loop));
        pieces.push_back(std::move(piece));
        places_.groups.push_back(made++ == 0 ? group : -1);
        places_.outlines.push_back(std::move(points));
        shapes_.push_back(runs[0]->shape);
      }
      if (made > 0) chained_groups_.insert(group);
    }
    tell_open(left);
  }

  const SvgDocument& document_;
  double unit_;
  const std::string &file_, &size_;
  std::vector<SvgLine> closed_, open_;
  std::vector<int> within_;  ///< index of a closed line round it; −1
  std::vector<const SvgShape*> marks_;
  std::vector<std::string> hole_names_;  ///< per closed line: the text that calls it a hole
  SvgPlaces places_;
  std::vector<const SvgShape*> shapes_;  ///< per piece
  std::optional<std::set<int>> groups_with_pieces_;
  std::set<int> chained_groups_;  ///< whose open lines close together
  std::size_t points_ = 0;
};

}  // namespace

std::vector<CountedPiece> drawn_pieces(const SvgDocument& document, double unit,
                                       const std::string& file, const std::string& size,
                                       LeftOut& left) {
  return Sorter(document, unit, file, size).sort(left);
}

}  // namespace loosefit::io
