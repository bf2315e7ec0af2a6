#pragma once
#include "loosefit/base/error.h"

namespace loosefit::dress {

/// A garment that its pattern places cuts through those under it, wherever it is placed.
class GarmentsCut : public GeometryError {
 public:
  using GeometryError::GeometryError;
};

}  // namespace loosefit::dress
