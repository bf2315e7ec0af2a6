#include "loosefit/io/scenario_site.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/io/degrees_text.h"
#include "loosefit/placement/site_points.h"

// [[site]]: where a sensor is wanted and what it is.
namespace loosefit::io {
namespace {

using Kind = placement::FootprintShape::Kind;

const NumberRange kPercent{-200, 300, "percent"};
const char* const kPlaces = "one of landmark, panel with at, segment with ratios";
const char* const kShapes = "one of radius, size = [across, along], length, girth = true";

std::vector<std::string> segment_names() {
  std::vector<std::string> names;
  for (placement::BodySegment segment : placement::all_body_segments())
    names.push_back(placement::name(segment));
  return names;
}

placement::BodyAddress read_anatomy(ConfigReader& table) {
  placement::BodyAddress address;
  const std::string segment =
      table.choice("segment", "", segment_names(), "segment of an anatomical address");
  for (placement::BodySegment s : placement::all_body_segments())
    if (placement::name(s) == segment) address.segment = s;
  const bool sided = placement::has_side(address.segment);
  std::vector<std::string> alike;
  for (placement::BodySegment s : placement::all_body_segments())
    if (placement::has_side(s) == sided) alike.push_back(placement::name(s));
  table.only_for("segment", alike);
  if (sided) {
    table.require("side", "\"left\" or \"right\": a person has two of these segments");
    const std::string side = table.choice("side", "", {"left", "right"}, "of the wearer");
    address.side = side == "left" ? 1 : -1;
  } else if (table.has("side")) {
    throw table.error("side", "no side: there is one " + segment);
  }
  table.require("ratios", "three ratios [X, Y, Z] in percent");
  const std::vector<double> percent = table.numbers(
      "ratios", kPercent, "place in the segment [X, Y, Z] in percent of its extent", 3);
  if (percent.size() != 3) throw table.error("ratios", "three ratios [X, Y, Z] in percent");
  address.percent = Vec3(percent[0], percent[1], percent[2]);
  return address;
}

placement::FootprintShape read_footprint(ConfigReader table) {
  table.only({"radius", "size", "length", "girth"});
  placement::FootprintShape shape;
  int given = 0;
  for (const char* key : {"radius", "size", "length", "girth"}) given += table.has(key);
  if (given != 1)
    throw table.error("", table.keys().empty() ? "nothing" : join(table.keys()), kShapes, {});
  if (table.has("size")) {
    shape.kind = Kind::rectangle;
    shape.size = table.point("size", {0.001, 0.5, "metres"}, "[across, along] of a rectangle");
  } else if (table.has("length")) {
    shape.kind = Kind::line;
    table.require("length", "a length");
    shape.length =
        *table.optional_number("length", {0.001, 2, "metres"}, "of a strain sensor along the axis");
  } else if (table.has("girth")) {
    shape.kind = Kind::girth;
    table.require("girth", "true");
    table.always_true("girth", "once round the body, square to the axis of the segment",
                      "true, or another shape");
  } else {
    table.require("radius", "a radius");
    shape.radius = *table.optional_number("radius", {0.001, 0.1, "metres"}, "of a disc");
  }
  table.finish();
  return shape;
}

placement::SensorBoard read_sensor_board(ConfigReader table) {
  placement::SensorBoard board;
  board.mass = table.number("mass", board.mass, {0, 2, "kilograms"}, "mass of the sensor");
  board.bending = table.number("bending", board.bending, {0, 10, "N m"},
                               "sheet rigidity added within the footprint");
  board.membrane_factor =
      table.number("membrane_factor", board.membrane_factor, {1, 1e4, "a factor"},
                   "in-plane stiffness multiplier within the footprint");
  table.finish();
  return board;
}

std::string pair_text(const Vec2& p) {
  return fmt::format("[{}, {}]", shortest(p.x()), shortest(p.y()));
}

std::string footprint_text(const placement::FootprintShape& shape) {
  switch (shape.kind) {
    case Kind::disc:
      return "radius = " + shortest(shape.radius);
    case Kind::rectangle:
      return "size = " + pair_text(shape.size);
    case Kind::line:
      return "length = " + shortest(shape.length);
    default:
      return "girth = true";
  }
}

std::string place_text(const placement::SiteSpec& site) {
  if (!site.panel.empty())
    return "panel = " + toml_quoted(site.panel) + "\nat = " + pair_text(site.at) + "\n";
  if (!site.landmark.empty() || !site.anatomy)
    return "landmark = " + toml_quoted(site.landmark) + "\n";
  const placement::BodyAddress& address = *site.anatomy;
  std::string text = "segment = " + toml_quoted(placement::name(address.segment)) + "\n";
  if (address.side != 0)
    text += std::string("side = ") + (address.side > 0 ? "\"left\"\n" : "\"right\"\n");
  return text + fmt::format("ratios = [{}, {}, {}]\n", shortest(address.percent.x()),
                            shortest(address.percent.y()), shortest(address.percent.z()));
}

}  // namespace

placement::SiteSpec read_site_section(ConfigReader table) {
  table.only({"name", "landmark", "panel", "at", "segment", "side", "ratios", "angle_deg",
              "footprint", "board"});
  placement::SiteSpec site;
  table.require("name", "a name");
  site.name = table.text("name", "", "what the place is called in the output");
  const bool landmark = table.has("landmark"), panel = table.has("panel"),
             segment = table.has("segment");
  if (landmark + panel + segment != 1)
    throw table.error(panel && landmark ? "landmark" : segment ? "segment" : "panel", kPlaces);
  if (landmark) {
    table.require("landmark", "a landmark");
    site.landmark = table.text("landmark", "", "landmark of the body, or a preset site");
    if (const auto own = placement::preset_footprint(site.landmark)) site.footprint = *own;
  }
  if (panel) {
    table.require("panel", "a panel");
    site.panel = table.text("panel", "", "panel of the pattern");
    site.at = table.point("at", {-5, 5, "metres"}, "place in pattern coordinates: u weft, v warp");
  }
  if (segment) site.anatomy = read_anatomy(table);
  site.angle = radians(table.number("angle_deg", 0, {-360, 360, "degrees"},
                                    "of the axis of the sensor, from the warp, counter-clockwise"));
  if (const auto footprint = table.optional_table("footprint", "cloth under the sensor: one shape"))
    site.footprint = read_footprint(*footprint);
  if (const auto board = table.optional_table("board", "simulate the sensor as a stiff part")) {
    site.board = read_sensor_board(*board);
    if (site.footprint.kind == Kind::line || site.footprint.kind == Kind::girth)
      throw table.error("board", "no board under a line",
                        "a thread or cable along a path is an [[attachment]]");
  }
  table.finish();
  return site;
}

std::string site_toml(const placement::SiteSpec& site) {
  std::string text = "[[site]]\nname = " + toml_quoted(site.name) + "\n" + place_text(site) +
                     "angle_deg = " + degrees_text(site.angle) + "\nfootprint = { " +
                     footprint_text(site.footprint) + " }\n";
  if (site.board)
    text += fmt::format("board = {{ mass = {}, bending = {}, membrane_factor = {} }}\n",
                        shortest(site.board->mass), shortest(site.board->bending),
                        shortest(site.board->membrane_factor));
  return text;
}

}  // namespace loosefit::io
