#include "loosefit/placement/tolerance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::placement {
namespace {

using End = Tolerance::End;

// q = 1 − (s/a)² along and 1 − (s/b)² around: a tenth is lost at s = √0.1 a and √0.1 b.
TEST(Tolerance, OfAQuadraticFieldIsExact) {
  const Vec2 centre(0.2, 0.5), along = Vec2(3, 4) / 5.0, around(-along.y(), along.x());
  const double a = 0.10, b = 0.03;
  const FlatScore q = [&](const Vec2& p) {
    const double s = (p - centre).dot(along), t = (p - centre).dot(around);
    return 1 - s * s / (a * a) - t * t / (b * b);
  };
  const Tolerance r = tolerance(q, centre, 7 * along);
  EXPECT_NEAR(r.along, std::sqrt(0.1) * a, 2e-6);
  EXPECT_NEAR(r.around, std::sqrt(0.1) * b, 2e-6);
  EXPECT_NEAR((r.direction - along).norm(), 0, 1e-12);
  EXPECT_EQ(r.along_end, End::score);
  EXPECT_EQ(r.around_end, End::score);
}

TEST(Tolerance, TakesTheSmallerSideAndIsRelativeToTheScore) {
  // Falls by 5 per metre to the left, rises to the right; 10 % of 0.5 is lost after 10 mm.
  const FlatScore q = [](const Vec2& p) { return 0.5 + 5 * p.x(); };
  const Tolerance r = tolerance(q, Vec2::Zero(), Vec2::UnitX());
  EXPECT_NEAR(r.along, 0.010, 2e-6);
  EXPECT_EQ(r.along_end, End::score);
  EXPECT_EQ(r.around, ToleranceOptions{}.reach);
  EXPECT_EQ(r.around_end, End::reach);
}

TEST(Tolerance, EndsAtTheOutline) {
  const FlatScore q = [](const Vec2& p) {
    return p.y() < 0.0123 ? std::optional<double>(1) : std::nullopt;
  };
  const Tolerance r = tolerance(q, Vec2::Zero(), Vec2::UnitY());
  EXPECT_NEAR(r.along, 0.0123, 2e-6);
  EXPECT_EQ(r.along_end, End::outline);
}

TEST(Tolerance, SeesADipBehindWhichTheScoreRecovers) {
  const FlatScore q = [](const Vec2& p) { return std::abs(p.x() - 0.02) < 0.0015 ? 0.2 : 0.8; };
  const Tolerance r = tolerance(q, Vec2::Zero(), Vec2::UnitX());
  EXPECT_NEAR(r.along, 0.0185, 2e-6);
}

TEST(Tolerance, OfAFailingPlaceIsZero) {
  const Tolerance r = tolerance([](const Vec2&) { return 0.0; }, Vec2::Zero(), Vec2::UnitX());
  EXPECT_EQ(r.along, 0);
  EXPECT_EQ(r.around, 0);
}

TEST(Tolerance, RefusesNonsense) {
  const FlatScore one = [](const Vec2&) { return 1.0; };
  EXPECT_THROW(tolerance(one, Vec2::Zero(), Vec2::Zero()), InvalidInput);
  ToleranceOptions bad;
  bad.step = 0;
  EXPECT_THROW(tolerance(one, Vec2::Zero(), Vec2::UnitX(), bad), InvalidInput);
  bad = {};
  bad.loss = 1;
  EXPECT_THROW(tolerance(one, Vec2::Zero(), Vec2::UnitX(), bad), InvalidInput);
}

}  // namespace
}  // namespace loosefit::placement
