#include <algorithm>

#include "loosefit/pipeline/case_ease.h"
#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

std::string percent(double share, int decimals = 0) { return fixed(100 * share, decimals) + " %"; }

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string load_tables(const maps::BodyLoad& load) {
  Table force({"Normal force on the wearer", "N", "weights of the garment", "share"});
  force.define(0, "normal-force");
  const auto row = [&](const std::string& name, double newton) {
    force.add({name, fixed(newton, 2), load.weight > 0 ? fixed(newton / load.weight, 1) : "–",
               load.normal_force > 0 ? percent(newton / load.normal_force) : "–"});
  };
  row("in all", load.normal_force);
  for (const std::string& limb : maps::limb_names())
    if (load.of_limb.at(limb) > 0) row(spaced(limb), load.of_limb.at(limb));
  row("of it, squeezed between arm and trunk", load.between_arm_and_trunk);
  std::vector<std::string> gaps = {"Gap to the skin up to"};
  for (double gap : maps::kNearGaps) gaps.push_back(number(1e3 * gap, 2) + " mm");
  Table contact(gaps);
  contact.define(0, "near-share");
  std::vector<std::string> shares = {"share of the cloth"};
  for (double share : load.near_share) shares.push_back(percent(share));
  contact.add(shares);
  return force.html() + contact.html();
}

std::string ease_table(const std::vector<pipeline::StationEase>& stations) {
  Table table({"Ease", "asked", "cut", "worn"});
  table.define(0, "ease");
  for (const pipeline::StationEase& s : stations)
    table.add({spaced(s.name), s.asked ? percent(*s.asked) : "–", percent(s.cut, 1),
               s.worn ? percent(*s.worn, 1) : "–"});
  return table.html();
}

std::string range_table(const maps::StrainRange& range) {
  Table table({"Strain of single triangles (raw) against its measured range", "largest", "range",
               "cloth beyond"});
  table.define(0, "measured-range");
  const auto row = [&](const char* name, const maps::DirectionRange& d, auto text) {
    table.add({name, text(d.largest), d.is_stated() ? text(d.limit) : "not stated",
               d.is_stated() ? percent(d.share_beyond, 1) : "–"});
  };
  row("warp", range.warp, [](double v) { return percent(v, 1); });
  row("weft", range.weft, [](double v) { return percent(v, 1); });
  row("trellis shear", range.shear, [](double v) { return fixed(degrees(v), 1) + "°"; });
  return table.html();
}

}  // namespace

std::string fit_check_section(const pipeline::CaseResult& result) {
  const pipeline::CaseMaps& maps = result.studied().maps;
  if (maps.maps.empty() && !maps.load) return {};
  std::string html = element("h2", "Does it hang?");
  if (maps.load) html += load_tables(*maps.load);
  const auto stations =
      pipeline::station_eases(result.studied(), result.scenario.studied().spec);
  if (!stations.empty()) html += ease_table(stations);
  html += range_table(maps.strain_range);
  return html + element("p",
                        "A garment that hangs presses on its wearer with a few times its weight. "
                        "More than " +
                            fixed(pipeline::kLooseWeights, 0) +
                            " weights mean that it is held somewhere that is too narrow. Beyond "
                            "the measured range the forces of the cloth are extrapolated.");
}

}  // namespace loosefit::report
