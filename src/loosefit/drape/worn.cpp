#include "loosefit/drape/worn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "loosefit/drape/limb_lines.h"
#include "loosefit/drape/openings.h"
#include "loosefit/drape/rest_levels.h"
#include "loosefit/drape/tube_rings.h"

namespace loosefit {
namespace {

constexpr double kSlip = 0.5;         ///< of waist to crotch, that a waist may slide
constexpr double kLowest = 0.75;      ///< of waist to crotch, below which no waist is worn
constexpr double kRise = 1.0;         ///< of waist to crotch, that it may lie too high
constexpr double kGone = 1.0;         ///< of waist to crotch, that an unknown opening may sink
constexpr double kForTheWaist = 0.9;  ///< of the chest's girth, what was not made for the chest
constexpr double kTouch = 0.010;      ///< [m]
constexpr double kShoulder = 0.12;    ///< of stature, armhole to shoulder joint
constexpr double kSleeve = 0.6;       ///< of the chest's girth, the widest tube for a limb

const char* const kLimbNames[] = {"the head", "the left arm", "the right arm", "the left leg",
                                  "the right leg"};

std::string round_what(const LimbNumbers& n) {
  if (n == kRoundTrunk) return "the trunk";
  if (n == kRoundNothing) return "no part of the body";
  std::string text;
  for (int limb = 0; limb < kLimbs; ++limb)
    if (n[limb] != 0) text += (text.empty() ? "" : " and ") + std::string(kLimbNames[limb]);
  return text;
}

class Verdict {
 public:
  Verdict(const Garment& garment, const Pattern& pattern, const std::vector<Vec3>& x,
          const Body& body)
      : garment_(garment),
        pattern_(pattern),
        x_(x),
        body_(body),
        lines_(limb_lines(body)),
        levels_(body),
        way_(levels_.waist - levels_.crotch) {
    const auto chest = body.measured.find("chest");
    chest_girth_ = chest != body.measured.end() ? chest->second : 0.55 * levels_.height;
  }

  std::vector<std::string> reasons(bool over_others) {
    if (!over_others && !touches()) say("the garment touches the body nowhere");
    if (lines_[kHead].empty()) return reasons_;
    const std::vector<Opening> openings = garment_openings(garment_, pattern_);
    bool known = false;
    for (const Opening& opening : openings) {
      check(opening);
      known = known || opening.use != OpeningUse::unknown;
    }
    if (!known) check_sunk(openings);
    check_labels();
    return reasons_;
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
    round_ = limbs_through(opening.loop, x_, lines_);
    if (round_ == wanted) return true;
    const double widest = std::max(1.5 * opening.girth, kSleeve * chest_girth_);
    for (const std::vector<int>& ring : tube_rings(garment_, opening.loop, widest))
      if (limbs_through(ring, x_, lines_) == wanted) return true;
    return false;
  }

  void check(const Opening& o) {
    switch (o.use) {
      case OpeningUse::neck:
        return check_neck(o);
      case OpeningUse::left_arm:
        return check_arm(o, kLeftArm, "left");
      case OpeningUse::right_arm:
        return check_arm(o, kRightArm, "right");
      case OpeningUse::left_leg:
        return check_leg(o, kLeftLeg, "left");
      case OpeningUse::right_leg:
        return check_leg(o, kRightLeg, "right");
      case OpeningUse::waist:
        return check_trunk(o, "waistband");
      case OpeningUse::upper:
        return check_upper(o);
      case OpeningUse::hem:
        return check_hem(o);
      case OpeningUse::limb:
        if (limbs_through(o.loop, x_, lines_) == kRoundNothing)
          say("an opening goes round no part of the body");
        return;
      case OpeningUse::unknown:
        return;
    }
  }

