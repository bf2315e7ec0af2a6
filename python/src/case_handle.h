#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/ranking_table.h"

namespace loosefit::python {

/// _core.Case: what one case has yielded. Arrays and views share it and do not change it.
struct CaseHandle {
  std::shared_ptr<const pipeline::CaseResult> result;
  std::optional<placement::RankingTable> ranking;  ///< as the scenario asks
};

/// _core.Case, Worn and Map, and the functions that make cases.
void bind_case(pybind11::module_& core);

}  // namespace loosefit::python
