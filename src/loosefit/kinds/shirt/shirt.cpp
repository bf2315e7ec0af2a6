#include "loosefit/kinds/shirt/shirt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "loosefit/base/text.h"
#include "loosefit/kinds/find_size.h"
#include "loosefit/kinds/match_parts.h"
#include "loosefit/kinds/shirt/lay_shirt.h"
#include "loosefit/kinds/shirt/shirt_adapt.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/kinds/shirt/shirt_sizes.h"
#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/kinds/shirt/shirt_variants.h"

namespace loosefit::kinds {
namespace {

std::vector<KindMeasure> measures() {
  std::vector<KindMeasure> list;
  for (const ShirtMeasure& m : shirt_measure_list()) {
    const std::string name = m.name;
    list.push_back({name, name == "hps_to_hem" ? "hps_to_hip" : name, m.low, m.high,
                    name == "shoulder_slope" ? "rad" : "m", m.usual == nullptr});
  }
  return list;
}

std::vector<KindKey> keys(const ShirtFit& usual) {
  const char *const kMobility = "a body-garment mobility", *const kFraction = "a fraction";
  return {
      {"chest", usual.chest, -0.35, 2, kMobility, "girth under the arms", true},
      {"waist", usual.waist, -0.35, 2, kMobility,
       "girth at the waist; without it the side seams run straight, and outwards where a belly "
       "needs room",
       true},
      {"hip", usual.hip, -0.35, 2, kMobility, "girth of the hem", true},
      {"sleeve", usual.sleeve, -0.35, 2, kMobility, "girth of the sleeve below the armhole, against the arm there", true},
      {"elbow", usual.elbow, -0.35, 2, kMobility,
       "ease of the sleeve at the elbow; without it even between sleeve and wrist", true},
      {"forearm", usual.forearm, -0.35, 2, kMobility,
       "ease of the sleeve where the forearm is fullest; without it as elbow", true},
      {"wrist", usual.wrist, -0.35, 2, kMobility, "girth of the cuff", true},
      {"neck_ease", usual.neck_ease, -0.2, 1, kFraction,
       "share added to the neck base, in length and in width"},
      {"scye_ease", usual.scye_ease, 0, 0.15, "metres", "underarm below the armpit"},
      {"shoulder_follow", usual.shoulder_follow, 0, 1, kFraction,
       "share of a loose chest that widens the shoulders"},
      {"cap_ease", usual.cap_ease, 0, 0.15, kFraction, "sleeve cap longer than the armhole"},
      {"cap_ratio", usual.cap_ratio, 0.4, 0.85, kFraction,
       "cap height over armhole depth that the draft seeks: high for hanging arms, low for raised "
       "ones"},
      {"sleeve_length", usual.sleeve_length, 0.25, 1, "a share of the arm",
       "from the shoulder point to the hem of the sleeve; below 1 wrist counts against the arm "
       "there"},
      {"bust_dart", usual.bust_dart, 0, 1, kFraction,
       "share of the length that the front needs over the bust, taken up in darts at the sides; "
       "below 12 mm no dart is cut"},
      {"back_waist", usual.back_waist, 0, 0.06, "metres",
       "taken in at the waist, in all, by two darts of the back below the shoulder blades; a girth "
       "that waist asks for is kept; below 5 mm there are none"},
      {"sleeve_follow", usual.sleeve_follow, 0, 1, kFraction,
       "1: every place of the sleeve has the ease asked for there; 0: it tapers evenly where that "
       "leaves more room, with sleeve counted against the upper arm where that is fullest"},
      {"elbow_bend", usual.elbow_bend, 0, 40, "degrees",
       "bend of the arm that the sleeve is cut for, by a dart in its back at the elbow"},
      {"neckband_width", usual.neckband, 0, 0.08, "metres",
       "strip of two layers round the neck, whose rim lies at the neck base; 0: none", false, true},
      {"neckband_stretch", usual.neckband_stretch, 0, 0.4, kFraction,
       "neckband a straight strip, shorter than the neckline, which it is sewn to stretched; "
       "0: cut curved, as the neckline is",
       false, true},
      {"cuff_width", usual.cuff, 0, 0.12, "metres",
       "folded strip at the end of the sleeve, within sleeve_length; wrist is its "
       "ease, against the arm at its seam; 0: none",
       false, true},
      {"cuff_stretch", usual.cuff_stretch, 0, 0.6, kFraction,
       "cuff shorter than the end of the sleeve, which it is sewn to stretched", false, true},
      {"band_stiffness", usual.band_stiffness, 0.1, 100, "a multiple",
       "stiffness of neckband and cuffs, of one layer of the fabric; in bending at least 1", false,
       true},
      {"edge_finish", usual.edge_finish, 0, 0.05, "metres",
       "width of the hems turned under along free edges; 0: edges as they are cut", false, true},
  };
}

std::string details_of(const ShirtDraftReport& report) {
  return fmt::format(
      "armhole {:.1f} mm, depth {:.1f} mm, cap height {:.1f} mm (ratio {:.2f}), underarm "
      "lowered {:.1f} mm, shoulder dropped {:.1f} mm",
      1000 * report.armhole, 1000 * report.armhole_depth, 1000 * report.cap_height,
      report.cap_ratio, 1000 * report.deepened, 1000 * report.dropped);
}

/// Where the underarm is not as far below the armpit as fit.scye_ease wished, whoever moved it, and
/// a cap that is lower than sought in spite of that; nothing where it lies as wished. `change`:
/// that of the wished value, if it gave way.
std::optional<std::string> note_of_armhole(double wished, const ShirtChange* change,
                                           const ShirtFit& fit, const ShirtDraftReport& report) {
  constexpr double kTold = 0.002;  // [m], less than a step of the draft
  constexpr double kToldRatio = 0.005;
  const double lies = fit.scye_ease + report.deepened, moved = lies - wished;
  if (std::abs(moved) <= kTold) return {};
  // What moved it back again in part is no reason.
  std::vector<std::string> reasons;
  if (change && (change->after > change->before) == (moved > 0)) reasons.push_back(change->reason);
  if (report.deepened < 0 && moved < 0)
    reasons.push_back("the sleeve cap would be too steep for the armhole");
  if (report.deepened > 0 && moved > 0)
    reasons.push_back(fmt::format(
        "the sleeve cap would be lower than {:.3g} of the armhole's depth (fit.cap_ratio)",
        fit.cap_ratio));
  std::string note =
      ShirtChange{"fit.scye_ease", wished, lies, join(reasons, ", and since ")}.told();
  if (report.cap_ratio < fit.cap_ratio - kToldRatio)
    note += fmt::format("; with that it is {:.2f}", report.cap_ratio);
  return note;
}

/// Bands and hems, which may be asked for beside a size.
void take_making(ShirtFit& fit, const ShirtFit& asked) {
  fit.neckband = asked.neckband;
  fit.neckband_stretch = asked.neckband_stretch;
  fit.cuff = asked.cuff;
  fit.cuff_stretch = asked.cuff_stretch;
  fit.band_stiffness = asked.band_stiffness;
  fit.edge_finish = asked.edge_finish;
}

DraftedGarment draft(const std::string& kind, const ShirtFit& usual, const DraftRequest& request) {
  ShirtMeasures measures = shirt_measures_of(request.measures);
  ShirtFit fit = shirt_fit_of(request.fit, usual);
  if (!request.size.empty()) {
    const KindSize size = find_size(shirt_sizes(), request.size);
    const ShirtFit asked = fit;
    measures = shirt_measures_of(size.measures);
    fit = shirt_fit_of(size.fit);
    take_making(fit, asked);
    // A size is one of long sleeves; cut off, they are as loose as at the upper arm.
    if (asked.sleeve_length < 1) {
      fit.sleeve_length = asked.sleeve_length;
      fit.wrist = fit.sleeve;
    }
  }
  AdaptedShirt shirt = draft_adapted_shirt(measures, fit, request.yielding);
  shirt.pattern.name = shirt.pattern.kind = kind;
  // Nobody is told of what nobody asked for: the usual armhole, or that of a size.
  // A scenario gives every key; one that may give way at its usual value was asked for by nobody.
  const auto asked = [&](const std::string& key) {
    const auto given = request.fit.find(key);
    return given != request.fit.end() &&
           (!request.yielding.count("fit." + key) || given->second != named(usual).at(key));
  };
  const bool tell_armhole = request.size.empty() && (asked("scye_ease") || asked("cap_ratio"));
  const ShirtChange* of_armhole = nullptr;
  std::vector<std::string> notes;
  for (const ShirtChange& change : shirt.changes)
    if (tell_armhole && change.key == "fit.scye_ease")
      of_armhole = &change;
    else
      notes.push_back(change.told());
  if (tell_armhole)
    if (auto note = note_of_armhole(fit.scye_ease, of_armhole, shirt.fit, shirt.report))
      notes.push_back(std::move(*note));
  return {std::move(shirt.pattern), named(shirt.measures), named(shirt.fit), std::move(notes),
          details_of(shirt.report)};
}

}  // namespace

GarmentKind shirt_kind(const std::string& name, const std::string& title, const ShirtFit& usual) {
  GarmentKind kind;
  kind.name = name;
  kind.title = title;
  kind.measures = measures();
  kind.keys = keys(usual);
  kind.sizes = shirt_sizes();
  kind.draft = [name, usual](const DraftRequest& request) { return draft(name, usual, request); };
  kind.levels = shirt_levels;
  kind.stations = shirt_stations;
  kind.lay = lay_shirt;
  kind.openings = {
      {OpeningUse::neck,
       {{"front", "neck"}, {"back", "neck"}, {"neckband_front", "rim"}, {"neckband_back", "rim"}}},
      {OpeningUse::hem, {{"front", "hem"}, {"back", "hem"}, {"back", "hem_L"}, {"back", "hem_R"}}},
      {OpeningUse::left_arm,
       {{"sleeve_L_front", "cuff"},
        {"sleeve_L_back", "cuff"},
        {"cuff_L_front", "rim"},
        {"cuff_L_back", "rim"}}},
      {OpeningUse::right_arm,
       {{"sleeve_R_front", "cuff"},
        {"sleeve_R_back", "cuff"},
        {"cuff_R_front", "rim"},
        {"cuff_R_back", "rim"}}}};
  kind.mark = "shirt 1";
  kind.note_parts = [](pattern::Pattern& pattern) {
    const std::vector<pattern::Pattern>& drafts = shirt_variants();
    return std::any_of(drafts.begin(), drafts.end(),
                       [&](const pattern::Pattern& draft) { return match_parts(draft, pattern); });
  };
  return kind;
}

GarmentKind long_sleeve_shirt() {
  return shirt_kind("long-sleeve-shirt", "long-sleeve shirt", usual_shirt_fit());
}

GarmentKind t_shirt() {
  ShirtFit fit = usual_shirt_fit();
  fit.sleeve = fit.wrist = 0.20;
  fit.cap_ease = 0;
  fit.cap_ratio = 0.55;  // knits give, and the arms of a T-shirt are raised
  fit.sleeve_length = 0.38;
  fit.neckband_stretch = 0.10;  // of rib, which gives
  return shirt_kind("t-shirt", "T-shirt", fit);
}

}  // namespace loosefit::kinds
