#pragma once
#include <optional>
#include <vector>

#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// Reads arrays of maps at all vertices of one worn garment. What several arrays share (strains,
/// orientations, slips, errors) is computed for the first that asks. Keeps a reference to the
/// input.
class VertexReader {
 public:
  explicit VertexReader(const MapInput& input) : input_(input) {}
  /// One value per vertex in the array's unit. \throws InvalidInput when the input does not fit
  /// (maps/skin_partner.h, maps/orientation_error.h).
  std::vector<double> values(const MapArray& array);

 private:
  std::vector<double> of(ReadCloth read);
  std::vector<double> of(ReadOverSkin read) const;
  std::vector<double> of(ReadField field) const { return field(input_); }
  std::vector<double> of(ReadOrientation read);
  std::vector<double> of(ReadSlip read);
  std::vector<double> of(ReadError read);

  const MapInput& input_;
  std::optional<std::vector<ClothStrain>> strains_;
  std::optional<std::vector<Orientation>> orientations_;
  std::optional<std::vector<Slip>> slips_;
  std::optional<std::vector<ErrorSummary>> errors_;
};

}  // namespace loosefit::maps
