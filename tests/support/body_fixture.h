#pragma once
#include "loosefit/body/body_model.h"

namespace loosefit {

/// The parametric body, loaded once per test binary. Throws (the test fails) when it is not baked:
/// `make test` fetches and bakes it first.
inline const body::BodyModel& body_model() {
  static const body::BodyModel model = body::BodyModel::load();
  return model;
}

/// A reference point of the source data (dm, y up, z forward) in our frame.
inline Vec3 from_decimetres(double x, double y, double z) { return Vec3(x, -z, y) * 0.1; }

}  // namespace loosefit
