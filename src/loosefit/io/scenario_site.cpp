#include "loosefit/io/scenario_site.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/io/degrees_text.h"
#include "loosefit/io/scenario_attachment.h"
#include "loosefit/io/scorecard_key.h"
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

placement::LinePlace read_place(const ConfigReader& table, const std::string& key,
                                const std::string& text) {
  try {
    return placement::parse_place(text);
  } catch (const InvalidInput& error) {
    throw table.error(key, error.found(), error.expected(), error.hint());
  }
}

/// A sensor that is a line: from, to and what is on the way.
placement::LineSpec read_line(ConfigReader& table) {
  placement::LineSpec line;
  const auto end = [&](const char* key, const char* about) {
    table.require(key, "a place");
    return read_place(table, key, table.text(key, "", about));
  };
  line.stops.push_back(
      end("from", "where a line begins: landmark, panel:u,v or segment [x, y, z]"));
  for (const std::string& text :
       table.texts("via", "", "places that a line goes through, in their order", 1))
    line.stops.push_back(read_place(table, "via", text));
  line.stops.push_back(end("to", "where a line ends, told alike"));
  const std::string course =
      table.choice("course", "shortest", {"shortest", "straight", "least-strain"},
                   "the shortest way in the cloth as cut, straight in one piece of the pattern, or "
                   "the way that is stretched least in all postures and donnings");
  if (course == "straight") line.course = placement::LineSpec::Course::straight;
  if (course == "least-strain") line.course = placement::LineSpec::Course::least_strain;
  line.over = table.choice("over", "", {"front", "back", "left", "right", "inside", "outside"},
                           "side of the body that it leads over");
  if (!line.over.empty() && table.has("via"))
    throw table.error("over", "a side beside via", "one of the two", {});
  line.height = table.number("height", line.height, {-0.02, 0.02, "metres"},
                             "of the middle of the sensor above that of the cloth, outwards");
  line.pre_stretch = table.number("pre_stretch", line.pre_stretch, {0, 2, "a fraction"},
                                  "by which the sensor is stretched when it is sewn on");
  line.part = table.number("part", line.part, {0.002, 1, "metres"},
                           "wished length of the parts in which it is told");
  if (line.course == placement::LineSpec::Course::least_strain) {
    line.longest = table.number("longest", line.longest, {0, 20, "metres"},
                                "limit of a least-strain line in the flat cloth; 0: none");
    line.seam_price = table.number("seam_price", line.seam_price, {0, 100, "metres"},
                                   "way that is as dear as to cross a seam");
    line.bend_price = table.number("bend_price", line.bend_price, {0, 0.1, "metres"},
                                   "strain per curvature of the cloth: half the lead's thickness");
    line.slip_price = table.number("slip_price", line.slip_price, {0, 1e3, "1/m"},
                                   "strain per metre by which the cloth slips on the skin");
    for (const std::string& text : table.texts(
             "keep_out", "", "zones of the pattern and regions of the body that it passes by", 1))
      try {
        placement::add_keep_out(text, line.keep_out);
      } catch (const InvalidInput& error) {
        throw table.error("keep_out", error.found(), error.expected(), error.hint());
      }
  } else {
    for (const char* key : {"longest", "seam_price", "bend_price", "slip_price", "keep_out"})
      if (table.has(key))
        throw table.error(key, "a condition of a route", "course = \"least-strain\" beside it", {});
  }
  line.scorecard = scorecard_of(
      table, "scorecard", "scorecard by which a line is judged, or the path of a .toml file", true);
  line.stiffness = table.number("stiffness", line.stiffness, {0, 1e5, "N/m"},
                                "of the whole line: force per metre by which it is longer");
  line.width = table.number("width", line.width, {0.0005, 0.1, "metres"},
                            "breadth of cloth on which the line pulls");
  line.linear_density =
      table.number("linear_density", line.linear_density, {0, 1, "kg/m"}, "mass per length");
  line.bending =
      table.number("bending", line.bending, {0, 0.01, "N m²"}, "rod rigidity, spread over width");
  if (line.is_sewn_part() && line.course == placement::LineSpec::Course::least_strain)
    throw table.error("course", "least-strain for a line with stiffness, mass or rigidity",
                      "shortest or straight",
                      "find the route without them, then give places of it "
                      "(summary.json lines.NAME.routes) as via");
  return line;
}

