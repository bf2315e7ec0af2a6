#pragma once
#include <optional>
#include <string>

namespace loosefit::maps {

/// Error that a mesh leaves in the mean of a quantity over a part of the garment as large as a
/// body region, as one standard deviation [unit of the array]. Two thirds of the 17 regions of the
/// reference shirt (paper-cotton, loose) lie within it of the same shirt with edges of 5 mm; what
/// those edges leave open is in it as a least error (docs/accuracy.md 3). Of yarn strains and shear
/// it is the error of their 95th percentile, which their means do not exceed. A sensor is smaller
/// than a region, and other fabrics and fits differ: read it as a size. The gap is taken as the distance, rotations of a sensor as the angular deviation.
/// array: PerformanceMap::array; edge_length > 0 [m]. Nothing for arrays whose convergence nobody
/// has measured, and for edges beyond 20 mm.
std::optional<double> mesh_error(const std::string& array, double value, double edge_length);

}  // namespace loosefit::maps
