#include "loosefit/placement/sites.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"
#include "loosefit/placement/shift_along_cloth.h"
#include "loosefit/placement/site_points.h"

namespace loosefit::placement {
namespace {

/// Everything that finding sites on one drape needs, made once.
struct Finder {
  const garment::Garment& garment;
  const std::vector<Vec3>& positions;
  const body::PosedBody& body;
  const maps::WornGarment& worn;
  const std::vector<maps::PerformanceMap>& maps;
  GarmentOverSkin over_skin{garment, positions, body, worn};
  SitePoints points{body};

  geometry::ClosestPoint skin(const SiteSpec& spec) const {
    return spec.landmark.empty() && spec.anatomy ? points.addresses().skin(*spec.anatomy)
                                                 : body.tree().query(points.at(spec.landmark));
  }

  GarmentOverSkin::Over find(const SiteSpec& spec) const {
    if (spec.panel.empty()) return over_skin.over(skin(spec));
    return {pattern_point(garment, spec.panel, spec.at), 0, true, {}};
  }

  /// Long axis of the segment towards the trunk; zero where it is not known.
  Vec3 long_axis(const std::optional<BodyAddress>& anatomy) const {
    if (anatomy) {
      const Vec3 z = points.addresses().axes(anatomy->segment, anatomy->side)->axes.col(2);
      return anatomy->segment == BodySegment::chest ? Vec3(-z) : z;
    }
    const auto trunk = trunk_axes(body);
    return trunk ? Vec3(-trunk->down) : Vec3(Vec3::Zero());
  }

