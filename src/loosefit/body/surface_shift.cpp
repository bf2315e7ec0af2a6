#include "loosefit/body/surface_shift.h"

#include <tbb/parallel_for.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/body/facing_skin.h"
#include "loosefit/body/lay_person.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::body {
namespace {

using geometry::ClosestPoint;
using geometry::ClosestPointTree;
using geometry::TriangleMesh;

// Weight of smoothness against one vertex that knows its place: from stiff to supple.
constexpr std::array kStiffness = {8.0, 4.0, 2.0, 2.0, 2.0};
constexpr double kReach = 0.03;      // farther skin of the scan is somebody's else [m]
constexpr double kHairReach = 0.12;  // farther off than that nothing hangs round a neck [m]
constexpr double kSameSide = 0.5;    // least cosine between the normals
constexpr double kPassed = 0.02;     // depth to which skin may have passed through other skin [m]
constexpr double kAlone = 1e-4;      // of the shift itself, where no neighbour knows its place

constexpr std::size_t kStandOffSamples = 3000;  // of the scan's vertices
constexpr std::size_t kSegments = 9;

bool is_covered(Segment s) {
  return s != Segment::head && s != Segment::hand && s != Segment::foot;
}

/// `lacks`: per vertex, whether it is of a limb that the scan does not have.
RegistrationError error_of(const LaidSkin& laid, const BodyModel& model, const TriangleMesh& scan,
                           const ClosestPointTree& tree, const std::vector<char>& lacks) {
  std::vector<double> distances;
  const auto counts = [&](std::size_t v) { return is_covered(model.segments()[v]) && !lacks[v]; };
  for (std::size_t v = 0; v < laid.surface.size(); v += 7)
    if (counts(v)) distances.push_back(tree.query(laid.surface[v]).distance);
  const TriangleMesh mesh{laid.surface, laid.triangles};
  const ClosestPointTree back(mesh);
  const std::size_t step = std::max<std::size_t>(1, scan.vertices.size() / distances.size());
  for (std::size_t v = 0; v < scan.vertices.size(); v += step) {
    const ClosestPoint c = back.query(scan.vertices[v]);
    if (counts(std::size_t(laid.triangles[std::size_t(c.triangle)][0])))
      distances.push_back(c.distance);
  }
  std::ranges::sort(distances);
  return {distances[distances.size() / 2], distances[distances.size() * 95 / 100]};
}

StandOff stand_off_of(const LaidSkin& laid, const BodyModel& model, const TriangleMesh& scan) {
  const TriangleMesh mesh{laid.surface, laid.triangles};
  const ClosestPointTree tree(mesh);
  std::array<int, kSegments> seen{}, off{};
  const std::size_t step = std::max<std::size_t>(1, scan.vertices.size() / kStandOffSamples);
  for (std::size_t v = 0; v < scan.vertices.size(); v += step) {
    const ClosestPoint c = tree.query(scan.vertices[v]);
    const auto& [p, q, r] = laid.triangles[std::size_t(c.triangle)];
    const Segment segment = model.segments()[std::size_t(p)];
    if (!is_covered(segment)) continue;
    const Vec3 outward = geometry::triangle_normal(
        laid.surface[std::size_t(p)], laid.surface[std::size_t(q)], laid.surface[std::size_t(r)]);
    ++seen[std::size_t(segment)];
    off[std::size_t(segment)] += outward.dot(scan.vertices[v] - c.point) > kStandOff;
  }
  StandOff found;
  const auto share = [](int part, int whole) { return whole == 0 ? 0.0 : double(part) / whole; };
  found.share = share(std::accumulate(off.begin(), off.end(), 0),
                      std::accumulate(seen.begin(), seen.end(), 0));
  for (std::size_t s = 0; s < kSegments; ++s)
    if (const double of_its_own = share(off[s], seen[s]); of_its_own > found.most_share) {
      found.most_share = of_its_own;
      found.most = static_cast<Segment>(s);
    }
  return found;
}

/// Fills in what the scan has over the model's neck. A scan may end there, so that few of its
/// points tell: the skin of the model is asked instead, from which the scan lies along the normal.
template <class NormalOf>
void look_at_neck(StandOff& found, const LaidSkin& laid, const BodyModel& model,
                  const ClosestPointTree& scan, const NormalOf& scan_normal) {
  const auto outward = geometry::vertex_normals(laid.surface, laid.triangles);
  int all = 0, seen = 0, off = 0;
  for (std::size_t v = 0; v < laid.surface.size(); ++v) {
    if (model.segments()[v] != Segment::neck) continue;
    ++all;
    const Vec3& n = outward[v];
    const auto faces = [&](int t) { return scan_normal(t).dot(n) > kSameSide; };
    const ClosestPoint c = scan.query(laid.surface[v], kHairReach, faces);
    if (c.triangle < 0) continue;
    const Vec3 to_scan = c.point - laid.surface[v];
    const double out = to_scan.dot(n);
    // Sideways lies the rim where a scan ends.
    if ((to_scan - out * n).norm() > std::max(kStandOff, std::abs(out))) continue;
    ++seen;
    off += out > kStandOff;
  }
  found.neck_seen = all == 0 ? 0 : double(seen) / all;
  found.neck_share = seen == 0 ? 0 : double(off) / seen;
}

/// Whether other skin faces a vertex nearby: in armpits, between the thighs, under hanging arms.
std::vector<char> hidden_vertices(const LaidSkin& laid, const std::vector<Vec3>& outward,
                                  int count) {
  const TriangleMesh mesh{laid.surface, laid.triangles};
  const ClosestPointTree tree(mesh);
  std::vector<char> hidden(std::size_t(count), 0);
  tbb::parallel_for(std::size_t{0}, hidden.size(), [&](std::size_t v) {
    const Vec3 &p = laid.surface[v], &n = outward[v];
    const auto normal_of = [&](int t) -> Vec3 {
      return outward[std::size_t(laid.triangles[std::size_t(t)][0])];
    };
    const auto opposite = [&](int t) { return normal_of(t).dot(n) < -kSameSide; };
    // Ahead, or passed through where the model's flesh does not give way.
    hidden[v] = faces_skin(tree, normal_of, p, n) || tree.query(p, kPassed, opposite).triangle >= 0;
  });
  return hidden;
}

}  // namespace

