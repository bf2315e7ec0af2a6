#include "loosefit/body/body_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/body/section.h"
#include "loosefit/body/surface_topology.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit {
namespace {

constexpr double kShortest = 0.5, kTallest = 2.3;  // standing people [m]
constexpr double kWeldDistance = 1e-6;
constexpr double kSmallPiece = 0.05;  // share of the area that may be dropped

struct Box {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;
};

Box box_of(const std::vector<Vec3>& points) {
  Box box;
  for (const auto& p : points) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

double metres_per_unit(const std::string& units, const InputPlace& place) {
  static const std::map<std::string, double> kUnits = {
      {"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}};
  const auto found = kUnits.find(units);
  if (found == kUnits.end())
    throw InvalidInput(place, "units \"" + units + "\"", "m, cm, mm or in");
  return found->second;
}

void scale_to_metres(TriangleMesh& mesh, const ScanOptions& options,
                     std::vector<std::string>& warnings) {
  const InputPlace place{options.file, 0, "units"};
  const Box box = box_of(mesh.vertices);
  const double extent = (box.upper - box.lower).maxCoeff();
  double scale = 0;
  if (!options.units.empty()) {
    scale = metres_per_unit(options.units, place);
  } else {
    for (const char* guess : {"m", "cm", "mm"}) {
      const double metres = extent * metres_per_unit(guess, place);
      if (metres < kShortest || metres > kTallest) continue;
      scale = metres_per_unit(guess, place);
      warnings.push_back(
          fmt::format("no units given: the longest extent {:.4g} is taken as {}", extent, guess));
      break;
    }
  }
  const double metres = extent * scale;
  if (!(metres >= kShortest && metres <= kTallest)) {
    throw InvalidInput(place,
                       options.units.empty() ? fmt::format("a longest extent of {:.4g}", extent)
                                             : fmt::format("a longest extent of {:.4g} m", metres),
                       fmt::format("a person of {:g} to {:g} m", kShortest, kTallest),
                       "give the units of the file: m, cm, mm or in");
  }
  for (auto& p : mesh.vertices) p *= scale;
}

void stand_up(TriangleMesh& mesh, const ScanOptions& options, std::vector<std::string>& warnings) {
  const Box box = box_of(mesh.vertices);
  const Vec3 extent = box.upper - box.lower;
  std::string up = options.up;
  if (up.empty()) {
    up = extent.y() > extent.z() ? "y" : "z";
    warnings.push_back("no up axis given: " + up + " is taken as up, the longer of y and z");
  }
  if (up != "y" && up != "z") {
    throw InvalidInput({options.file, 0, "up"}, "\"" + up + "\"", "y or z");
  }
  if (up == "y") {
    for (auto& p : mesh.vertices) p = Vec3(p.x(), -p.z(), p.y());
  }
  const Box standing = box_of(mesh.vertices);
  const Vec3 size = standing.upper - standing.lower;
  if (size.y() > size.x()) {
    for (auto& p : mesh.vertices) p = Vec3(-p.y(), p.x(), p.z());
    warnings.push_back("the surface is wider along depth than along x: turned by 90 degrees");
  }
}

// Toes stick out in front of the ankles.
void face_forward(TriangleMesh& mesh, std::vector<std::string>& warnings) {
  const Box box = box_of(mesh.vertices);
  const double height = box.upper.z() - box.lower.z();
  double foot = 0, ankle = 0;
  int foot_count = 0, ankle_count = 0;
  double foot_low = 1e9, foot_high = -1e9;
  for (const auto& p : mesh.vertices) {
    const double level = (p.z() - box.lower.z()) / height;
    if (level < 0.025) {
      foot += p.y(), ++foot_count;
      foot_low = std::min(foot_low, p.y()), foot_high = std::max(foot_high, p.y());
    }
    if (level > 0.05 && level < 0.09) ankle += p.y(), ++ankle_count;
  }
  if (foot_count == 0 || ankle_count == 0) return;
  const double middle = ankle / ankle_count;
  if (foot_high - middle > 1.15 * (middle - foot_low)) {
    for (auto& p : mesh.vertices) p = Vec3(-p.x(), -p.y(), p.z());
    warnings.push_back("the toes point to +y: turned by 180 degrees to face -y");
  }
}

void keep_largest_piece(TriangleMesh& mesh, const ScanOptions& options,
                        std::vector<std::string>& warnings) {
  const auto pieces = connected_pieces(mesh);
  if (pieces.size() <= 1) return;
  double total = 0;
  for (const auto& piece : pieces) total += piece.area;
  const double dropped = total - pieces[0].area;
  if (dropped > kSmallPiece * total) {
    throw GeometryError({options.file, 0, ""},
                        fmt::format("{} separate pieces, the largest with {:.0f} % of the area",
                                    pieces.size(), 100 * pieces[0].area / total),
                        "one closed surface", "merge or delete the other pieces");
  }
  keep_piece(mesh, pieces[0]);
  warnings.push_back(fmt::format("{} small separate pieces dropped", pieces.size() - 1));
}

void require_closed(const TriangleMesh& mesh, const ScanOptions& options) {
  const EdgeReport edges = inspect_edges(mesh);
  if (edges.open > 0) {
    throw GeometryError(
        {options.file, 0, ""},
        fmt::format("an open surface: {} edges without a neighbour in {} holes, the "
                    "largest near ({:.2f}, {:.2f}, {:.2f}) m",
                    edges.open, edges.holes, edges.place.x(), edges.place.y(), edges.place.z()),
        "a closed surface", "fill the holes first (soles, crotch, armpits, crown)");
  }
  if (edges.crowded > 0) {
    throw GeometryError(
        {options.file, 0, ""},
        fmt::format("{} edges with more than two faces, one near ({:.2f}, {:.2f}, {:.2f}) m",
                    edges.crowded, edges.place.x(), edges.place.y(), edges.place.z()),
        "two faces at every edge", "remove inner or doubled faces");
  }
}

// Sideways by head and shoulders, which have no arms beside them; in depth by the trunk's waist.
void centre(TriangleMesh& mesh) {
  const Box box = box_of(mesh.vertices);
  const double height = box.upper.z() - box.lower.z();
  double x = 0;
  int count = 0;
  for (const auto& p : mesh.vertices) {
    const double level = (p.z() - box.lower.z()) / height;
    if (level > 0.80 && level < 0.98) x += p.x(), ++count;
  }
  x /= std::max(1, count);
  const double waist = box.lower.z() + 0.62 * height;
  Box trunk;
  const auto loops = plane_section(mesh, Vec3(0, 0, waist), Vec3::UnitZ());
  if (const SectionLoop* loop = trunk_loop(loops, x)) trunk = box_of(loop->points);
  const double y =
      trunk.lower.y() < trunk.upper.y() ? 0.5 * (trunk.lower.y() + trunk.upper.y()) : 0;
  for (auto& p : mesh.vertices) p -= Vec3(x, y, box.lower.z());
}

}  // namespace

CheckedSurface check_surface(TriangleMesh mesh, const ScanOptions& options) {
  CheckedSurface checked;
  scale_to_metres(mesh, options, checked.warnings);
  weld(mesh, kWeldDistance);
  keep_largest_piece(mesh, options, checked.warnings);
  require_closed(mesh, options);
  switch (orient_consistently(mesh)) {
    case Orientation::impossible:
      throw GeometryError({options.file, 0, ""}, "a one-sided surface", "a surface with an inside");
    case Orientation::repaired:
      checked.warnings.push_back("faces of mixed orientation were turned to agree");
      break;
    case Orientation::consistent:
      break;
  }
  if (enclosed_volume(mesh) < 0) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    checked.warnings.push_back("the faces looked inwards: turned outwards");
  }
  stand_up(mesh, options, checked.warnings);
  face_forward(mesh, checked.warnings);
  centre(mesh);
  const auto crossings = self_intersections(mesh.vertices, mesh.triangles);
  if (!crossings.empty()) {
    const Vec3& p = mesh.vertices[std::size_t(mesh.triangles[std::size_t(crossings[0].first)][0])];
    checked.warnings.push_back(
        fmt::format("{} pairs of faces intersect each other, one near ({:.2f}, {:.2f}, {:.2f}) m; "
                    "distances there are unreliable",
                    crossings.size(), p.x(), p.y(), p.z()));
  }
  checked.mesh = std::move(mesh);
  return checked;
}

}  // namespace loosefit
