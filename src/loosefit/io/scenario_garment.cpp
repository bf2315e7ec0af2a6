#include <filesystem>

#include "loosefit/io/scenario_sections.h"

namespace loosefit {
namespace {

const NumberRange kMobility{-0.35, 2, "a body-garment mobility"};
const NumberRange kPatternPlace{-5, 5, "metres"};

ShirtFit read_fit(ConfigReader table, ShirtFit fit) {
  fit.chest = table.number("chest", fit.chest, kMobility);
  fit.waist = table.optional_number("waist", kMobility);
  fit.hip = table.number("hip", fit.hip, kMobility);
  fit.sleeve = table.number("sleeve", fit.sleeve, kMobility);
  fit.wrist = table.number("wrist", fit.wrist, kMobility);
  fit.neck_ease = table.number("neck_ease", fit.neck_ease, {-0.2, 1, "a fraction"});
  fit.scye_ease = table.number("scye_ease", fit.scye_ease, {0, 0.15, "metres"});
  fit.shoulder_follow = table.number("shoulder_follow", fit.shoulder_follow, {0, 1, "a fraction"});
  fit.cap_ease = table.number("cap_ease", fit.cap_ease, {0, 0.15, "a fraction"});
  table.finish();
  return fit;
}

bool names_a_file(const std::string& pattern) {
  return pattern.find('/') != std::string::npos ||
         std::filesystem::path(pattern).extension() == ".json";
}

}  // namespace

ScenarioGarment read_garment_section(ConfigReader table) {
  ScenarioGarment garment;
  garment.pattern = table.text("pattern", garment.pattern);
  if (names_a_file(garment.pattern)) {
    garment.file = existing_file(table, "pattern");
    garment.pattern = std::filesystem::path(garment.file).filename().string();
    for (const char* key : {"fit", "size"})
      if (table.has(key))
        throw table.error(key, "no fit or size beside a pattern file",
                          "a pattern file is taken at the size it has");
  } else {
    garment.pattern = table.choice("pattern", garment.pattern, {"long-sleeve-shirt"});
    garment.size = table.text("size", "");
    if (!garment.size.empty() && table.has("fit"))
      throw table.error("fit", "either fit or size",
                        "a size fixes the garment; a fit follows the body");
    garment.fit = read_fit(table.table("fit"), garment.fit);
  }
  table.finish();
  return garment;
}

ScenarioAttachment read_attachment_section(ConfigReader table) {
  using Kind = ScenarioAttachment::Kind;
  ScenarioAttachment a;
  a.name = table.text("name", "");
  if (a.name.empty()) throw table.error("name", "a name");
  a.kind = table.choice("kind", "", {"board", "cable"}) == "cable" ? Kind::cable : Kind::board;
  if (!table.has("kind")) throw table.error("kind", "\"board\" or \"cable\"");
  a.panel = table.text("panel", "");
  if (a.panel.empty()) throw table.error("panel", "the name of a panel of the pattern");
  if (a.kind == Kind::board) {
    a.at = table.point("at", kPatternPlace);
    if (table.has("size") == table.has("radius"))
      throw table.error(table.has("size") ? "radius" : "size",
                        "either size = [width, height] or radius");
    if (table.has("size")) a.size = table.point("size", {0.001, 0.5, "metres"});
    a.radius = table.number("radius", 0, {0.001, 0.25, "metres"});
    a.mass = table.number("mass", 0, {0, 2, "kilograms"});
    a.bending = table.number("bending", 0, {0, 10, "N m"});
    a.membrane_factor = table.number("membrane_factor", 1, {1, 1e4, "a factor"});
  } else {
    a.path = table.points("path", kPatternPlace, 2);
    a.width = table.number("width", a.width, {0.0005, 0.1, "metres"});
    a.mass_per_length = table.number("mass_per_length", 0, {0, 1, "kg/m"});
    a.bending = table.number("bending", 0, {0, 0.01, "N m²"});
  }
  table.finish();
  return a;
}

ScenarioSite read_site_section(ConfigReader table) {
  ScenarioSite site;
  site.name = table.text("name", "");
  if (site.name.empty()) throw table.error("name", "a name");
  site.landmark = table.text("landmark", "");
  site.panel = table.text("panel", "");
  if (site.landmark.empty() == site.panel.empty())
    throw table.error(site.panel.empty() ? "panel" : "landmark",
                      "either panel with at = [u, v], or landmark");
  if (!site.panel.empty()) site.at = table.point("at", kPatternPlace);
  table.finish();
  return site;
}

}  // namespace loosefit
