#include "loosefit/body/body_partner.h"

#include <algorithm>
#include <array>

#include "loosefit/base/error.h"

namespace loosefit::body {
namespace {
geometry::TriangleMesh point_mesh(const std::vector<Vec3>& vertices) {
  geometry::TriangleMesh mesh;
  mesh.vertices = vertices;
  for (int v = 0; v < static_cast<int>(vertices.size()); ++v) mesh.triangles.push_back({v, v, v});
  return mesh;
}

BodyPart part_of_vertex(const Body& body, int vertex) {
  switch (body.segment[vertex]) {
    case Segment::upper_arm:
    case Segment::forearm:
    case Segment::hand:
      return body.side[vertex] >= 0 ? BodyPart::arm_left : BodyPart::arm_right;
    case Segment::thigh:
    case Segment::shank:
    case Segment::foot:
      return body.side[vertex] >= 0 ? BodyPart::leg_left : BodyPart::leg_right;
    default:
      return BodyPart::trunk;
  }
}
}  // namespace

PartnerFinder::Particles::Particles(const std::vector<Vec3>& vertices)
    : mesh(point_mesh(vertices)), tree(mesh) {}

PartnerFinder::PartnerFinder(const Body& body, const geometry::ClosestPointTree& surface)
    : body_(body), tree_(surface), faces_of_vertex_(body.surface.vertices.size()) {
  if (body.segment.size() != body.surface.vertices.size() ||
      body.side.size() != body.segment.size() || body.normals.size() != body.segment.size())
    throw InvalidInput("maps need a body with a segment, a side and a normal for every vertex");
  const auto& triangles = body.surface.triangles;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    const Triangle& c = triangles[t];
    face_normals_.push_back(geometry::triangle_normal(
        body.surface.vertices[c[0]], body.surface.vertices[c[1]], body.surface.vertices[c[2]]));
    for (int v : c) faces_of_vertex_[v].push_back(t);
  }
}

const geometry::ClosestPointTree& PartnerFinder::particle_tree() const {
  return particles_.get([&] { return Particles(body_.surface.vertices); }).tree;
}

bool PartnerFinder::belongs(int vertex, BodyPart part) const {
  const BodyPart own = part_of_vertex(body_, vertex);
  if (own == part) return true;
  const Segment segment = body_.segment[vertex];
  switch (part) {
    case BodyPart::trunk:
      return segment != Segment::forearm && segment != Segment::hand;
    case BodyPart::both_legs:
      return own == BodyPart::leg_left || own == BodyPart::leg_right || segment == Segment::torso;
    case BodyPart::trunk_and_arms:
      return true;
    case BodyPart::leg_left:
    case BodyPart::leg_right:
      return segment == Segment::torso || segment == Segment::thigh;
    default:
      return segment == Segment::torso;
  }
}

BodyPart PartnerFinder::part_of(const std::vector<Vec3>& points,
                                const std::vector<Vec3>& normals) const {
  constexpr double kOtherLeg = 0.2,
                   kForearms = 0.1;  // of the points, from which on a panel has them
  std::array<int, 5> votes{};
  int round_forearms = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int vertex = particle_tree().query(points[i]).triangle;
    ++votes[static_cast<int>(part_of_vertex(body_, vertex))];
    const Segment segment = body_.segment[vertex];
    round_forearms += (segment == Segment::forearm || segment == Segment::hand) &&
                      body_.normals[vertex].dot(normals[i]) > 0;
  }
  const auto most = static_cast<BodyPart>(std::ranges::max_element(votes) - votes.begin());
  const auto count = static_cast<double>(points.size());
  const auto of = [&](BodyPart part) { return votes[static_cast<int>(part)]; };
  if (most == BodyPart::trunk && round_forearms > kForearms * count)
    return BodyPart::trunk_and_arms;
  if ((most == BodyPart::leg_left || most == BodyPart::leg_right) &&
      std::min(of(BodyPart::leg_left), of(BodyPart::leg_right)) > kOtherLeg * count)
    return BodyPart::both_legs;
  return most;
}

bool PartnerFinder::faces_alike(int triangle, const Vec3& garment_normal, BodyPart part) const {
  return belongs(body_.surface.triangles[triangle][0], part) &&
         face_normals_[triangle].dot(garment_normal) > 0;
}

BodyPartner PartnerFinder::find_on_surface(const Vec3& point, const Vec3& garment_normal,
                                           BodyPart part) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  BodyPartner partner;
  const geometry::ClosestPoint nearest =
      tree_.query(point, kFar, [&](int t) { return belongs(body_.surface.triangles[t][0], part); });
  const bool any = nearest.triangle >= 0;  // a scan may lack the part altogether
  partner.exact = any ? tree_.query(point, nearest.distance + kFoldReach,
                                    [&](int t) { return faces_alike(t, garment_normal, part); })
                      : tree_.query(point);
  if (partner.exact.triangle < 0) partner.exact = nearest;

  const Triangle& corner = body_.surface.triangles[partner.exact.triangle];
  for (int k = 0; k < 3; ++k)
    partner.normal += partner.exact.barycentric[k] * body_.normals[corner[k]];
  partner.normal.normalize();
  return partner;
}

BodyPartner PartnerFinder::find(const Vec3& point, const Vec3& garment_normal,
                                BodyPart part) const {
  BodyPartner partner = find_on_surface(point, garment_normal, part);
  // Vertices of such faces as the exact partner lies on.
  const int found = partner.exact.triangle;
  const bool on_part = belongs(body_.surface.triangles[found][0], part);
  const bool alike = faces_alike(found, garment_normal, part);
  const auto has_face = [&](int vertex) {
    for (int t : faces_of_vertex_[vertex])
      if (!on_part || (alike ? faces_alike(t, garment_normal, part)
                             : belongs(body_.surface.triangles[t][0], part)))
        return true;
    return false;
  };
  constexpr double kFar = std::numeric_limits<double>::infinity();
  partner.particle_distance = particle_tree().query(point, kFar, has_face).distance;
  return partner;
}

std::vector<BodyPartner> find_partners(const PartnerFinder& finder,
                                       const std::vector<Vec3>& positions,
                                       const std::vector<Vec3>& normals,
                                       const std::vector<BodyPart>& part) {
  std::vector<BodyPartner> partners(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    partners[i] = finder.find(positions[i], normals[i], part[i]);
  return partners;
}

}  // namespace loosefit::body
