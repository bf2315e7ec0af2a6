#include "loosefit/placement/ranking_wearers.h"

#include <fmt/format.h>

#include <algorithm>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::placement {
namespace {

using Kind = FootprintShape::Kind;

bool is_line(const FootprintShape& shape) {
  return shape.kind == Kind::line || shape.kind == Kind::girth;
}

bool states_footprint(const Site& site) {
  const FootprintShape plain;
  return !site.preset && !(site.shape.kind == plain.kind && site.shape.radius == plain.radius);
}

std::vector<Site> described(const RankingGround& ground, const std::vector<Site>& sites) {
  return revisit_sites(sites, ground.garment, ground.positions, ground.body, ground.worn, {});
}

PatternPlace some_place(const garment::Garment& garment) {
  PatternPlace place;
  place.panel = garment.triangle_panel.at(0);
  place.triangle = 0;
  place.barycentric = Vec3::Constant(1.0 / 3);
  for (const Vec2& corner : garment.triangle_uv[0]) place.at += corner / 3;
  return place;
}

void append(WearerSamples more, WearerSamples& all) {
  for (auto& metrics : more) all.push_back(std::move(metrics));
}

}  // namespace

void give_sensor(const RankingGround& ground, const Scorecard& scorecard,
                 std::vector<Site>& sites) {
  const SegmentDirection directions(ground.garment, ground.positions, ground.body, ground.worn);
  for (Site& site : sites) {
    if (site.shape.kind == Kind::girth || states_footprint(site)) continue;
    site.shape = scorecard.footprint;
    site.footprint = {};
    if (site.preset || site.angle == 0)
      site.angle = scorecard.around ? directions.around(site.point.triangle)
                                    : directions.along(site.point.triangle);
  }
}

std::vector<Site> sites_with_sensor(const RankingGround& ground, const std::vector<Site>& sites,
                                    const Scorecard& scorecard,
                                    std::vector<std::string>& left_out) {
  std::vector<Site> kept;
  for (const Site& site : sites) {
    if (site.shape.kind == Kind::girth && !is_line(scorecard.footprint))
      left_out.push_back(site.name);
    else
      kept.push_back(site);
  }
  give_sensor(ground, scorecard, kept);
  return described(ground, kept);
}

Wearers::Wearers(const std::vector<RankingWearer>& wearers, const Scorecard& scorecard)
    : wearers_(wearers) {
  if (wearers.empty()) throw InvalidInput("a ranking needs at least one wearer");
  std::vector<std::string> left_out;  // named by the first wearer
  for (const RankingWearer& wearer : wearers) {
    const SensorProbe& probe = probes_.emplace_back(wearer.ground, scorecard);
    donnings_.push_back(probe.at(some_place(wearer.ground.garment), {}, 0).size());
    sites_.push_back(sites_with_sensor(wearer.ground, wearer.sites, scorecard, left_out));
  }
}

bool Wearers::cut_differently() const {
  return std::any_of(sites_.begin() + 1, sites_.end(),
                     [](const std::vector<Site>& own) { return !own.empty(); });
}

std::vector<std::string> Wearers::sample_names() const {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < wearers_.size(); ++k)
    for (std::size_t d = 0; d < donnings_[k]; ++d)
      names.push_back(donnings_[k] == 1 ? wearers_[k].name
                                        : fmt::format("{} donning {}", wearers_[k].name, d + 1));
  return names;
}

std::vector<int> Wearers::sample_wearers() const {
  std::vector<int> wearers;
  for (std::size_t k = 0; k < wearers_.size(); ++k)
    wearers.insert(wearers.end(), donnings_[k], static_cast<int>(k));
  return wearers;
}

std::vector<Site> Wearers::on(std::size_t wearer, const std::vector<Site>& sites) const {
  const std::vector<Site>& own = sites_[wearer];
  const RankingGround& ground = wearers_[wearer].ground;
  // The line of a girth is that of the first drape; another mesh has other triangles.
  const bool same_mesh = ground.garment.triangles == wearers_[0].ground.garment.triangles;
  std::vector<Site> here;
  for (const Site& site : sites) {
    if (!own.empty()) {
      const auto named =
          std::find_if(own.begin(), own.end(), [&](const Site& s) { return s.name == site.name; });
      if (named == own.end())
        throw InvalidInput(
            fmt::format("site {}: found no such place in {}", printable(site.name),
                        printable(wearers_[wearer].name)),
            "a site that some of the garments do not reach cannot be ranked over all of them");
      here.push_back(*named);
      continue;
    }
    const auto place = probes_[wearer].find(site.panel, site.at);
    if (!place)
      throw InvalidInput(fmt::format("site {}: found no cloth at panel {}, [{:.4f}, {:.4f}] in {}",
                                     printable(site.name), printable(site.panel), site.at.x(),
                                     site.at.y(), printable(wearers_[wearer].name)),
                         "runs over which sites are ranked need a garment of the same cut");
    here.push_back(site);
    here.back().point = {place->triangle, place->barycentric};
    if (!same_mesh) here.back().footprint = {};
  }
  return own.empty() ? described(ground, here) : here;
}

std::vector<WearerSamples> Wearers::at(const std::vector<Site>& sites) const {
  std::vector<WearerSamples> all(sites.size());
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    const std::vector<Site> here = k == 0 ? sites : on(k, sites);
    for (std::size_t i = 0; i < sites.size(); ++i) append(probes_[k].at(here[i]), all[i]);
  }
  return all;
}

std::vector<std::string> Wearers::not_covering(const std::vector<Site>& sites) const {
  std::vector<std::string> why(sites.size());
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    const std::vector<Site> here = k == 0 ? sites : on(k, sites);
    for (std::size_t i = 0; i < sites.size(); ++i)
      if (why[i].empty() && !here[i].not_covering.empty())
        why[i] = here[i].not_covering +
                 (probes_.size() > 1 ? " (" + printable(wearers_[k].name) + ")" : "");
  }
  return why;
}

bool Wearers::cover(const PatternPlace& place) const {
  const std::string& panel = first().ground().garment.panel_names[place.panel];
  for (const SensorProbe& probe : probes_) {
    const auto there = &probe == &first() ? place : probe.find(panel, place.at);
    if (there && !probe.covers(*there)) return false;
  }
  return true;
}

WearerSamples Wearers::at(const PatternPlace& place, const FootprintShape& shape,
                          double turn) const {
  WearerSamples all = first().at(place, shape, turn);
  const std::string& panel = first().ground().garment.panel_names[place.panel];
  for (std::size_t k = 1; k < probes_.size(); ++k) {
    const auto there = probes_[k].find(panel, place.at);
    append(there ? probes_[k].at(*there, shape, turn) : WearerSamples(donnings_[k]), all);
  }
  return all;
}

}  // namespace loosefit::placement
