#include <fmt/format.h>

#include <set>

#include "loosefit/base/text.h"
#include "loosefit/base/version.h"
#include "loosefit/body/stumps.h"
#include "loosefit/io/material_origin.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/report/html.h"
#include "loosefit/report/plot.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

std::string millimetres(double metres) { return fmt::format("{:.0f}", 1000 * metres); }
std::string percent(double share) { return signed_number(100 * share, 3) + " %"; }

Table fit_table(const pipeline::CaseResult& result) {
  Table table({"Level", "garment [mm]", "body [mm]", "fit (BGM)"});
  table.define(3, "bgm");
  for (const auto& [level, mobility] : result.studied().pattern.fit) {
    const auto girth = result.studied().pattern.girths.find(level);
    const bool known = girth != result.studied().pattern.girths.end();
    table.add({level, known ? millimetres(girth->second) : "–",
               known ? millimetres(girth->second / (1 + mobility)) : "–", percent(mobility)});
  }
  return table;
}

/// The fit along one limb, as cut and as asked; empty without stations.
std::string fit_plot(const pipeline::CaseResult& result, const std::string& limb,
                     const std::string& title, const std::string& from) {
  Plot plot;
  plot.title = title;
  plot.x_label = "mm down from the " + from;
  plot.y_label = "fit (BGM) [%]";
  plot.height = 260;
  Plot::Series cut{"as cut", {}, {}, false}, asked{"as asked", {}, {}, true};
  for (const pipeline::StationFit& s : result.studied().pattern.fit_along) {
    if (s.limb != limb) continue;
    cut.x.push_back(1000 * s.along);
    cut.y.push_back(100 * s.cut());
    if (!s.asked) continue;
    asked.x.push_back(1000 * s.along);
    asked.y.push_back(100 * *s.asked);
  }
  if (cut.x.empty()) return {};
  plot.series = {cut};
  if (!asked.x.empty()) plot.series.push_back(asked);
  return svg_plot(plot);
}

Table body_table(const pipeline::CaseResult& result) {
  Table table({"Measure", "asked [mm]", "measured [mm]", "difference [mm]"});
  std::set<std::string> done;
  for (const body::MeasureRow& row : result.body.asked) {
    table.add({row.name, millimetres(row.asked), millimetres(row.measured),
               signed_number(std::round(1000 * (row.measured - row.asked)), 2)});
    done.insert(row.name);
  }
  for (const char* name : {"height", "chest", "underbust", "waist", "hip", "neck", "upper_arm",
                           "wrist", "arm_length", "shoulder_breadth"}) {
    const auto found = result.body.body->measured.find(name);
    if (found != result.body.body->measured.end() && !done.count(name))
      table.add({name, "–", millimetres(found->second), "–"});
  }
  return table;
}

/// What a scan lacks of a person; nothing where it is whole.
std::string missing_in_words(const pipeline::CaseResult& result) {
  if (!result.body.parameters.stumps) return {};
  return element("p", "The scan has no " + join(result.body.parameters.stumps->names(), ", no ") +
                          ": the garment hangs there, and no site lies there.");
}

Table garment_table(const pipeline::CaseResult& result) {
  const garment::Garment& garment = result.studied().mesh();
  const fabric::Material& m = result.scenario.studied().material.material;
  Table table({"Garment and cloth", ""});
  table.define(0, "mesh");
  table.add({"vertices, triangles",
             fmt::format("{}, {}", garment.vertex_count, garment.triangles.size())});
  table.add({"flat area", number(garment.area) + " m²"});
  table.add({"mass", number(1000 * garment.mass) + " g"});
  table.add({"cloth", m.name});
  table.add({"bending length", number(1000 * io::bending_length(m)) + " mm"});
  return table;
}

std::string constants_table(const scenario::MaterialCard& card) {
  Table table({"Constant", "value", "unit", "from"});
  for (const io::ConstantInUse& c : io::constants_in_use(card))
    table.add({c.key, shortest(c.value), c.unit, c.from});
  return table.html();
}

Table time_table(const pipeline::CaseResult& result) {
  Table table({"Stage", "seconds"});
  double total = 0;
  for (const StageClock::Entry& entry : result.seconds) {
    table.add({entry.stage, fmt::format("{:.2f}", entry.seconds)});
    total += entry.seconds;
  }
  table.add({"together", fmt::format("{:.2f}", total)});
  if (result.peak_memory_mb > 0) table.add({"peak memory [MB]", number(result.peak_memory_mb)});
  return table;
}

/// The program, the paper that it builds on (CITATION.cff), and the cloth.
std::string citation(const pipeline::CaseResult& result) {
  const fabric::Material& m = result.scenario.studied().material.material;
  const std::string cloth =
      m.source.empty() ? m.name + ", without a stated source" : m.name + " (" + m.source + ")";
  return escaped("Loosefit " + version() +
                 ", sensor performance maps of draped garments; after Harms, Amft and Tröster, Does "
                 "loose fitting matter? Predicting sensor performance in smart garments (2012). "
                 "Fabric: " +
                 cloth + ".");
}

}  // namespace

std::string fit_section(const pipeline::CaseResult& result) {
  std::string fit = element("h2", "Fit");
  if (const Table table = fit_table(result); !table.empty()) fit += table.html();
  if (const maps::GarmentGirth& chest = result.studied().maps.chest;
      !result.studied().maps.maps.empty() && chest.flat > 0) {
    fit +=
        element("p", "Cut at chest level (" + millimetres(chest.level) +
                         " mm above the floor) the draped garment is " + millimetres(chest.draped) +
                         " mm round, flat " + millimetres(chest.flat) + " mm: hoop strain " +
                         percent(chest.hoop_strain()) + ".");
  }
  const std::string body =
      element("h2", "Body") + missing_in_words(result) + body_table(result).html();
  std::string html = element("div", element("div", fit) + element("div", body), "columns");
  const std::string trunk =
                        fit_plot(result, "trunk", "Trunk", "high point shoulder, over the back"),
                    arm = fit_plot(result, "arm", "Sleeve", "shoulder point"),
                    leg = fit_plot(result, "leg", "Leg", "crotch");
  if (!trunk.empty() || !arm.empty() || !leg.empty())
    html += element("h3", "Fit along trunk and limbs") +
            element("div",
                    element("div", trunk) + element("div", arm) +
                        (leg.empty() ? "" : element("div", leg)),
                    "columns");
  return html;
}

std::string provenance_section(const pipeline::CaseResult& result) {
  Table library({"Version", ""});
  for (const auto& [name, number_text] : versions()) library.add({name, number_text});
  std::string cloth = garment_table(result).html();
  const fabric::Material& m = result.scenario.studied().material.material;
  if (!m.source.empty()) cloth += element("p", "Constants: " + escaped(m.source));
  std::string html = element("h2", "Where the numbers come from");
  html += element("div",
                  element("div", cloth) +
                      element("div", time_table(result).html() + "<p></p>" + library.html()),
                  "columns");
  html +=
      element("h3", "Constants of the cloth") + constants_table(result.scenario.studied().material);
  for (std::size_t l = 0; l < result.worn_under().size(); ++l)
    html += element("h3", "Constants of the cloth under it, " + std::to_string(l + 1)) +
            constants_table(result.scenario.garments[l].material);
  html += element("h3", "How to cite") + element("p", citation(result));
  html += element("h3", "Scenario, every default written out");
  return html + "<details><summary>scenario.toml</summary><pre>" +
         escaped(io::scenario_toml(result.scenario)) + "</pre></details>\n";
}

}  // namespace loosefit::report
