#include "loosefit/kinds/tank_top/tank_top.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/text.h"
#include "loosefit/base/types.h"
#include "loosefit/dress/front_neckline.h"
#include "loosefit/dress/sheets.h"
#include "loosefit/kinds/check_values.h"
#include "loosefit/kinds/find_size.h"
#include "loosefit/kinds/match_parts.h"
#include "loosefit/kinds/shirt/shirt_frame.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/kinds/shirt/shirt_sizes.h"
#include "loosefit/kinds/tank_top/tank_top_draft.h"
#include "loosefit/kinds/told_limit.h"

namespace loosefit::kinds {
namespace {

std::vector<KindMeasure> measures() {
  return {{"chest", "chest", 0.35, 2.2},
          {"waist", "waist", 0.30, 2.2},
          {"hip", "hip", 0.35, 2.2},
          {"neck", "neck", 0.15, 0.80},
          {"shoulder_breadth", "shoulder_breadth", 0.15, 0.80},
          {"shoulder_slope", "shoulder_slope", 0, radians(45), "rad"},
          {"scye_depth", "scye_depth", 0.05, 0.35},
          {"hps_to_waist", "hps_to_waist", 0.15, 0.80},
          {"hps_to_hem", "hps_to_hip", 0.20, 1.60},
          {"front_fullness", "front_fullness", -0.10, 0.15, "m", false},
          {"front_balance", "front_balance", -0.10, 0.25, "m", false}};
}

std::vector<KindKey> keys() {
  const char *const kMobility = "a body-garment mobility", *const kFraction = "a fraction";
  return {
      {"chest", 0.05, -0.35, 2, kMobility, "girth under the arms", true},
      {"waist",
       {},
       -0.35,
       2,
       kMobility,
       "girth at the waist; without it the side seams run straight, and outwards where a belly "
       "needs room",
       true},
      {"hip", 0.06, -0.35, 2, kMobility, "girth of the hem", true},
      {"strap_width", 0.45, 0.15, 1, kFraction, "of the body's shoulder, neck to shoulder point"},
      {"strap_place", 0.45, 0, 1, kFraction,
       "of the rest of that shoulder: 0 the strap lies at the neck, 1 at the shoulder point"},
      {"neck_drop", 0.55, 0.1, 0.85, kFraction,
       "depth of the front neckline, of the way from strap to underarm"},
      {"back_drop", 0.30, 0.05, 0.85, kFraction, "the same of the back"},
      {"scye_ease", 0.02, 0, 0.15, "metres", "underarm below the armpit"},
  };
}

/// Straps for which a narrow chest has no room get narrower and move towards the neck, unless they
/// were asked for.
void make_room_for_straps(DraftedGarment& drafted, const std::set<std::string>& yielding) {
  const auto give_way = [&](const char* key, double most) {
    double& value = drafted.fit[key];
    if (value <= most || !yielding.count(std::string("fit.") + key)) return;
    const double given = told_most(most);
    drafted.notes.push_back(fmt::format(
        "fit.{}: {} instead of {:.3g}, since otherwise the straps would end outside the "
        "underarm",
        key, shortest(given), value));
    value = given;
  };
  give_way("strap_width", strap_room(drafted.measures, drafted.fit).width);
  give_way("strap_place", strap_room(drafted.measures, drafted.fit).place);
}

/// What makes the front of a body differ from its back is taken at the end of its range, unless it
/// was asked for.
void keep_front_in_range(DraftedGarment& drafted, const std::set<std::string>& yielding) {
  for (const KindMeasure& measure : measures()) {
    const auto value = drafted.measures.find(measure.name);
    const std::string key = "measures." + measure.name;
    if (measure.required || value == drafted.measures.end() || !yielding.count(key)) continue;
    const double kept = std::clamp(value->second, measure.low, measure.high);
    if (kept == value->second) continue;
    drafted.notes.push_back(
        fmt::format("{}: {:.3g} instead of {:.3g}, since otherwise the body's own is beyond what "
                    "the draft knows",
                    key, kept, value->second));
    value->second = kept;
  }
}

DraftedGarment draft(const DraftRequest& request) {
  DraftedGarment drafted;
  drafted.measures = request.measures;
  for (const KindKey& key : keys())
    if (key.usual) drafted.fit[key.name] = *key.usual;
  for (const auto& [name, value] : request.fit) drafted.fit[name] = value;
  // A size brings the girths of its shirt; straps and necklines have their defaults.
  if (!request.size.empty()) {
    const KindSize& size = find_size(shirt_sizes(), request.size);
    drafted.measures = size.measures;
    for (const char* level : {"chest", "waist", "hip"}) {
      drafted.fit.erase(level);
      if (const auto girth = size.fit.find(level); girth != size.fit.end())
        drafted.fit[level] = girth->second;
    }
  }
  BodyMeasures& m = drafted.measures;
  const auto raise = [&](const char* name, double least, const char* otherwise) {
    double& value = m.at(name);
    const std::string key = std::string("measures.") + name;
    if (value >= least || !request.yielding.count(key)) return;
    const double given = told_least(least);
    drafted.notes.push_back(fmt::format("{}: {} instead of {:.3g}, since otherwise {}", key,
                                        shortest(given), value, otherwise));
    value = given;
  };
  keep_front_in_range(drafted, request.yielding);
  check_values(measures(), m, keys(), drafted.fit);
  // A body so short that the hem would end at the underarm gets a longer one, and one whose front
  // alone would end there a longer front.
  raise("hps_to_hem", shortest_tank_top(m, drafted.fit), "the hem would end at the underarm");
  if (m.count("front_balance"))
    raise("front_balance", least_front_balance(m, drafted.fit),
          "the front would end at the underarm");
  make_room_for_straps(drafted, request.yielding);
  drafted.pattern = draft_tank_top(m, drafted.fit);
  return drafted;
}

/// Front before and back behind the body, straps over the shoulders, sides under the arms.
std::vector<Vec3> lay_tank_top(const garment::Garment& g, const body::Body& body,
                               const dress::LayingRoom& room) {
  const dress::BodyOutline depth(body, room.clearance);
  const ShirtFrame frame = shirt_frame(g, body, depth, room.clearance);
  // Ends of the strap on the line of the shoulder, from the neck on.
  constexpr double kInner = 0.25, kOuter = 0.70;
  const auto on_shoulder = [](const ShirtFrame::Half& half, double share) -> Vec2 {
    return half.neck + share * (half.shoulder - half.neck);
  };
  const auto &l = frame.left, &r = frame.right;
  const Vec2 inner_l = on_shoulder(l, kInner), outer_l = on_shoulder(l, kOuter),
             inner_r = on_shoulder(r, kInner), outer_r = on_shoulder(r, kOuter);
  dress::Sheets sheets(g);
  for (int p = 0; p < static_cast<int>(g.panel_names.size()); ++p) {
    const bool back = g.panel_parts[p] == "back";
    dress::PanelOutline panel(g, g.panel_parts[p]);
    panel.lay("hem", "side_L", {l.hem, r.hem});
    panel.lay("side_L", "hem", {l.hem, l.armpit});
    panel.lay("side_R", "hem", {r.hem, r.armpit});
    panel.lay("armhole_L", "side_L", {l.armpit, outer_l});
    panel.lay("armhole_R", "side_R", {r.armpit, outer_r});
    panel.lay("shoulder_L", "armhole_L", {outer_l, inner_l});
    panel.lay("shoulder_R", "armhole_R", {outer_r, inner_r});
    panel.lay("neck", "shoulder_L",
              back || room.straight_neck
                  ? std::vector<Vec2>{inner_l, inner_r}
                  : dress::front_neckline(front_neck_length(g), body, inner_l, inner_r));
    sheets.add(p, panel, back);
  }
  return sheets.positions(depth, room);
}

}  // namespace

GarmentKind tank_top() {
  GarmentKind kind;
  kind.name = "tank-top";
  kind.title = "tank top";
  kind.measures = measures();
  kind.keys = keys();
  kind.sizes = shirt_sizes();
  kind.draft = draft;
  kind.levels = shirt_levels;
  kind.stations = shirt_stations;
  kind.lay = lay_tank_top;
  kind.openings = {{OpeningUse::neck, {{"front", "neck"}, {"back", "neck"}}},
                   {OpeningUse::hem, {{"front", "hem"}, {"back", "hem"}}},
                   {OpeningUse::left_arm, {{"front", "armhole_L"}, {"back", "armhole_L"}}},
                   {OpeningUse::right_arm, {{"front", "armhole_R"}, {"back", "armhole_R"}}}};
  kind.mark = "tank top 1";
  kind.note_parts = [](pattern::Pattern& pattern) {
    static const pattern::Pattern kDraft = draft({{}, "women-38", {}, {}}).pattern;
    return match_parts(kDraft, pattern);
  };
  return kind;
}

}  // namespace loosefit::kinds
