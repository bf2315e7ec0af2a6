#include "loosefit/garment/attach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/garment/board_material.h"
#include "loosefit/garment/board_shape.h"
#include "loosefit/garment/check_attachment.h"
#include "loosefit/garment/covered_share.h"
#include "loosefit/garment/lay_band.h"
#include "loosefit/garment/rigid_board.h"
#include "loosefit/geometry/closest_point.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::garment {
namespace {

constexpr double kCableStep = 0.001;  // [m]

Vec3 lift(const Vec2& p) { return {p.x(), p.y(), 0}; }

/// Spreads a point mass on the corners of the triangle of `panel` that holds it, or the nearest
/// one.
void add_mass(Garment& g, int panel, const Vec2& at, double mass) {
  int best = -1;
  double best_distance = std::numeric_limits<double>::infinity();
  Vec3 weights = Vec3::Zero();
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    if (g.triangle_panel[t] != panel) continue;
    const auto& [a, b, c] = g.triangle_uv[t];
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    if ((at - at.cwiseMax(low).cwiseMin(high)).norm() >= best_distance) continue;
    const Vec3 w = geometry::closest_barycentric(lift(at), lift(a), lift(b), lift(c));
    const double distance = (w[0] * a + w[1] * b + w[2] * c - at).norm();
    if (distance >= best_distance) continue;
    best = static_cast<int>(t);
    best_distance = distance;
    weights = w;
    if (distance == 0) break;
  }
  if (best < 0) return;
  g.vertex_attached_mass.resize(g.vertex_count, 0.0);
  for (int i = 0; i < 3; ++i) {
    g.vertex_mass[g.triangles[best][i]] += weights[i] * mass;
    g.vertex_attached_mass[g.triangles[best][i]] += weights[i] * mass;
  }
}

template <class Shape>
void stiffen(Garment& g, int panel, double bending, double membrane_factor, Shape shape) {
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    if (g.triangle_panel[t] != panel) continue;
    const auto& [a, b, c] = g.triangle_uv[t];
    if (!shape.may_cover(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c))) continue;
    const double share = covered_share(g.triangle_uv[t], shape);
    g.triangle_added_bending[t] += share * bending;
    g.triangle_membrane_factor[t] *= 1 + share * (membrane_factor - 1);
  }
}

void pad(Garment& g, int panel, double thickness, const BoardShape& shape) {
  const std::vector<Vec2> outline = shape.outline();
  g.triangle_padding.resize(g.triangles.size(), 0.0);
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const auto& [a, b, c] = g.triangle_uv[t];
    if (g.triangle_panel[t] == panel && pattern::inside_polygon(outline, (a + b + c) / 3))
      g.triangle_padding[t] = std::max(g.triangle_padding[t], thickness);
  }
}

void add(Garment& g, int panel, const std::string& name, const Board& board,
         const fabric::Material& material) {
  const BoardShape shape(board);
  const std::vector<Vec2> samples = shape.samples();
  for (const Vec2& p : samples) add_mass(g, panel, p, board.mass / double(samples.size()));
  g.mass += board.mass;
  if (board.side == Board::Side::inside && board.thickness > 0)
    pad(g, panel, board.thickness, shape);
  if (board.is_rigid()) return add_rigid_board(g, panel, name, board);
  const SheetStiffness sheet = sheet_stiffness(board, material);
  stiffen(g, panel, sheet.bending, sheet.membrane_factor, shape);
}

void add(Garment& g, int panel, const std::string&, const Cable& cable, const fabric::Material&) {
  for (std::size_t i = 0; i + 1 < cable.path.size(); ++i) {
    const Vec2 &a = cable.path[i], &b = cable.path[i + 1];
    const double length = (b - a).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kCableStep)));
    for (int s = 0; s < steps; ++s)
      add_mass(g, panel, a + (s + 0.5) / steps * (b - a), cable.linear_density * length / steps);
    g.mass += cable.linear_density * length;
  }
  stiffen(g, panel, cable.bending / cable.width, 1, PathStrip(cable.path, cable.width));
  lay_band(g, panel, cable);
}

}  // namespace

void attach(Garment& garment, const pattern::Pattern& pattern,
            const std::vector<Attachment>& attachments, const fabric::Material& material) {
  check_rigid_boards(attachments);
  for (const Attachment& attachment : attachments) {
    const int panel = check_attachment(attachment, pattern);
    std::visit([&](const auto& part) { add(garment, panel, attachment.name, part, material); },
               attachment.part);
  }
}

}  // namespace loosefit::garment
