#include "loosefit/drape/phases/contract.h"

namespace loosefit::drape {

void contract_soft(ClothState& state) {
  const ContractTuning& tuning = state.tuning.contract;
  for (const double share : tuning.stiffness_shares) {
    state.make_model(share, false);
    state.model->take_weight();
    state.soften_contact(true);
    if (!state.must_stop())
      state.settle({tuning.softened_tolerance, tuning.softened_iterations, tuning.first_dt, true});
  }
  state.make_model();
  state.soften_contact(true);
}

void contract(ClothState& state) {
  const ContractTuning& tuning = state.tuning.contract;
  if (!state.must_stop()) state.settle({tuning.dressed_tolerance, kNoLimit, tuning.first_dt, true});
}

}  // namespace loosefit::drape
