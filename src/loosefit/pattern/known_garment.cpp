#include "loosefit/pattern/known_garment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "loosefit/base/text.h"
#include "loosefit/pattern/cap_scoop.h"
#include "loosefit/pattern/known_bands.h"
#include "loosefit/pattern/known_half_sleeves.h"
#include "loosefit/pattern/known_hood.h"
#include "loosefit/pattern/known_one_shoulder.h"
#include "loosefit/pattern/known_skirt.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"
#include "loosefit/pattern/skirt_below.h"

namespace loosefit::pattern {
namespace {

constexpr double kSameLength = 0.02;  // of lengths that are sewn or mirrored
constexpr double kDeeper = 0.01;      // by which a front's neck is lower [m]

double difference(double a, double b) { return std::abs(a - b) / std::max({a, b, 1e-9}); }

class Knower {
 public:
  explicit Knower(const Pattern& pattern) : pattern_(pattern) {
    garment_.pieces.resize(pattern.panels.size());
  }

  KnownGarment know() {
    for (std::size_t p = 0; p < pattern_.panels.size(); ++p) sort(static_cast<int>(p));
    if (trunks_.size() == 2 && (sleeves_.empty() || sleeves_.size() == 2) && legs_.empty())
      shirt();
    else if (one_shoulders_.size() == 2 && trunks_.empty() && sleeves_.empty() && legs_.empty())
      one_shoulder();
    else if (legs_.size() == 4 && trunks_.empty() && sleeves_.empty())
      trousers();
    else if (whole_legs_.size() == 2 && trunks_.empty() && sleeves_.empty() && legs_.empty())
      leggings();
    else if (trunks_.empty() && sleeves_.empty() && legs_.empty())
      skirt();
    if (garment_.kind == "skirt")
      for (const std::string& why : top_doubts(pattern_, garment_.pieces)) doubt(why);
    if (garment_.kind.empty()) {
      // What an outline may have been says nothing of the way up it stands.
      std::ranges::fill(garment_.pieces, KnownPiece{});
      return std::move(garment_);
    }
    if (trunks_.size() == 2 && skirts_.size() == 2) skirt_below();
    hood();
    for (const ChainSeam& seam : garment_.seams) {
      const double a = chain_length(pattern_, seam.first), b = chain_length(pattern_, seam.second);
      if (difference(a, b) > kSameLength)
        doubt(fmt::format("seam {}: its sides are {:.1f} and {:.1f} mm long", seam.name, 1000 * a,
                          1000 * b));
    }
    bands();
    std::vector<std::string> left;
    for (std::size_t p = 0; p < pattern_.panels.size(); ++p)
      if (garment_.pieces[p].role == PieceRole::unknown)
        left.push_back(printable(pattern_.panels[p].name));
    if (!left.empty()) doubt("no part of it: " + join(left));
    return std::move(garment_);
  }

 private:
  const Panel& panel(int p) const { return pattern_.panels[p]; }
  PieceWords words(int p) const { return words_of(panel(p)); }
  void doubt(const std::string& why) { garment_.doubts.push_back(why); }

