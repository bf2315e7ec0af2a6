#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/lines/course.h"
#include "loosefit/placement/site_state.h"

namespace loosefit::lines {

/// What of a line matters to what it sees (LineSpec).
struct LineSensor {
  double height = 0;           ///< of its middle above that of the cloth, outwards [m]
  double pre_stretch = 0;      ///< by which it is longer on the flat cloth than by itself [–]
  double axial_stiffness = 0;  ///< EA: force per elongation [N]
};

/// A line in one posture after one donning. Elongations are of the sensor against its own length:
/// (1 + pre-stretch) × length now / length in the flat cloth − 1.
struct LineState {
  int posture = 0, donning = 0;  ///< as WornState
  double length = 0;             ///< of the sensor, at its height [m]
  double elongation = 0;         ///< of the whole [–]
  std::vector<double> parts;     ///< of each part [–]
  double slack = 0;    ///< share of its parts that are shorter than by themselves by 0.5 % or more
  double contact = 0;  ///< share of its length that touches the skin
  double bend_radius = 0;  ///< least radius to which the cloth bends along it [m]; ∞: straight
  double force = 0;        ///< greatest tension of any part (fabric/band_energy.h) [N]
  double largest_part() const;
  double largest_strain() const;  ///< of any part, either way [–]
};

/// Measures lines in one state. Keeps references to everything.
///
/// The length is that of the line on the draped triangles, plus what bending adds at its height h:
/// ds (1 + h κ), κ the curvature of the cloth along the line, positive where it is convex outwards
/// (maps/surface_curvature.h; the neutral axis of a bent beam, e.g. Timoshenko). A hollow takes at
/// most all of it.
class LineMeter {
 public:
  LineMeter(const garment::Garment& garment, const fabric::Material& material,
            const placement::WornState& state);
  LineState measure(const LineCourse& course, const LineSensor& sensor) const;

 private:
  const garment::Garment& garment_;
  fabric::Material material_;
  placement::WornState state_;
  std::vector<Mat3> curvature_;  ///< per vertex [1/m]
};

}  // namespace loosefit::lines
