#include "loosefit/kinds/hoodie/hoodie.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/kinds/check_values.h"
#include "loosefit/kinds/hoodie/hood_draft.h"
#include "loosefit/kinds/match_parts.h"
#include "loosefit/kinds/shirt/shirt.h"
#include "loosefit/kinds/told_limit.h"

namespace loosefit::kinds {
namespace {

constexpr char kCrown[] = "hps_to_crown";
/// The hood's front edge beyond the height of the head, which it goes round.
constexpr double kHeadRoom = 0.10;
/// The least that it is beyond that: a lower one slides off the head (judgement).
constexpr double kLeastHeadRoom = 0.03;
constexpr double kDepth = 0.72;  ///< of the hood, of its height

ShirtFit usual_fit() {
  ShirtFit fit = usual_shirt_fit();
  fit.chest = 0.25;
  fit.hip = 0.20;
  fit.sleeve = 0.35;
  fit.wrist = 0.45;
  fit.neck_ease = 0.25;  // goes over the head
  fit.scye_ease = 0.04;
  fit.cap_ratio = 0.65;
  fit.sleeve_follow = 0;  // sweatshirts are cut straight
  fit.cuff = 0.06;
  fit.cuff_stretch = 0.25;
  return fit;
}

GarmentKind roomy_shirt() { return shirt_kind("hoodie", "hooded sweatshirt", usual_fit()); }

/// Keys of the hood and of the band at the hem.
std::vector<KindKey> own_keys() {
  const char* const kFraction = "a fraction";
  return {
      {"hood_height",
       {},
       0.15,
       0.6,
       "metres",
       "front edge of the hood, from the neckline up; without it 10 cm more than from neck to "
       "crown"},
      {"hood_depth",
       {},
       0.15,
       0.5,
       "metres",
       "from the front edge of the hood to the back of the head; without it 0.72 of hood_height, "
       "and over the back of the neckline"},
      {"hem_band_width", 0.06, 0, 0.15, "metres", "folded strip round the hem; 0: none", false,
       true},
      {"hem_band_stretch", 0.12, 0, 0.5, kFraction,
       "that strip shorter than the hem, which it is sewn to stretched", false, true}};
}

std::vector<KindKey> keys() {
  std::vector<KindKey> list = roomy_shirt().keys;
  // A hood has no neckband, and a hem that is sewn to a band is in one part.
  std::erase_if(list, [](const KindKey& key) {
    return key.name.starts_with("neckband_") || key.name == "back_waist";
  });
  for (KindKey& key : own_keys()) list.push_back(std::move(key));
  return list;
}

/// From the neck to the crown, of people of that back where it is not known [m].
double height_of_head(const NamedValues& measures) {
  const auto known = measures.find(kCrown);
  return known != measures.end() ? known->second : 0.12 + 0.42 * measures.at("hps_to_waist");
}

/// A hood that is too low for the wearer's head is refused, or gives way if it may, to the least
/// height that may be asked for.
void check_hood_height(double& height, DraftedGarment& drafted, bool yields) {
  const auto crown = drafted.measures.find(kCrown);
  if (crown == drafted.measures.end()) return;
  const double least = crown->second + kLeastHeadRoom;
  if (height >= least) return;
  if (!yields)
    throw InvalidInput({{}, 0, "fit.hood_height"}, fmt::format("{:.4g} m", height),
                       fmt::format("at least {:.3f} m, over a head of {:.3f} m from neck to crown",
                                   told_least(least), crown->second),
                       "without fit.hood_height it is as high as the head needs");
  drafted.notes.push_back(fmt::format(
      "fit.hood_height: {:.3f} instead of {:.3g}, since otherwise the hood would not stay on the "
      "head",
      told_least(least), height));
  height = told_least(least);
}

DraftedGarment draft(const DraftRequest& request) {
  NamedValues own;
  DraftRequest shirt = request;
  for (const KindKey& key : own_keys()) {
    if (const auto asked = request.fit.find(key.name); asked != request.fit.end())
      own[key.name] = asked->second;
    else if (key.usual)
      own[key.name] = *key.usual;
    shirt.fit.erase(key.name);
  }
  shirt.measures.erase(kCrown);
  check_values({}, {}, own_keys(), own);
  DraftedGarment drafted = roomy_shirt().draft(shirt);
  const auto crown = request.measures.find(kCrown);
  if (crown != request.measures.end() && request.size.empty())
    drafted.measures[kCrown] = crown->second;
  if (!own.count("hood_height")) own["hood_height"] = height_of_head(drafted.measures) + kHeadRoom;
  check_hood_height(own["hood_height"], drafted, request.yielding.count("fit.hood_height") > 0);

  const auto fit = [&](const char* key) { return drafted.fit.at(key); };
  pattern::Pattern& pattern = drafted.pattern;
  if (!own.count("hood_depth"))
    own["hood_depth"] = std::max(kDepth * own["hood_height"], least_hood_depth(pattern));
  add_hood(pattern, {own["hood_height"], own["hood_depth"], fit("edge_finish")});
  add_hem_band(pattern, {own["hem_band_width"], own["hem_band_stretch"], fit("band_stiffness")});
  for (const auto& [name, value] : own) drafted.fit[name] = value;
  return drafted;
}

/// With and without what a draft may leave out.
const std::vector<pattern::Pattern>& variants() {
  static const std::vector<pattern::Pattern> kVariants = [] {
    std::vector<pattern::Pattern> drafts;
    for (const double band : {0.0, 0.06})
      for (const double cuff : {0.0, 0.06})
        drafts.push_back(
            draft({{}, "women-38", {{"hem_band_width", band}, {"cuff_width", cuff}}, {}}).pattern);
    return drafts;
  }();
  return kVariants;
}

}  // namespace

GarmentKind hoodie() {
  GarmentKind kind = roomy_shirt();
  kind.measures.push_back({kCrown, kCrown, 0.10, 0.45, "m", false});
  kind.keys = keys();
  kind.draft = draft;
  kind.lay = {};  // sewn together round the body, as hoods of pattern files are
  for (KindOpening& opening : kind.openings) {
    if (opening.use == OpeningUse::neck) opening.edges = {{"hood_L", "face"}, {"hood_R", "face"}};
    if (opening.use == OpeningUse::hem)
      for (const char* part : {"hem_band_front", "hem_band_back"})
        opening.edges.emplace_back(part, "rim");
  }
  kind.mark = "hoodie 1";
  kind.note_parts = [](pattern::Pattern& pattern) {
    return std::any_of(variants().begin(), variants().end(),
                       [&](const pattern::Pattern& draft) { return match_parts(draft, pattern); });
  };
  return kind;
}

}  // namespace loosefit::kinds
