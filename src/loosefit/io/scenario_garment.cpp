#include <algorithm>
#include <filesystem>
#include <set>

#include "loosefit/io/scenario_sections.h"
#include "loosefit/pattern/garment_size.h"
#include "loosefit/pattern/shirt_adapt.h"

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
  fit.sleeve_length =
      table.number("sleeve_length", fit.sleeve_length, {0.25, 1, "a share of the arm"});
  table.finish();
  return fit;
}

std::string required_text(ConfigReader& table, const std::string& key, const std::string& what) {
  if (!table.has(key)) throw table.error(key, what);
  return table.text(key, "");
}

Board read_board(ConfigReader& table) {
  Board board;
  board.centre = table.point("at", kPatternPlace);
  const bool disc = table.has("radius");
  if (table.has("size") == disc)
    throw table.error(disc ? "radius" : "size", "either size = [width, height] or radius");
  if (!disc) board.size = table.point("size", {0.001, 0.5, "metres"});
  board.radius = table.number("radius", 0, {0.001, 0.25, "metres"});
  board.angle = radians(table.number("angle_deg", 0, {-360, 360, "degrees"}));
  board.mass = table.number("mass", board.mass, {0, 2, "kilograms"});
  board.bending = table.number("bending", board.bending, {0, 10, "N m"});
  board.membrane_factor =
      table.number("membrane_factor", board.membrane_factor, {1, 1e4, "a factor"});
  return board;
}

Cable read_cable(ConfigReader& table) {
  Cable cable;
  cable.path = table.points("path", kPatternPlace, 2);
  cable.width = table.number("width", cable.width, {0.0005, 0.1, "metres"});
  cable.linear_density = table.number("linear_density", 0, {0, 1, "kg/m"});
  cable.bending = table.number("bending", 0, {0, 0.01, "N m²"});
  return cable;
}

bool names_a_file(const std::string& pattern) {
  return pattern.find('/') != std::string::npos ||
         !std::filesystem::path(pattern).extension().empty();
}

/// Names of the fit that give way: those that the user did not give, or the ones of `adapt`.
std::vector<std::string> read_adapt(ConfigReader& table, const std::set<std::string>& given) {
  std::vector<std::string> rest;
  for (const std::string& name : shirt_fit_names())
    if (!given.count(name)) rest.push_back(name);
  if (!table.has("adapt")) return rest;
  const std::vector<std::string> wished = table.choices("adapt", {}, shirt_fit_names());
  std::vector<std::string> in_order;
  for (const std::string& name : shirt_fit_names())
    if (std::find(wished.begin(), wished.end(), name) != wished.end()) in_order.push_back(name);
  return in_order;
}

}  // namespace

GarmentSpec read_garment_keys(ConfigReader& table) {
  GarmentSpec garment;
  if (table.has("file"))
    throw table.error("file", "an unknown key", "a key of garment",
                      "a pattern file is named by pattern = \"PATH\"");
  garment.pattern = table.text("pattern", garment.pattern);
  if (names_a_file(garment.pattern)) {
    garment.file = existing_file(table, "pattern");
    garment.pattern = std::filesystem::path(garment.file).filename().string();
    for (const char* key : {"fit", "size", "adapt"})
      if (table.has(key))
        throw table.error(key, std::string("no ") + key + " beside a pattern file",
                          "a pattern file is taken at the size it has");
  } else {
    garment.pattern = table.choice("pattern", garment.pattern, shirt_kinds());
    garment.fit = usual_fit(garment.pattern);
    garment.size = table.choice("size", "", garment_size_names());
    if (!garment.size.empty() && table.has("fit"))
      throw table.error("fit", "either fit or size",
                        "a size fixes the garment; a fit follows the body");
    const std::vector<std::string> given = table.table("fit").keys();
    garment.fit = read_fit(table.table("fit"), garment.fit);
    garment.adapt = read_adapt(table, {given.begin(), given.end()});
  }
  return garment;
}

GarmentSpec read_garment_section(ConfigReader table) {
  GarmentSpec garment = read_garment_keys(table);
  table.finish();
  return garment;
}

Attachment read_attachment_section(ConfigReader table) {
  std::vector<std::string> known = {"kind", "name", "panel"};
  const ConfigNode* kind = table.node("kind");
  const bool only_board = kind && kind->text == "board", only_cable = kind && kind->text == "cable";
  if (!only_cable)
    for (const char* key :
         {"at", "size", "radius", "angle_deg", "mass", "bending", "membrane_factor"})
      known.push_back(key);
  if (!only_board)
    for (const char* key : {"path", "width", "linear_density", "bending"}) known.push_back(key);
  table.only(known);
  Attachment a;
  a.name = required_text(table, "name", "a name");
  a.panel = required_text(table, "panel", "the name of a panel of the pattern");
  required_text(table, "kind", "\"board\" or \"cable\"");
  if (table.choice("kind", "", {"board", "cable"}) == "board")
    a.part = read_board(table);
  else
    a.part = read_cable(table);
  table.finish();
  return a;
}

}  // namespace loosefit
