#include "loosefit/drape/drape_session.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <thread>

#include "loosefit/base/error.h"
#include "loosefit/body/named_postures.h"
#include "support/worn_shirt.h"

namespace loosefit::drape {
namespace {

using support::knit;

struct Wearer {
  body::BodyParameters parameters = support::adult_parameters();
  fabric::Material material = knit();
  garment::GarmentHierarchy garment = garment::build_hierarchy(
      support::shirt_for(support::standing(parameters, 25), 0.10), 0.05, material);

  body::BodyPath still() const { return support::arms_path(parameters, 25, 25); }
};

/// The body turned about a vertical axis by `angle` times the share: gravity and everything that
/// touches turn with it.
body::BodyPath turning(const Wearer& wearer, double angle) {
  return [&wearer, angle](double share) {
    body::Body body = support::standing(wearer.parameters, 25);
    const Mat3 turn = Eigen::AngleAxisd(angle * share, Vec3::UnitZ()).toRotationMatrix();
    for (Vec3& p : body.surface.vertices) p = turn * p;
    for (Vec3& n : body.normals) n = turn * n;
    for (auto& map : body.pose_from_rest) map = (turn * map).eval();
    return body;
  };
}

TEST(DrapeSession, ClothTurnsWithABodyThatTurnsAsAWhole) {
  const Wearer wearer;
  Progress silent;
  const DrapeOptions options;
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  DrapeSession session(wearer.garment, wearer.material, options, silent);
  EXPECT_THROW(session.follow(wearer.still(), silent), Error);
  const Drape first = session.put_on(wearer.still());
  ASSERT_TRUE(first.certificate.settled()) << first.certificate.stop_reason;
  EXPECT_THROW(session.put_on(wearer.still()), Error);

  const Drape same = session.follow(wearer.still(), silent);  // no motion: at rest it stays
  ASSERT_TRUE(same.certificate.settled()) << same.certificate.stop_reason;
  // Contact is seen afresh, which may let a fold go; it does not go far, and most of it stays.
  std::vector<double> moved;
  for (std::size_t i = 0; i < first.positions.size(); ++i)
    moved.push_back((same.positions[i] - first.positions[i]).norm());
  std::sort(moved.begin(), moved.end());
  EXPECT_LT(moved[moved.size() / 2], 3e-4);
  EXPECT_LT(moved.back(), 15e-3);

  constexpr double kAngle = 0.5;
  const Drape turned = session.follow(turning(wearer, kAngle), silent);
  ASSERT_TRUE(turned.certificate.settled()) << turned.certificate.stop_reason;
  const Mat3 turn = Eigen::AngleAxisd(kAngle, Vec3::UnitZ()).toRotationMatrix();
  std::vector<double> off;
  for (std::size_t i = 0; i < first.positions.size(); ++i)
    off.push_back((turned.positions[i] - turn * first.positions[i]).norm());
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 5e-3) << "of a way of a decimetre";
  EXPECT_LT(off[off.size() * 95 / 100], 1e-2);
}

TEST(DrapeSession, PosturesFollowedAtTheSameTimeAreThoseFollowedOneByOne) {
  // Two levels: the way is gone on the coarse one.
  Wearer wearer;
  wearer.garment = garment::build_hierarchy(
      support::shirt_for(support::standing(wearer.parameters, 25), 0.10), 0.017, wearer.material);
  ASSERT_EQ(wearer.garment.levels.size(), 2u);
  Progress silent;
  DrapeOptions options;
  DrapeSession session(wearer.garment, wearer.material, options, silent);
  ASSERT_TRUE(session.put_on(wearer.still()).certificate.settled());
  const double angles[] = {0.3, -0.4};
  Drape beside[2];
  const auto follow = [&](int k) {
    Progress own;
    beside[k] = session.follow(turning(wearer, angles[k]), own);
  };
  std::thread other(follow, 1);
  follow(0);
  other.join();
  for (int k : {1, 0}) {
    const Drape alone = session.follow(turning(wearer, angles[k]), silent);
    EXPECT_TRUE(alone.certificate.settled()) << alone.certificate.stop_reason;
    EXPECT_EQ(alone.positions, beside[k].positions) << angles[k];
  }
}

TEST(DrapeSession, ADisturbedStartEndsElsewhere) {
  const Wearer wearer;
  Progress silent;
  DrapeOptions options;
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto drape = [&] {
    return DrapeSession(wearer.garment, wearer.material, options, silent).put_on(wearer.still());
  };
  const Drape plain = drape();
  options.start_shift = Vec3(0, 0, -0.01);
  options.start_twist = radians(8);
  const Drape one = drape();
  ASSERT_TRUE(one.certificate.settled()) << one.certificate.stop_reason;
  double apart = 0;
  for (std::size_t i = 0; i < plain.positions.size(); ++i)
    apart += (one.positions[i] - plain.positions[i]).norm() /
             static_cast<double>(plain.positions.size());
  EXPECT_GT(apart, 1e-3);
  EXPECT_LT(apart, 0.03);
}

}  // namespace
}  // namespace loosefit::drape
