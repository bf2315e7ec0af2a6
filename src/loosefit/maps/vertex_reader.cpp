#include "loosefit/maps/vertex_reader.h"

#include <algorithm>

#include "loosefit/base/error.h"

namespace loosefit::maps {
namespace {

template <class Read, class Value>
std::vector<double> each(Read read, const std::vector<Value>& of) {
  std::vector<double> values;
  values.reserve(of.size());
  for (const Value& value : of) values.push_back(read(value));
  return values;
}

}  // namespace

std::vector<double> VertexReader::values(const MapArray& array) {
  std::vector<double> values =
      std::visit([this](auto reading) { return this->of(reading); }, array.read);
  for (double& value : values) value = array.in_unit(value);
  return values;
}

std::vector<double> VertexReader::of(ReadCloth read) {
  if (!strains_) strains_ = cloth_strains(input_.garment, input_.positions, *input_.material);
  std::vector<double> per_triangle;
  per_triangle.reserve(strains_->size());
  for (const ClothStrain& cloth : *strains_) per_triangle.push_back(read(cloth, kGrain));
  return to_vertices(input_.garment, per_triangle);
}

std::vector<double> VertexReader::of(ReadOverSkin read) const {
  const WornGarment& worn = input_.worn;
  const garment::Garment& garment = input_.garment;
  std::vector<double> padding;
  if (!garment.triangle_padding.empty()) padding.resize(garment.vertex_count);
  for (std::size_t t = 0; t < garment.triangle_padding.size(); ++t)
    for (int v : garment.triangles[t])
      padding[v] = std::max(padding[v], garment.triangle_padding[t]);
  std::vector<double> values;
  values.reserve(worn.partners.size());
  for (std::size_t v = 0; v < worn.partners.size(); ++v)
    values.push_back(read({worn.partners[v], worn.distances[v], worn.normals[v], input_.material,
                           padding.empty() ? 0.0 : padding[v]}));
  return values;
}

std::vector<double> VertexReader::of(ReadOrientation read) {
  if (!orientations_)
    orientations_ = vertex_orientations(input_.garment, input_.positions, input_.worn);
  return each(read, *orientations_);
}

std::vector<double> VertexReader::of(ReadSlip read) {
  if (!slips_) slips_ = vertex_slips(input_.garment, *input_.reference, input_.states->front());
  return each(read, *slips_);
}

std::vector<double> VertexReader::of(ReadError read) {
  if (!errors_)
    errors_ = vertex_orientation_errors(input_.garment, *input_.reference, *input_.states);
  return each(read, *errors_);
}

}  // namespace loosefit::maps
