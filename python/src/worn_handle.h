#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::python {

/// _core.Worn: one garment of a case as worn in one of its states; points into the case.
struct WornHandle {
  std::shared_ptr<const pipeline::CaseResult> result;
  const pipeline::CaseGarment* garment = nullptr;
  const drape::Drape* drape = nullptr;
  const std::vector<pipeline::CaseMap>* maps = nullptr;  ///< null: none are made of it
};

/// A garment of the case (0 the innermost, −1 the studied one) in the reference state, or in
/// another one of `wear.states`. \throws pybind11::index_error; Error for a state without a drape.
WornHandle worn_in_reference(std::shared_ptr<const pipeline::CaseResult> result, int garment);
WornHandle worn_in_state(std::shared_ptr<const pipeline::CaseResult> result, int state,
                         int garment);

/// _core.Worn.
void bind_worn(pybind11::module_& core);

}  // namespace loosefit::python
