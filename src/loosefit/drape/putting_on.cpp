#include "loosefit/drape/putting_on.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "loosefit/base/text.h"

namespace loosefit::drape {
namespace {

using kinds::OpeningUse;

/// Of chest and hips, the girth to which a rim presses them in (judgement).
constexpr double kPressedIn = 0.97;

/// Ordered so that what is true of all ways is the least, and of one of them the greatest.
enum Answer { no, not_known, yes };

/// Something that has to pass, and its girth where the body tells it [m].
struct Passing {
  std::string what;
  std::optional<double> girth;
  double pressed_in = 1;  ///< share of the girth that is left under a rim
};

class Judge {
 public:
  Judge(const std::vector<Rim>& rims, const body::PassingGirths& girths,
        const fabric::Material& material)
      : rims_(rims), material_(material) {
    head_ = {"the head", girths.head};
    for (const int side : {0, 1}) {
      const std::string name = side == 0 ? "left" : "right";
      hand_[side] = {"the " + name + " hand", girths.hand[side]};
      foot_[side] = {"the " + name + " heel and instep", girths.foot[side]};
    }
    chest_ = {"the chest", girths.chest, kPressedIn};
    hips_ = {"the hips", girths.hip, kPressedIn};
  }

  PuttingOn judged() {
    for (const Rim& rim : rims_) judge(rim);
    tell_unknown();
    return std::move(result_);
  }

 private:
  void judge(const Rim& rim) {
    switch (rim.opening.use) {
      case OpeningUse::neck:
        if (other(rim, OpeningUse::left_leg) && !other(rim, OpeningUse::hem) &&
            !other(rim, OpeningUse::waist))
          return tell(rim, passes(rim, hips_), {hips_});
        return tell(rim, passes(rim, head_), {head_});
      case OpeningUse::left_arm:
        return tell(rim, passes(rim, hand_[0]), {hand_[0]});
      case OpeningUse::right_arm:
        return tell(rim, passes(rim, hand_[1]), {hand_[1]});
      case OpeningUse::left_leg:
        return tell(rim, passes(rim, foot_[0]), {foot_[0]});
      case OpeningUse::right_leg:
        return tell(rim, passes(rim, foot_[1]), {foot_[1]});
      case OpeningUse::waist:
      case OpeningUse::upper:
        return judge_top_of_tube(rim);
      case OpeningUse::hem:
        return judge_hem(rim);
      case OpeningUse::limb:
        return judge_limb(rim);
      case OpeningUse::cape_hem:
      case OpeningUse::tube:
      case OpeningUse::unknown:
        return;
    }
  }

  /// Trousers and skirts are stepped into; a skirt is also pulled over the chest as a whole.
  void judge_top_of_tube(const Rim& top) {
    const Rim* hem = other(top, OpeningUse::hem);
    if (!hem) return tell(top, passes(top, hips_), {hips_});
    const Answer from_above = std::min(passes(top, chest_), passes(*hem, chest_));
    tell(top, std::max(passes(top, hips_), from_above), {hips_, chest_});
  }

  /// The hem of a skirt is judged with its waist.
  void judge_hem(const Rim& hem) {
    const Rim* neck = other(hem, OpeningUse::neck);
    if (!neck && !other(hem, OpeningUse::left_arm) && !other(hem, OpeningUse::right_arm)) return;
    tell(hem, std::max(passes(hem, chest_), neck ? passes(*neck, hips_) : no), {chest_});
  }

  void judge_limb(const Rim& rim) {
    const Passing* const of_limb[] = {&head_, &hand_[0], &hand_[1], &foot_[0], &foot_[1]};
    for (int limb = 0; limb < kLimbs; ++limb)
      if (rim.opening.round == round_limb(Limb(limb)))
        tell(rim, passes(rim, *of_limb[limb]), {*of_limb[limb]});
  }

  static bool is_known(const Rim& rim) {
    return rim.opening.use != OpeningUse::unknown && rim.opening.use != OpeningUse::tube;
  }

  /// Of each cloth the first opening of unknown use that something may have to pass.
  void tell_unknown() {
    std::vector<Opening> all;
    for (const Rim& rim : rims_) all.push_back(rim.opening);
    std::set<int> told;  // cloth
    for (const Rim& rim : rims_) {
      const Opening& o = rim.opening;
      const bool one_is_known = std::ranges::any_of(
          rims_, [&](const Rim& r) { return r.opening.piece == o.piece && is_known(r); });
      const bool is_slit =
          o.of_legs && (other(rim, OpeningUse::waist) || other(rim, OpeningUse::upper));
      // The edge over a bare shoulder lets head and arm pass.
      const bool is_front = is_open_front(o, all) && !other(rim, OpeningUse::hem);
      const bool for_nothing = o.is_cut_hole || is_slit || is_front;
      if (is_known(rim) || (one_is_known && for_nothing) || !told.insert(o.piece).second) continue;
      result_.not_judged.push_back("what " + rim.name + " has to let pass is not known");
    }
  }

  /// Another opening of the same cloth.
  const Rim* other(const Rim& rim, OpeningUse use) const {
    const auto found = std::ranges::find_if(rims_, [&](const Rim& r) {
      return r.opening.piece == rim.opening.piece && r.opening.use == use;
    });
    return found == rims_.end() ? nullptr : &*found;
  }

  Answer passes(const Rim& rim, const Passing& passing) const {
    if (!passing.girth) return not_known;
    if (rim.opened(material_) >= passing.pressed_in * *passing.girth) return yes;
    return rim.is_stated(material_) ? no : not_known;
  }

  /// `ways`: what may pass, one or the other.
  void tell(const Rim& rim, Answer answer, const std::vector<Passing>& ways) {
    if (answer == yes) return;
    std::vector<std::string> names, girths;
    for (const Passing& way : ways) {
      names.push_back(way.what);
      if (way.girth) girths.push_back(fmt::format("{:.3f} m ({})", *way.girth, way.what));
    }
    if (answer == no)
      result_.too_narrow.push_back(fmt::format(
          "{} opens to {:.3f} m in {}, {:.3f} m as cut, and has to let pass {}", rim.name,
          rim.opened(material_), printable(material_.name), rim.cut(), join(girths, " or ")));
    else if (girths.size() < ways.size())
      result_.not_judged.push_back(
          fmt::format("whether {} lets pass {} is not known: the body does not tell that girth",
                      rim.name, join(names, " or ")));
    else
      result_.not_judged.push_back(fmt::format(
          "whether {} lets pass {} is not known: it is {:.3f} m long as cut, and {} states neither "
          "valid_strain nor stretch",
          rim.name, join(girths, " or "), rim.cut(), printable(material_.name)));
  }

  const std::vector<Rim>& rims_;
  const fabric::Material& material_;
  Passing head_, hand_[2], foot_[2], chest_, hips_;
  PuttingOn result_;
};

}  // namespace

std::vector<std::string> PuttingOn::reasons() const {
  std::vector<std::string> all = too_narrow;
  all.insert(all.end(), not_judged.begin(), not_judged.end());
  return all;
}

PuttingOn putting_on(const std::vector<Rim>& rims, const body::PassingGirths& girths,
                     const fabric::Material& material) {
  if (!girths.head && !girths.hand[0] && !girths.hand[1] && !girths.foot[0] && !girths.foot[1])
    return {.too_narrow = {},
            .not_judged = {"a body without joints does not tell what has to pass the openings"}};
  if (rims.empty())
    return {.too_narrow = {}, .not_judged = {"the cloth has no opening that a limb goes through"}};
  return Judge(rims, girths, material).judged();
}

}  // namespace loosefit::drape
