#include "loosefit/io/scenario_attachment.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"
#include "loosefit/garment/board_material.h"
#include "loosefit/io/degrees_text.h"

namespace loosefit::io {
namespace {

const NumberRange kPatternPlace{-5, 5, "metres"};

std::string required_text(ConfigReader& table, const std::string& key, const std::string& what) {
  table.require(key, what);
  return table.text(key, "", what);
}

garment::Board read_board(ConfigReader& table) {
  garment::Board board;
  read_board_make(table, board);
  board.centre = table.point("at", kPatternPlace, "centre in pattern coordinates: u weft, v warp");
  const bool disc = table.has("radius");
  if (table.has("size") == disc)
    throw table.error(disc ? "radius" : "size", "either size = [width, height] or radius");
  if (disc) {
    table.require("radius", "a radius");
    board.radius = *table.optional_number("radius", {0.001, 0.25, "metres"}, "of a disc");
  } else {
    board.size = table.point("size", {0.001, 0.5, "metres"}, "[width, height] of a rectangle");
  }
  board.angle = radians(
      table.number("angle_deg", 0, {-360, 360, "degrees"}, "turn of the board in the pattern"));
  return board;
}

garment::Cable read_cable(ConfigReader& table) {
  garment::Cable cable;
  cable.path = table.points("path", kPatternPlace, 2, "course in pattern coordinates");
  cable.width = table.number("width", cable.width, {0.0005, 0.1, "metres"},
                             "breadth of cloth over which the cable is spread");
  cable.linear_density = table.number("linear_density", 0, {0, 1, "kg/m"}, "mass per length");
  cable.bending = table.number("bending", 0, {0, 0.01, "N m²"}, "rod rigidity, spread over width");
  cable.axial_stiffness = table.number("axial_stiffness", 0, {0, 1e5, "newton"},
                                       "force of a cable or elastic per elongation of one");
  cable.pre_stretch = table.number("pre_stretch", 0, {0, 2, "a fraction"},
                                   "by which a cable or elastic is stretched when it is sewn on");
  return cable;
}

std::string point_text(const Vec2& p) {
  return fmt::format("[{}, {}]", shortest(p.x()), shortest(p.y()));
}

std::vector<std::string> make_texts(const garment::BoardMake& board) {
  std::vector<std::string> texts = {
      "mass = " + shortest(board.mass), "thickness = " + shortest(board.thickness),
      std::string("side = \"") +
          (board.side == garment::BoardMake::Side::inside ? "inside\"" : "outside\"")};
  if (!board.material.empty()) texts.push_back("material = " + toml_quoted(board.material));
  if (board.bending) texts.push_back("bending = " + shortest(*board.bending));
  if (board.membrane_factor)
    texts.push_back("membrane_factor = " + shortest(*board.membrane_factor));
  return texts;
}

std::string part_text(const garment::Board& board) {
  return "at = " + point_text(board.centre) + "\n" +
         (board.radius > 0 ? "radius = " + shortest(board.radius)
                           : "size = " + point_text(board.size)) +
         fmt::format("\nangle_deg = {}\n", degrees_text(board.angle)) +
         join(make_texts(board), "\n") + "\n";
}

std::string part_text(const garment::Cable& cable) {
  std::vector<std::string> path;
  for (const Vec2& p : cable.path) path.push_back(point_text(p));
  return fmt::format(
      "path = [{}]\nwidth = {}\nlinear_density = {}\nbending = {}\n"
      "axial_stiffness = {}\npre_stretch = {}\n",
      join(path), shortest(cable.width), shortest(cable.linear_density), shortest(cable.bending),
      shortest(cable.axial_stiffness), shortest(cable.pre_stretch));
}

}  // namespace

void read_board_make(ConfigReader& table, garment::BoardMake& board) {
  using Side = garment::BoardMake::Side;
  board.mass = table.number("mass", board.mass, {0, 2, "kilograms"}, "mass of the board");
  const bool inside = table.choice("side", "outside", {"outside", "inside"},
                                   "of the cloth; inside is towards the skin") == "inside";
  board.side = inside ? Side::inside : Side::outside;
  const double thickest = inside ? garment::kThickestInside : garment::kThickest;
  board.thickness = table.number("thickness", board.thickness, {0, thickest, "metres"},
                                 "its centre of mass is half of it off the cloth; inside the cloth "
                                 "it keeps that from the skin, and is 10 mm at most");
  std::vector<std::string> materials;
  for (const garment::BoardMaterial& m : garment::board_materials()) materials.push_back(m.name);
  board.material =
      table.choice("material", "", materials,
                   "of a flexible board; without it a board is rigid");
  if (!board.material.empty() && board.thickness == 0)
    board.thickness = garment::find_board_material(board.material)->usual;
  board.bending = table.optional_number(
      "bending", {0, 10, "N m"}, "measured sheet rigidity: the board is flexible, not rigid");
  board.membrane_factor = table.optional_number(
      "membrane_factor", {1, 1e4, "a factor"},
      "measured in-plane stiffness by that of the cloth: the board is flexible, not rigid");
}

std::string board_make_toml(const garment::BoardMake& board) { return join(make_texts(board)); }

garment::Attachment read_attachment_section(ConfigReader table) {
  std::vector<std::string> known = {"kind", "name", "panel"};
  const ConfigNode* kind = table.node("kind");
  const bool only_board = kind && kind->text == "board", only_cable = kind && kind->text == "cable";
  if (!only_cable)
    for (const char* key : {"at", "size", "radius", "angle_deg", "mass", "thickness", "side",
                            "material", "bending", "membrane_factor"})
      known.push_back(key);
  if (!only_board)
    for (const char* key :
         {"path", "width", "linear_density", "bending", "axial_stiffness", "pre_stretch"})
      known.push_back(key);
  table.only(known);
  garment::Attachment a;
  a.name = required_text(table, "name", "a name");
  a.panel = required_text(table, "panel", "the name of a panel of the pattern");
  table.require("kind", "\"board\" or \"cable\"");
  const std::string chosen = table.choice("kind", "", {"board", "cable"}, "what is sewn on");
  table.only_for("kind", {chosen});
  if (chosen == "board")
    a.part = read_board(table);
  else
    a.part = read_cable(table);
  table.finish();
  return a;
}

std::string attachment_toml(const garment::Attachment& a) {
  return fmt::format("[[attachment]]\nkind = \"{}\"\nname = {}\npanel = {}\n",
                     std::holds_alternative<garment::Board>(a.part) ? "board" : "cable",
                     toml_quoted(a.name), toml_quoted(a.panel)) +
         std::visit([](const auto& part) { return part_text(part); }, a.part);
}

}  // namespace loosefit::io
