#include "loosefit/drape/phases/lift_off.h"

#include "loosefit/drape/phases/certify_state.h"
#include "loosefit/drape/phases/contract.h"
#include "loosefit/drape/phases/free_penetrations.h"

namespace loosefit::drape {

void lift_off_and_resettle(ClothState& state) {
  state.keep(state.first_try, state.last.residual);
  state.first_try->stop = state.how_it_ended();
  state.lowest.reset(), state.clear.reset(), state.saddle.reset();
  state.report.held_off_triangles = 0;
  state.part = "retry";
  state.make_model();
  state.soften_contact(true);
  contract(state);
  state.soften_contact(false);
  if (!state.is_over()) free_penetrations(state);
  certify_state(state);
}

}  // namespace loosefit::drape