  /// Fills in all that depends on drape and body; name, point, angle, shape (and the footprint of a
  /// girth line that is sewn on already) are given.
  void describe(Site& site) const {
    site.panel = garment.panel_names[garment.triangle_panel[site.point.triangle]];
    site.at = pattern_place(garment, site.point);
    site.position = at(garment, site.point, positions);
    site.not_covering = off_skin(garment, positions, worn, site.point);
    const body::BodyPartner partner = over_skin.under(site.point);
    site.body_point = partner.exact.point;
    site.anatomy = points.addresses().address(partner.exact);
    int nearest = 0;
    site.point.barycentric.maxCoeff(&nearest);
    site.region = worn.regions[garment.triangles[site.point.triangle][nearest]];
    const Vec3 along = long_axis(site.anatomy);
    const auto& [triangle, b] = site.point;
    const bool girth = site.shape.kind == FootprintShape::Kind::girth;
    if (!girth)
      site.footprint = footprint(garment, positions, triangle, b, site.shape, site.angle);
    else if (site.footprint.samples.empty())  // otherwise sewn on where an earlier drape was cut
      site.footprint = girth_footprint(garment, positions, triangle, b,
                                       along.isZero() ? Vec3(Vec3::UnitZ()) : along);
    // A girth line runs all round; the direction is wanted at the site.
    std::vector<int> triangles{triangle};
    if (!girth)
      for (const auto& sample : site.footprint.samples)
        if (sample.triangle != triangles.back()) triangles.push_back(sample.triangle);
    const double angle = angle_in_pattern(garment, positions, triangles, along);
    site.segment_angle = std::isnan(angle) ? 0 : angle;
    site.map_values.clear();
    for (const maps::PerformanceMap& map : maps)
      site.map_values[map.array] = average(site.footprint, garment, map.values);
  }
};

std::string site_key(std::size_t i, const std::string& key) {
  return "site[" + std::to_string(i) + "]." + key;
}

std::string address_key(const SiteSpec& spec) {
  return !spec.panel.empty() ? "at" : !spec.landmark.empty() ? "landmark" : "ratios";
}

/// What stands where the site cannot be: the garment ends before.
InvalidInput not_covered(const Finder& finder, const SiteSpec& spec, std::size_t i,
                         const GarmentPoint& nearest) {
  const std::string where =
      spec.landmark.empty() ? spec.anatomy->str() : '"' + printable(spec.landmark) + '"';
  std::string hint;
  if (nearest.triangle >= 0) {
    Site site;
    site.point = nearest;
    finder.describe(site);
    hint = "the nearest place that it covers is panel " + site.panel + ", at = [" +
           shortest(std::round(site.at.x() * 1e3) / 1e3 + 0.0) + ", " +
           shortest(std::round(site.at.y() * 1e3) / 1e3 + 0.0) + "]";
    if (site.anatomy) hint += ", over " + site.anatomy->str();
  }
  return InvalidInput(InputPlace{"", 0, site_key(i, address_key(spec))},
                      where + ", which the garment does not cover", "skin under the garment", hint);
}

const char* const kOverTheEdge = "its shift leads over the edge of the garment";

InvalidInput over_the_edge(const SiteSpec& spec) {
  return InvalidInput(
      InputPlace{"", 0, "shift"},
      "[" + shortest(spec.shift.x()) + ", " + shortest(spec.shift.y()) + "], over the edge",
      "a shift that ends on the garment", "");
}

}  // namespace

MetricValues Site::metrics() const {
  std::map<std::string, std::vector<double>> known;
  for (const MetricValues& sample : samples)
    for (const auto& [metric, value] : sample)
      if (std::isfinite(value)) known[metric].push_back(value);
  MetricValues medians;
  for (const auto& [metric, values] : known) medians[metric] = median(values);
  return medians;
}

void check_sites(const garment::Garment& garment, const body::Body& body,
                 const std::vector<SiteSpec>& wished) {
  if (wished.empty()) return;
  const SitePoints points(body);
  for (std::size_t i = 0; i < wished.size(); ++i) {
    const SiteSpec& spec = wished[i];
    if (spec.line) continue;
    try {
      if (!spec.panel.empty())
        pattern_point(garment, spec.panel, spec.at);
      else if (spec.landmark.empty() && spec.anatomy)
        points.addresses().skin(*spec.anatomy);
      else
        points.at(spec.landmark);
    } catch (const InvalidInput& error) {
      throw error.at({"", 0, site_key(i, error.place().key)});
    }
  }
}

SiteSpec without_shift(const SiteSpec& site, const garment::Garment& garment) {
  const std::optional<ShiftedPoint> place =
      shifted(garment, pattern_point(garment, site.panel, site.at), site.shift);
  if (!place) throw over_the_edge(site);
  SiteSpec there = site;
  there.panel = garment.panel_names[garment.triangle_panel[place->point.triangle]];
  there.at = pattern_place(garment, place->point);
  there.angle = place->angle(site.angle);
  there.shift.setZero();
  return there;
}

std::vector<Site> find_sites(const garment::Garment& garment, const std::vector<Vec3>& positions,
                             const body::PosedBody& body, const maps::WornGarment& worn,
                             const std::vector<maps::PerformanceMap>& maps,
                             const std::vector<SiteSpec>& wished, bool with_presets,
                             std::vector<UncoveredSite>* uncovered) {
  check_sites(garment, body, wished);
  const Finder finder{garment, positions, body, worn, maps};
  std::vector<Site> sites;
  const auto add = [&](const SiteSpec& spec, std::optional<std::size_t> index) {
    const GarmentOverSkin::Over over = finder.find(spec);
    std::optional<ShiftedPoint> place;
    if (over.covered) place = shifted(garment, over.point, spec.shift);
    if (!place) {
      if (uncovered && !spec.board)
        uncovered->push_back({spec.name, !index, over.covered ? kOverTheEdge : over.why_not});
      else if (index && over.covered)
        throw over_the_edge(spec).at({"", 0, site_key(*index, "shift")});
      else if (index)
        throw not_covered(finder, spec, *index, over.point);
      return;
    }
    Site site;
    site.name = spec.name;
    site.point = place->point;
    site.angle = place->angle(spec.angle);
    site.shape = spec.footprint;
    site.preset = !index;
    finder.describe(site);
    sites.push_back(site);
  };
  for (std::size_t i = 0; i < wished.size(); ++i)
    if (!wished[i].line) add(wished[i], i);
  if (with_presets)
    for (const SiteSpec& spec : finder.points.presets()) add(spec, std::nullopt);
  return sites;
}

std::vector<Site> revisit_sites(const std::vector<Site>& sites, const garment::Garment& garment,
                                const std::vector<Vec3>& positions, const body::PosedBody& body,
                                const maps::WornGarment& worn,
                                const std::vector<maps::PerformanceMap>& maps) {
  if (sites.empty()) return {};
  const Finder finder{garment, positions, body, worn, maps};
  std::vector<Site> revisited = sites;
  for (Site& site : revisited) finder.describe(site);
  return revisited;
}

std::vector<garment::Attachment> site_boards(const std::vector<SiteSpec>& sites) {
  std::vector<garment::Attachment> boards;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const SiteSpec& site = sites[i];
    if (!site.board) continue;
    if (site.footprint.kind != FootprintShape::Kind::disc &&
        site.footprint.kind != FootprintShape::Kind::rectangle)
      throw InvalidInput(InputPlace{"", 0, site_key(i, "footprint")}, "a line under a board",
                         "radius or size", "sew a thread or cable on with [[attachment]]");
    if (site.panel.empty() || !site.shift.isZero())
      throw InvalidInput(InputPlace{"", 0, site_key(i, "board")}, "a board without a place",
                         "panel and at", "");
    garment::Board board;
    static_cast<garment::BoardMake&>(board) = *site.board;
    board.centre = site.at;
    board.angle = site.angle;
    if (!site.board->size.isZero())
      board.size = site.board->size;
    else if (site.footprint.kind == FootprintShape::Kind::disc)
      board.radius = site.footprint.radius;
    else
      board.size = site.footprint.size;
    boards.push_back({site.name, site.panel, board});
  }
  return boards;
}

}  // namespace loosefit::placement
