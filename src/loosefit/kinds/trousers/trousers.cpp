#include "loosefit/kinds/trousers/trousers.h"

#include <fmt/format.h>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/kinds/check_values.h"
#include "loosefit/kinds/match_parts.h"
#include "loosefit/kinds/told_limit.h"
#include "loosefit/kinds/trousers/lay_trousers.h"
#include "loosefit/kinds/trousers/trousers_draft.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

std::vector<KindMeasure> measures() {
  return {{"waist", "waist", 0.30, 2.2},
          {"hip", "hip", 0.35, 2.2},
          {"waist_level", "waist_level", 0.35, 1.60},
          {"hip_level", "hip_level", 0.25, 1.40},
          {"crotch_height", "crotch_height", 0.18, 1.20},
          {"thigh", "thigh", 0.20, 1.2, "m", false},
          {"knee", "knee", 0.12, 0.9, "m", false},
          {"calf", "calf", 0.12, 0.9, "m", false},
          {"ankle", "ankle", 0.08, 0.6, "m", false}};
}

/// Defaults of the fit in which the kinds differ.
struct Usual {
  double hip, knee, hem, crotch_width, crotch_ease, leg_length, waistband;
  std::optional<double> thigh, calf;
};

std::vector<KindKey> keys(const Usual& usual) {
  const char *const kMobility = "a body-garment mobility", *const kFraction = "a fraction",
                    *const kLength = "metres";
  return {
      {"waist",
       {},
       -0.35,
       2,
       kMobility,
       "girth of the pieces at the waist, gathered into the waistband; without it as narrow as the "
       "seams can be cut above the hip",
       true},
      {"hip", usual.hip, -0.35, 2, kMobility, "girth at the hip", true},
      {"thigh", usual.thigh, -0.35, 2, kMobility,
       "girth of the leg a twelfth of the inseam below the crotch; without it the inseam curves "
       "from "
       "the crotch to the knee",
       true},
      {"knee", usual.knee, -0.35, 2, kMobility, "girth of the leg at the knee", true},
      {"calf", usual.calf, -0.35, 2, kMobility,
       "girth of the leg where the calf is fullest; without it straight from knee to hem", true},
      {"hem", usual.hem, -0.35, 3, kMobility, "girth of the hem, against the leg where it ends",
       true},
      {"crotch_width", usual.crotch_width, 0.06, 0.26, kFraction,
       "how far the crotch curves reach under the body, front and back, of the girth at the hip"},
      {"crotch_ease", usual.crotch_ease, -0.03, 0.12, kLength,
       "crotch of the trousers below the body's"},
      {"leg_length", usual.leg_length, 0.1, 0.98, "a share of the leg",
       "from the crotch to the hem, of the way to the floor"},
      {"waistband", usual.waistband, -0.5, 1, kMobility,
       "length of the waistband before it is stretched"},
      {"waistband_width", 0.035, 0, 0.12, kLength,
       "strip of two layers round the waist, its middle on the waist; 0: none"},
      {"waistband_stiffness", 0.25, 0.02, 100, "a multiple",
       "stiffness of the waistband, of one layer of the fabric; in bending at least 1"},
  };
}

DraftedGarment draft(const char* kind, const Usual& usual, const DraftRequest& request) {
  DraftedGarment drafted;
  if (!request.size.empty())
    throw InvalidInput({{}, 0, "size"}, '"' + request.size + '"', "no size for this kind",
                       std::string(kind) + " are drafted to measure; leave out the size");
  drafted.measures = request.measures;
  for (const KindKey& key : keys(usual))
    if (key.usual) drafted.fit[key.name] = *key.usual;
  for (const auto& [name, value] : request.fit) drafted.fit[name] = value;
  check_values(measures(), drafted.measures, keys(usual), drafted.fit);
  const double least = least_waist(drafted.measures, drafted.fit);
  if (const auto waist = drafted.fit.find("waist"); waist == drafted.fit.end()) {
    drafted.fit["waist"] = usual_waist(drafted.measures, drafted.fit);
  } else if (waist->second < least && request.yielding.count("fit.waist")) {
    drafted.notes.push_back(
        fmt::format("fit.waist: {} instead of {:.3g}, which is all that the seams can take in "
                    "above this hip",
                    shortest(told_least(least)), waist->second));
    waist->second = told_least(least);
  }
  std::set<std::string> asked;
  for (const auto& [name, value] : request.fit)
    if (!request.yielding.count("fit." + name)) asked.insert(name);
  drafted.pattern = draft_trousers(kind, drafted.measures, drafted.fit, asked);
  return drafted;
}

double edge_length(const pattern::Pattern& p, const std::string& part, const char* edge) {
  const int panel = p.find_part(part);
  const int e = panel < 0 ? -1 : pattern::find_edge_part(p.panels[panel], edge);
  return e < 0 ? 0 : pattern::EdgePath(p.panels[panel], e).length();
}

