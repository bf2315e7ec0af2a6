#include "loosefit/study/case_layers.h"

#include "loosefit/base/error.h"
#include "loosefit/study/unsettled_advice.h"

namespace loosefit {
namespace {

void advise(const Scenario& scenario, Drape& drape) {
  if (drape.unsettled) drape.unsettled->hint = unsettled_advice(scenario, drape);
}

/// An error about a garment of [[under]], told with its section.
InvalidInput in_under(const InvalidInput& error, const Scenario& scenario, std::size_t layer) {
  const std::string& key = error.place().key;
  const std::string& file = scenario.garments[layer].spec.file;
  const bool of_body = key.starts_with("measures.") || key.starts_with("body.");
  if (!error.place().file.empty() || of_body) return error;
  if (!file.empty()) return error.at({file, 0, key});
  return error.at({{}, 0, "under[" + std::to_string(layer) + "]." + key});
}

}  // namespace

std::vector<CaseUnder> make_under_patterns(const Scenario& scenario, const Body& body) {
  std::vector<CaseUnder> under(scenario.worn_under().size());
  for (std::size_t l = 0; l < under.size(); ++l) try {
      under[l].pattern = make_pattern(scenario.garments[l].spec, body);
    } catch (const InvalidInput& error) {
      throw in_under(error, scenario, l);
    }
  return under;
}

void mesh_under(CaseResult& result, double edge_length) {
  for (std::size_t l = 0; l < result.under.size(); ++l) try {
      CaseUnder& under = result.under[l];
      under.garment = build_hierarchy(under.pattern.pattern, edge_length,
                                      result.scenario.garments[l].material.material);
    } catch (const InvalidInput& error) {
      throw in_under(error, result.scenario, l);
    }
}

std::vector<ClothLayer> cloth_layers(const CaseResult& result, double friction_share) {
  std::vector<ClothLayer> layers;
  for (std::size_t l = 0; l < result.under.size(); ++l) {
    const ScenarioGarment& wished = result.scenario.garments[l];
    layers.push_back({&result.under[l].garment, wished.material.material, wished.friction});
  }
  layers.push_back({&result.garment, result.scenario.studied().material.material});
  for (ClothLayer& layer : layers) {
    layer.material.friction_body *= friction_share;
    layer.material.friction_self *= friction_share;
    if (layer.friction_over) *layer.friction_over *= friction_share;
  }
  return layers;
}

void take_drape(const Drape& all, CaseResult& result) {
  const std::vector<ClothLayer> layers = cloth_layers(result);
  const int last = static_cast<int>(layers.size()) - 1;
  for (int l = 0; l < last; ++l) result.under[l].drape = drape_of_layer(all, layers, l);
  result.drape = drape_of_layer(all, layers, last);
  advise(result.scenario, result.drape);
}

void take_drape(const Drape& all, const CaseResult& result, CaseState& state) {
  const std::vector<ClothLayer> layers = cloth_layers(result);
  const int last = static_cast<int>(layers.size()) - 1;
  state.under.clear();
  for (int l = 0; l < last; ++l) state.under.push_back(drape_of_layer(all, layers, l));
  state.drape = drape_of_layer(all, layers, last);
  advise(result.scenario, state.drape);
}

std::filesystem::path under_folder(int layer) {
  return std::filesystem::path("under") / std::to_string(layer + 1);
}

TriangleMesh under_surface(const CaseResult& result, const CaseState* state) {
  TriangleMesh all;
  for (std::size_t l = 0; l < result.under.size(); ++l) {
    const auto& positions = (state ? state->under[l] : result.under[l].drape).positions;
    const int shift = static_cast<int>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), positions.begin(), positions.end());
    for (const Triangle& t : result.under[l].mesh().triangles)
      all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return all;
}

}  // namespace loosefit
