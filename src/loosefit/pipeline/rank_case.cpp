#include "loosefit/pipeline/rank_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <tuple>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pipeline/case_sites.h"
#include "loosefit/pipeline/case_warnings.h"
#include "loosefit/pipeline/wear_states.h"

namespace loosefit::pipeline {
namespace {

constexpr double kSamePlace = 5e-4;  // [m]

/// Every corner of `inner` on `outer`; how the curves are divided does not matter.
bool lies_on(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer) {
  return std::all_of(inner.begin(), inner.end(), [&](const Vec2& p) {
    return (pattern::closest_on_polygon(outer, p) - p).norm() < kSamePlace;
  });
}

placement::SiteMeter meter_of(const CaseResult& result) {
  return placement::SiteMeter(result.studied().mesh(), result.scenario.studied().material.material,
                              worn_states(result));
}

bool has(const std::vector<placement::Site>& sites, const std::string& name) {
  return std::any_of(sites.begin(), sites.end(),
                     [&](const placement::Site& s) { return s.name == name; });
}

/// Sites that all wearers have; the rest goes and is named. `wearers` hold those of each, `bare`
/// what the garment of each does not cover.
std::vector<placement::Site> common(const std::vector<placement::Site>& sites,
                                    const std::vector<placement::RankingWearer>& wearers,
                                    const std::vector<std::vector<placement::UncoveredSite>>& bare,
                                    std::vector<placement::UncoveredSite>& uncovered,
                                    std::vector<std::string>& notes) {
  std::vector<placement::Site> kept;
  std::vector<std::string> gone;
  for (const placement::Site& site : sites) {
    const auto lacking =
        std::find_if(wearers.begin() + 1, wearers.end(),
                     [&](const placement::RankingWearer& w) { return !has(w.sites, site.name); });
    if (lacking == wearers.end()) {
      kept.push_back(site);
    } else if (site.preset) {
      gone.push_back(site.name);
    } else {
      const std::vector<placement::UncoveredSite>& theirs = bare[lacking - wearers.begin()];
      const auto named =
          std::find_if(theirs.begin(), theirs.end(),
                       [&](const placement::UncoveredSite& u) { return u.name == site.name; });
      if (named != theirs.end()) {
        uncovered.push_back({site.name, false, named->why + " (" + printable(lacking->name) + ")"});
        continue;
      }
      throw InvalidInput(
          {"", 0, "site"},
          "\"" + printable(site.name) + "\", which " + printable(lacking->name) + " does not have",
          "the same [[site]] in every run",
          "their garments are cut differently, so every run finds its own place");
    }
  }
  if (!gone.empty())
    notes.push_back("presets that some garment does not cover are left out: " + join(gone));
  return kept;
}

std::vector<std::string> notes_on(const std::vector<RankedRun>& runs, bool same) {
  std::vector<std::string> names, notes;
  for (const RankedRun& run : runs)
    for (const std::string& text : state_warnings(*run.result))
      notes.push_back(runs.size() == 1 ? text : run.name + ": " + text);
  if (runs.size() == 1) return notes;
  for (const RankedRun& run : runs) names.push_back(run.name);
  notes.push_back(fmt::format("samples are the runs {}: {}", join(names),
                              same ? "sensors stay where they are sewn in the first"
                                   : "garments are cut differently, so every run has its own "
                                     "place of a site"));
  const auto posture = [](const RankedRun& run) { return run.result->scenario.body.posture; };
  if (std::any_of(runs.begin(), runs.end(),
                  [&](const RankedRun& run) { return posture(run) != posture(runs.front()); }))
    notes.push_back(
        "the runs are in different postures, each dressed anew: nothing is told of the change from "
        "one posture to another");
  return notes;
}

}  // namespace

placement::RankingWish ranking_wish(const scenario::ScenarioRanking& asked, std::uint64_t seed) {
  placement::RankingWish wish;
  wish.scorecard = io::load_scorecard(asked.modality);
  wish.best = asked.best;
  wish.partial = asked.partial;
  wish.search.seed = wish.rank.seed = seed;
  return wish;
}

bool same_pieces(const pattern::Pattern& a, const pattern::Pattern& b) {
  if (a.panels.size() != b.panels.size()) return false;
  for (const pattern::Panel& panel : a.panels) {
    const int other = b.find_panel(panel.name);
    if (other < 0) return false;
    const std::vector<Vec2> p = pattern::outline_polygon(panel),
                            q = pattern::outline_polygon(b.panels[other]);
    if (!lies_on(p, q) || !lies_on(q, p)) return false;
  }
  return true;
}

placement::RankingTable rank_cases(const std::vector<RankedRun>& runs,
                                   const placement::RankingWish& wish, bool with_sites) {
  if (runs.empty()) throw InvalidInput("a ranking needs at least one run");
  const CaseResult& first = *runs.front().result;
  const bool same = std::all_of(runs.begin(), runs.end(), [&](const RankedRun& run) {
    return same_pieces(first.studied().pattern.pattern, run.result->studied().pattern.pattern);
  });
  if (!same && wish.best > 0)
    throw InvalidInput({"", 0, "best"}, "a search over garments of different cuts",
                       "runs with the same pattern pieces",
                       "give every scenario the pattern.json of one run as [garment] pattern");
  // What each run tells of a place; and its own sites where garments are cut differently.
  std::deque<placement::SiteMeter> meters;
  std::vector<placement::RankingWearer> wearers;
  std::vector<std::vector<placement::UncoveredSite>> bare;
  for (const RankedRun& run : runs) {
    const CaseResult& result = *run.result;
    const CaseGarment& garment = result.studied();
    meters.push_back(meter_of(result));
    wearers.push_back({run.name,
                       {garment.mesh(), garment.drape.positions, result.body.body,
                        garment.maps.worn, meters.back()}});
    bare.emplace_back();
    if (!with_sites || same) continue;
    SiteStage own = find_case_sites(result);
    wearers.back().sites = std::move(own.sites);
    bare.back() = std::move(own.uncovered);
  }
  // Sites of the first run, as far as all have them.
  placement::RankingWish whole = wish;
  std::vector<std::string> notes = notes_on(runs, same);
  if (with_sites) {
    SiteStage of_first = find_case_sites(first);
    whole.sites = std::move(of_first.sites);
    whole.uncovered = std::move(of_first.uncovered);
    if (!same) whole.sites = common(whole.sites, wearers, bare, whole.uncovered, notes);
    wearers.front().sites.clear();
  }
  placement::RankingTable table = placement::make_ranking(wearers, whole);
  table.notes.insert(table.notes.begin(), notes.begin(), notes.end());
  return table;
}

}  // namespace loosefit::pipeline
