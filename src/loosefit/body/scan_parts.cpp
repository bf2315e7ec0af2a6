#include "loosefit/body/scan_parts.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <memory>

#include "loosefit/body/facing_skin.h"
#include "loosefit/body/mesh_repair.h"
#include "loosefit/body/surface_topology.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::body {
namespace {

constexpr double kOnPerson = 0.03;  // [m]
constexpr double kLeastOnIt = 0.5;  // share of a part's vertices
constexpr double kWithin = 0.001;   // deeper inside of another part, skin is nobody's [m]

Vec3 middle_of(const geometry::TriangleMesh& mesh, int t) {
  const Triangle& corner = mesh.triangles[std::size_t(t)];
  return (mesh.vertices[std::size_t(corner[0])] + mesh.vertices[std::size_t(corner[1])] +
          mesh.vertices[std::size_t(corner[2])]) /
         3;
}

Vec3 normal_of(const geometry::TriangleMesh& mesh, int t) {
  const Triangle& corner = mesh.triangles[std::size_t(t)];
  return geometry::triangle_normal(mesh.vertices[std::size_t(corner[0])],
                                   mesh.vertices[std::size_t(corner[1])],
                                   mesh.vertices[std::size_t(corner[2])]);
}

double area_of(const geometry::TriangleMesh& mesh, int t) {
  const Triangle& corner = mesh.triangles[std::size_t(t)];
  return geometry::triangle_area(mesh.vertices[std::size_t(corner[0])],
                                 mesh.vertices[std::size_t(corner[1])],
                                 mesh.vertices[std::size_t(corner[2])]);
}

/// A part by itself, its holes closed.
geometry::TriangleMesh closed_part(geometry::TriangleMesh mesh, const Piece& piece) {
  keep_piece(mesh, piece);
  for (const Hole& hole : find_holes(mesh)) fill_hole(mesh, hole);
  return mesh;
}

/// The same with an index. It stays where it is made.
struct Solid {
  Solid(const geometry::TriangleMesh& mesh, const Piece& piece) : closed(closed_part(mesh, piece)) {
    for (const Vec3& p : closed.vertices) box.extend(p);
    tree = std::make_unique<geometry::ClosestPointTree>(closed);
    for (int t = 0; t < int(closed.triangles.size()); ++t) normals.push_back(normal_of(closed, t));
  }
  bool contains(const Vec3& p) const {
    return box.contains(p) && tree->signed_distance(p) < -kWithin;
  }
  bool faces(const Vec3& p, const Vec3& n) const {
    return box.exteriorDistance(p) < kFacingSkin &&
           faces_skin(
               *tree, [this](int t) { return normals[std::size_t(t)]; }, p, n);
  }
  geometry::TriangleMesh closed;
  Eigen::AlignedBox3d box;
  std::unique_ptr<geometry::ClosestPointTree> tree;
  std::vector<Vec3> normals;
};

}  // namespace

int turn_parts_outwards(geometry::TriangleMesh& mesh) {
  int turned = 0;
  for (const Piece& piece : connected_pieces(mesh)) {
    if (geometry::enclosed_volume(closed_part(mesh, piece)) >= 0) continue;
    ++turned;
    for (const int t : piece.triangles)
      std::swap(mesh.triangles[std::size_t(t)][1], mesh.triangles[std::size_t(t)][2]);
  }
  return turned;
}

SkinOfParts skin_of_parts(const geometry::TriangleMesh& mesh) {
  const std::vector<Piece> pieces = connected_pieces(mesh);
  std::vector<std::unique_ptr<Solid>> solids;
  for (const Piece& piece : pieces) solids.push_back(std::make_unique<Solid>(mesh, piece));
  SkinOfParts skin;
  skin.mesh.vertices = mesh.vertices;
  double all = 0, inside = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const int t : pieces[i].triangles) {
      const Vec3 p = middle_of(mesh, t), n = normal_of(mesh, t);
      bool contained = false, faced = false;
      for (std::size_t k = 0; k < solids.size() && !contained; ++k)
        if (k != i) contained = solids[k]->contains(p), faced = faced || solids[k]->faces(p, n);
      all += area_of(mesh, t);
      if (contained) inside += area_of(mesh, t);
      if (!contained && !faced) skin.mesh.triangles.push_back(mesh.triangles[std::size_t(t)]);
    }
  skin.inside = all > 0 ? inside / all : 0;
  drop_unused_vertices(skin.mesh);
  return skin;
}

std::vector<ForeignPart> foreign_parts(const geometry::TriangleMesh& scan,
                                       const geometry::TriangleMesh& person) {
  const geometry::ClosestPointTree skin(person);
  const std::vector<Piece> pieces = connected_pieces(scan);
  double all = 0;
  for (const Piece& piece : pieces) all += piece.area;
  std::vector<ForeignPart> foreign;
  for (const Piece& piece : pieces) {
    std::size_t on_it = 0;
    Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
    for (const int t : piece.triangles) {
      const Vec3 p = middle_of(scan, t);
      on_it += skin.query(p, kOnPerson).triangle >= 0;
      lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
    }
    if (double(on_it) >= kLeastOnIt * double(piece.triangles.size())) continue;
    const Vec3 size = upper - lower, middle = (lower + upper) / 2;
    foreign.push_back(
        {piece.triangles, piece.area / all,
         fmt::format("{:.2f} by {:.2f} by {:.2f} m, {:.2f} m above the floor, {:.2f} m to the {} "
                     "of the person, with {:.1f} % of the area",
                     size.x(), size.y(), size.z(), middle.z(), std::abs(middle.x()),
                     middle.x() < 0 ? "right" : "left", 100 * piece.area / all)});
  }
  return foreign;
}

}  // namespace loosefit::body
