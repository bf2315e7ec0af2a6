#include "loosefit/pipeline/garment_layers.h"

#include "loosefit/base/error.h"
#include "loosefit/pipeline/ease_on_mesh.h"
#include "loosefit/pipeline/unsettled_advice.h"
#include "loosefit/scenario/garment_tables.h"

namespace loosefit::pipeline {
namespace {

/// An error about a garment under the studied one, told with its section [[under]].
InvalidInput in_section(const InvalidInput& error, const scenario::Scenario& scenario,
                        std::size_t garment) {
  if (garment + 1 == scenario.garments.size()) return error;
  const std::string& key = error.place().key;
  const std::string& file = scenario.garments[garment].spec.file;
  const bool of_body = key.starts_with("measures.") || key.starts_with("body.");
  if (!error.place().file.empty() || of_body) return error;
  if (!file.empty() && !scenario::is_beside_pattern(key)) return error.at({file, 0, key});
  return error.at({{}, 0, "under[" + std::to_string(garment) + "]." + key});
}

}  // namespace

std::vector<CasePattern> make_patterns(const scenario::Scenario& scenario, const body::Body& body,
                                       const kinds::GirthsAlong& girths) {
  std::vector<CasePattern> patterns;
  for (std::size_t g = 0; g < scenario.garments.size(); ++g) try {
      patterns.push_back(make_pattern(scenario.garments[g].spec, body, girths));
    } catch (const InvalidInput& error) {
      throw in_section(error, scenario, g);
    }
  return patterns;
}

std::vector<CaseGarment> mesh_garments(const scenario::Scenario& scenario,
                                       const std::vector<CasePattern>& patterns,
                                       const std::vector<garment::Attachment>& attachments,
                                       MeshLevels levels) {
  const auto build =
      levels == MeshLevels::all ? garment::build_hierarchy : garment::build_coarsest_level;
  const double edge_length = scenario.simulation.edge_length;
  std::vector<CaseGarment> garments;
  for (std::size_t g = 0; g < patterns.size(); ++g) try {
      const bool studied = g + 1 == patterns.size();
      CaseGarment& garment = garments.emplace_back();
      garment.pattern = patterns[g];
      garment.hierarchy =
          build(patterns[g].pattern, edge_length, scenario.garments[g].material.material,
                studied ? attachments : std::vector<garment::Attachment>{},
                limb_fineness(patterns[g], edge_length));
      set_vertex_ease(garment.hierarchy, patterns[g]);
    } catch (const InvalidInput& error) {
      throw in_section(error, scenario, g);
    }
  return garments;
}

std::vector<drape::ClothLayer> cloth_layers(const scenario::Scenario& scenario,
                                            const std::vector<CaseGarment>& garments,
                                            double friction_share) {
  std::vector<drape::ClothLayer> layers;
  for (std::size_t g = 0; g < garments.size(); ++g) {
    const scenario::ScenarioGarment& asked = scenario.garments[g];
    drape::ClothLayer& layer = layers.emplace_back(
        drape::ClothLayer{&garments[g].hierarchy, asked.material.material, asked.friction});
    layer.material.friction_body *= friction_share;
    layer.material.friction_self *= friction_share;
    if (layer.friction_over) *layer.friction_over *= friction_share;
  }
  return layers;
}

std::vector<drape::Drape> split_drape(const drape::Drape& all, const scenario::Scenario& scenario,
                                      const std::vector<CaseGarment>& garments) {
  const std::vector<drape::ClothLayer> layers = cloth_layers(scenario, garments);
  std::vector<drape::Drape> drapes;
  for (int l = 0; l < static_cast<int>(layers.size()); ++l)
    drapes.push_back(drape::drape_of_layer(all, layers, l));
  drape::Drape& studied = drapes.back();
  if (studied.unsettled) studied.unsettled->hint = unsettled_advice(scenario, studied);
  return drapes;
}

geometry::TriangleMesh surface_under_studied(const CaseResult& result, const CaseState* state) {
  geometry::TriangleMesh all;
  for (std::size_t g = 0; g < result.worn_under().size(); ++g) {
    const CaseGarment& garment = result.garments[g];
    const auto& positions = (state ? state->drapes[g] : garment.drape).positions;
    const int shift = static_cast<int>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), positions.begin(), positions.end());
    for (const Triangle& t : garment.mesh().triangles)
      all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return all;
}

}  // namespace loosefit::pipeline