  void sort(int p) {
    const PieceWords w = words(p);
    if (w.pocket || w.hood || w.yoke || w.cuff || w.waist || w.hem) return;
    if (w.neck && !w.front && !w.back && !w.sleeve) return;
    const std::vector<Section> sections = outline_sections(panel(p));
    if (!w.sleeve && !w.leg && (sections.size() == 8 || w.front || w.back))
      if (auto piece = as_trunk(sections)) {
        garment_.pieces[p] = *piece;
        return trunks_.push_back(p);
      }
    if (w.sleeve)
      if (auto piece = as_raglan_sleeve(sections)) {
        garment_.pieces[p] = *piece;
        return sleeves_.push_back(p);
      }
    if (w.leg || w.left || w.right)
      if (auto piece = as_whole_leg(sections); piece && !w.sleeve) {
        garment_.pieces[p] = *piece;
        return whole_legs_.push_back(p);
      }
    if (auto piece = as_sleeve(sections);
        piece && (w.sleeve || (!w.front && !w.back && !w.skirt))) {
      garment_.pieces[p] = *piece;
      return sleeves_.push_back(p);
    }
    if (!w.sleeve)
      if (auto piece = as_leg(sections)) {
        garment_.pieces[p] = *piece;
        return legs_.push_back(p);
      }
    if (!w.sleeve && !w.neck && (w.skirt || w.front || w.back))
      if (auto piece = as_skirt(sections)) {
        garment_.pieces[p] = *piece;
        return skirts_.push_back(p);
      }
    if (!w.sleeve && !w.leg && !w.skirt)
      if (auto piece = as_one_shoulder(sections)) {
        garment_.pieces[p] = *piece;
        return one_shoulders_.push_back(p);
      }
    gores_.push_back(p);
  }

  double neck_depth(int p) const {
    const std::vector<Section>& sections = garment_.pieces[p].sections;
    return section_depth(panel(p), sections[sections.size() / 2]);
  }

  /// Orders two pieces: the front first. By their names, else by `deeper`.
  void front_first(std::vector<int>& two, double deeper_by) {
    const PieceWords a = words(two[0]), b = words(two[1]);
    const int first = int(a.front) - int(a.back), second = int(b.front) - int(b.back);
    if (first == second && std::abs(deeper_by) < kDeeper) {
      // Front and back that are alike may change places without harm.
      if (first == 0 && !are_alike(garment_.pieces[two[0]], garment_.pieces[two[1]]))
        doubt("which of " + printable(panel(two[0]).name) + " and " +
              printable(panel(two[1]).name) + " is the front is not told");
      if (first != 0)
        doubt("both " + printable(panel(two[0]).name) + " and " + printable(panel(two[1]).name) +
              " are called " + (first > 0 ? "front" : "back"));
      return;
    }
    if (first < second || (first == second && deeper_by < 0)) std::swap(two[0], two[1]);
  }

  /// A front's neck is lower than a back's, whatever they are called.
  void doubt_names(int front, int back, double higher) {
    garment_.names_against_shapes.push_back(fmt::format(
        "{} is the front by its name, but the neck of {} is {:.0f} mm deeper, as that of a front "
        "is: their names may have changed places",
        printable(panel(front).name), printable(panel(back).name), 1000 * higher));
    doubt(garment_.names_against_shapes.back());
  }

  void add(const std::string& name, std::vector<Stitch::Side> first,
           std::vector<Stitch::Side> second) {
    garment_.seams.push_back({name, std::move(first), std::move(second), false});
  }
  std::vector<Stitch::Side> sides(int p, int section) const {
    return garment_.pieces[p].sections[section].sides(panel(p), p);
  }
  static void append(auto& to, const auto& more) { to.insert(to.end(), more.begin(), more.end()); }

  std::vector<int> unknown_pieces() const {
    std::vector<int> rest;
    for (std::size_t p = 0; p < pattern_.panels.size(); ++p)
      if (garment_.pieces[p].role == PieceRole::unknown) rest.push_back(static_cast<int>(p));
    return rest;
  }

  /// Of what is left a hood, which takes the neck.
  void hood() {
    const auto neck = std::find_if(loops_.begin(), loops_.end(), [](const OpenLoop& loop) {
      return loop.kind == LoopKind::neck;
    });
    if (neck == loops_.end()) return;
    KnownHood known = know_hood(pattern_, unknown_pieces(), *neck, front_middle_);
    append(garment_.doubts, known.doubts);
    if (!known.found()) return;
    for (KnownHood::Part& part : known.parts) garment_.pieces[part.panel] = std::move(part.piece);
    append(garment_.seams, known.seams);
    garment_.kind = "hooded " + garment_.kind;
    loops_.erase(neck);
  }