  void check_neck(const Opening& o) {
    if (goes_round(o, kRoundNeck)) return;
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

  void check_arm(const Opening& o, Limb limb, const std::string& side) {
    if (goes_round(o, round_limb(limb))) return;
    if (round_ == kRoundNothing)
      say("the " + side + " sleeve is empty");
    else
      say("the " + side + " arm's opening goes round " + round_what(round_));
  }

  void check_leg(const Opening& o, Limb limb, const std::string& side) {
    if (goes_round(o, round_limb(limb))) return;
    if (round_ == kRoundNothing)
      say("the " + side + " trouser leg is empty");
    else
      say("the " + side + " leg's opening goes round " + round_what(round_));
  }

  void check_hem(const Opening& o) {
    if (!goes_round(o, kRoundTrunk)) say("the hem goes round " + round_what(round_));
  }

  /// The top of a tube: a collar or a sleeve, when that is what the pattern is placed round.
  void check_upper(const Opening& o) {
    const bool on_hips = !o.at_chest && o.girth < kForTheWaist * chest_girth_;
    check_trunk(
        o, on_hips || o.placed.z() <= levels_.waist + kSlip * way_ ? "waistband" : "upper opening");
  }

  void check_trunk(const Opening& o, const std::string& name) {
    if (!goes_round(o, kRoundTrunk)) {
      say("the " + name + " goes round " + round_what(round_));
      return;
    }
    const double highest = name == "waistband" ? levels_.waist : levels_.chest;
    const double upper_hips = levels_.waist - kSlip * way_;
    double made = std::clamp(o.placed.z(), upper_hips, highest);
    if (o.at_waist) made = levels_.waist;
    if (o.at_chest) made = levels_.chest;
    const double lowest = std::max(made - kSlip * way_, levels_.waist - kLowest * way_);
    const double level = levels_.of(o.loop, x_);
    if (level < lowest) {
      const std::string to = level_name(level, levels_);
      if (to == level_name(made, levels_))
        say(fmt::format("the {} has slid down {:.2f} m", name, made - level));
      else
        say("the " + name + " has slid " + (to.starts_with("below") ? to : "to " + to));
    } else if (level > made + kRise * way_) {
      say(fmt::format("the {} lies {:.2f} m above {}", name, level - made,
                      level_name(made, levels_)));
    }
  }

  void check_sunk(const std::vector<Opening>& openings) {
    const std::vector<Vec3> placed = placed_by_pattern(garment_, pattern_);
    if (placed.empty()) return;
    std::vector<int> of;
    for (const Opening& o : openings) of.insert(of.end(), o.loop.begin(), o.loop.end());
    if (of.empty())
      for (int v = 0; v < garment_.vertex_count; ++v) of.push_back(v);
    double before = 0;
    for (int v : of) before += placed[v].z() / static_cast<double>(of.size());
    const double sunk = before - levels_.of(of, x_);
    if (sunk > kGone * way_)
      say(fmt::format("the garment lies {:.2f} m below where it was put on", sunk));
  }

  void check_labels() {
    for (const std::string side : {"left", "right"}) {
      const auto collar = labelled_vertices(garment_, pattern_, side + "_collar");
      if (!collar.empty() && levels_.of(collar, x_) < levels_.chest)
        say("the " + side + " side of the collar lies below the breast");
      const auto armhole = labelled_vertices(garment_, pattern_, side + "_armhole");
      const Vec3& shoulder = body_.joints.at(side == "left" ? "shoulder_L" : "shoulder_R");
      double away = 0;
      for (int v : armhole) away += (x_[v] - shoulder).norm() / static_cast<double>(armhole.size());
      if (away > kShoulder * levels_.height)
        say(fmt::format("the {} armhole lies {:.2f} m from the shoulder", side, away));
    }
  }

  const Garment& garment_;
  const Pattern& pattern_;
  const std::vector<Vec3>& x_;
  const Body& body_;
  LimbLines lines_;
  RestLevels levels_;
  double way_;  ///< from waist down to crotch [m]
  double chest_girth_ = 0;
  LimbNumbers round_{};  ///< what the opening that was asked last goes round
  std::vector<std::string> reasons_;
};

}  // namespace

std::vector<std::string> why_not_worn(const Garment& garment, const Pattern& pattern,
                                      const std::vector<Vec3>& x, const Body& body,
                                      bool over_others) {
  return Verdict(garment, pattern, x, body).reasons(over_others);
}

}  // namespace loosefit
