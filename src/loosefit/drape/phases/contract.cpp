#include "loosefit/drape/phases/contract.h"

namespace loosefit::drape {

void contract_soft(ClothState& state) {
  const ContractTuning& tuning = state.tuning.contract;
  for (const double share : tuning.stiffness_shares) {
    state.make_model(share, false);
    state.model->take_weight();
    state.soften_contact(true);
    if (!state.must_stop())
      state.settle({.tolerance = tuning.softened_tolerance,
                    .max_iterations = tuning.softened_iterations,
                    .first_dt = tuning.first_dt,
                    .preparing = true});
  }
  state.make_model();
  state.soften_contact(true);
}

void contract(ClothState& state) {
  const ContractTuning& tuning = state.tuning.contract;
  if (!state.must_stop())
    state.settle({.tolerance = tuning.dressed_tolerance,
                  .max_iterations = kNoLimit,
                  .first_dt = tuning.first_dt,
                  .preparing = true});
}

}  // namespace loosefit::drape
