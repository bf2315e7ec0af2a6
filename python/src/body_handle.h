#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/posed_body.h"

namespace loosefit::python {

/// _core.Body: a body in one posture, shared with whatever it was made for.
struct BodyHandle {
  std::shared_ptr<const body::Body> body;
  body::BodyFit fit;  ///< how it came about: asked against measured, and warnings
};

/// The body alone, kept alive with its index by the pointer.
std::shared_ptr<const body::Body> shared_body(const body::PosedBody& posed);

/// _core.Body and _core.make_body.
void bind_body(pybind11::module_& core);

}  // namespace loosefit::python
