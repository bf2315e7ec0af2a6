#include "loosefit/placement/keep_out.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::placement {
namespace {

InvalidInput refused(const std::string& text, const std::string& hint) {
  return InvalidInput({"", 0, "keep-out"}, "\"" + printable(text) + "\"",
                      "PANEL:u,v,u,v (corners), PANEL:u,v,radius in metres, or a body region",
                      hint);
}

/// Numbers with commas between them; empty when there is anything else.
std::vector<double> numbers(const std::string& text) {
  std::vector<double> values;
  const char *at = text.data(), *end = at + text.size();
  while (true) {
    double value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value) || std::abs(value) > 10) return {};
    values.push_back(value);
    if (stop == end) return values;
    if (*stop != ',') return {};
    at = stop + 1;
  }
}

}  // namespace

double KeepOutZone::distance(const Vec2& at) const {
  if (shape == Shape::disc) return std::max(0.0, (at - centre).norm() - radius);
  const Vec2 low = lower.cwiseMin(upper), high = lower.cwiseMax(upper);
  return (at - at.cwiseMax(low).cwiseMin(high)).norm();
}

void add_keep_out(const std::string& text, KeepOut& keep_out) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) {
    const auto region = body::find_region(text);
    if (!region) throw refused(text, did_you_mean(text, body::region_names()));
    keep_out.regions.push_back(*region);
    return;
  }
  KeepOutZone zone;
  zone.name = text;
  zone.panel = text.substr(0, colon);
  const std::vector<double> at = numbers(text.substr(colon + 1));
  if (zone.panel.empty() || (at.size() != 3 && at.size() != 4))
    throw refused(text, "for example front:0.02,0.10,0.10,0.22");
  if (at.size() == 3) {
    if (!(at[2] > 0)) throw refused(text, "the radius must be above 0");
    zone.shape = KeepOutZone::Shape::disc;
    zone.centre = {at[0], at[1]};
    zone.radius = at[2];
  } else {
    zone.lower = {at[0], at[1]};
    zone.upper = {at[2], at[3]};
  }
  keep_out.zones.push_back(zone);
}

void check_keep_out(const KeepOut& keep_out, const std::vector<std::string>& panels) {
  for (const KeepOutZone& zone : keep_out.zones)
    if (std::find(panels.begin(), panels.end(), zone.panel) == panels.end())
      throw InvalidInput({"", 0, "keep-out"},
                         "\"" + printable(zone.panel) + "\" in " + printable(zone.name),
                         "a panel of the pattern", did_you_mean(zone.panel, panels));
}

}  // namespace loosefit::placement
