#include <algorithm>

#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

/// Below this coherence the direction of the folds says nothing worth printing.
constexpr double kPlainCoherence = 0.2;

std::string row_name(body::Region region) {
  std::string text = body::name(region);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

}  // namespace

std::string wrinkle_section(const pipeline::CaseResult& result) {
  if (result.studied().maps.wrinkles.empty()) return {};
  Table table({"Region", "slope [deg]", "direction [deg]", "coherence"});
  table.make_sortable("wrinkles");
  table.define(1, "slope");
  table.define(3, "coherence");
  for (const auto& [region, w] : result.studied().maps.wrinkles)
    table.add({row_name(region), fixed(degrees(w.slope), 1),
               w.coherence < kPlainCoherence ? "–" : fixed(degrees(w.angle), 0),
               fixed(w.coherence, 2)});
  return element("h3", "Wrinkles by region of the body") + table.html() +
         element(
             "p",
             "Slope: rms tilt of the cloth out of its shape smoothed over " +
                 number(1000 * maps::kWrinkleWidth, 2) +
                 " mm. Direction: of the folds' lines against the long axis of the body "
                 "segment, on the trunk 0 is upright and 90 level, positive counter-clockwise "
                 "seen from outside. Coherence: 1 when all folds run alike, 0 when no direction "
                 "is preferred.");
}

}  // namespace loosefit::report
