#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/text.h"
#include "loosefit/pipeline/check_worn.h"
#include "loosefit/report/html.h"
#include "loosefit/report/map_texts.h"
#include "loosefit/report/residual_chart.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

std::string who(const pipeline::CaseResult& result) {
  const scenario::ScenarioBody& body = result.scenario.body;
  if (!body.file.empty()) return "a scanned body";
  const bool child = body.age < 16;
  const char* sex = body.sex < 0.25   ? (child ? "girl" : "woman")
                    : body.sex > 0.75 ? (child ? "boy" : "man")
                                      : (child ? "child" : "person");
  return fmt::format("a {} of {:.0f} years and {:.2f} m", sex, body.age, body.height);
}

std::string what(const pipeline::CaseResult& result) {
  const scenario::GarmentSpec& garment = result.scenario.studied().spec;
  std::string text =
      garment.file.empty() ? garment.kind : std::filesystem::path(garment.file).filename().string();
  std::replace(text.begin(), text.end(), '-', ' ');
  if (!garment.size.empty()) text += " in size " + garment.size;
  return text;
}

std::string fact(const std::string& label, const std::string& term, const std::string& value) {
  return "<li>" + defined(label, term) + " <b>" + escaped(value) + "</b></li>";
}

/// Where most of some triangles are: "mostly at the left side".
std::string mostly_at(const pipeline::CaseResult& result, const std::vector<int>& triangles) {
  std::map<body::Region, int> of_region;
  for (int t : triangles)
    ++of_region[result.studied().maps.worn.regions[result.studied().mesh().triangles[t][0]]];
  if (of_region.empty()) return {};
  const auto most = std::max_element(of_region.begin(), of_region.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  return ", most at " + spaced(body::name(most->first));
}

std::string count_text(int count) { return count < 0 ? "not tested" : std::to_string(count); }

}  // namespace

std::string headline_section(const pipeline::CaseResult& result) {
  std::string html = element("h1", "Does loose fitting matter here?");
  std::string sentence = "The " + what(result) + " on " + who(result);
  const auto chest = result.studied().pattern.fit.find("chest");
  if (chest != result.studied().pattern.fit.end())
    sentence +=
        fmt::format(", {}{:.0f}\u00a0% at the chest", chest->second < 0 ? "tight by " : "loose by ",
                    std::abs(100 * chest->second));
  sentence += ", in " + result.scenario.studied().material.material.name;
  for (std::size_t g = result.worn_under().size(); g-- > 0;)
    sentence += " over the " + result.garments[g].pattern.pattern.name + " in " +
                result.scenario.garments[g].material.material.name;
  sentence += ".";
  // The verdict first, in a word; the certificate says why.
  const drape::Certificate& c = result.certificate();
  const std::string verdict = c.holds()     ? "Settled and worn"
                              : c.settled() ? "Not worn"
                                            : "Not settled";
  html += element("p",
                  "<span class=\"verdict " + std::string(c.holds() ? "good" : "bad") + "\">" +
                      verdict + "</span>" + escaped(sentence),
                  "lead");
  return html;
}

std::string warning_section(const pipeline::CaseResult& result) {
  if (result.warnings.empty()) return {};
  std::string list;
  for (const std::string& warning : result.warnings) list += element("li", escaped(warning));
  const std::size_t count = result.warnings.size();
  return "<details class=\"box warn\"" + std::string(result.certificate().holds() ? "" : " open") +
         "><summary><strong>Worth knowing</strong> (" + std::to_string(count) +
         (count == 1 ? " warning" : " warnings") + ")</summary>" + element("ul", list) +
         "</details>\n";
}

std::string certificate_section(const pipeline::CaseResult& result) {
  const drape::Certificate& c = result.certificate();
  const drape::SettleReport& settling = result.studied().drape.report;
  const double tolerance = result.scenario.simulation.residual_tolerance;
  // The verdict in words: settled and worn, settled but not worn, or not at rest.
  std::string text;
  if (c.holds()) {
    text = "<strong>Settled.</strong> The net force left on the cloth is " +
           number(100 * c.residual, 2) +
           " % of its weight, and an exact test finds no triangle of the garment crossing the body "
           "or another part of itself. <strong>Worn:</strong> " +
           escaped(pipeline::what_worn_says(result)) + ".";
  } else if (c.settled()) {
    text = "<strong>" + std::string(result.sealed() ? "SEALED: " : "") +
           "this garment is not worn: " + escaped(join(c.worn_reasons, "; ")) +
           ".</strong> It is at rest, but not where it was made for. " +
           (result.sealed() ? "No maps were made of it, because their numbers would mislead."
                            : "The maps below were asked for all the same; do not rely on their "
                              "numbers.");
  } else if (result.sealed()) {
    text =
        "<strong>SEALED: this drape is not at rest.</strong> No maps were made of it, because "
        "their numbers would mislead.";
  } else {
    text =
        "<strong>NOT SETTLED.</strong> The maps below were asked for all the same; do not rely on "
        "their numbers.";
  }
  // The numbers behind it; crossings between garments only when there are several.
  std::string facts =
      fact("residual ‖F‖/‖W‖", "residual", number(c.residual, 3)) +
      fact("largest on one particle", "residual-max", number(c.residual_max, 3)) +
      fact("crossings with the body", "crossings", count_text(c.intersections_body)) +
      fact("crossings with itself", "crossings", count_text(c.intersections_self)) +
      fact("stable:", "stable",
           !c.stable   ? "not tested"
           : *c.stable ? "yes"
                       : "no") +
      (result.worn_under().empty()
           ? ""
           : fact("of these, between garments", "crossings", count_text(c.intersections_layers))) +
      fact("stopped:", "stopped", c.stop_reason) +
      fact("worn:", "worn", c.worn() ? "yes" : "no, " + join(c.worn_reasons, "; "));
  facts += fact("can be put on:", "can-be-put-on", pipeline::putting_on_verdict(result.putting_on));
  if (const maps::StrainRange& range = result.studied().maps.strain_range;
      !result.studied().maps.maps.empty()) {
    const auto told = [&](const std::vector<int>& triangles) {
      return std::to_string(triangles.size()) + mostly_at(result, triangles);
    };
    facts += fact("crushed triangles:", "crushed", told(range.crushed));
    facts += fact("torn triangles:", "crushed", told(range.torn));
  }
  if (settling.total().iterations > 0)
    facts += fact("iterations", "iterations", std::to_string(settling.total().iterations));
  // Green or red box, and below it how the force fell.
  std::string html = element("h2", "Certificate");
  html += element("div", text + element("ul", facts, "facts"), c.holds() ? "box good" : "box bad");
  return html + residual_chart(settling.history, tolerance);
}

}  // namespace loosefit::report
