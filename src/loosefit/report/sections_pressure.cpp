#include <algorithm>

#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

std::string kilopascal(double pascal) { return fixed(pascal / 1000, 3); }

std::vector<std::string> row(std::string place, const maps::PressureAgreement& a) {
  std::replace(place.begin(), place.end(), '_', ' ');
  return {std::move(place),
          fixed(100 * a.contact_area, 2),
          kilopascal(a.contact_mean),
          kilopascal(a.membrane_mean),
          fixed(a.contact_force, 2),
          fixed(a.membrane_force, 2),
          kilopascal(a.rms_difference),
          number(a.correlation, 2)};
}

}  // namespace

std::string pressure_section(const pipeline::CaseResult& result) {
  const pipeline::CasePressure& pressure = result.studied().maps.pressure;
  if (pressure.field.empty()) return {};
  Table table({"Where", "contact [dm²]", "mean, by force [kPa]", "by tension [kPa]",
               "normal force [N]", "by tension [N]", "rms difference [kPa]", "correlation"});
  table.make_sortable("pressure");
  for (std::size_t column : {2, 4}) table.define(column, "pressure-force");
  for (std::size_t column : {3, 5}) table.define(column, "pressure-tension");
  table.add(row("whole garment", pressure.overall));
  for (const auto& [region, agreement] : pressure.regional)
    table.add(row(body::name(region), agreement));
  const std::vector<double> shares = maps::pressure_class_shares(pressure.field);
  Table classes({"Of the worn cloth", "no contact", "below 0.3 kPa", "0.3 to 0.7", "0.7 to 2.7",
                 "2.7 to 4", "above 4"});
  std::vector<std::string> percent = {"share"};
  for (double share : shares) percent.push_back(fixed(100 * share, 1) + " %");
  classes.add(percent);
  return element("h3", "Contact pressure by two estimates") + table.html() +
         element(
             "p",
             "By force: what the body pushes on the cloth, per worn area. By tension: membrane "
             "tension times the curvature of the body under the cloth, plus the cloth's weight "
             "across it. Both over the cloth that touches. They share nothing but the shape, so "
             "where they part, trust neither closer than their difference.") +
         classes.html() +
         element("p",
                 "An electrode is unreliable below 0.3 kPa, marginal to 0.7, good to 2.7; above "
                 "4 kPa most wearers are uncomfortable.");
}

}  // namespace loosefit::report
