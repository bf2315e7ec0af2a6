#include "loosefit/garment/check_attachment.h"

#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/garment/board_material.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::garment {
namespace {

/// Checks of one attachment, each failure under its own key.
struct Checker {
  const Attachment& attachment;
  const pattern::Panel& panel;

  [[noreturn]] void fail(const std::string& key, const std::string& found,
                         const std::string& expected) const {
    throw InvalidInput(InputPlace{{}, 0, fmt::format("attachment {}.{}", attachment.name, key)},
                       found, expected);
  }
  void range(const std::string& key, double value, double low, double high,
             const char* unit) const {
    if (!(value >= low && value <= high))
      fail(key, fmt::format("{:.6g} {}", value, unit),
           fmt::format("{:g} to {:g} {}", low, high, unit));
  }
  void inside(const std::string& key, const Vec2& point) const {
    const std::vector<Vec2> outline = pattern::outline_polygon(panel);
    if (!point.allFinite()) fail(key, "a coordinate that is not finite", "metres");
    for (const pattern::PanelHole& hole : panel.holes)
      if (pattern::inside_polygon(hole.points, point))
        fail(key,
             fmt::format("({:.4f}, {:.4f}) m, in the hole \"{}\" of panel {}", point.x(), point.y(),
                         printable(hole.name), panel.name),
             "a point on the cloth");
    const Vec2 nearest = pattern::closest_on_polygon(outline, point);
    if (pattern::inside_polygon(outline, point) || (nearest - point).norm() < 1e-9) return;
    fail(
        key, fmt::format("({:.4f}, {:.4f}) m, outside panel {}", point.x(), point.y(), panel.name),
        fmt::format("a point inside; the nearest is ({:.4f}, {:.4f}) m", nearest.x(), nearest.y()));
  }

  void operator()(const Board& board) const {
    inside("position", board.centre);
    range("mass", board.mass, 0, 5, "kg");
    const bool inside_cloth = board.side == Board::Side::inside;
    range("thickness", board.thickness, 0, inside_cloth ? kThickestInside : kThickest, "m");
    if (board.bending) range("bending", *board.bending, 0, 10, "N m");
    if (board.membrane_factor) range("membrane_factor", *board.membrane_factor, 1, 1e4, "");
    if (board.material.empty()) {
    } else if (!find_board_material(board.material)) {
      fail("material", '"' + printable(board.material) + '"', "one of " + board_material_names());
    } else if (!(board.thickness > 0)) {
      fail("thickness", "none", "the thickness of the " + board.material + " in metres");
    }
    if (!std::isfinite(board.angle)) fail("angle", "a value that is not finite", "an angle");
    if (board.radius != 0) {
      range("radius", board.radius, 1e-4, 0.5, "m");
    } else {
      range("width", board.size.x(), 1e-4, 1, "m");
      range("height", board.size.y(), 1e-4, 1, "m");
    }
  }
  void operator()(const Cable& cable) const {
    if (cable.path.size() < 2)
      fail("path", fmt::format("{} points", cable.path.size()), "at least two");
    if (cable.path.size() > 1000)
      fail("path", fmt::format("{} points", cable.path.size()), "at most 1000");
    for (std::size_t i = 0; i < cable.path.size(); ++i)
      inside(fmt::format("path[{}]", i), cable.path[i]);
    range("linear_density", cable.linear_density, 0, 1, "kg/m");
    range("bending", cable.bending, 0, 1, "N m²");
    range("width", cable.width, 5e-4, 0.2, "m");
    range("axial_stiffness", cable.axial_stiffness, 0, 1e5, "N");
    range("pre_stretch", cable.pre_stretch, 0, 2, "");
  }
};

}  // namespace

int check_attachment(const Attachment& attachment, const pattern::Pattern& pattern) {
  const int panel = pattern.find_panel(attachment.panel);
  if (panel < 0) {
    std::vector<std::string> names;
    for (const pattern::Panel& p : pattern.panels) names.push_back(p.name);
    throw InvalidInput(InputPlace{{}, 0, fmt::format("attachment {}.panel", attachment.name)},
                       '"' + attachment.panel + '"',
                       fmt::format("one of {}", fmt::join(names, ", ")),
                       did_you_mean(attachment.panel, names));
  }
  std::visit(Checker{attachment, pattern.panels[panel]}, attachment.part);
  return panel;
}

}  // namespace loosefit::garment
