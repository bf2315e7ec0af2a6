#pragma once
#include "loosefit/drape/drape_session.h"
#include "loosefit/fabric/material.h"
#include "support/shirt_on_body.h"

namespace loosefit::support {

/// A soft knit with everything that drapes ask of a fabric.
inline fabric::Material knit() {
  fabric::Material m;
  m.name = "test knit";
  m.areal_density = 0.16;
  m.thickness = 7e-4;
  m.stiffness_warp = 200;
  m.stiffness_weft = 120;
  m.poisson = 0.3;
  m.stiffness_shear = 50;
  m.bending_warp = m.bending_weft = 3e-6;
  return m;
}

/// Standing, the arms from one angle to another [degrees].
inline body::BodyPath arms_path(const body::BodyParameters& parameters, double from, double to) {
  return [parameters, from, to](double share) {
    return standing(parameters, from + share * (to - from));
  };
}

}  // namespace loosefit::support
