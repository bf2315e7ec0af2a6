#include "loosefit/placement/site_search.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <tuple>

#include "loosefit/base/error.h"
#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"

namespace loosefit::placement {
namespace {

void check(const garment::Garment& garment, const SearchField& field,
           const SearchConstraints& constraints, const SearchOptions& options) {
  if (options.best < 1 || options.best > kMostPlaces)
    throw InvalidInput(
        fmt::format("number of sites: found {}, expected 1 to {}", options.best, kMostPlaces));
  for (double length :
       {constraints.spacing, constraints.seam_clearance, constraints.edge_clearance})
    if (!(length >= 0 && length <= kLargestClearance))
      throw InvalidInput("spacing or clearance: found " + shortest(length) +
                         ", expected metres from 0 to " + shortest(kLargestClearance));
  const auto vertices = static_cast<std::size_t>(garment.vertex_count);
  const bool need_regions = !constraints.keep_out.regions.empty() || !constraints.regions.empty();
  if (field.positions.size() != vertices || (need_regions && field.regions.size() != vertices))
    throw InvalidInput(fmt::format(
        "search: found {} positions and {} regions, expected one per vertex of the garment ({})",
        field.positions.size(), field.regions.size(), vertices));
  check_keep_out(constraints.keep_out, garment.panel_names);
}

/// Whether a sensor may sit at a place; counts the first reason against it.
class Admission {
 public:
  Admission(const garment::Garment& garment, const SearchField& field,
            const SearchConstraints& constraints, double radius)
      : garment_(garment),
        field_(field),
        constraints_(constraints),
        radius_(radius),
        borders_(garment) {}

  bool admits(const PatternPlace& place, SearchResult& counts) const {
    if (field_.covers && !field_.covers(place)) return ++counts.uncovering, false;
    if (!constraints_.regions.empty() && !over(place, constraints_.regions))
      return ++counts.elsewhere, false;
    return clear(place, counts);
  }
  /// The same but for the regions that are searched.
  bool clear(const PatternPlace& place, SearchResult& counts) const {
    if (borders_.to_seam(place.panel, place.at) < constraints_.seam_clearance + radius_)
      return ++counts.near_seam, false;
    if (borders_.to_free_edge(place.panel, place.at) < constraints_.edge_clearance + radius_)
      return ++counts.near_edge, false;
    for (const KeepOutZone& zone : constraints_.keep_out.zones)
      if (zone.panel == garment_.panel_names[place.panel] && zone.distance(place.at) < radius_)
        return ++counts.kept_out, false;
    if (!constraints_.keep_out.regions.empty() && over(place, constraints_.keep_out.regions))
      return ++counts.kept_out, false;
    return true;
  }

 private:
  /// Whether the place lies over one of these parts of the body.
  bool over(const PatternPlace& place, const std::vector<body::Region>& regions) const {
    int nearest = 0;
    place.barycentric.maxCoeff(&nearest);
    const body::Region here = field_.regions[garment_.triangles[place.triangle][nearest]];
    return std::find(regions.begin(), regions.end(), here) != regions.end();
  }

  const garment::Garment& garment_;
  const SearchField& field_;
  const SearchConstraints& constraints_;
  double radius_;
  PanelBorders borders_;
};

/// Scores of places, block by block so that progress can be told and the work be stopped.
std::vector<SiteScore> scored(const std::vector<PatternPlace>& places, const SearchField& field,
                              const Scorecard& scorecard) {
  constexpr std::size_t kBlock = 128;
  std::vector<SiteScore> scores(places.size());
  for (std::size_t first = 0; first < places.size(); first += kBlock) {
    const std::size_t last = std::min(first + kBlock, places.size());
    tbb::parallel_for(first, last, [&](std::size_t i) {
      scores[i] = score_samples(field.metrics(places[i]), scorecard);
    });
    if (field.progress) field.progress(static_cast<double>(last) / places.size());
  }
  return scores;
}

/// Best first.
void order(std::vector<FoundSite>& sites) {
  std::stable_sort(sites.begin(), sites.end(), [](const FoundSite& a, const FoundSite& b) {
    return std::tuple(a.score.robust, a.score.median, a.score.margin) >
           std::tuple(b.score.robust, b.score.median, b.score.margin);
  });
}

/// The first sites that keep their distance to those before, as numbers.
std::vector<std::size_t> spaced(const std::vector<FoundSite>& ordered, double spacing, int most) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < ordered.size() && static_cast<int>(chosen.size()) < most; ++i)
    if (std::none_of(chosen.begin(), chosen.end(), [&](std::size_t j) {
          return (ordered[j].position - ordered[i].position).norm() < spacing;
        }))
      chosen.push_back(i);
  return chosen;
}

