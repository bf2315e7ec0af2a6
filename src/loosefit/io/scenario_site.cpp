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
  const std::string segment = table.choice("segment", "", segment_names());
  for (placement::BodySegment s : placement::all_body_segments())
    if (placement::name(s) == segment) address.segment = s;
  const std::string side = table.choice("side", "", {"left", "right"});
  address.side = side == "left" ? 1 : side == "right" ? -1 : 0;
  if (placement::has_side(address.segment) && side.empty())
    throw table.error("side", "\"left\" or \"right\": a person has two of these segments");
  if (!placement::has_side(address.segment) && !side.empty())
    throw table.error("side", "no side: there is one " + segment);
  if (!table.has("ratios")) throw table.error("ratios", "three ratios [X, Y, Z] in percent");
  const std::vector<double> percent = table.numbers("ratios", kPercent);
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
    shape.size = table.point("size", {0.001, 0.5, "metres"});
  } else if (table.has("length")) {
    shape.kind = Kind::line;
    shape.length = table.number("length", 0, {0.001, 2, "metres"});
  } else if (table.has("girth")) {
    shape.kind = Kind::girth;
    if (!table.boolean("girth", true)) throw table.error("girth", "true, or another shape");
  }
  shape.radius = table.number("radius", shape.radius, {0.001, 0.1, "metres"});
  table.finish();
  return shape;
}

placement::SensorBoard read_sensor_board(ConfigReader table) {
  placement::SensorBoard board;
  board.mass = table.number("mass", board.mass, {0, 2, "kilograms"});
  board.bending = table.number("bending", board.bending, {0, 10, "N m"});
  board.membrane_factor =
      table.number("membrane_factor", board.membrane_factor, {1, 1e4, "a factor"});
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
  if (!table.has("name")) throw table.error("name", "a name");
  site.name = table.text("name", "");
  const bool landmark = table.has("landmark"), panel = table.has("panel"),
             segment = table.has("segment");
  if (landmark + panel + segment != 1)
    throw table.error(panel && landmark ? "landmark" : segment ? "segment" : "panel", kPlaces);
  if (landmark) {
    site.landmark = table.text("landmark", "");
    if (const auto own = placement::preset_footprint(site.landmark)) site.footprint = *own;
  }
  if (panel) {
    site.panel = table.text("panel", "");
    site.at = table.point("at", {-5, 5, "metres"});
  }
  if (segment) site.anatomy = read_anatomy(table);
  site.angle = radians(table.number("angle_deg", 0, {-360, 360, "degrees"}));
  if (table.has("footprint")) site.footprint = read_footprint(table.table("footprint"));
  if (table.has("board")) {
    site.board = read_sensor_board(table.table("board"));
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
