#include "loosefit/garment/flat_lengths.h"

namespace loosefit::garment {

std::vector<double> flat_lengths(const Garment& garment, const geometry::MeshTopology& topology) {
  std::vector<double> lengths;
  lengths.reserve(topology.edges().size());
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto& [triangle, corner] = topology.sides(e).back();
    const auto& uv = garment.triangle_uv[triangle];
    lengths.push_back((uv[(corner + 1) % 3] - uv[corner]).norm());
  }
  return lengths;
}

}  // namespace loosefit::garment
