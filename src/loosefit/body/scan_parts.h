#pragma once
#include <string>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// Turns the faces of each connected part outwards, whatever holes it has. Neighbours in it have to
/// agree already (orient_consistently). Returns how many parts it turned.
int turn_parts_outwards(geometry::TriangleMesh& mesh);

/// The skin of a person whose scan comes in parts: head, trunk and limbs as surfaces of their own,
/// open or closed, apart by up to 2 cm, touching or overlapping.
struct SkinOfParts {
  geometry::TriangleMesh mesh;  ///< without what lies inside of another part or faces one
  double inside = 0;            ///< share of the area that lies inside of another part
};
SkinOfParts skin_of_parts(const geometry::TriangleMesh& mesh);

/// A part of a scan that is not the person: a floor, a stand, noise, somebody else.
struct ForeignPart {
  std::vector<int> triangles;
  double share = 0;   ///< of the area of all parts
  std::string place;  ///< in words: how large it is and where
};

/// Parts of which less than half lies within 3 cm of the person's skin, the largest first.
std::vector<ForeignPart> foreign_parts(const geometry::TriangleMesh& scan,
                                       const geometry::TriangleMesh& person);

}  // namespace loosefit::body
