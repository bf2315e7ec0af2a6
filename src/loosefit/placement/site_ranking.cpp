#include "loosefit/placement/site_ranking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/placement/footprint_unfold.h"

namespace loosefit {
namespace {

using Kind = FootprintShape::Kind;

/// Apart from this, the candidates' spacing, places are measured to see what the states can tell
/// [m].
constexpr double kProbeSpacing = 0.10;

bool is_line(const FootprintShape& shape) {
  return shape.kind == Kind::line || shape.kind == Kind::girth;
}

bool states_footprint(const Site& site) {
  const FootprintShape plain;
  return !site.preset && !(site.shape.kind == plain.kind && site.shape.radius == plain.radius);
}

/// Measures the scorecard's sensor wherever it is held.
class SensorProbe {
 public:
  SensorProbe(const RankingGround& ground, const Scorecard& scorecard)
      : ground_(ground),
        scorecard_(scorecard),
        directions_(ground.garment, ground.positions, ground.body, ground.worn) {}

  double angle(int triangle) const {
    return scorecard_.around ? directions_.around(triangle) : directions_.along(triangle);
  }
  Vec2 along(const PatternPlace& place) const {
    return axis_in_pattern(directions_.along(place.triangle));
  }

  std::vector<MetricValues> at(const Site& site) const {
    SensorPatch patch{site.footprint,
                      ground_.garment.triangle_panel[site.point.triangle],
                      axis_in_pattern(site.angle),
                      {}};
    if (site.shape.kind == Kind::girth)
      for (const Footprint::Sample& sample : site.footprint.samples)
        patch.sample_directions.push_back(axis_in_pattern(directions_.around(sample.triangle)));
    return measured(patch);
  }
  /// The scorecard's sensor at a place.
  std::vector<MetricValues> at(const PatternPlace& place) const {
    const double turn = angle(place.triangle);
    SensorPatch patch;
    patch.footprint = footprint(ground_.garment, ground_.positions, place.triangle,
                                place.barycentric, scorecard_.footprint, turn, &neighbours_);
    patch.panel = place.panel;
    patch.direction = axis_in_pattern(turn);
    return measured(patch);
  }

 private:
  std::vector<MetricValues> measured(const SensorPatch& patch) const {
    return site_metrics_by_donning(ground_.meter.measure(patch), ground_.meter.reference_posture());
  }
  const RankingGround& ground_;
  const Scorecard& scorecard_;
  SegmentDirection directions_;
  TriangleNeighbours neighbours_ = triangle_neighbours(ground_.garment);
};

void merge(const std::vector<MetricValues>& samples, MetricValues& known) {
  for (const MetricValues& metrics : samples)
    for (const auto& [name, value] : metrics)
      if (std::isfinite(value)) known[name] = value;
}

/// Metrics that some place has.
MetricValues known_anywhere(const RankingGround& ground, const SensorProbe& probe,
                            const RankingWish& wish, const std::vector<SiteSamples>& samples) {
  MetricValues known;
  for (const SiteSamples& site : samples) merge(site.samples, known);
  if (wish.best > 0) {
    const PatternLocator locator(ground.garment);
    for (const PatternPlace& place : poisson_places(locator, kProbeSpacing, wish.search.seed))
      merge(probe.at(place), known);
  }
  return known;
}

std::string names(const std::vector<Region>& regions) {
  std::vector<std::string> words;
  for (Region region : regions) words.push_back(name(region));
  return join(words);
}

RankedPlace described(const Site& site) {
  return {name(site.region),
          site.panel,
          site.at,
          site.position,
          site.angle,
          site.anatomy ? site.anatomy->str() : "",
          {}};
}

Site found_site(const RankingGround& ground, const FoundSite& found, const SensorProbe& probe,
                const Scorecard& scorecard, int number) {
  Site site;
  site.name = fmt::format("best_{}", number);
  site.point = {found.place.triangle, found.place.barycentric};
  site.shape = scorecard.footprint;
  site.angle = probe.angle(found.place.triangle);
  site = revisit_sites({site}, ground.garment, ground.positions, ground.body, ground.worn, {})[0];
  return site;
}

}  // namespace

std::vector<Site> sites_with_sensor(const RankingGround& ground, const std::vector<Site>& sites,
                                    const Scorecard& scorecard,
                                    std::vector<std::string>& left_out) {
  const SegmentDirection directions(ground.garment, ground.positions, ground.body, ground.worn);
  std::vector<Site> kept;
  for (const Site& given : sites) {
    Site site = given;
    if (site.shape.kind == Kind::girth && !is_line(scorecard.footprint)) {
      left_out.push_back(site.name);
      continue;
    }
    if (site.shape.kind != Kind::girth && !states_footprint(site)) {
      site.shape = scorecard.footprint;
      site.footprint = {};
      if (site.preset || site.angle == 0)
        site.angle = scorecard.around ? directions.around(site.point.triangle)
                                      : directions.along(site.point.triangle);
    }
    kept.push_back(site);
  }
  return revisit_sites(kept, ground.garment, ground.positions, ground.body, ground.worn, {});
}

RankingTable make_ranking(const RankingGround& ground, const RankingWish& wish) {
  if (wish.best > 0 && wish.scorecard.footprint.kind == Kind::girth)
    throw InvalidInput({"", 0, "footprint.shape"}, "\"girth\" in a scorecard to search with",
                       "disc, rectangle or line",
                       "give lines round the body as sites, or search with a line");
  RankingTable table;
  table.scorecard = wish.scorecard;
  const SensorProbe probe(ground, wish.scorecard);
  std::vector<std::string> left_out;
  for (const Site& site : sites_with_sensor(ground, wish.sites, wish.scorecard, left_out)) {
    table.sites.push_back({site.name, probe.at(site)});
    table.places.push_back(described(site));
  }
  if (!left_out.empty())
    table.notes.push_back("lines round the body, which this sensor is not, are left out: " +
                          join(left_out));
  if (wish.partial) {
    Scorecard part = known_part(wish.scorecard, known_anywhere(ground, probe, wish, table.sites));
    if (!part.criteria.empty()) table.scorecard = std::move(part);
  }
  if (wish.best > 0) {
    SearchField field;
    field.metrics = [&](const PatternPlace& place) { return probe.at(place); };
    field.along = [&](const PatternPlace& place) { return probe.along(place); };
    field.positions = ground.positions;
    field.regions = ground.worn.regions;
    field.progress = wish.progress;
    SearchOptions options = wish.search;
    options.best = wish.best;
    SearchConstraints constraints = wish.constraints;
    if (constraints.regions.empty()) constraints.regions = wish.scorecard.regions;
    const SearchResult result =
        search_sites(ground.garment, field, table.scorecard, constraints, options);
    if (!constraints.regions.empty())
      table.notes.push_back("searched over " + names(constraints.regions));
    for (const FoundSite& found : result.sites) {
      const int number = static_cast<int>(&found - result.sites.data()) + 1;
      const Site site = found_site(ground, found, probe, wish.scorecard, number);
      table.sites.push_back({site.name, probe.at(site)});
      table.places.push_back(described(site));
      table.places.back().tolerance = found.tolerance;
    }
    if (!result.shortfall.empty()) table.notes.push_back(result.shortfall);
  }
  table.ranking = rank_sites(table.sites, table.scorecard, wish.rank);
  return table;
}

}  // namespace loosefit