  /// Of what is left the bands at open loops.
  void bands() {
    KnownBands known = know_bands(pattern_, unknown_pieces(), loops_);
    for (KnownBand& band : known.bands) {
      garment_.pieces[band.panel].role = PieceRole::band;
      garment_.pieces[band.panel].side = loops_[band.loop].side;
      garment_.seams.push_back(std::move(band.side));
      garment_.seams.push_back(std::move(band.ends));
    }
    append(garment_.doubts, known.doubts);
  }

  void add_loop(const std::string& name, LoopKind kind, int side, std::vector<Stitch::Side> first,
                const std::vector<Stitch::Side>& more = {}) {
    append(first, more);
    loops_.push_back({name, kind, side, std::move(first)});
  }

  /// The neck, which begins with that of the front.
  void add_neck(const std::vector<Stitch::Side>& front, const std::vector<Stitch::Side>& rest) {
    front_middle_ = chain_length(pattern_, front) / 2;
    front_middle_ /= 2 * front_middle_ + chain_length(pattern_, rest);
    add_loop("neck", LoopKind::neck, 0, front, rest);
  }

  void shirt() {
    front_first(trunks_, neck_depth(trunks_[0]) - neck_depth(trunks_[1]));
    const int front = trunks_[0], back = trunks_[1];
    if (const double higher = neck_depth(back) - neck_depth(front); higher > kDeeper)
      doubt_names(front, back, higher);
    const int last = static_cast<int>(garment_.pieces[front].sections.size()) - 1;
    const bool raglan = last == 5;
    if (garment_.pieces[back].sections.size() != garment_.pieces[front].sections.size()) return;
    for (const int p : sleeves_)
      if ((garment_.pieces[p].sections.size() == 6) != raglan) return;
    if (raglan && sleeves_.empty()) return;
    garment_.pieces[front].role = PieceRole::front;
    garment_.pieces[back].role = PieceRole::back;
    garment_.kind = sleeves_.empty() ? "tank top" : raglan ? "raglan shirt" : "t-shirt";
    // Seen from outside the wearer's left is at the right of the front, at the left of the back.
    add("side_L", sides(front, 1), sides(back, last));
    add("side_R", sides(front, last), sides(back, 1));
    add_loop("hem", LoopKind::hem, 0, sides(front, 0), sides(back, 0));
    if (raglan) return raglan_sleeves(front, back);
    add_neck(sides(front, 4), sides(back, 4));
    add("shoulder_L", sides(front, 3), sides(back, 5));
    add("shoulder_R", sides(front, 5), sides(back, 3));
    if (sleeves_.empty()) {
      if (half_sleeves({sides(front, 2), sides(back, 6)}, {sides(front, 6), sides(back, 2)}))
        return;
      add_loop("armhole_L", LoopKind::armhole, 1, sides(front, 2), sides(back, 6));
      add_loop("armhole_R", LoopKind::armhole, -1, sides(back, 2), sides(front, 6));
      return;
    }
    tell_sleeves([this](int p) { return cap_scoop(panel(p), garment_.pieces[p].sections[2]); });
    for (const int p : sleeves_) {
      const bool left = garment_.pieces[p].side > 0;
      const std::string name = left ? "_L" : "_R";
      std::vector<Stitch::Side> hole;
      if (left) {
        hole = sides(front, 2);
        append(hole, sides(back, 6));
      } else {
        hole = sides(back, 2);
        append(hole, sides(front, 6));
      }
      add("armhole" + name, sides(p, 2), hole);
      add("underarm" + name, sides(p, 1), sides(p, 3));
      add_loop("wrist" + name, LoopKind::wrist, left ? 1 : -1, sides(p, 0));
    }
  }

  bool half_sleeves(const OpenArmhole& left, const OpenArmhole& right) {
    KnownHalfSleeves known = know_half_sleeves(pattern_, unknown_pieces(), left, right);
    if (!known.found()) return false;
    garment_.kind = "shirt with sleeves in halves";
    take(known);
    return true;
  }

