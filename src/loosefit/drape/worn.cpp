#include "loosefit/drape/worn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/text.h"
#include "loosefit/drape/hem_hang.h"
#include "loosefit/drape/hood_seam.h"
#include "loosefit/drape/limb_lines.h"
#include "loosefit/drape/openings.h"
#include "loosefit/drape/polyline.h"
#include "loosefit/drape/rest_levels.h"
#include "loosefit/drape/tube_rings.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::drape {
namespace {

constexpr double kSlip = 0.5;       ///< of waist to crotch, that a waist may slide
constexpr double kLowest = 0.75;    ///< of waist to crotch, below which no waist is worn
constexpr double kRise = 1.0;       ///< of waist to crotch, that it may lie too high
constexpr double kHighest = 0.75;   ///< of waist to crotch, above the waist: below the bust
constexpr double kGone = 1.0;       ///< of waist to crotch, that an unknown opening may sink
constexpr double kTouch = 0.010;    ///< [m]
constexpr double kShoulder = 0.12;  ///< of stature, armhole to shoulder joint
constexpr double kNeck = 0.88;      ///< of stature, above which no garment of a wearer begins
constexpr double kHangs = 0.7;      ///< of the cloth from neck to hem, that at least hangs straight
constexpr double kLimb = 0.05;      ///< of stature, from shoulder or hip joint to armpit or crotch
constexpr double kFolded = 0.5;     ///< of a tube's length, a fold that turns no tube over
constexpr double kSleeve = 0.6;     ///< of the chest's girth, the widest tube for a limb

class Verdict {
 public:
  Verdict(const garment::Garment& garment, const pattern::Pattern& pattern,
          const std::vector<Vec3>& x, const body::PosedBody& body)
      : garment_(garment),
        pattern_(pattern),
        x_(x),
        body_(body),
        lines_(limb_lines(body)),
        levels_(body),
        way_(levels_.waist - levels_.crotch),
        chest_girth_(chest_girth(body, levels_)) {}

  std::vector<std::string> reasons(bool over_others) {
    if (!over_others && !touches()) say("the garment touches the body nowhere");
    if (lines_[kHead].empty()) return reasons_;
    placed_ = placed_by_pattern(garment_, pattern_);
    openings_ = garment_openings(garment_, pattern_, body_);
    const std::vector<Opening>& openings = openings_;
    at_rest_ = limb_lines(levels_.joints());
    std::map<int, std::vector<const Opening*>> of_piece;
    for (const Opening& opening : openings) {
      check(opening);
      of_piece[opening.piece].push_back(&opening);
    }
    for (const auto& [piece, of] : of_piece) {
      check_sunk(of);
      check_tube(of);
      check_way_up(of);
      check_slid(of);
      check_open_front(of);
    }
    if (openings.empty()) check_sunk({});
    check_sleeves();
    check_labels();
    return reasons_;
  }

  const std::vector<std::string>& risen() {
    reasons(true);
    for (const Opening& hem : openings_)
      if (hem.use == kinds::OpeningUse::hem) check_ridden_up(hem);
    return risen_;
  }

  /// Openings that no question is asked of, by girth and a piece that they lie on.
  std::string unjudged() {
    reasons(true);
    std::vector<std::string> found;
    for (const Opening& o : openings_)
      if (o.use == kinds::OpeningUse::unknown && !is_open_front(o, openings_))
        found.push_back(fmt::format("{:.2f} m round at {}", o.girth, printable(piece_at(o))));
    if (found.empty()) return {};
    return fmt::format("what {} for is not known, and what goes through was not asked: {}",
                       found.size() == 1 ? "an opening is" : "some openings are", join(found));
  }

  /// Whether every opening that no other question is asked of has the limbs through it that it has
  /// at `first` on another posture of the body.
  bool alike(const std::vector<Vec3>& first, const LimbLines& lines) {
    if (lines_[kHead].empty() || lines[kHead].empty()) return true;
    for (const Opening& o : garment_openings(garment_, pattern_, body_))
      if (o.use == kinds::OpeningUse::unknown &&
          !goes_round(o, limbs_through_openings(o.loop, first, lines)))
        return false;
    return true;
  }

 private:
  void say(const std::string& reason) {
    if (std::find(reasons_.begin(), reasons_.end(), reason) == reasons_.end())
      reasons_.push_back(reason);
  }

  bool touches() const {
    return std::any_of(x_.begin(), x_.end(),
                       [&](const Vec3& p) { return levels_.distance(p) < kTouch; });
  }

