#include "loosefit/drape/phases/lift_off.h"

#include "loosefit/drape/phases/certify_state.h"
#include "loosefit/drape/phases/contract.h"
#include "loosefit/drape/phases/free_penetrations.h"

namespace loosefit::drape {
namespace {

/// The usual grid does not resolve a fold of skin in which cloth is caught.
void see_folds(ClothState& state) {
  const double spacing = state.tuning.certify.fold_field_spacing;
  if (state.body->field->spacing() <= spacing) return;
  state.outgrown.push_back(state.body);
  state.body =
      with_field(state.body->body, bounds(state.x), spacing, state.tuning.carry, state.arms_go_up);
}

}  // namespace

void lift_off_and_resettle(ClothState& state) {
  state.keep(state.first_try, state.last.residual);
  state.first_try->stop = state.how_it_ended();
  state.lowest.reset(), state.clear.reset(), state.saddle.reset();
  state.report.held_off_triangles = 0;
  state.part = "retry";
  const Certificate& c = state.certificate;
  if (c.intersections_body + c.intersections_self > 0) see_folds(state);
  state.make_model();
  state.soften_contact(true);
  contract(state);
  state.soften_contact(false);
  if (!state.is_over()) free_penetrations(state);
  certify_state(state);
}

}  // namespace loosefit::drape
