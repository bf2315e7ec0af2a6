#include <algorithm>

#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

double seconds_of(const pipeline::CaseResult& result) {
  double sum = 0;
  for (const StageClock::Entry& entry : result.seconds)
    if (entry.stage == "dress" || entry.stage == "settle") sum += entry.seconds;
  return sum;
}

std::vector<std::string> row(const std::string& name, const pipeline::StateId& id,
                             const drape::Certificate& c, double seconds) {
  return {name, std::to_string(id.donning + 1),
          c.holds()     ? "settled"
          : c.settled() ? "not worn"
                        : "not settled",
          number(c.residual, 2), fixed(seconds, 1)};
}

}  // namespace

std::string wear_section(const pipeline::CaseResult& result) {
  const pipeline::CaseWear& wear = result.wear;
  if (wear.states.empty()) return {};
  Table table({"posture", "donning", "drape", "residual", "seconds, side by side", "slip median mm",
               "slip 95 % mm", "slip greatest mm"});
  table.make_sortable("postures");
  table.define(3, "residual");
  for (std::size_t column : {5, 6, 7}) table.define(column, "slip");
  auto first =
      row(wear.postures.front(), pipeline::StateId{}, result.certificate(), seconds_of(result));
  first.insert(first.end(), 3, "–");
  table.add(first);
  for (const pipeline::CaseState& s : wear.states) {
    auto cells = row(s.name, s.id, s.certificate(), s.seconds);
    if (!s.left_out.empty()) cells[2] = s.left_out;
    const pipeline::CaseMap* slip = pipeline::find_map(s.maps.maps, "slip_mm");
    const maps::MapStatistics found = slip ? slip->overall : maps::MapStatistics{};
    for (double value : {found.median, found.p95, found.max})
      cells.push_back(slip ? fixed(value, 1) : "–");
    table.add(cells);
  }
  std::string html = element("h2", "Postures and donnings");
  html +=
      element("p",
              "The garment was put on, then followed the body with friction from the first "
              "posture to each other one. Slip is that of the cloth on the skin since then. A "
              "drape that is not settled, or in which the garment is not worn, counts nowhere.");
  html += table.html();
  if (wear.donnings.size() > 1) {
    Table how(
        {"donning", "shift left mm", "shift back mm", "shift up mm", "twist deg", "friction ×"});
    for (std::size_t k = 0; k < wear.donnings.size(); ++k) {
      const pipeline::CaseDonning& d = wear.donnings[k];
      how.add({std::to_string(k + 1), fixed(1000 * d.shift.x(), 1), fixed(1000 * d.shift.y(), 1),
               fixed(1000 * d.shift.z(), 1), fixed(degrees(d.twist), 1), fixed(d.friction, 2)});
    }
    html += how.html();
  }
  return html;
}

}  // namespace loosefit::report
