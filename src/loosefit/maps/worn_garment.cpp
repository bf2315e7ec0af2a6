#include "loosefit/maps/worn_garment.h"

#include "loosefit/base/error.h"
#include "loosefit/body/body_frame.h"
#include "loosefit/maps/strain.h"

namespace loosefit::maps {

WornGarment relate(const garment::Garment& garment, const std::vector<Vec3>& positions,
                   const body::PosedBody& body) {
  if (static_cast<int>(positions.size()) != garment.vertex_count)
    throw InvalidInput("maps: " + std::to_string(positions.size()) + " positions for " +
                       std::to_string(garment.vertex_count) + " garment vertices");
  const body::PartnerFinder& finder = body.partners();
  WornGarment worn;
  worn.normals = geometry::vertex_normals(positions, garment.triangles);
  worn.areas = vertex_areas(garment);

  std::vector<std::vector<Vec3>> points(garment.panel_names.size()), normals(points.size());
  for (int v = 0; v < garment.vertex_count; ++v) {
    points[garment.vertex_panel[v]].push_back(positions[v]);
    normals[garment.vertex_panel[v]].push_back(worn.normals[v]);
  }
  for (std::size_t panel = 0; panel < points.size(); ++panel)
    worn.panel_part.push_back(finder.part_of(points[panel], normals[panel]));
  for (int panel : garment.vertex_panel) worn.vertex_part.push_back(worn.panel_part[panel]);

  worn.partners = body::find_partners(finder, positions, worn.normals, worn.vertex_part);
  std::vector<double> flat;
  for (const body::BodyPartner& partner : worn.partners) flat.push_back(partner.exact.distance);
  worn.curved = curved_triangles(garment, positions, worn.normals, flat, body);
  worn.distances = smooth_vertex_distances(garment, worn.curved, flat);
  const std::vector<body::Region>& regions = body.regions();
  const std::vector<Vec3>& axes = body.axes();
  for (const body::BodyPartner& partner : worn.partners) {
    worn.regions.push_back(body::region_of(regions, body->surface, partner.exact));
    worn.segment_axes.push_back(
        body::at_point(body->surface, axes, partner.exact.triangle, partner.exact.barycentric));
  }
  return worn;
}

}  // namespace loosefit::maps
