#include "loosefit/io/svg/svg_marks.h"

#include <optional>

#include "loosefit/base/text.h"
#include "loosefit/io/pieces/fold_words.h"
#include "loosefit/io/pieces/quantity.h"
#include "loosefit/io/svg/svg_labels.h"
#include "loosefit/io/svg/svg_lines.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr double kNearOutline = 0.03;  // of marks and texts that have no group [m]

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

bool has_digit(const std::string& text) {
  return text.find_first_of("0123456789") != std::string::npos;
}

/// Per piece the texts in it or beside it that say how often it is cut or speak of a fold. Others
/// with a number or a word of a count are told.
std::vector<std::vector<std::string>> telling_texts(const SvgDocument& document, double unit,
                                                    const SvgPlaces& places,
                                                    std::vector<CountedPiece>& pieces,
                                                    LeftOut& left) {
  std::vector<std::vector<std::string>> texts(pieces.size());
  for (const SvgText& text : document.texts) {
    const std::string words = trimmed_words(text.words), shown = '"' + printable(words, 60) + '"';
    const bool tells = find_quantity(words) || speaks_of_fold(words);
    const bool may_count = !tells && speaks_of_count(words);
    if (!tells && !may_count) {
      if (has_digit(words)) left.count("texts that are not read", shown);
      continue;
    }
    std::optional<Vec2> at;
    if (text.at) at = in_metres({*text.at}, unit)[0];
    const int p = places.piece_of(text.groups, at);
    if (p < 0) {
      left.tell("text " + shown + " at line " + std::to_string(text.line) +
                ": it stands in no piece and next to none, it counts and folds nothing");
    } else if (tells) {
      texts[p].push_back(words);
    } else {
      pieces[p].piece.notes.push_back("its text " + shown +
                                      " may say how often it is cut and is not understood: it "
                                      "counts nothing");
      left.count("texts that are not read", shown);
    }
  }
  return texts;
}

void tell_of_fold(DrawnPiece& piece, const std::vector<std::string>& texts,
                  const std::vector<std::string>& labels) {
  const char* const mark = "no line called \"fold\"";
  if (speaks_of_fold(piece.name))
    note_missing_fold(piece, "its name", piece.name, mark);
  else
    for (const std::string& label : labels) note_missing_fold(piece, "its label", label, mark);
  for (const std::string& text : texts) note_missing_fold(piece, "its text", text, mark);
}

}  // namespace

int SvgPlaces::piece_of(const std::vector<int>& round, const std::optional<Vec2>& at) const {
  for (std::size_t k = round.size(); k-- > 0;)
    for (std::size_t p = 0; p < groups.size(); ++p)
      if (groups[p] == round[k] && groups[p] >= 0) return static_cast<int>(p);
  if (!at) return -1;
  int nearest = -1;
  double least = kNearOutline;
  for (std::size_t p = 0; p < outlines.size(); ++p) {
    if (pattern::inside_polygon(outlines[p], *at)) return static_cast<int>(p);
    const double d = (pattern::closest_on_polygon(outlines[p], *at) - *at).norm();
    if (d < least) least = d, nearest = static_cast<int>(p);
  }
  return nearest;
}

void give_marks(const SvgDocument& document, double unit, const std::vector<const SvgShape*>& marks,
                const SvgPlaces& places, std::vector<CountedPiece>& pieces, LeftOut& left) {
  for (const SvgShape* mark : marks) {
    const pattern::PieceWords own = words_of_shape(*mark), group = words_of_group(document, *mark);
    const bool grain = own.grain || (!own.fold && !own.notch && group.grain);
    const bool fold = own.fold || (!own.grain && !own.notch && group.fold);
    const std::optional<Axis> axis = longest_side(*mark, unit);
    const Vec2 start = in_metres({mark->runs[0].start}, unit)[0];
    const Vec2 at = (grain || fold) && axis ? Vec2((axis->first + axis->second) / 2) : start;
    const int p = places.piece_of(mark->groups, at);
    if (p < 0 || ((grain || fold) && !axis)) {
      if (fold)
        left.tell("fold line " + called_line(*mark) +
                  ": it belongs to no piece, nothing is unfolded");
      else
        left.count("marks that belong to no piece", own_name(mark->label, mark->id));
    } else if (grain) {
      pieces[p].piece.grain = axis;
    } else if (fold) {
      for (const SvgRun& run : mark->runs)
        pieces[p].piece.folds.push_back(sampled_in_metres(run, unit).nodes);
    } else {
      pieces[p].piece.notches.push_back(at);
    }
  }
}

void give_counts(const SvgDocument& document, double unit,
                 const std::vector<const SvgShape*>& shapes, const SvgPlaces& places,
                 std::vector<CountedPiece>& pieces, LeftOut& left) {
  const auto all_texts = telling_texts(document, unit, places, pieces, left);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    DrawnPiece& piece = pieces[p].piece;
    const std::vector<std::string>& texts = all_texts[p];
    std::vector<std::string> labels;
    std::optional<PieceCount> known;
    const auto take = [&](const std::optional<PieceCount>& count) {
      if (!count) return;
      if (!known)
        known = count;
      else if (count->as_drawn != known->as_drawn || count->mirrored != known->mirrored)
        piece.notes.push_back("it is said to be cut as \"" + printable(known->said) +
                              "\" and as \"" + printable(count->said) + "\": the first is taken");
    };
    const auto read = [&](const std::string& quantity) {
      if (quantity.empty()) return;
      const std::optional<PieceCount> count = read_quantity(quantity);
      if (!count)
        piece.notes.push_back("its quantity \"" + printable(quantity) + "\" is no number");
      take(count);
    };
    if (const SvgShape* shape = shapes[p]) {
      read(shape->quantity);
      labels = shape->said;
      labels.push_back(own_name(shape->label, shape->id));
      for (const std::string& words : labels) take(find_quantity(words));
    }
    for (const std::string& words : texts) take(find_quantity(words));
    if (const SvgShape* shape = shapes[p])
      for (std::size_t k = shape->groups.size(); k-- > 0;) {
        const SvgGroup& group = document.groups[shape->groups[k]];
        read(group.quantity);
        std::vector<std::string> around = group.said;
        around.push_back(own_name(group.label, group.id));
        for (const std::string& words : around) take(find_quantity(words));
        labels.insert(labels.end(), around.begin(), around.end());
      }
    if (known) pieces[p].count = *known;
    if (piece.folds.empty()) tell_of_fold(piece, texts, labels);
  }
}

}  // namespace loosefit::io
