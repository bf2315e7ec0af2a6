#include "loosefit/drape/cloth_layer.h"

#include "loosefit/base/error.h"
#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::drape {

std::vector<Triangle> ClothMesh::triangles_of(int layer) const {
  return {triangles.begin() + first_triangle[layer], triangles.begin() + first_triangle[layer + 1]};
}

ClothMesh joined(const std::vector<const garment::Garment*>& garments) {
  ClothMesh all;
  all.first_vertex = all.first_triangle = {0};
  for (const garment::Garment* garment : garments) {
    const int shift = all.vertices;
    for (const Triangle& t : garment->triangles)
      all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    const std::vector<double> area = geometry::flat_areas(garment->triangle_uv);
    all.area.insert(all.area.end(), area.begin(), area.end());
    all.triangle_layer.resize(all.triangles.size(), all.layers());
    all.vertices += garment->vertex_count;
    all.first_vertex.push_back(all.vertices);
    all.first_triangle.push_back(static_cast<int>(all.triangles.size()));
  }
  return all;
}

Drape drape_of_layer(const Drape& all, const std::vector<ClothLayer>& layers, int layer) {
  if (layers.size() == 1) return all;
  std::size_t first = 0, count = 0, total = 0;
  for (int i = 0; i < static_cast<int>(layers.size()); ++i) {
    const auto vertices = static_cast<std::size_t>(layers[i].garment->finest().vertex_count);
    if (i < layer) first += vertices;
    if (i == layer) count = vertices;
    total += vertices;
  }
  if (all.positions.size() != total) throw Error("a drape of other layers");
  Drape one;
  one.certificate = all.certificate;
  one.report = all.report;
  const auto part = [&](const auto& of_all, auto& of_one) {
    if (of_all.size() == total)
      of_one.assign(of_all.begin() + first, of_all.begin() + first + count);
  };
  part(all.positions, one.positions);
  part(all.body_contact_force, one.body_contact_force);
  part(all.body_normal_force, one.body_normal_force);
  return one;
}

}  // namespace loosefit::drape