RegisteredPerson lay_skin(const BodyModel& model, const TriangleMesh& scan,
                          const PosedPerson& person, std::vector<MissingLimb> missing) {
  const BodyData& data = model.data();
  const auto count = Eigen::Index(data.body_vertices);
  const ClosestPointTree tree(scan);
  const std::vector<Vec3> normals = geometry::smooth_normals(scan);
  const auto scan_normal = [&](int t) -> const Vec3& { return normals[std::size_t(t)]; };
  std::set<std::pair<int, int>> edges;
  for (const auto& quad : data.quads)
    for (std::size_t i = 0; i < 4; ++i) edges.insert(std::minmax(quad[i], quad[(i + 1) % 4]));

  RegisteredPerson result;
  result.person = person;
  std::vector<char> lacks(model.segments().size(), 0);
  for (const MissingLimb& limb : missing)
    for (const int v : limb.vertices) lacks[std::size_t(v)] = 1;
  result.missing = std::move(missing);
  std::vector<Vec3> shift(std::size_t(count), Vec3::Zero());
  LaidSkin laid = lay(model, result.person);
  result.of_model = error_of(laid, model, scan, tree, lacks);
  result.stand_off = stand_off_of(laid, model, scan);
  look_at_neck(result.stand_off, laid, model, tree, scan_normal);
  std::vector<Vec3> moved(std::size_t(count), Vec3::Zero());  // so far, in the scan's frame
  for (const double stiffness : kStiffness) {
    const auto outward = geometry::vertex_normals(laid.surface, laid.triangles);
    std::vector<char> pressed = hidden_vertices(laid, outward, data.body_vertices);
    std::vector<ClosestPoint> closest(pressed.size());
    tbb::parallel_for(std::size_t{0}, pressed.size(), [&](std::size_t v) {
      const auto faces = [&](int t) { return scan_normal(t).dot(outward[v]) > kSameSide; };
      const ClosestPoint& c = closest[v] = tree.query(laid.surface[v], kReach, faces);
      if (c.triangle >= 0 && !pressed[v])
        pressed[v] = faces_skin(tree, scan_normal, c.point, scan_normal(c.triangle));
    });
    // Skin that is pressed drags its neighbours along.
    const std::vector<char> touched = pressed;
    for (const auto& [a, b] : edges)
      if (touched[std::size_t(a)] || touched[std::size_t(b)])
        pressed[std::size_t(a)] = pressed[std::size_t(b)] = 1;
    // Smooth shifts: Σ |d - target|² + stiffness Σ |d_i - d_j|² over the edges.
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(count, 3);
    for (Eigen::Index v = 0; v < count; ++v) {
      double known = kAlone;
      const auto i = std::size_t(v);
      const Vec3& n = outward[i];
      const Segment segment = model.segments()[i];
      if (segment != Segment::hand && segment != Segment::foot && !pressed[i] && !lacks[i] &&
          closest[i].triangle >= 0) {
        known = 1;
        right.row(v) = (moved[i] + n * n.dot(closest[i].point - laid.surface[i])).transpose();
      }
      entries.emplace_back(v, v, known);
    }
    for (const auto& [a, b] : edges) {
      entries.emplace_back(a, a, stiffness), entries.emplace_back(b, b, stiffness);
      entries.emplace_back(a, b, -stiffness), entries.emplace_back(b, a, -stiffness);
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success)
      throw GeometryError("the skin of a scan cannot be laid: its shifts have no solution");
    const Eigen::MatrixX3d solved = solver.solve(right);
    // Into the rest posture. What Catmull-Clark smooths away of a shift comes with the next round.
    for (Eigen::Index v = 0; v < count; ++v) {
      const auto i = std::size_t(v);
      const Vec3 more = solved.row(v).transpose() - moved[i];
      const Mat3 linear = result.person.place.linear() * laid.maps[i].leftCols<3>();
      shift[i] += linear.inverse() * more;
      moved[i] += more;
    }
    result.person.parameters.shift = std::make_shared<const std::vector<Vec3>>(shift);
    laid = lay(model, result.person);
  }
  result.error = error_of(laid, model, scan, tree, lacks);
  return result;
}

}  // namespace loosefit::body
