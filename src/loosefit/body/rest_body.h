#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "loosefit/body/body_data.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// A person in the model's own A-pose. The first 13 380 vertices are the body vertices of the data,
/// whether subdivided or not, so rulers and landmarks hold for both.
struct RestBody {
  geometry::TriangleMesh surface;
  std::vector<Vec3> joints;  ///< per joint of BodyData
};

class Stumps;

/// What of a person no posture changes.
struct BodyShape {
  RestBody rest;                               ///< whole, whatever limbs are missing
  std::shared_ptr<const Stumps> stumps;        ///< null: nothing is missing
  std::map<std::string, double> measured;      ///< as Body::measured
  std::map<std::string, int> landmark_vertex;  ///< as Body::landmark_vertex
};

/// Joint positions of morphed rows.
std::vector<Vec3> joint_positions(const BodyData& data, const std::vector<Vec3>& rows);

}  // namespace loosefit::body