  void take(const auto& known) {
    for (const auto& [p, piece] : known.pieces) garment_.pieces[p] = piece;
    append(garment_.seams, known.seams);
    append(garment_.doubts, known.doubts);
    append(loops_, known.loops);
  }

  void one_shoulder() {
    const auto piece = [this](int p) -> KnownPiece& { return garment_.pieces[p]; };
    if (piece(one_shoulders_[0]).side == piece(one_shoulders_[1]).side) return skirt();
    trunks_ = one_shoulders_;
    front_first(trunks_, 0);
    const int front = trunks_[0], back = trunks_[1];
    garment_.kind = kOneShoulder;
    garment_.seams = one_shoulder_seams(pattern_, front, piece(front), back, piece(back));
    loops_ = one_shoulder_loops(pattern_, front, piece(front), back, piece(back));
    piece(front).role = PieceRole::front, piece(back).role = PieceRole::back;
    piece(front).side = piece(back).side = 0;  // they lie across the middle
  }

  /// A dress drawn as bodice and skirt.
  void skirt_below() {
    const auto at = [this](int p) { return PieceAt{p, &garment_.pieces[p]}; };
    std::vector<int> two = skirts_;
    front_first(two, 0);
    SkirtBelow below =
        know_skirt_below(pattern_, at(trunks_[0]), at(trunks_[1]), at(two[0]), at(two[1]));
    if (!below.found()) return;
    for (const int p : two) append(garment_.doubts, way_up_doubt(panel(p), garment_.pieces[p]));
    garment_.pieces[two[0]].role = PieceRole::front_skirt;
    garment_.pieces[two[1]].role = PieceRole::back_skirt;
    garment_.kind += " with a skirt";
    append(garment_.seams, below.seams);
    append(garment_.doubts, below.doubts);
    std::erase_if(loops_, [](const OpenLoop& loop) { return loop.kind == LoopKind::hem; });
    loops_.push_back(std::move(below.hem));
  }

  /// A sleeve's raglan next to its cuff in the outline is the front's on a right sleeve.
  void raglan_sleeves(int front, int back) {
    const double of_front = garment_.pieces[front].sections[2].length,
                 of_back = garment_.pieces[back].sections[2].length;
    tell_sleeves([&](int p) {
      const auto& s = garment_.pieces[p].sections;
      const double right = std::abs(s[2].length - of_front) + std::abs(s[4].length - of_back),
                   left = std::abs(s[4].length - of_front) + std::abs(s[2].length - of_back);
      return (left - right) / std::max(1e-9, of_front + of_back);
    });
    for (const int p : sleeves_) {
      const bool left = garment_.pieces[p].side > 0;
      const std::string name = left ? "_L" : "_R";
      add("raglan_front" + name, sides(p, left ? 4 : 2), sides(front, left ? 2 : 4));
      add("raglan_back" + name, sides(p, left ? 2 : 4), sides(back, left ? 4 : 2));
      add("underarm" + name, sides(p, 1), sides(p, 5));
      add_loop("wrist" + name, LoopKind::wrist, left ? 1 : -1, sides(p, 0));
    }
    // From front to back over the right sleeve, back over the left one.
    std::vector<Stitch::Side> neck;
    for (const int side : {-1, 1}) {
      for (const int p : sleeves_)
        if (garment_.pieces[p].side == side) append(neck, sides(p, 3));
      if (side < 0) append(neck, sides(back, 3));
    }
    add_neck(sides(front, 3), neck);
  }

