#include "loosefit/report/case_forms.h"

#include "loosefit/pipeline/garment_layers.h"
#include "loosefit/render/mannequin.h"

namespace loosefit::report {

CaseForms::CaseForms(const pipeline::CaseResult& result) : result_(result) {
  kept_[nullptr];
  for (const pipeline::CaseState& state : result.wear.states)
    if (state.id.in_first_donning()) kept_[&state];
}

CaseForms::Form CaseForms::in_studied(const pipeline::CaseState* state) const {
  const auto kept = kept_.find(state);
  return kept == kept_.end() ? make(state) : kept->second.get([&] { return make(state); });
}

CaseForms::Form CaseForms::make(const pipeline::CaseState* state) const {
  const body::Body& body =
      state ? result_.body_in(state->id.posture).body() : result_.body.body.body();
  const std::vector<Vec3>& positions =
      state ? state->drape().positions : result_.studied().drape.positions;
  return std::make_shared<const geometry::TriangleMesh>(render::mannequin(
      body, result_.studied().mesh(), positions, pipeline::surface_under_studied(result_, state)));
}

}  // namespace loosefit::report
