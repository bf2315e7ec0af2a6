#include "loosefit/placement/sensor_probe.h"

#include <algorithm>

#include "loosefit/placement/derived_metrics.h"

namespace loosefit::placement {

SensorProbe::SensorProbe(const RankingGround& ground, const Scorecard& scorecard)
    : ground_(ground),
      scorecard_(scorecard),
      directions_(ground.garment, ground.positions, ground.body, ground.worn),
      neighbours_(triangle_neighbours(ground.garment)),
      locator_(ground.garment) {}

double SensorProbe::angle(int triangle) const {
  return scorecard_.around ? directions_.around(triangle) : directions_.along(triangle);
}

Vec2 SensorProbe::along(const PatternPlace& place) const {
  return axis_in_pattern(directions_.along(place.triangle));
}

std::optional<PatternPlace> SensorProbe::find(const std::string& panel, const Vec2& at) const {
  const std::vector<std::string>& names = ground_.garment.panel_names;
  const auto named = std::find(names.begin(), names.end(), panel);
  if (named == names.end()) return std::nullopt;
  return locator_.find(static_cast<int>(named - names.begin()), at);
}

bool SensorProbe::covers(const PatternPlace& place) const {
  return off_skin(ground_.garment, ground_.positions, ground_.worn,
                  {place.triangle, place.barycentric})
      .empty();
}

SensorPatch SensorProbe::patch_of(const Site& site) const {
  SensorPatch patch{site.footprint,
                    ground_.garment.triangle_panel[site.point.triangle],
                    axis_in_pattern(site.angle),
                    {}};
  if (site.shape.kind == FootprintShape::Kind::girth)
    for (const Footprint::Sample& sample : site.footprint.samples)
      patch.sample_directions.push_back(axis_in_pattern(directions_.around(sample.triangle)));
  return patch;
}

WearerSamples SensorProbe::at(const Site& site) const {
  return measured(patch_of(site), site.shape);
}

std::vector<MetricValues> SensorProbe::in_states(const Site& site) const {
  const std::vector<SiteState> states = ground_.meter.measure(patch_of(site));
  std::vector<MetricValues> all;
  for (std::size_t k = 0; k < states.size(); ++k)
    all.push_back(with_derived(site_metrics_of_state(states, k, ground_.meter.reference_posture()),
                               scorecard_.parameters, site.shape));
  return all;
}

WearerSamples SensorProbe::at(const PatternPlace& place, const FootprintShape& shape,
                              double turn) const {
  SensorPatch patch;
  patch.footprint = footprint(ground_.garment, ground_.positions, place.triangle, place.barycentric,
                              shape, turn, &neighbours_);
  patch.panel = place.panel;
  patch.direction = axis_in_pattern(turn);
  return measured(patch, shape);
}

WearerSamples SensorProbe::measured(const SensorPatch& patch, const FootprintShape& shape) const {
  WearerSamples samples =
      site_metrics_by_donning(ground_.meter.measure(patch), ground_.meter.reference_posture());
  for (MetricValues& metrics : samples)
    metrics = with_derived(metrics, scorecard_.parameters, shape);
  return samples;
}

}  // namespace loosefit::placement
