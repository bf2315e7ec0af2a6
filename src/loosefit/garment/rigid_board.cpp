#include "loosefit/garment/rigid_board.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/garment/board_shape.h"
#include "loosefit/geometry/closest_point.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::garment {
namespace {

Vec3 lift(const Vec2& p) { return {p.x(), p.y(), 0}; }

std::vector<int> covered_triangles(const Garment& g, int panel, const Board& board) {
  std::set<int> taken;
  for (const Garment::RigidBoard& other : g.rigid_boards)
    taken.insert(other.vertices.begin(), other.vertices.end());
  const BoardShape shape(board);
  const std::vector<Vec2> outline = shape.outline();
  std::vector<int> covered;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(g.triangles.size()); ++t) {
    if (g.triangle_panel[t] != panel) continue;
    if (std::ranges::any_of(g.triangles[t], [&](int v) { return taken.count(v) > 0; })) continue;
    const auto& [a, b, c] = g.triangle_uv[t];
    if (pattern::inside_polygon(outline, (a + b + c) / 3)) covered.push_back(t);
    const Vec3 w = geometry::closest_barycentric(lift(board.centre), lift(a), lift(b), lift(c));
    const double distance = (w[0] * a + w[1] * b + w[2] * c - board.centre).norm();
    if (distance < least) least = distance, nearest = t;
  }
  if (covered.empty() && nearest >= 0 && least < shape.breadth()) covered.push_back(nearest);
  return covered;
}

/// Two that lie farthest apart, and the one that makes the largest triangle with them,
/// counter-clockwise.
std::array<int, 3> far_apart(const std::vector<Vec2>& places) {
  std::array<int, 3> found{0, 1, 2};
  const int n = static_cast<int>(places.size());
  double most = -1;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      if (const double d = (places[i] - places[j]).squaredNorm(); d > most)
        most = d, found[0] = i, found[1] = j;
  double widest = 0;
  for (int k = 0; k < n; ++k) {
    const double area =
        geometry::cross(places[found[1]] - places[found[0]], places[k] - places[found[0]]);
    if (std::abs(area) > std::abs(widest)) widest = area, found[2] = k;
  }
  if (widest < 0) std::swap(found[0], found[1]);
  return found;
}

Vec3 barycentric(const Vec2& p, const std::array<Vec2, 3>& corner) {
  const double whole = geometry::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double b = geometry::cross(p - corner[0], corner[2] - corner[0]) / whole;
  const double c = geometry::cross(corner[1] - corner[0], p - corner[0]) / whole;
  return {1 - b - c, b, c};
}

}  // namespace

void add_rigid_board(Garment& g, int panel, const std::string& name, const Board& board) {
  Garment::RigidBoard rigid;
  rigid.name = name;
  rigid.triangles = covered_triangles(g, panel, board);
  if (rigid.triangles.empty()) return;
  std::map<int, Vec2> place;  // a vertex of a dart has two: the first will do
  for (int t : rigid.triangles) {
    rigid.area += geometry::flat_area(g.triangle_uv[t]);
    for (int k = 0; k < 3; ++k) place.try_emplace(g.triangles[t][k], g.triangle_uv[t][k]);
  }
  std::vector<Vec2> places;
  for (const auto& [vertex, at] : place) {
    rigid.vertices.push_back(vertex);
    places.push_back(at);
  }
  const std::array<int, 3> far = far_apart(places);
  for (int k = 0; k < 3; ++k) {
    rigid.leaders[k] = rigid.vertices[far[k]];
    rigid.leader_uv[k] = places[far[k]];
  }
  for (const Vec2& at : places) rigid.weights.push_back(barycentric(at, rigid.leader_uv));
  rigid.mass = board.mass;
  rigid.offset = (board.side == Board::Side::outside ? 0.5 : -0.5) * board.thickness;
  g.rigid_boards.push_back(std::move(rigid));
}

void check_rigid_boards(const std::vector<Attachment>& attachments) {
  for (std::size_t i = 0; i < attachments.size(); ++i) {
    const auto* one = std::get_if<Board>(&attachments[i].part);
    if (!one || !one->is_rigid()) continue;
    for (std::size_t j = 0; j < i; ++j) {
      const auto* other = std::get_if<Board>(&attachments[j].part);
      if (!other || !other->is_rigid() || attachments[i].panel != attachments[j].panel) continue;
      const auto over = [](const Board& a, const Board& b) {
        const BoardShape shape(b);
        return std::ranges::any_of(BoardShape(a).samples(),
                                   [&](const Vec2& p) { return shape.covers(p); });
      };
      if (over(*one, *other) || over(*other, *one))
        throw InvalidInput(InputPlace{{}, 0, "attachment " + attachments[i].name + ".position"},
                           "a rigid board over the rigid board " + attachments[j].name,
                           "boards beside each other",
                           "one board with the mass of both is as stiff as the two");
    }
  }
}

}  // namespace loosefit::garment