  bool goes_round(const Opening& opening, const LimbNumbers& wanted) {
    round_ = limbs_through_openings(opening.loop, x_, lines_);
    if (round_ == wanted) return true;
    for (const std::vector<int>& ring : tube_rings(garment_, opening.loop, widest(opening)))
      if (limbs_through_openings(ring, x_, lines_) == wanted) return true;
    return false;
  }

  void check(const Opening& o) {
    switch (o.use) {
      case kinds::OpeningUse::neck:
        return check_neck(o);
      case kinds::OpeningUse::left_arm:
        return check_arm(o, kLeftArm, "left");
      case kinds::OpeningUse::right_arm:
        return check_arm(o, kRightArm, "right");
      case kinds::OpeningUse::left_leg:
        return check_leg(o, kLeftLeg, "left");
      case kinds::OpeningUse::right_leg:
        return check_leg(o, kRightLeg, "right");
      case kinds::OpeningUse::waist:
        return check_trunk(o, "waistband");
      case kinds::OpeningUse::upper:
        return check_upper(o);
      case kinds::OpeningUse::hem:
        return check_hem(o);
      case kinds::OpeningUse::limb:
        if (!goes_round(o, o.round))
          say("an opening made for " + round_what(o.round) + " goes round " + round_what(round_));
        return;
      case kinds::OpeningUse::cape_hem:
        return check_cape_hem(o);
      case kinds::OpeningUse::tube:
      case kinds::OpeningUse::unknown:
        return;
    }
  }

  void check_neck(const Opening& o) {
    if (limbs_through_openings(o.loop, x_, lines_) == kRoundNeck && is_of_hood(o))
      return say("the hood has slid off the head");
    if (goes_round(o, kRoundNeck)) return;
    // The head is in a hood, not through its opening: the hood's seam goes round the neck.
    if (const auto seam = hood_seam(garment_, openings_, o);
        round_ == kRoundNothing && !seam.empty() &&
        limbs_through_openings(seam, x_, lines_) == kRoundNeck)
      return;
    const LimbNumbers left = {1, 1, 0, 0, 0}, right = {1, 0, 1, 0, 0};
    if (round_ == kRoundTrunk)
      say("the neck opening lies below both shoulders");
    else if (round_ == left)
      say("the neck opening lies below the left shoulder");
    else if (round_ == right)
      say("the neck opening lies below the right shoulder");
    else if (round_ == kRoundNothing)
      say("the head is not through the neck opening");
    else
      say("the neck opening goes round " + round_what(round_));
  }

  /// Whether most of a rim is of hoods, by the names of their pieces.
  bool is_of_hood(const Opening& o) const {
    const auto hood = std::count_if(o.loop.begin(), o.loop.end(), [&](int v) {
      return pattern::words_of(garment_.panel_names[garment_.vertex_panel[v]]).hood;
    });
    return 2 * static_cast<std::size_t>(hood) > o.loop.size();
  }

  /// Whether what was asked last goes round nothing since this limb of the wearer ends before the
  /// ring of the tube that is placed nearest to the trunk.
  bool hangs(const Opening& o, Limb limb) const {
    if (round_ != kRoundNothing || !lacks_end(limb, body_)) return false;
    const auto rings = tube_rings(garment_, o.loop, widest(o));
    Vec3 first = Vec3::Zero();
    for (const std::vector<int>& ring = rings.empty() ? o.loop : rings.back(); int v : ring)
      first += placed_[v] / static_cast<double>(ring.size());
    return ends_before(limb, Polyline(at_rest_[limb]).project(first));
  }

  /// Whether a limb ends before this way along it [m], or no farther than armpit or crotch.
  bool ends_before(Limb limb, double way) const {
    const Polyline line(at_rest_[limb]);
    const Vec3& root = at_rest_[limb][limb < kLeftLeg ? 1 : 2];
    const double trunk = line.project(root) + kLimb * levels_.height;
    return lacks_end(limb, body_) && line.project(at_rest_[limb].back()) < std::max(way, trunk);
  }

  void check_arm(const Opening& o, Limb limb, const std::string& side) {
    if (goes_round(o, round_limb(limb)) || hangs(o, limb)) return;
    if (round_ == kRoundNothing)
      say("the " + side + " sleeve is empty");
    else
      say("the " + side + " arm's opening goes round " + round_what(round_));
  }

  void check_leg(const Opening& o, Limb limb, const std::string& side) {
    if (goes_round(o, round_limb(limb)) || hangs(o, limb)) return;
    if (round_ == kRoundNothing)
      say("the " + side + " trouser leg is empty");
    else
      say("the " + side + " leg's opening goes round " + round_what(round_));
  }