/// FoundSite::held_out of the first `most` places of searches among these sites.
std::vector<std::vector<double>> held_out(const std::vector<FoundSite>& rated, double spacing,
                                          int most, std::vector<int> together) {
  const std::size_t samples = rated.empty() ? 0 : rated.front().score.samples.size();
  if (together.empty()) {
    together.resize(samples);
    std::iota(together.begin(), together.end(), 0);
  }
  const std::set<int> folds(together.begin(), together.end());
  if (folds.size() < 2) return std::vector<std::vector<double>>(most);
  std::vector<std::vector<double>> scores(
      most, std::vector<double>(samples, std::numeric_limits<double>::quiet_NaN()));
  for (const int fold : folds) {
    std::vector<FoundSite> others = rated;
    for (std::size_t i = 0; i < rated.size(); ++i) {
      std::vector<double> kept;
      for (std::size_t k = 0; k < samples; ++k)
        if (together[k] != fold) kept.push_back(rated[i].score.samples[k]);
      others[i].score.robust = quantile(kept, kRobustShare);
      others[i].score.median = median(kept);
      others[i].score.margin = 0;  // may be that of a sample that is held out
    }
    std::erase_if(others, [](const FoundSite& site) { return site.score.robust <= 0; });
    order(others);
    const std::vector<std::size_t> chosen = spaced(others, spacing, most);
    for (std::size_t j = 0; j < chosen.size(); ++j)
      for (std::size_t k = 0; k < samples; ++k)
        if (together[k] == fold) scores[j][k] = others[chosen[j]].score.samples[k];
  }
  return scores;
}

std::string shortfall(const SearchResult& result, int wanted) {
  const int found = static_cast<int>(result.sites.size());
  if (found >= wanted) return {};
  const int ruled_out =
      result.uncovering + result.elsewhere + result.near_seam + result.near_edge + result.kept_out;
  const int left = result.candidates - ruled_out - result.not_rated - result.failing;
  const std::string uncovering =
      result.uncovering ? fmt::format(" {} cover no skin,", result.uncovering) : "";
  return fmt::format(
      "{} of {} sites: of {} places looked at,{} {} lie over other regions, {} too near to seams, "
      "{} "
      "to edges, {} where nothing may be, {} cannot be rated, {} fail; the spacing leaves {} of "
      "the "
      "other {}",
      found, wanted, result.candidates, uncovering, result.elsewhere, result.near_seam,
      result.near_edge, result.kept_out, result.not_rated, result.failing, found, left);
}

}  // namespace

SearchResult search_sites(const garment::Garment& garment, const SearchField& field,
                          const Scorecard& scorecard, const SearchConstraints& constraints,
                          const SearchOptions& options) {
  check(garment, field, constraints, options);
  const PatternLocator locator(garment);
  const Admission admission(garment, field, constraints, outer_radius(scorecard.footprint));
  SearchResult result;
  std::vector<PatternPlace> admitted;
  for (const PatternPlace& place :
       poisson_places(locator, options.candidate_spacing, options.seed)) {
    ++result.candidates;
    if (admission.admits(place, result)) admitted.push_back(place);
  }
  std::vector<FoundSite> rated;
  const std::vector<SiteScore> scores = scored(admitted, field, scorecard);
  for (std::size_t i = 0; i < admitted.size(); ++i) {
    if (!scores[i].rated())
      ++result.not_rated;
    else
      rated.push_back(
          {admitted[i], at_place(garment, admitted[i], field.positions), scores[i], {}});
  }
  const std::vector<std::vector<double>> unseen =
      held_out(rated, constraints.spacing, options.best, field.held_out_together);
  result.failing = static_cast<int>(
      std::erase_if(rated, [](const FoundSite& site) { return site.score.robust <= 0; }));
  order(rated);
  for (const std::size_t i : spaced(rated, constraints.spacing, options.best)) {
    FoundSite& site = result.sites.emplace_back(std::move(rated[i]));
    site.held_out = unseen[result.sites.size() - 1];
  }
  const PlaceTest allowed =
      keeps_clear(garment, field, constraints, outer_radius(scorecard.footprint));
  for (FoundSite& site : result.sites)
    site.tolerance =
        site_tolerance(locator, field, scorecard, site.place, options.tolerance, allowed);
  result.shortfall = shortfall(result, options.best);
  return result;
}

PlaceTest keeps_clear(const garment::Garment& garment, const SearchField& field,
                      const SearchConstraints& constraints, double radius) {
  const auto admission = std::make_shared<Admission>(garment, field, constraints, radius);
  return [admission](const PatternPlace& place) {
    SearchResult unused;
    return admission->clear(place, unused);
  };
}

Tolerance site_tolerance(const PatternLocator& locator, const SearchField& field,
                         const Scorecard& scorecard, const PatternPlace& place,
                         const ToleranceOptions& options, const PlaceTest& allowed) {
  const FlatScore flat = [&](const Vec2& at) -> std::optional<double> {
    const auto shifted = locator.find(place.panel, at);
    if (!shifted || (allowed && !allowed(*shifted))) return std::nullopt;
    const SiteScore score = score_samples(field.metrics(*shifted), scorecard);
    return score.rated() ? score.robust : 0;
  };
  return tolerance(flat, place.at, field.along ? field.along(place) : Vec2(Vec2::UnitY()), options);
}

}  // namespace loosefit::placement