placement::SensorBoard read_sensor_board(ConfigReader table) {
  placement::SensorBoard board;
  read_board_make(table, board);
  if (table.has("size"))
    board.size = table.point("size", {0.001, 0.5, "metres"},
                             "[across, along] of the board; absent: that of the footprint");
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

std::string line_toml(const std::string& name, const placement::LineSpec& line) {
  std::vector<std::string> via;
  for (std::size_t i = 1; i + 1 < line.stops.size(); ++i)
    via.push_back(toml_quoted(line.stops[i].str()));
  std::string text = fmt::format("[[site]]\nname = {}\nfrom = {}\n", toml_quoted(name),
                                 toml_quoted(line.stops.front().str()));
  if (!via.empty()) text += "via = [" + join(via) + "]\n";
  text += "to = " + toml_quoted(line.stops.back().str()) + "\n";
  if (!line.over.empty()) text += "over = " + toml_quoted(line.over) + "\n";
  using Course = placement::LineSpec::Course;
  const char* const course = line.course == Course::straight       ? "straight"
                             : line.course == Course::least_strain ? "least-strain"
                                                                   : "shortest";
  if (line.course == Course::least_strain) {
    text += fmt::format("longest = {}\nseam_price = {}\nbend_price = {}\nslip_price = {}\n",
                        shortest(line.longest), shortest(line.seam_price),
                        shortest(line.bend_price), shortest(line.slip_price));
    std::vector<std::string> kept;
    for (const placement::KeepOutZone& zone : line.keep_out.zones)
      kept.push_back(toml_quoted(zone.name));
    for (const body::Region region : line.keep_out.regions)
      kept.push_back(toml_quoted(body::name(region)));
    if (!kept.empty()) text += "keep_out = [" + join(kept) + "]\n";
  }
  if (!line.scorecard.empty()) text += "scorecard = " + toml_quoted(line.scorecard) + "\n";
  return text + fmt::format(
                    "course = \"{}\"\nheight = {}\npre_stretch = {}\npart = {}\nstiffness = {}\n"
                    "width = {}\nlinear_density = {}\nbending = {}\n",
                    course, shortest(line.height), shortest(line.pre_stretch), shortest(line.part),
                    shortest(line.stiffness), shortest(line.width), shortest(line.linear_density),
                    shortest(line.bending));
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
  placement::SiteSpec site;
  if (table.has("from") || table.has("to")) {
    table.only({"name", "from", "to", "via", "course", "over", "height", "pre_stretch", "part",
                "scorecard", "longest", "seam_price", "bend_price", "slip_price", "keep_out",
                "stiffness", "width", "linear_density", "bending"});
    table.require("name", "a name");
    site.name = table.text("name", "", "what the place is called in the output");
    site.line = read_line(table);
    table.finish();
    return site;
  }
  table.only({"name", "landmark", "panel", "at", "segment", "side", "ratios", "shift", "angle_deg",
              "footprint", "board"});
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
  site.shift = table.point_or_zero("shift", {-kMostSiteShift, kMostSiteShift, "metres"},
                                   "of the sensor from there along the cloth: weft, warp");
  site.angle = radians(table.number("angle_deg", 0, {-360, 360, "degrees"},
                                    "of the axis of the sensor, from the warp, counter-clockwise"));
  if (const auto footprint = table.optional_table("footprint", "cloth under the sensor: one shape"))
    site.footprint = read_footprint(*footprint);
  if (const auto board = table.optional_table("board", "simulate the sensor as the body it is")) {
    site.board = read_sensor_board(*board);
    if (!site.board->size.isZero() && !table.has("footprint")) {
      site.footprint.kind = Kind::rectangle;
      site.footprint.size = site.board->size;
    }
    if (site.footprint.kind == Kind::line || site.footprint.kind == Kind::girth)
      throw table.error("board", "no board under a line",
                        "a thread or cable along a path is an [[attachment]]");
  }
  table.finish();
  return site;
}

std::string site_toml(const placement::SiteSpec& site) {
  if (site.line) return line_toml(site.name, *site.line);
  std::string text = "[[site]]\nname = " + toml_quoted(site.name) + "\n" + place_text(site);
  if (!site.shift.isZero()) text += "shift = " + pair_text(site.shift) + "\n";
  text += "angle_deg = " + degrees_text(site.angle) + "\nfootprint = { " +
          footprint_text(site.footprint) + " }\n";
  if (site.board)
    text += "board = { " + board_make_toml(*site.board) +
            (site.board->size.isZero() ? "" : ", size = " + pair_text(site.board->size)) + " }\n";
  return text;
}

}  // namespace loosefit::io