  /// \param front_first_of positive where the outline goes from the cuff to the front of the arm
  /// first, as that of a right sleeve does
  void tell_sleeves(const std::function<double(int)>& front_first_of) {
    int side[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
      const int p = sleeves_[i];
      const PieceWords w = words(p);
      const double front_begins = front_first_of(p);
      const int shape = front_begins > kScoopTells ? -1 : front_begins < -kScoopTells ? 1 : 0;
      const int name = w.left ? 1 : w.right ? -1 : 0;
      if (name != 0 && shape != 0 && name != shape)
        doubt("piece " + printable(panel(p).name) +
              ": its name and the shape of its cap say different arms");
      side[i] = name != 0 ? name : shape;
    }
    if (side[0] == 0 && side[1] == 0)
      side[0] = -1, side[1] = 1;
    else if (side[0] == 0)
      side[0] = -side[1];
    else if (side[1] == 0)
      side[1] = -side[0];
    if (side[0] == side[1]) {
      doubt("both sleeves are for the same arm");
      side[1] = -side[0];
    }
    for (int i = 0; i < 2; ++i) garment_.pieces[sleeves_[i]].side = side[i];
  }

  void trousers() {
    // Fronts and backs; without names the crotch of a back is longer.
    std::vector<int> fronts, backs, unnamed;
    for (const int p : legs_) {
      const PieceWords w = words(p);
      (w.front ? fronts : w.back ? backs : unnamed).push_back(p);
    }
    const auto crotch = [&](int p) {
      return garment_.pieces[p].sections[garment_.pieces[p].side > 0 ? 3 : 2].length;
    };
    std::stable_sort(unnamed.begin(), unnamed.end(),
                     [&](int a, int b) { return crotch(a) < crotch(b); });
    for (const int p : unnamed) (fronts.size() < 2 ? fronts : backs).push_back(p);
    if (fronts.size() != 2 || backs.size() != 2) return;
    garment_.kind = "trousers";
    for (const int p : fronts) garment_.pieces[p].role = PieceRole::front_leg;
    for (const int p : backs) {
      garment_.pieces[p].role = PieceRole::back_leg;
      garment_.pieces[p].side = -garment_.pieces[p].side;
    }
    const auto of_side = [&](std::vector<int>& two, const char* what) {
      if (garment_.pieces[two[0]].side == garment_.pieces[two[1]].side) {
        doubt(std::string("both ") + what + " are for the same leg");
        garment_.pieces[two[1]].side = -garment_.pieces[two[0]].side;
      }
      if (garment_.pieces[two[0]].side < 0) std::swap(two[0], two[1]);
    };
    of_side(fronts, "fronts");
    of_side(backs, "backs");
    // Of a left front and of a right back the outseam comes next after the hem.
    const auto section = [&](int p, int next_case) {
      const KnownPiece& piece = garment_.pieces[p];
      const bool next = piece.role == PieceRole::front_leg ? piece.side > 0 : piece.side < 0;
      return next ? next_case : 5 - next_case;
    };
    for (int i = 0; i < 2; ++i) {
      const std::string name = i == 0 ? "_L" : "_R";
      add("outseam" + name, sides(fronts[i], section(fronts[i], 1)),
          sides(backs[i], section(backs[i], 1)));
      add("inseam" + name, sides(fronts[i], section(fronts[i], 4)),
          sides(backs[i], section(backs[i], 4)));
      const bool left = i == 0;
      add_loop("hem" + name, LoopKind::hem, left ? 1 : -1, sides(fronts[i], 0), sides(backs[i], 0));
    }
    std::vector<Stitch::Side> waist;
    for (const int p : {fronts[0], fronts[1], backs[1], backs[0]})
      append(waist, sides(p, section(p, 2)));
    add_loop("waist", LoopKind::waist, 0, std::move(waist));
    add("crotch_front", sides(fronts[0], section(fronts[0], 3)),
        sides(fronts[1], section(fronts[1], 3)));
    add("crotch_back", sides(backs[0], section(backs[0], 3)),
        sides(backs[1], section(backs[1], 3)));
  }

