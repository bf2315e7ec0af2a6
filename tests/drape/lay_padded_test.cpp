#include "loosefit/drape/lay_padded.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/dress/dress_layers.h"
#include "loosefit/dress/no_room.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/registry.h"
#include "support/shirt_on_body.h"

namespace loosefit::drape {
namespace {

TEST(LayPadded, ArmsAndLegsAreOtherLimbsAndPatternFilesTellNothing) {
  const auto other = [](const char* one, const char* two) {
    return dress_other_limbs(kinds::garment_kind(one), kinds::garment_kind(two));
  };
  EXPECT_TRUE(other("t-shirt", "trousers"));
  EXPECT_TRUE(other("trousers", "long-sleeve-shirt"));
  EXPECT_TRUE(other("tank-top", "leggings"));
  EXPECT_FALSE(other("long-sleeve-shirt", "t-shirt"));
  EXPECT_FALSE(other("trousers", "leggings"));
  EXPECT_FALSE(other("t-shirt", "pattern-file"));
}

garment::Garment drafted(const char* name, const body::Body& body) {
  const kinds::GarmentKind& kind = kinds::garment_kind(name);
  const pattern::Pattern pattern =
      kind.draft({kinds::draft_measures(kind, body.measured), "", {}, {}}).pattern;
  return garment::assemble(pattern, 0.03, fabric::Material{});
}

TEST(LayPadded, AShirtOverTrousersLiesNearTheChestWhereNothingIsUnderIt) {
  const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  const garment::Garment trousers = drafted("trousers", body.body()),
                         shirt = drafted("t-shirt", body.body());
  const dress::LayRound &below = kinds::garment_kind("trousers").lay,
                        &over = kinds::garment_kind("t-shirt").lay;
  const auto padded = [&](const body::PosedBody& wearer) {
    return lay_padded(shirt, over, wearer);
  };
  // Mean distance from the skin of what lies above the waist.
  const auto off = [&](const std::vector<Vec3>& x) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = trousers.vertex_count; i < x.size(); ++i)
      if (x[i].z() > body->landmarks.at("back_waist").z() + 0.05) {
        sum += body.tree().query(x[i]).distance;
        ++count;
      }
    return sum / count;
  };
  const double near = off(dress::dress_layers({{&trousers, below}, {&shirt, {}, padded}}, body));
  const double alone = off([&] {
    std::vector<Vec3> x(trousers.vertex_count, Vec3::Zero());
    for (const Vec3& p : lay_padded(shirt, over, body)) x.push_back(p);
    return x;
  }());
  EXPECT_LT(near, alone + 0.005) << "as near as without trousers";
}

TEST(LayPadded, WhatCutsItselfAtEveryDistanceFindsNoRoom) {
  const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  const garment::Garment shirt = drafted("t-shirt", body.body());
  const dress::LayRound crumpled = [&](const garment::Garment& garment, const body::Body& wearer,
                                       const dress::LayingRoom& room) {
    std::vector<Vec3> x = kinds::garment_kind("t-shirt").lay(garment, wearer, room);
    for (Vec3& p : x) p.y() = 0.01 * std::sin(100 * p.x());
    return x;
  };
  EXPECT_THROW(lay_padded(shirt, crumpled, body), dress::NoRoom);
}

}  // namespace
}  // namespace loosefit::drape