  /// An edge round the trunk is asked itself, not the rings of its tube: those below it may be
  /// round the trunk while the edge lies on the hands.
  bool edge_goes_round_trunk(const Opening& o, const std::string& name) {
    round_ = limbs_through_openings(o.loop, x_, lines_);
    if (round_ == kRoundTrunk) return true;
    const LimbNumbers left = {1, 0, 1, 0, 0}, right = {1, 1, 0, 0, 0};
    const std::string what = round_ == kRoundNeck ? "the trunk and both arms"
                             : round_ == left     ? "the trunk and the left arm"
                             : round_ == right    ? "the trunk and the right arm"
                                                  : round_what(round_);
    say("the " + name + " goes round " + what);
    return false;
  }

  void check_hem(const Opening& o) { edge_goes_round_trunk(o, "hem"); }

  /// The arms may be within, or come out below it.
  void check_cape_hem(const Opening& o) {
    const LimbNumbers n = limbs_through_openings(o.loop, x_, lines_);
    if (n[kLeftLeg] != n[kRightLeg] || n[kHead] == n[kLeftLeg])
      say("the hem goes round " + round_what(n));
  }

  /// The top of a tube round the trunk.
  void check_upper(const Opening& o) {
    const bool on_hips = !o.at_chest && o.girth < kForTheWaist * chest_girth_;
    check_trunk(
        o, on_hips || made_for(o) <= levels_.waist + kSlip * way_ ? "waistband" : "upper opening");
  }

  /// A tube that is placed round nothing known: whatever goes through one end, through the other.
  void check_tube(const std::vector<const Opening*>& ends) {
    if (ends.size() != 2 || ends[0]->use != kinds::OpeningUse::tube) return;
    const bool first = is_upper_end(*ends[0], *ends[1]);
    const Opening &upper = *ends[first ? 0 : 1], &lower = *ends[first ? 1 : 0];
    const LimbNumbers up = limbs_through_openings(upper.loop, x_, lines_);
    if (up == kRoundNeck) return check_cape_hem(lower);
    const LimbNumbers low = limbs_through_openings(lower.loop, x_, lines_);
    const bool through = (up != kRoundNothing && goes_round(lower, up)) ||
                         (low != kRoundNothing && goes_round(upper, low));
    if (!through)
      say("nothing goes through both ends of a tube");
    else if (up == kRoundTrunk)
      check_upper(upper);
  }

  /// The top of a tube round the trunk lies above its hem. Folded cloth may have both on a level.
  void check_way_up(const std::vector<const Opening*>& of) {
    const Opening *top = nullptr, *hem = nullptr;
    for (const Opening* o : of) {
      if (o->use == kinds::OpeningUse::waist || o->use == kinds::OpeningUse::upper) top = o;
      if (o->use == kinds::OpeningUse::hem) hem = o;
    }
    if (!top || !hem) return;
    const double length = share() * (top->placed - hem->placed).norm();
    if (levels_.of(hem->loop, x_) > levels_.of(top->loop, x_) + kFolded * length)
      say("the garment is upside down: its hem lies above its waist");
  }

  /// The end of a stocking or a sleeve alone that is nearer to the trunk has not slid down its
  /// limb.
  void check_slid(const std::vector<const Opening*>& of) {
    for (int limb = kLeftArm; limb < kLimbs; ++limb) {
      const Polyline rest(at_rest_[limb]);
      double made = HUGE_VAL, worn = HUGE_VAL;  // ways along the limb [m]
      for (const Opening* o : of) {
        // Where one that lies beside its limb in the file belongs on it, nothing tells.
        if (o->use != kinds::OpeningUse::limb || !o->placed_round ||
            o->round != round_limb(Limb(limb)))
          continue;
        made = std::min(made, rest.project(o->placed));
        worn = std::min(worn, Polyline(lines_[limb]).project(middle_of(o->loop)));
      }
      if (!std::isfinite(made)) continue;
      // On a shorter wearer it is placed above where the limb begins.
      made = std::max(made, rest.project(at_rest_[limb][1]) + kLimb * levels_.height);
      if (worn - made > kSlip * way_)
        say(fmt::format("what goes round {} has slid down it by {:.2f} m", limb_name(Limb(limb)),
                        worn - made));
    }
  }

