#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/rigid_motion.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// Statures that are believed where somebody says the unit [m]: as far as anybody ever stood.
inline constexpr double kShortestPerson = 0.5, kTallestPerson = 2.75;

/// Metres of a unit "m", "cm", "mm" or "in"; nothing for other texts.
std::optional<double> metres_of(const std::string& unit);

/// What the user knows of a scanned surface; empty texts are inferred with a warning.
struct ScanOptions {
  std::string file;   ///< for messages
  std::string units;  ///< "m", "cm", "mm", "in" or empty
  std::string up;     ///< "z", "y" or empty
  /// Widest hole that is filled, as a share of the stature. The default is 50 mm of an adult: a
  /// flat patch of width d on a trunk of radius R misses the skin by d²/8R, here by 3 mm, which is
  /// what a tape can tell; wider holes hide shape that nobody has measured.
  double widest_hole = 0.03;
  double most_filled = 0.01;  ///< share of the skin that may be filled holes
  /// Whether several surfaces may be one person: then they are kept as they are, holes included.
  bool take_parts = false;
  bool tell_crossings = true;  ///< warn of faces that pass through each other
};

/// Brings a closed, outward oriented surface in file units and file axes into metres and our frame:
/// z up, facing -y, floor at z = 0, trunk over the origin. Units are inferred from the stature: one
/// of m, cm, mm and in must make it that of a standing person, and only one.
/// \return the rigid motion from the file's world (in metres; a file with y up turned by
/// (x, y, z) → (x, −z, y)) to our frame: turns about z and a shift.
/// \throws InvalidInput when no or more than one unit makes it a person, or for unknown options.
RigidMotion stand_in_our_frame(geometry::TriangleMesh& mesh, const ScanOptions& options,
                               std::vector<std::string>& warnings);

}  // namespace loosefit::body
