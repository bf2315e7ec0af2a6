#include "loosefit/render/clear_of_cloth.h"

#include <algorithm>
#include <limits>

namespace loosefit::render {
namespace {
constexpr double kClearance = 0.003;    // [m]
constexpr double kUnderCloth = 0.0015;  // [m]
constexpr double kPokesOut = 0.008;  // what is farther out of the cloth is not meant to be in [m]
constexpr double kAlike = 0.6;       // cosine between cloth and form that lie on each other
constexpr double kAbove = 0.9;       // cosine: a place lies above cloth, not beside its edge
constexpr double kFarBack = 0.002;   // what is held back farther goes with its neighbours [m]
constexpr double kCrease = 0.7;      // cosine between skin and form
constexpr int kRoundsTogether = 8;
constexpr int kRounds = 2;

Vec3 normal_at(const geometry::TriangleMesh& mesh, int triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return geometry::triangle_normal(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
}

/// Whether a place is in the skin: cloth beside an arm, on the trunk, is not.
bool within(const geometry::ClosestPointTree& skin, const Vec3& p) {
  const geometry::ClosestPoint nearest = skin.query(p);
  return normal_at(skin.mesh(), nearest.triangle).dot(p - nearest.point) < kUnderCloth;
}

/// Presses what pokes out of the cloth under it, but for creases.
void press_under(std::vector<Vec3>& places, const std::vector<Vec3>& normals,
                 const std::vector<char>& creased, const geometry::ClosestPointTree& skin,
                 const geometry::ClosestPointTree& tree) {
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t v = 0; v < places.size(); ++v) {
      if (creased[v]) continue;
      const geometry::ClosestPoint nearest = tree.query(places[v], kPokesOut);
      if (nearest.triangle < 0) continue;
      const Vec3 n = normal_at(tree.mesh(), nearest.triangle);
      const double along = n.dot(normals[v]), out = n.dot(places[v] - nearest.point);
      if (along < kAlike || out < -kUnderCloth) continue;
      if (std::abs(out) < kAbove * nearest.distance || !within(skin, nearest.point)) continue;
      places[v] -= (out + kUnderCloth) / along * normals[v];
    }
}

}  // namespace

std::vector<Vec3> clear_of_cloth(const geometry::ClosestPointTree& skin,
                                 const std::vector<Vec3>& smooth, const std::vector<Vec3>& normals,
                                 const geometry::TriangleMesh& cloth) {
  if (cloth.triangles.empty()) return smooth;
  const geometry::ClosestPointTree tree(cloth);
  const std::vector<Vec3>& from = skin.mesh().vertices;
  // In a crease there is no inwards: it would lead through the cloth of the other side.
  const std::vector<Vec3> skin_normals = geometry::vertex_normals(from, skin.mesh().triangles);
  std::vector<char> creased(from.size());
  for (std::size_t v = 0; v < from.size(); ++v)
    creased[v] = skin_normals[v].dot(normals[v]) < kCrease;
  std::vector<double> room(from.size(), std::numeric_limits<double>::infinity());
  // As near to a wanted place as there is room.
  const auto held = [&](std::size_t v, const Vec3& wanted) {
    const Vec3 way = wanted - from[v];
    const Vec3 inwards =
        creased[v] ? Vec3::Zero() : Vec3(std::min(way.dot(normals[v]), 0.0) * normals[v]);
    const Vec3 rest = way - inwards;
    const double length = rest.norm();
    return length <= room[v] ? wanted : Vec3(from[v] + inwards + room[v] / length * rest);
  };
  std::vector<Vec3> places = smooth;
  std::vector<char> stopped(from.size(), 0);
  for (std::size_t v = 0; v < from.size(); ++v) {
    const double length = (smooth[v] - from[v]).norm();
    if (length == 0) continue;
    const geometry::ClosestPoint nearest = tree.query(from[v], length + kClearance);
    if (nearest.triangle < 0) continue;
    room[v] = std::max(0.0, nearest.distance - kClearance);
    places[v] = held(v, smooth[v]);
    stopped[v] = (places[v] - smooth[v]).norm() > kFarBack;
  }
  // Those held back go with their neighbours, or they would crumple.
  for (int round = 0; round < kRoundsTogether; ++round) {
    std::vector<Vec3> sum(from.size(), Vec3::Zero());
    std::vector<int> count(from.size(), 0);
    for (const Triangle& t : skin.mesh().triangles)
      for (int k = 0; k < 3; ++k)
        if (const int v = t[k]; stopped[v]) {
          sum[v] += places[t[(k + 1) % 3]] + places[t[(k + 2) % 3]];
          count[v] += 2;
        }
    for (std::size_t v = 0; v < from.size(); ++v)
      if (stopped[v]) places[v] = held(v, sum[v] / count[v]);
  }
  press_under(places, normals, creased, skin, tree);
  return places;
}

}  // namespace loosefit::render
