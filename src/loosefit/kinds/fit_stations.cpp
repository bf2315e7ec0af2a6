#include "loosefit/kinds/fit_stations.h"

#include <algorithm>
#include <cmath>

#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {

std::optional<double> mobility_at(const std::vector<AskedMobility>& asked, double along) {
  if (asked.empty()) return std::nullopt;
  if (along <= asked.front().along) return asked.front().mobility;
  for (std::size_t i = 1; i < asked.size(); ++i)
    if (const AskedMobility& a = asked[i - 1], &b = asked[i]; along <= b.along)
      return a.mobility + (along - a.along) / (b.along - a.along) * (b.mobility - a.mobility);
  return asked.back().mobility;
}

double width_at(const pattern::Panel& panel, double y) {
  std::vector<double> crossings;
  const auto cross = [&](const std::vector<Vec2>& line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec2 &a = line[i], &b = line[(i + 1) % line.size()];
      if ((a.y() < y) != (b.y() < y))
        crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  };
  cross(pattern::outline_polygon(panel));
  for (const pattern::PanelHole& hole : panel.holes) cross(hole.points);
  std::sort(crossings.begin(), crossings.end());
  double width = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    width += crossings[i + 1] - crossings[i];
  return width;
}

std::vector<FitStation> stations_along(const std::string& limb,
                                       const std::vector<const pattern::Panel*>& panels,
                                       double first, double last,
                                       const std::function<double(double)>& y_of,
                                       const std::vector<AskedMobility>& asked) {
  std::vector<FitStation> stations;
  const int from = static_cast<int>(std::ceil(first / kStationStep)),
            to = static_cast<int>(std::floor(last / kStationStep));
  for (int k = from; k <= to; ++k) {
    const double along = k * kStationStep;
    FitStation station{limb, along, 0, mobility_at(asked, along), {}};
    bool whole = !panels.empty();
    for (const pattern::Panel* panel : panels) {
      const double width = panel ? width_at(*panel, y_of(along)) : 0;
      whole = whole && width > 0;
      station.garment += width;
      if (panel) station.lines.push_back({panel->part, y_of(along)});
    }
    if (whole) stations.push_back(station);
  }
  return stations;
}

}  // namespace loosefit::kinds
