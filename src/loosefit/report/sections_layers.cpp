#include <fmt/format.h>

#include <cmath>

#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

std::vector<std::string> row(const std::string& place, const pipeline::CaseGarment& garment,
                             const fabric::Material& material) {
  double force = 0, distance = std::nan("");
  for (double f : garment.drape.body_normal_force) force += f;
  for (const pipeline::CaseMap& map : garment.maps.maps)
    if (map.map.array == "distance_mm") distance = map.overall.median;
  const auto& fit = garment.pattern.fit;
  const auto chest = fit.find("chest");
  return {place,
          garment.pattern.pattern.name,
          material.name,
          chest == fit.end() ? "–" : signed_number(chest->second, 2),
          number(1000 * garment.mesh().mass),
          fixed(distance, 1),
          fixed(force, 2),
          fixed(garment.maps.pressure.overall.contact_mean / 1000, 3)};
}

}  // namespace

std::string layer_section(const pipeline::CaseResult& result) {
  if (result.worn_under().empty()) return {};
  Table table({"Garment", "pattern", "cloth", "fit at the chest", "mass [g]",
               "median distance from the skin [mm]", "normal force on the skin [N]",
               "mean pressure where it touches the skin [kPa]"});
  for (std::size_t g = 0; g < result.garments.size(); ++g)
    table.add(
        row(g < result.worn_under().size() ? fmt::format("under {}", g + 1) : "studied, outermost",
            result.garments[g], result.scenario.garments[g].material.material));
  return element("h2", "Worn over each other") + table.html() +
         element("p",
                 "From the skin outwards. All garments settled together, with friction between "
                 "them, and the certificate is that of all: crossings with itself count those of "
                 "one garment with another too. What an outer garment presses on an inner one the "
                 "skin feels through the inner one, so it counts there. All other numbers and "
                 "pictures of this page are those of the studied garment; distances are to the "
                 "skin, whatever lies between.");
}

}  // namespace loosefit::report
