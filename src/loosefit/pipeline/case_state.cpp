#include "loosefit/pipeline/case_state.h"

#include <fmt/format.h>

namespace loosefit::pipeline {

std::string state_label(const CaseState& state, std::size_t donnings) {
  if (donnings < 2) return state.name;
  return fmt::format("{} of donning {}", state.name, state.id.donning + 1);
}

}  // namespace loosefit::pipeline
