#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/curved_cloth.h"

namespace loosefit::maps {

/// The geometry between a garment and its wearer that all maps, regions and sites share.
struct WornGarment {
  std::vector<Vec3> normals;                ///< garment unit vertex normals, outwards
  std::vector<body::BodyPart> panel_part;   ///< per panel, by vote of its vertices
  std::vector<body::BodyPart> vertex_part;  ///< per vertex: that of vertex_panel
  std::vector<body::BodyPartner> partners;  ///< per vertex
  std::vector<CurvedTriangle> curved;       ///< per triangle
  std::vector<double> distances;            ///< of the smooth cloth to the partner, per vertex [m]
  std::vector<Vec3> segment_axes;           ///< per vertex: body/body_frame.h, at its partner
  std::vector<body::Region> regions;        ///< per vertex: region of its partner
  std::vector<double> areas;  ///< flat area of each vertex [m²], weights of statistics
};

/// \throws InvalidInput when positions do not fit the garment or the body lacks segments.
WornGarment relate(const garment::Garment& garment, const std::vector<Vec3>& positions,
                   const body::PosedBody& body);

}  // namespace loosefit::maps
