#include <gtest/gtest.h>

#include "loosefit/contact/friction.h"

namespace loosefit::contact {
namespace {

constexpr double kMu = 0.3, kNormal = 2.0, kReach = 1e-4;

std::vector<FrictionContact> one_contact() {
  FrictionContact c;
  c.key = 1;
  c.particle[0] = 0;
  c.weight[0] = 1;
  c.count = 1;
  c.normal_force = kNormal;
  return {c};
}

double force(const Friction& friction, const particles::VectorField& x) {
  particles::VectorField g(1, Vec3::Zero());
  friction.add_gradient(x, g);
  return g[0].norm();
}

// A point that sticks feels nothing when what it sticks to takes it along, and the whole Coulomb
// force when it moves and the ground does not, or the ground without it.
TEST(FrictionCarry, OnlyMotionAgainstTheGroundRubs) {
  const Vec3 way(0.05, 0.02, 0);
  const particles::VectorField here = {Vec3::Zero()}, there = {way};
  Friction taken(kMu, kReach), left(kMu, kReach), alone(kMu, kReach);
  for (Friction* f : {&taken, &left, &alone}) f->restart(one_contact(), here);
  taken.carry({way});
  EXPECT_EQ(force(taken, there), 0);
  taken.restart(one_contact(), there);
  EXPECT_EQ(force(taken, there), 0);
  left.carry({way});
  EXPECT_NEAR(force(left, here), kMu * kNormal, 1e-12);
  EXPECT_NEAR(force(alone, there), kMu * kNormal, 1e-12);
}

TEST(FrictionCarry, WhatWasStretchedBeforeStaysStretched) {
  const particles::VectorField here = {Vec3::Zero()}, crept = {Vec3(0.5 * kReach, 0, 0)};
  Friction friction(kMu, kReach);
  friction.restart(one_contact(), here);
  const double before = force(friction, crept);
  friction.restart(one_contact(), crept);
  friction.carry({Vec3(0, 0.03, 0)});
  EXPECT_NEAR(force(friction, {Vec3(0.5 * kReach, 0.03, 0)}), before, 1e-12);
  EXPECT_NEAR(before, kMu * kNormal * 0.75, 1e-12);  // s (2 − s) at s = ½
}

}  // namespace
}  // namespace loosefit::contact
