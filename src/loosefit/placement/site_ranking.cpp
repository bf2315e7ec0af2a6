#include "loosefit/placement/site_ranking.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::placement {
namespace {

using Kind = FootprintShape::Kind;

/// Apart from this, the candidates' spacing, places are measured to see what the states can tell
/// [m].
constexpr double kProbeSpacing = 0.10;

void merge(const WearerSamples& samples, MetricValues& known) {
  for (const MetricValues& metrics : samples)
    for (const auto& [name, value] : metrics)
      if (std::isfinite(value)) known[name] = value;
}

std::string names(const std::vector<body::Region>& regions) {
  std::vector<std::string> words;
  for (body::Region region : regions) words.push_back(body::name(region));
  return join(words);
}

void check(const Wearers& wearers, const RankingWish& wish) {
  check_keep_out(wish.constraints.keep_out, wearers.first().ground().garment.panel_names);
  if (wish.best == 0) return;
  if (wish.scorecard.footprint.kind == Kind::girth)
    throw InvalidInput({"", 0, "footprint.shape"}, "\"girth\" in a scorecard to search with",
                       "disc, rectangle or line",
                       "give lines round the body as sites, or search with a line");
  if (wearers.cut_differently())
    throw InvalidInput({"", 0, "best"}, "a search over garments of different cuts",
                       "runs with the same pattern pieces",
                       "give each run the pattern.json of the first: [garment] pattern = \"…\"");
}

/// Makes the table step by step.
class Table {
 public:
  Table(const Wearers& wearers, const RankingWish& wish)
      : wearers_(wearers),
        wish_(wish),
        probe_(wearers.first()),
        ground_(probe_.ground()),
        borders_(ground_.garment) {
    table_.scorecard = wish.scorecard;
    table_.sample_names = wearers.sample_names();
    table_.constraints = wish.constraints;
    if (table_.constraints.regions.empty()) table_.constraints.regions = wish.scorecard.regions;
  }

  void add_given() {
    std::vector<std::string> left_out;
    std::vector<Site> all = sites_with_sensor(ground_, wish_.sites, wish_.scorecard, left_out);
    const std::vector<std::string> why = wearers_.not_covering(all);
    std::vector<Site> covering;
    table_.uncovered = wish_.uncovered;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (why[i].empty())
        covering.push_back(std::move(all[i]));
      else
        table_.uncovered.push_back({all[i].name, all[i].preset, why[i]});
    }
    add(covering);
    if (!left_out.empty())
      table_.notes.push_back("lines round the body, which this sensor is not, are left out: " +
                             join(left_out));
  }

  /// Criteria that the states cannot tell go.
  void keep_known_part() {
    MetricValues known;
    for (const SiteSamples& site : table_.sites) merge(site.samples, known);
    if (wish_.best > 0)
      for (const PatternPlace& place :
           poisson_places(probe_.locator(), kProbeSpacing, wish_.search.seed))
        merge(measured(place), known);
    Scorecard part = known_part(wish_.scorecard, known);
    if (!part.criteria.empty()) table_.scorecard = std::move(part);
  }

  void search() {
    SearchField field;
    field.metrics = [this](const PatternPlace& place) { return measured(place); };
    field.along = [this](const PatternPlace& place) { return probe_.along(place); };
    field.covers = [this](const PatternPlace& place) { return wearers_.cover(place); };
    field.positions = ground_.positions;
    field.regions = ground_.worn.regions;
    field.progress = wish_.progress;
    field.held_out_together = wearers_.sample_wearers();
    if (wearers_.count() == 1) field.held_out_together.clear();  // each donning by itself
    SearchOptions options = wish_.search;
    options.best = wish_.best;
    const SearchResult result =
        search_sites(ground_.garment, field, table_.scorecard, table_.constraints, options);
    if (!table_.constraints.regions.empty())
      table_.notes.push_back("searched over " + names(table_.constraints.regions));
    std::vector<Site> found;
    for (const FoundSite& place : result.sites) {
      Site& site = found.emplace_back();
      site.name = fmt::format("best_{}", found.size());
      site.point = {place.place.triangle, place.place.barycentric};
      site.shape = wish_.scorecard.footprint;
      site.angle = probe_.angle(place.place.triangle);
    }
    const std::size_t given = table_.places.size();
    add(revisit_sites(found, ground_.garment, ground_.positions, ground_.body, ground_.worn, {}));
    for (std::size_t i = 0; i < found.size(); ++i)
      table_.places[given + i].tolerance = result.sites[i].tolerance;
    note_held_out(found, result.sites);
    if (!result.shortfall.empty()) table_.notes.push_back(result.shortfall);
  }

  RankingTable ranked() {
    RankOptions options = wish_.rank;
    options.wearer_of_sample = wearers_.sample_wearers();
    table_.ranking = rank_sites(table_.sites, table_.scorecard, options);
    const std::vector<RankedSite>& ranked = table_.ranking.sites;
    if (wish_.tolerances)
      tbb::parallel_for(std::size_t{0}, ranked.size(), [&](std::size_t i) {
        if (ranked[i].score.rated() && ranked[i].score.robust > 0) add_tolerance(ranked[i].index);
      });
    note_borders();
    return std::move(table_);
  }

