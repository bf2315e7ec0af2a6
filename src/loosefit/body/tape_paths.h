#pragma once
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

// What a tailor's tape does on any closed body surface, z up, trunk over x = 0. Lengths in metres.

/// Horizontal tape round the trunk at height z. \throws GeometryError when there is no trunk there.
double trunk_girth(const geometry::TriangleMesh& mesh, double z);

/// The part of trunk_girth in front of the two points that lie farthest aside, where a garment has
/// its side seams.
double trunk_girth_front(const geometry::TriangleMesh& mesh, double z);

/// Tape round the limb that contains `origin`, in the plane with this normal.
/// \throws GeometryError when no closed section contains the point.
double girth_round(const geometry::TriangleMesh& mesh, const Vec3& origin, const Vec3& normal);

/// Tape from a point on the shoulder straight down the back to height z, bridging hollows; hangs
/// from what stands out most.
double back_tape(const geometry::TriangleMesh& mesh, const Vec3& from, double z);

/// The same down the front, over the bust or the belly.
double front_tape(const geometry::TriangleMesh& mesh, const Vec3& from, double z);

/// Tape round an elbow, in the plane that halves the angle between upper arm and forearm.
double bent_elbow_girth(const geometry::TriangleMesh& mesh, const Vec3& shoulder, const Vec3& elbow,
                        const Vec3& wrist);

/// Tape round the neck base: behind through C7, in front through the pit of the neck, at the sides
/// through the neck-shoulder points. No plane cuts that curve out; each half is taken as half an
/// ellipse on its own slanted plane.
double neck_base_girth(const Vec3& left, const Vec3& right, const Vec3& c7, const Vec3& pit);

/// Highest point of the sagittal section at x, below `ceiling`.
Vec3 top_at(const geometry::TriangleMesh& mesh, double x, double ceiling);

/// Where sleeve meets trunk: the sagittal section round the shoulder joint.
struct Armscye {
  double girth = 0;
  double fold = 0;  ///< height z of its lowest point, the underarm
};
/// Within `farthest` [m] outwards of the joint, where arm and trunk part: nearer to the neck the
/// section runs down the side of a stout trunk, farther out along the arm. \throws GeometryError
/// when no closed section contains the joint.
Armscye armscye_round(const geometry::TriangleMesh& mesh, const Vec3& shoulder_joint,
                      double farthest = 0.06);

}  // namespace loosefit::body
