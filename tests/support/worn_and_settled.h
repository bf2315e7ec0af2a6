#pragma once
#include <gtest/gtest.h>

#include "loosefit/drape/drape_session.h"
#include "loosefit/drape/worn.h"
#include "loosefit/garment/hierarchy.h"

namespace loosefit::testing_support {

/// Puts a limp garment on a body that stands still, and expects it to settle and to be worn.
inline void expect_worn_and_settled(const pattern::Pattern& pattern, double edge_length,
                                    const body::PosedBody& body) {
  fabric::Material material;
  material.bending_warp = material.bending_weft = 5e-6;
  const garment::GarmentHierarchy garment =
      garment::build_hierarchy(pattern, edge_length, material);
  Progress silent;
  drape::DrapeOptions options;
  options.time_budget = 200;
  const drape::Drape d = drape::drape_garment(
      garment, material, [&](double) { return body; }, options, silent);
  EXPECT_TRUE(d.certificate.settled()) << d.certificate.stop_reason;
  const auto why = drape::why_not_worn(garment.finest(), pattern, d.positions, body);
  EXPECT_TRUE(why.empty()) << (why.empty() ? "" : why.front());
}

}  // namespace loosefit::testing_support
