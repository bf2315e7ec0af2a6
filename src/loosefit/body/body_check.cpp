#include "loosefit/body/body_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/body/mesh_repair.h"
#include "loosefit/body/scan_parts.h"
#include "loosefit/body/surface_topology.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::body {
namespace {

constexpr double kWeldDistance = 1e-6;  // share of the longest extent
constexpr double kSmallPiece = 0.05;    // share of the area that may be dropped
constexpr double kSpeck = 0.003;        // share of the area below which a piece is no part
constexpr std::size_t kMostHoles = 20;

double longest_extent(const geometry::TriangleMesh& mesh) {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  for (const auto& p : mesh.vertices) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  return (upper - lower).maxCoeff();
}

/// Along the up axis, which is the longer of y and z where nobody says it; arms held level may be
/// wider.
double stature(const geometry::TriangleMesh& mesh, const ScanOptions& options) {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  for (const auto& p : mesh.vertices) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  const Vec3 extent = upper - lower;
  if (options.up == "y" || options.up == "z") return options.up == "y" ? extent.y() : extent.z();
  return std::max(extent.y(), extent.z());
}

double area_of(const std::vector<Vec3>& vertices, auto first, auto last) {
  double area = 0;
  for (; first != last; ++first)
    area += geometry::triangle_area(vertices[std::size_t((*first)[0])],
                                    vertices[std::size_t((*first)[1])],
                                    vertices[std::size_t((*first)[2])]);
  return area;
}

std::string counted(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// Where somebody finds a point again in the program that the scan came from.
std::string in_file(const Vec3& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x(), p.y(), p.z());
}

/// Whether two surfaces have their vertices in the same places.
bool are_alike(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b, double near) {
  if (a.vertices.size() != b.vertices.size() || a.triangles.size() != b.triangles.size())
    return false;
  const auto sorted = [](std::vector<Vec3> points) {
    std::ranges::sort(points, [](const Vec3& p, const Vec3& q) {
      return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
    });
    return points;
  };
  const std::vector<Vec3> p = sorted(a.vertices), q = sorted(b.vertices);
  for (std::size_t i = 0; i < p.size(); ++i)
    if ((p[i] - q[i]).norm() > near) return false;
  return true;
}

void keep_largest_piece(geometry::TriangleMesh& mesh, const ScanOptions& options,
                        std::vector<std::string>& warnings) {
  const auto pieces = connected_pieces(mesh);
  if (pieces.size() <= 1) return;
  double total = 0;
  for (const auto& piece : pieces) total += piece.area;
  const double dropped = total - pieces[0].area;
  if (dropped > kSmallPiece * total) {
    const Triangle& second = mesh.triangles[std::size_t(pieces[1].triangles[0])];
    throw GeometryError(
        {options.file, 0, ""},
        fmt::format("{} surfaces that do not hang together, the largest with {:.0f} % of the area, "
                    "the next with {:.0f} %, near {} of the file",
                    pieces.size(), 100 * pieces[0].area / total, 100 * pieces[1].area / total,
                    in_file(mesh.vertices[std::size_t(second[0])])),
        "one person in one closed surface",
        "delete what is not the person (floor, turntable, a second person), and join what is");
  }
  keep_piece(mesh, pieces[0]);
  warnings.push_back(counted(pieces.size() - 1, "small separate piece", "small separate pieces") +
                     " dropped");
}

/// Drops what is too small for a part of a person, and parts that are there already. Returns
/// whether several are left.
bool keep_parts(geometry::TriangleMesh& mesh, double near, std::vector<std::string>& warnings) {
  const auto pieces = connected_pieces(mesh);
  double total = 0;
  for (const auto& piece : pieces) total += piece.area;
  std::vector<geometry::TriangleMesh> parts;
  std::size_t specks = 0, repeated = 0;
  for (const auto& piece : pieces) {
    if (piece.area < kSpeck * total) {
      ++specks;
      continue;
    }
    geometry::TriangleMesh part = mesh;
    keep_piece(part, piece);
    const bool again = std::ranges::any_of(
        parts, [&](const geometry::TriangleMesh& other) { return are_alike(part, other, near); });
    if (again)
      ++repeated;
    else
      parts.push_back(std::move(part));
  }
  if (specks > 0)
    warnings.push_back(counted(specks, "small separate piece", "small separate pieces") +
                       " dropped");
  if (repeated > 0)
    warnings.push_back(counted(repeated, "surface", "surfaces") +
                       " dropped that the file has twice");
  if (specks + repeated > 0) {
    mesh = {};
    for (const geometry::TriangleMesh& part : parts) {
      const int base = int(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
      for (const Triangle& t : part.triangles)
        mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
  }
  return parts.size() > 1;
}

void require_two_faces_at_edges(const geometry::TriangleMesh& mesh, const ScanOptions& options) {
  const EdgeReport edges = inspect_edges(mesh);
  if (edges.crowded == 0) return;
  throw GeometryError(
      {options.file, 0, ""},
      fmt::format("{} where more than two faces meet, one near {} of the file",
                  counted(std::size_t(edges.crowded), "edge", "edges"), in_file(edges.place)),
      "two faces at every edge", "remove inner walls and doubled faces there");
}

void orient(geometry::TriangleMesh& mesh, const ScanOptions& options,
            std::vector<std::string>& warnings) {
  switch (orient_consistently(mesh)) {
    case Orientation::impossible:
      throw GeometryError({options.file, 0, ""},
                          "a surface with one side only (a band with a twist in it)",
                          "a surface with an inside and an outside",
                          "make the surface again from the points of the scan, closed "
                          "(\"watertight\")");
    case Orientation::repaired:
      warnings.push_back("faces of mixed orientation were turned to agree");
      break;
    case Orientation::consistent:
      break;
  }
}

void fill_small_holes(geometry::TriangleMesh& mesh, const ScanOptions& options,
                      std::vector<std::string>& warnings) {
  const std::vector<Hole> holes = find_holes(mesh);
  if (holes.empty()) return;
  const double widest = options.widest_hole * stature(mesh, options);
  const auto too_wide =
      std::count_if(holes.begin(), holes.end(), [&](const Hole& h) { return h.width > widest; });
  // Holes that are too wide to be guessed: refused with where they are.
  if (too_wide > 0) {
    std::string places;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, std::size_t(too_wide)); ++i)
      places += fmt::format("{}{:.3g} wide near {}", i == 0 ? "" : "; ", holes[i].width,
                            in_file(holes[i].centre));
    throw GeometryError({options.file, 0, ""},
                        fmt::format("an open surface: {} that {} too wide to be filled, in units "
                                    "of the file: {}",
                                    counted(std::size_t(too_wide), "hole", "holes"),
                                    too_wide == 1 ? "is" : "are", places),
                        fmt::format("a closed surface, or holes of at most {:.3g} ({:g} % of the "
                                    "height)",
                                    widest, 100 * options.widest_hole),
                        "close them in the program that the scan came from; soles, crotch, armpits "
                        "and the crown are usual places");
  }
  // Fill the others and see how much of the skin is then a guess.
  const auto scanned = std::ptrdiff_t(mesh.triangles.size());
  for (const auto& hole : holes) fill_hole(mesh, hole);
  const auto first = mesh.triangles.begin();
  const double guessed = area_of(mesh.vertices, first + scanned, mesh.triangles.end()) /
                         area_of(mesh.vertices, first, mesh.triangles.end());
  if (holes.size() > kMostHoles || guessed > options.most_filled)
    throw GeometryError(
        {options.file, 0, ""},
        fmt::format("an open surface: {} with {:.1f} % of the skin, the widest {:.3g} wide near {}",
                    counted(holes.size(), "hole", "holes"), 100 * guessed, holes[0].width,
                    in_file(holes[0].centre)),
        fmt::format("a closed surface, or at most {} holes with at most {:g} % of the skin",
                    kMostHoles, 100 * options.most_filled),
        "close them in the program that the scan came from, which knows more of the skin than "
        "their rims");
  // What was filled is said.
  warnings.push_back(fmt::format(
      "{} filled, the widest {:.3g} wide near {} (units of the file): the skin there is a guess",
      counted(holes.size(), "small hole", "small holes"), holes[0].width,
      in_file(holes[0].centre)));
}

void warn_of_crossings(CheckedSurface& checked) {
  const geometry::TriangleMesh& mesh = checked.mesh;
  const auto crossings = geometry::self_intersections(mesh.vertices, mesh.triangles);
  if (crossings.empty()) return;
  const Vec3& p = mesh.vertices[std::size_t(mesh.triangles[std::size_t(crossings[0].first)][0])];
  checked.warnings.push_back(
      fmt::format("{} pairs of faces pass through each other, one {:.2f} m above the floor, {:.2f} "
                  "m to the {}; distances there are unreliable",
                  crossings.size(), p.z(), std::abs(p.x()), p.x() < 0 ? "right" : "left"));
}

}  // namespace

