#include "loosefit/study/garment_layers.h"

#include "loosefit/base/error.h"
#include "loosefit/study/unsettled_advice.h"

namespace loosefit {
namespace {

/// An error about a garment under the studied one, told with its section [[under]].
InvalidInput in_section(const InvalidInput& error, const Scenario& scenario, std::size_t garment) {
  if (garment + 1 == scenario.garments.size()) return error;
  const std::string& key = error.place().key;
  const std::string& file = scenario.garments[garment].spec.file;
  const bool of_body = key.starts_with("measures.") || key.starts_with("body.");
  if (!error.place().file.empty() || of_body) return error;
  if (!file.empty()) return error.at({file, 0, key});
  return error.at({{}, 0, "under[" + std::to_string(garment) + "]." + key});
}

}  // namespace

std::vector<CasePattern> make_patterns(const Scenario& scenario, const Body& body) {
  std::vector<CasePattern> patterns;
  for (std::size_t g = 0; g < scenario.garments.size(); ++g) try {
      patterns.push_back(make_pattern(scenario.garments[g].spec, body));
    } catch (const InvalidInput& error) {
      throw in_section(error, scenario, g);
    }
  return patterns;
}

std::vector<CaseGarment> mesh_garments(const Scenario& scenario,
                                       const std::vector<CasePattern>& patterns,
                                       const std::vector<Attachment>& attachments,
                                       MeshLevels levels) {
  const auto build = levels == MeshLevels::all ? build_hierarchy : build_coarsest_level;
  const double edge_length = scenario.simulation.edge_length;
  std::vector<CaseGarment> garments;
  for (std::size_t g = 0; g < patterns.size(); ++g) try {
      const bool studied = g + 1 == patterns.size();
      CaseGarment& garment = garments.emplace_back();
      garment.pattern = patterns[g];
      garment.hierarchy =
          build(patterns[g].pattern, edge_length, scenario.garments[g].material.material,
                studied ? attachments : std::vector<Attachment>{});
    } catch (const InvalidInput& error) {
      throw in_section(error, scenario, g);
    }
  return garments;
}

std::vector<ClothLayer> cloth_layers(const Scenario& scenario,
                                     const std::vector<CaseGarment>& garments,
                                     double friction_share) {
  std::vector<ClothLayer> layers;
  for (std::size_t g = 0; g < garments.size(); ++g) {
    const ScenarioGarment& asked = scenario.garments[g];
    ClothLayer& layer = layers.emplace_back(
        ClothLayer{&garments[g].hierarchy, asked.material.material, asked.friction});
    layer.material.friction_body *= friction_share;
    layer.material.friction_self *= friction_share;
    if (layer.friction_over) *layer.friction_over *= friction_share;
  }
  return layers;
}

std::vector<Drape> split_drape(const Drape& all, const Scenario& scenario,
                               const std::vector<CaseGarment>& garments) {
  const std::vector<ClothLayer> layers = cloth_layers(scenario, garments);
  std::vector<Drape> drapes;
  for (int l = 0; l < static_cast<int>(layers.size()); ++l)
    drapes.push_back(drape_of_layer(all, layers, l));
  Drape& studied = drapes.back();
  if (studied.unsettled) studied.unsettled->hint = unsettled_advice(scenario, studied);
  return drapes;
}

TriangleMesh surface_under_studied(const CaseResult& result, const CaseState* state) {
  TriangleMesh all;
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

}  // namespace loosefit