std::vector<FitLevel> levels(const pattern::Pattern& p, const BodyMeasures& measures,
                             const NamedValues& fit) {
  std::vector<FitLevel> found;
  const auto measured = [&](const char* name) -> std::optional<double> {
    const auto at = measures.find(name);
    return at == measures.end() ? std::nullopt : std::optional(at->second);
  };
  // Widths across pieces at a height; parts beside each other are summed.
  const auto width = [&](std::initializer_list<const char*> parts, double y) {
    double sum = 0;
    for (const char* part : parts)
      if (const int i = p.find_part(part); i >= 0) sum += width_at(p.panels[i], y);
    return sum;
  };
  const auto leg = [&](double y) { return width({"front_L", "back_L"}, y); };
  if (const double band =
          edge_length(p, "waistband_front", "rim") + edge_length(p, "waistband_back", "rim");
      band > 0)
    found.push_back({"waistband", band, measured("waist")});
  double waist = 0;
  for (const char* part : {"front_L", "front_R", "back_L", "back_R"})
    waist += edge_length(p, part, "waist");
  found.push_back({"waist", waist, measured("waist")});
  const auto crotch = measured("crotch_height");
  if (const auto hip = measured("hip_level"))
    found.push_back(
        {"hip", width({"front_L", "front_R", "back_L", "back_R"}, *hip), measured("hip")});
  if (!crotch || !measured("hip")) return found;
  const double length = fit.count("leg_length") ? fit.at("leg_length") : 1 - kAnkleLevel;
  const double hem = (1 - length) * *crotch;
  for (const auto& [name, level] :
       {std::pair{"thigh", kThighLevel}, {"knee", kKneeLevel}, {"calf", kCalfLevel}}) {
    const double y = level * *crotch;
    if (const double wide = y > hem ? leg(y) : 0; wide > 0)
      found.push_back({name, wide, leg_girth_at(measures, y)});
  }
  found.push_back({"hem", edge_length(p, "front_L", "hem") + edge_length(p, "back_L", "hem"),
                   leg_girth_at(measures, hem)});
  return found;
}

/// Down the left leg, from below the crotch to the hem.
std::vector<FitStation> stations(const pattern::Pattern& p, const BodyMeasures& measures,
                                 const NamedValues& fit) {
  const auto piece = [&](const char* part) {
    const int found = p.find_part(part);
    return found < 0 ? nullptr : &p.panels[found];
  };
  const auto crotch = measures.find("crotch_height");
  if (crotch == measures.end()) return {};
  const pattern::Panel *front = piece("front_L"), *back = piece("back_L");
  if (!front || !back) return {};
  double tip = -1e9, hem = -1e9;  // lowest end of a crotch curve, highest end of a hem
  for (const pattern::Panel* panel : {front, back}) {
    const int inseam = pattern::find_edge_part(*panel, "inseam");
    if (inseam < 0) return {};
    const Vec2 &a = panel->vertices[panel->edges[inseam].start],
               &b = panel->vertices[panel->edges[inseam].end];
    tip = tip == -1e9 ? std::max(a.y(), b.y()) : std::min(tip, std::max(a.y(), b.y()));
    hem = std::max(hem, std::min(a.y(), b.y()));
  }
  const std::vector<AskedMobility> asked =
      fit.empty() ? std::vector<AskedMobility>{} : leg_eases(measures, fit);
  std::vector<FitStation> found = stations_along(
      "leg", {front, back}, crotch->second - tip, crotch->second - hem,
      [&](double along) { return crotch->second - along; }, asked);
  for (FitStation& s : found)
    if (s.asked && !is_ease_asked(measures, fit, s.along)) s.asked.reset();
  return found;
}

GarmentKind make_kind(const char* name, const char* title, const Usual& usual) {
  GarmentKind kind;
  kind.name = name;
  kind.title = title;
  kind.measures = measures();
  kind.keys = keys(usual);
  kind.draft = [name, usual](const DraftRequest& request) { return draft(name, usual, request); };
  kind.levels = levels;
  kind.stations = stations;
  kind.lay = lay_trousers;
  kind.openings = {{OpeningUse::waist,
                    {{"waistband_front", "rim"},
                     {"waistband_back", "rim"},
                     {"front_L", "waist"},
                     {"front_R", "waist"},
                     {"back_L", "waist"},
                     {"back_R", "waist"}}},
                   {OpeningUse::left_leg, {{"front_L", "hem"}, {"back_L", "hem"}}},
                   {OpeningUse::right_leg, {{"front_R", "hem"}, {"back_R", "hem"}}}};
  kind.mark = std::string(name) + " 1";
  kind.note_parts = [name, usual](pattern::Pattern& pattern) {
    const NamedValues person = {{"waist", 0.72},
                                {"hip", 0.97},
                                {"waist_level", 1.03},
                                {"hip_level", 0.85},
                                {"crotch_height", 0.79}};
    for (const double band : {0.035, 0.0})
      if (match_parts(draft(name, usual, {person, "", {{"waistband_width", band}}, {}}).pattern,
                      pattern))
        return true;
    return false;
  };
  return kind;
}

}  // namespace

GarmentKind trousers() {
  return make_kind("trousers", "trousers",
                   {.hip = 0.08,
                    .knee = 0.25,
                    .hem = 0.90,
                    .crotch_width = 0.16,
                    .crotch_ease = 0.015,
                    .leg_length = 0.90,
                    .waistband = -0.06,
                    .thigh = {},
                    .calf = {}});
}

GarmentKind leggings() {
  return make_kind("leggings", "leggings",
                   {.hip = -0.05,
                    .knee = -0.05,
                    .hem = -0.03,
                    .crotch_width = 0.12,
                    .crotch_ease = 0,
                    .leg_length = 0.87,
                    .waistband = -0.08,
                    .thigh = -0.06,
                    .calf = -0.06});
}

}  // namespace loosefit::kinds