  /// The hem of a top hangs about as far from its neck as the cloth between them is long. One that
  /// is too narrow for the hips, or longer than the trunk lets it hang, rides up.
  void check_ridden_up(const Opening& hem) {
    const auto neck = std::ranges::find_if(openings_, [&](const Opening& o) {
      return o.use == kinds::OpeningUse::neck && o.piece == hem.piece && !is_of_hood(o);
    });
    if (neck == openings_.end()) return;
    std::vector<Vec3> at_rest = x_;
    for (int v : neck->loop) at_rest[v] = levels_.at_rest(x_[v]);
    for (int v : hem.loop) at_rest[v] = levels_.at_rest(x_[v]);
    if (const double share = hang_straightness(garment_, neck->loop, hem.loop, at_rest);
        share < kHangs)
      risen_.push_back(fmt::format(
          "the hem has ridden up: over a quarter of it or more it hangs at most "
          "{:.0f} % as far from the neck as the cloth between them is long, which lies gathered",
          100 * share));
  }

  /// The body of a jacket that is open in front is held by no ring: its sleeves begin at the
  /// shoulders, and its edge runs behind the neck.
  void check_open_front(const std::vector<const Opening*>& of) {
    const auto found =
        std::ranges::find_if(of, [&](const Opening* o) { return is_open_front(*o, openings_); });
    if (found == of.end()) return;
    const Opening* front = *found;
    for (const Opening* o : of) {
      if (!is_arm(*o)) continue;
      const std::string side = o->use == kinds::OpeningUse::left_arm ? "left" : "right";
      const Vec3& shoulder = body_->joints.at(side == "left" ? "shoulder_L" : "shoulder_R");
      double away = (middle_of(o->loop) - shoulder).norm();
      for (const std::vector<int>& ring : tube_rings(garment_, o->loop, widest(*o)))
        away = std::min(away, (middle_of(ring) - shoulder).norm());
      if (away > kShoulder * levels_.height) say_armhole(side, away);
    }
    double highest = levels_.of(x_[front->loop.front()]);
    for (int v : front->loop) highest = std::max(highest, levels_.of(x_[v]));
    const auto joints = levels_.joints();
    if (highest < 0.5 * (joints.at("shoulder_L").z() + joints.at("shoulder_R").z()))
      say("the back of the neck has slid off the shoulders");
  }

  /// Name of a piece with the first vertex of an opening.
  std::string piece_at(const Opening& o) const {
    return garment_.panel_names[garment_.vertex_panel[o.loop.front()]];
  }

  static bool is_arm(const Opening& o) {
    return o.use == kinds::OpeningUse::left_arm || o.use == kinds::OpeningUse::right_arm;
  }

  Vec3 middle_of(const std::vector<int>& vertices) const {
    Vec3 middle = Vec3::Zero();
    for (int v : vertices) middle += x_[v] / static_cast<double>(vertices.size());
    return middle;
  }

  void say_armhole(const std::string& side, double away) {
    say(fmt::format("the {} armhole lies {:.2f} m from the shoulder", side, away));
  }
  double widest(const Opening& o) const { return std::max(1.5 * o.girth, kSleeve * chest_girth_); }

  /// Share of a placed height that is left on this wearer: a pattern that begins above the
  /// shoulders was placed for somebody taller, or not placed on anybody.
  double share() const {
    double top = 0;
    for (const Vec3& p : placed_) top = std::max(top, p.z());
    return std::min(1.0, kNeck * levels_.height / std::max(1e-9, top));
  }

  /// Height on this wearer where the pattern places the opening [m].
  double made_for(const Opening& o) const { return share() * o.placed.z(); }

  void check_trunk(const Opening& o, const std::string& name) {
    if (!edge_goes_round_trunk(o, name)) return;
    const bool of_waist = name == "waistband" || o.of_legs;
    const double highest = of_waist ? levels_.waist : levels_.chest;
    const double upper_hips = levels_.waist - kSlip * way_;
    double made = std::clamp(made_for(o), upper_hips, highest);
    if (o.at_waist) made = levels_.waist;
    if (o.at_chest) made = levels_.chest;
    const double lowest = std::max(made - kSlip * way_, levels_.waist - kLowest * way_);
    double highest_worn = made + kRise * way_;
    if (of_waist) highest_worn = std::max(highest_worn, levels_.waist + kHighest * way_);
    const double level = levels_.of(o.loop, x_);
    if (level < lowest) {
      const std::string to = level_name(level, levels_);
      if (to == level_name(made, levels_))
        say(fmt::format("the {} has slid down {:.2f} m", name, made - level));
      else
        say("the " + name + " has slid " + (to.starts_with("below") ? to : "to " + to));
    } else if (level > highest_worn) {
      say(fmt::format("the {} lies {:.2f} m above {}", name, level - made,
                      level_name(made, levels_)));
    } else if (of_waist && level > levels_.waist + kSlip * way_) {
      risen_.push_back(
          fmt::format("the {} lies {:.2f} m above the waist: further down the garment "
                      "is too narrow for this body",
                      name, level - levels_.waist));
    }
  }