 private:
  WearerSamples measured(const PatternPlace& place) const {
    return wearers_.at(place, wish_.scorecard.footprint, probe_.angle(place.triangle));
  }

  void add(const std::vector<Site>& sites) {
    const std::vector<WearerSamples> samples = wearers_.at(sites);
    for (std::size_t i = 0; i < sites.size(); ++i) {
      table_.sites.push_back({sites[i].name, samples[i]});
      table_.places.push_back(described(sites[i]));
    }
  }

  /// What places found are worth in samples that did not find them.
  void note_held_out(const std::vector<Site>& names, const std::vector<FoundSite>& found) {
    const char* what = wearers_.count() > 1 ? "wearers" : "donnings";
    std::vector<std::string> said;
    for (std::size_t i = 0; i < found.size(); ++i) {
      std::vector<double> unseen = found[i].held_out;
      std::erase_if(unseen, [](double score) { return std::isnan(score); });
      if (unseen.empty()) continue;
      const auto [least, most] = std::minmax_element(unseen.begin(), unseen.end());
      said.push_back(fmt::format("{} {:.2f} to {:.2f}", names[i].name, *least, *most));
    }
    if (!said.empty())
      table_.notes.push_back(fmt::format("scores of places found, in {} that did not find them: {}",
                                         what, join(said)));
    else if (!found.empty())
      table_.notes.push_back(
          "places found are rated by the sample that found them: their scores are flattered");
  }

  RankedPlace described(const Site& site) const {
    RankedPlace place;
    place.region = body::name(site.region);
    place.panel = site.panel;
    place.at = site.at;
    place.position = site.position;
    place.angle = site.angle;
    place.anatomy = site.anatomy;
    place.shape = site.shape;
    const garment::Garment& garment = ground_.garment;
    if (site.shape.kind == Kind::girth)
      for (const Footprint::Sample& sample : site.footprint.samples) {
        Vec2 at = Vec2::Zero();
        for (int k = 0; k < 3; ++k)
          at += sample.barycentric[k] * garment.triangle_uv[sample.triangle][k];
        place.line.emplace_back(garment.panel_names[garment.triangle_panel[sample.triangle]], at);
      }
    const int panel = garment.triangle_panel[site.point.triangle];
    place.to_seam = borders_.to_seam(panel, site.at);
    place.to_edge = borders_.to_free_edge(panel, site.at);
    return place;
  }

  void add_tolerance(int index) {
    RankedPlace& place = table_.places[index];
    if (place.tolerance || place.shape.kind == Kind::girth || wearers_.cut_differently()) return;
    const auto at = probe_.find(place.panel, place.at);
    if (!at) return;
    SearchField field;
    field.metrics = [&](const PatternPlace& shifted) {
      return wearers_.at(shifted, place.shape, place.angle);
    };
    field.along = [this](const PatternPlace& shifted) { return probe_.along(shifted); };
    field.regions = ground_.worn.regions;
    // Who sews a sensor on a seam is not held to keeping off seams.
    PlaceTest allowed =
        keeps_clear(ground_.garment, field, table_.constraints, outer_radius(place.shape));
    if (!allowed(*at)) allowed = {};
    place.tolerance = site_tolerance(probe_.locator(), field, table_.scorecard, *at,
                                     wish_.search.tolerance, allowed);
  }

  /// A given site may lie where a search would never put one.
  void note_borders() {
    SearchField field;
    field.regions = ground_.worn.regions;
    std::vector<std::string> near;
    for (std::size_t i = 0; i < table_.places.size(); ++i) {
      const RankedPlace& place = table_.places[i];
      const auto at = probe_.find(place.panel, place.at);
      if (place.shape.kind == Kind::girth || !at) continue;
      if (!keeps_clear(ground_.garment, field, table_.constraints, outer_radius(place.shape))(*at))
        near.push_back(table_.sites[i].name);
    }
    if (!near.empty())
      table_.notes.push_back(
          fmt::format("nearer to a seam ({:g} mm), an edge ({:g} mm) or what is kept free than a "
                      "search allows: "
                      "{}",
                      1e3 * wish_.constraints.seam_clearance,
                      1e3 * wish_.constraints.edge_clearance, join(near)));
  }

  const Wearers& wearers_;
  const RankingWish& wish_;
  const SensorProbe& probe_;
  const RankingGround& ground_;
  PanelBorders borders_;
  RankingTable table_;
};

}  // namespace

RankingTable make_ranking(const std::vector<RankingWearer>& all, const RankingWish& wish) {
  const Wearers wearers(all, wish.scorecard);
  check(wearers, wish);
  Table table(wearers, wish);
  table.add_given();
  if (wish.partial) table.keep_known_part();
  if (wish.best > 0) table.search();
  return table.ranked();
}

RankingTable make_ranking(const RankingGround& ground, const RankingWish& wish) {
  return make_ranking(std::vector<RankingWearer>{{"", ground}}, wish);
}

}  // namespace loosefit::placement
