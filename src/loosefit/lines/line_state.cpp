#include "loosefit/lines/line_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/fabric/band_energy.h"
#include "loosefit/maps/gap.h"
#include "loosefit/maps/strain.h"
#include "loosefit/maps/surface_curvature.h"

namespace loosefit::lines {

double LineState::largest_part() const {
  return parts.empty() ? elongation : *std::max_element(parts.begin(), parts.end());
}

double LineState::largest_strain() const {
  double most = 0;
  for (const double part : parts) most = std::max(most, std::abs(part));
  return most;
}

LineMeter::LineMeter(const garment::Garment& garment, const fabric::Material& material,
                     const placement::WornState& state)
    : garment_(garment), material_(material), state_(state) {
  curvature_ = maps::vertex_curvatures({state.positions, garment.triangles});
}

LineState LineMeter::measure(const LineCourse& course, const LineSensor& sensor) const {
  LineState found;
  found.posture = state_.posture;
  found.donning = state_.donning;
  std::vector<double> worn(course.parts, 0.0);
  double touching = 0, sharpest = 0;
  for (const CoursePiece& piece : course.pieces) {
    const placement::GarmentPoint from{piece.triangle, piece.from}, to{piece.triangle, piece.to},
        middle{piece.triangle, 0.5 * (piece.from + piece.to)};
    const Vec3 way = placement::at(garment_, to, state_.positions) -
                     placement::at(garment_, from, state_.positions);
    const double length = way.norm();
    double bend = 0;
    if (length > 0) {
      Mat3 tensor = Mat3::Zero();
      for (int k = 0; k < 3; ++k)
        tensor += middle.barycentric[k] * curvature_[garment_.triangles[piece.triangle][k]];
      const Vec3 along = way / length;
      bend = along.dot(tensor * along);
    }
    worn[piece.part] += length * std::max(0.0, 1 + sensor.height * bend);
    sharpest = std::max(sharpest, std::abs(bend));
    const Vec3 place = placement::at(garment_, middle, state_.positions);
    const double distance = state_.body.tree().signed_distance(place);
    if (maps::touches(maps::gap_of(std::max(0.0, distance), material_), material_))
      touching += piece.cut;
  }
  const double own_share = 1 + sensor.pre_stretch;
  int slack = 0;
  for (const double part : worn) {
    found.length += part;
    found.parts.push_back(own_share * part / course.part_length() - 1);
    if (found.parts.back() < maps::kSlackStrain) ++slack;
  }
  found.force = sensor.axial_stiffness * fabric::band_law(found.largest_part()).force;
  found.elongation = own_share * found.length / course.length - 1;
  found.slack = static_cast<double>(slack) / course.parts;
  found.contact = touching / course.length;
  found.bend_radius = sharpest > 0 ? 1 / sharpest : std::numeric_limits<double>::infinity();
  return found;
}

}  // namespace loosefit::lines
