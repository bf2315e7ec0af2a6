#include "loosefit/render/mannequin.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "loosefit/render/garment_lines.h"

namespace loosefit {
namespace {
constexpr double kNeckShare =
    0.4;  // of the way from the neck joint to the head joint: below the jaw
constexpr double kInsideCloth = 0.03;  // the form ends this far above the hem [m]
constexpr double kThighStub = 0.10;    // of a thigh that is lifted [m]

std::optional<Vec3> joint(const Body& body, const char* name) {
  const auto found = body.joints.find(name);
  return found == body.joints.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

bool below_waist(Segment s) {
  return s == Segment::thigh || s == Segment::shank || s == Segment::foot;
}

bool on_trunk(const Body& body, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  Segment segment = Segment::torso;
  for (std::size_t v = 0; v < body.surface.vertices.size(); ++v)
    if (const double d = (body.surface.vertices[v] - p).squaredNorm(); d < nearest) {
      nearest = d;
      segment = body.segment[v];
    }
  return segment == Segment::torso || below_waist(segment);
}

/// Height along the trunk axis at which the form ends: a little above the mean of the hem.
double hem_height(const Body& body, const Garment& garment, const std::vector<Vec3>& positions,
                  const Vec3& axis, const Vec3& hips, const Vec3& neck) {
  const double middle = 0.5 * (hips + neck).dot(axis);
  double sum = 0;
  int count = 0;
  for (const auto& edge : garment_lines(garment).boundary)
    if (const Vec3& p = positions[edge[0]]; p.dot(axis) < middle && on_trunk(body, p)) {
      sum += p.dot(axis);
      ++count;
    }
  return (count > 0 ? sum / count : hips.dot(axis)) + kInsideCloth;
}

void close_with_fan(TriangleMesh& mesh, const std::vector<std::array<int, 2>>& rim,
                    const Vec3& outwards) {
  if (rim.empty()) return;
  Vec3 centre = Vec3::Zero();
  for (const auto& edge : rim) centre += 0.5 * (mesh.vertices[edge[0]] + mesh.vertices[edge[1]]);
  centre /= static_cast<double>(rim.size());
  for (const auto& edge : rim) {
    // Own vertices, so that the lid is flat and the neck keeps its normals.
    const int first = static_cast<int>(mesh.vertices.size());
    const Vec3 a = mesh.vertices[edge[0]], b = mesh.vertices[edge[1]];
    mesh.vertices.insert(mesh.vertices.end(), {centre, a, b});
    const bool flip = triangle_normal(centre, a, b).dot(outwards) < 0;
    mesh.triangles.push_back({first, first + (flip ? 2 : 1), first + (flip ? 1 : 2)});
  }
}
}  // namespace

TriangleMesh clipped(const TriangleMesh& mesh, const std::vector<double>& keep,
                     std::vector<std::array<int, 2>>* rim) {
  TriangleMesh result;
  std::vector<int> kept(mesh.vertices.size(), -1);
  std::map<std::pair<int, int>, int> split;
  const auto old_vertex = [&](int v) {
    if (kept[v] < 0) {
      kept[v] = static_cast<int>(result.vertices.size());
      result.vertices.push_back(mesh.vertices[v]);
    }
    return kept[v];
  };
  const auto new_vertex = [&](int a, int b) {
    const auto [place, is_new] =
        split.try_emplace(std::minmax(a, b), static_cast<int>(result.vertices.size()));
    if (is_new)
      result.vertices.push_back(mesh.vertices[a] + keep[a] / (keep[a] - keep[b]) *
                                                       (mesh.vertices[b] - mesh.vertices[a]));
    return place->second;
  };
  for (const Triangle& t : mesh.triangles) {
    std::vector<int> corners, cut;
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (keep[a] >= 0) corners.push_back(old_vertex(a));
      if ((keep[a] >= 0) != (keep[b] >= 0)) {
        corners.push_back(new_vertex(a, b));
        cut.push_back(corners.back());
      }
    }
    for (std::size_t k = 2; k < corners.size(); ++k)
      result.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    if (rim && cut.size() == 2) rim->push_back({cut[0], cut[1]});
  }
  return result;
}

TriangleMesh mannequin(const Body& body, const Garment& garment,
                       const std::vector<Vec3>& positions) {
  const std::vector<Vec3>& points = body.surface.vertices;
  const auto neck = joint(body, "neck"), head = joint(body, "head");
  const auto hip_left = joint(body, "hip_L"), hip_right = joint(body, "hip_R");
  double floor = 0, top = 0;
  for (const Vec3& p : points) top = std::max(top, p.z());
  const Vec3 hips = hip_left && hip_right ? Vec3(0.5 * (*hip_left + *hip_right))
                                          : Vec3(0, 0, floor + 0.5 * (top - floor));
  const Vec3 nape = neck.value_or(Vec3(0, 0, floor + 0.85 * (top - floor)));
  const Vec3 axis = (nape - hips).normalized();
  const double hem = hem_height(body, garment, positions, axis, hips, nape);

  // Hem first: the rim of the second cut is then the neck's alone.
  std::vector<double> keep(points.size(), 1.0);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Segment segment = body.segment[v];
    if (segment != Segment::torso && !below_waist(segment)) continue;
    keep[v] = points[v].dot(axis) - hem;
    if (!below_waist(segment)) continue;
    const char* side = body.side[v] >= 0 ? "_L" : "_R";
    const auto hip = joint(body, (std::string("hip") + side).c_str());
    const auto knee = joint(body, (std::string("knee") + side).c_str());
    if (!hip || !knee) continue;
    const Vec3 along = (*knee - *hip).normalized();
    const bool lifted = along.dot(-axis) < 0.8;
    if (lifted) keep[v] = std::min(keep[v], kThighStub - (points[v] - *hip).dot(along));
  }
  TriangleMesh form = clipped(body.surface, keep);
  if (!neck || !head) return form;

  // Across the trunk's axis, not the neck's, which leans forward: seen edge-on from the front.
  const double lid = (*neck + kNeckShare * (*head - *neck)).dot(axis);
  const double reach = 0.6 * (*head - *neck).norm() + 0.15;  // arms may be raised beside the neck
  keep.assign(form.vertices.size(), 1.0);
  for (std::size_t v = 0; v < form.vertices.size(); ++v) {
    const Vec3 from = form.vertices[v] - *neck;
    if ((from - from.dot(axis) * axis).norm() < reach) keep[v] = lid - form.vertices[v].dot(axis);
  }
  std::vector<std::array<int, 2>> rim;
  form = clipped(form, keep, &rim);
  close_with_fan(form, rim, axis);
  return form;
}

}  // namespace loosefit