  /// The highest opening of unknown use, by which the piece hangs; all cloth if it has none at all.
  void check_sunk(const std::vector<const Opening*>& openings) {
    if (placed_.empty()) return;
    std::vector<int> of;
    double made = -1;
    for (const Opening* o : openings)
      if (o->use == kinds::OpeningUse::unknown && made_for(*o) > made)
        made = made_for(*o), of = o->loop;
    if (openings.empty()) {
      made = 0;
      for (int v = 0; v < garment_.vertex_count; ++v) {
        of.push_back(v);
        made += share() * placed_[v].z() / garment_.vertex_count;
      }
    }
    if (of.empty()) return;
    const double sunk = made - levels_.of(of, x_);
    if (sunk > kGone * way_)
      say(fmt::format("the garment lies {:.2f} m below where it was put on", sunk));
  }

  /// Of an unusual cut with pieces that are called sleeves, an arm is in one, and each is where
  /// there are sleeves for both.
  void check_sleeves() {
    bool left = false, right = false, any = false;
    for (const std::string& name : garment_.panel_names) {
      const pattern::PieceWords words = pattern::words_of(name);
      any = any || words.sleeve;
      left = left || (words.sleeve && words.left);
      right = right || (words.sleeve && words.right);
    }
    if (!any || std::ranges::any_of(openings_, is_arm)) return;
    const auto in_one = [&](Limb arm) {
      return std::ranges::any_of(openings_,
                                 [&](const Opening& o) { return goes_round(o, round_limb(arm)); });
    };
    const bool left_in = in_one(kLeftArm) || ends_before(kLeftArm, 0),
               right_in = in_one(kRightArm) || ends_before(kRightArm, 0);
    if (!left_in && !right_in)
      say("no arm is in a sleeve");
    else if (left && right && !(left_in && right_in))
      say(fmt::format("the {} arm is in no sleeve", left_in ? "right" : "left"));
  }

  void check_labels() {
    for (const std::string side : {"left", "right"}) {
      const auto collar = labelled_vertices(garment_, pattern_, side + "_collar");
      if (!collar.empty() && levels_.of(collar, x_) < levels_.chest)
        say("the " + side + " side of the collar lies below the breast");
      const auto armhole = labelled_vertices(garment_, pattern_, side + "_armhole");
      const Vec3& shoulder = body_->joints.at(side == "left" ? "shoulder_L" : "shoulder_R");
      double away = 0;
      for (int v : armhole) away += (x_[v] - shoulder).norm() / static_cast<double>(armhole.size());
      if (away > kShoulder * levels_.height) say_armhole(side, away);
    }
  }

  const garment::Garment& garment_;
  const pattern::Pattern& pattern_;
  const std::vector<Vec3>& x_;
  const body::PosedBody& body_;
  std::vector<Vec3> placed_;  ///< by the pattern
  std::vector<Opening> openings_;
  LimbLines lines_, at_rest_;  ///< of the wearer, and standing upright
  RestLevels levels_;
  double way_;  ///< from waist down to crotch [m]
  double chest_girth_;
  LimbNumbers round_{};  ///< what the opening that was asked last goes round
  std::vector<std::string> reasons_, risen_;
};

}  // namespace

std::vector<std::string> why_not_worn(const garment::Garment& garment,
                                      const pattern::Pattern& pattern, const std::vector<Vec3>& x,
                                      const body::PosedBody& body, bool over_others) {
  return Verdict(garment, pattern, x, body).reasons(over_others);
}

std::vector<std::string> risen_edges(const garment::Garment& garment,
                                     const pattern::Pattern& pattern, const std::vector<Vec3>& x,
                                     const body::PosedBody& body) {
  return Verdict(garment, pattern, x, body).risen();
}

std::string unjudged_openings(const garment::Garment& garment, const pattern::Pattern& pattern,
                              const std::vector<Vec3>& x, const body::PosedBody& body) {
  return Verdict(garment, pattern, x, body).unjudged();
}

bool worn_alike(const garment::Garment& garment, const pattern::Pattern& pattern,
                const std::vector<Vec3>& x, const body::PosedBody& body,
                const std::vector<Vec3>& first, const body::Body& first_body) {
  return Verdict(garment, pattern, x, body).alike(first, limb_lines(first_body));
}

}  // namespace loosefit::drape