  /// The crotch of a back is longer; next to the hem in the outline of a left leg is the back.
  void leggings() {
    int side[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
      const auto& s = garment_.pieces[whole_legs_[i]].sections;
      const PieceWords w = words(whole_legs_[i]);
      const int name = w.left ? 1 : w.right ? -1 : 0;
      const int shape = difference(s[2].length, s[4].length) < kSameLength ? 0
                        : s[2].length > s[4].length                        ? 1
                                                                           : -1;
      if (name != 0 && shape != 0 && name != shape)
        doubt("piece " + printable(panel(whole_legs_[i]).name) +
              ": its name and its crotch, which is longer behind, say different legs");
      side[i] = shape != 0 ? shape : name;
    }
    if (side[0] == 0) side[0] = side[1] == 0 ? 1 : -side[1];
    if (side[1] == 0) side[1] = -side[0];
    if (side[0] == side[1]) {
      doubt("both legs are for the same side");
      side[1] = -side[0];
    }
    if (side[0] < 0) std::swap(whole_legs_[0], whole_legs_[1]);
    const int left = whole_legs_[0], right = whole_legs_[1];
    garment_.kind = "trousers with legs in one piece";
    garment_.pieces[left].side = 1, garment_.pieces[right].side = -1;
    for (const int p : whole_legs_) {
      const std::string name = p == left ? "_L" : "_R";
      garment_.pieces[p].role = PieceRole::leg;
      add("inseam" + name, sides(p, 1), sides(p, 5));
      add_loop("hem" + name, LoopKind::hem, garment_.pieces[p].side, sides(p, 0));
    }
    add("crotch_front", sides(left, 4), sides(right, 2));
    add("crotch_back", sides(left, 2), sides(right, 4));
    add_loop("waist", LoopKind::waist, 0, sides(left, 3), sides(right, 3));
  }

  /// Of front and back, or of gores.
  void skirt() {
    std::vector<int> all = skirts_;
    append(all, gores_);
    std::sort(all.begin(), all.end());
    KnownSkirt known = know_skirt(pattern_, all);
    const bool of_gores = known.found() && known.pieces.size() > 2;
    if (skirts_.size() == 2 && !of_gores) return skirt_of_two();
    for (const int p : skirts_) garment_.pieces[p] = {};
    if (!known.found() || !is_all_but_bands(known)) return;
    garment_.kind = "skirt";
    garment_.unnamed = known.unnamed;
    take(known);
  }

  /// Whether nothing but strips and what is no piece of the outside is left: gores alone may be of
  /// any garment.
  bool is_all_but_bands(const KnownSkirt& known) const {
    for (int p = 0; p < static_cast<int>(pattern_.panels.size()); ++p) {
      const bool in_it =
          std::ranges::any_of(known.pieces, [&](const auto& of) { return of.first == p; });
      if (!in_it && !words(p).pocket && !as_strip(outline_sections(panel(p)))) return false;
    }
    return true;
  }

  void skirt_of_two() {
    front_first(skirts_, 0);
    for (const int p : skirts_) append(garment_.doubts, way_up_doubt(panel(p), garment_.pieces[p]));
    const int front = skirts_[0], back = skirts_[1];
    garment_.kind = "skirt";
    garment_.pieces[front].role = PieceRole::front_skirt;
    garment_.pieces[back].role = PieceRole::back_skirt;
    add("side_L", sides(front, 1), sides(back, 3));
    add("side_R", sides(front, 3), sides(back, 1));
    add_loop("waist", LoopKind::waist, 0, sides(front, 2), sides(back, 2));
    add_loop("hem", LoopKind::hem, 0, sides(front, 0), sides(back, 0));
  }

  const Pattern& pattern_;
  KnownGarment garment_;
  std::vector<int> trunks_, one_shoulders_, sleeves_, legs_, whole_legs_, skirts_, gores_;
  std::vector<OpenLoop> loops_;
  double front_middle_ = 0;  ///< of the neck: share of its length in the middle of the front
};

}  // namespace

KnownGarment know_garment(const Pattern& pattern) { return Knower(pattern).know(); }

}  // namespace loosefit::pattern