CheckedSurface check_surface(geometry::TriangleMesh mesh, const ScanOptions& options) {
  CheckedSurface checked;
  auto& warnings = checked.warnings;
  drop_unused_vertices(mesh);
  int repeated = drop_repeated_triangles(mesh);
  weld_seams(mesh, kWeldDistance * longest_extent(mesh));
  repeated += drop_repeated_triangles(mesh);
  if (repeated > 0)
    warnings.push_back(counted(std::size_t(repeated), "repeated face", "repeated faces") +
                       " dropped");
  const bool in_parts =
      options.take_parts && keep_parts(mesh, kWeldDistance * longest_extent(mesh), warnings);
  if (!in_parts) keep_largest_piece(mesh, options, warnings);
  require_two_faces_at_edges(mesh, options);
  orient(mesh, options, warnings);
  if (!in_parts) fill_small_holes(mesh, options, warnings);
  require_two_faces_at_edges(mesh, options);
  if (turn_parts_outwards(mesh) > 0)
    warnings.push_back("the faces looked inwards: turned outwards");
  checked.from_world = stand_in_our_frame(mesh, options, warnings);
  checked.mesh = std::move(mesh);
  if (options.tell_crossings) warn_of_crossings(checked);
  return checked;
}

}  // namespace loosefit::body
