#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/drape/drape_session.h"
#include "loosefit/drape/recoveries.h"
#include "loosefit/drape/settle_garment.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/worn_shirt.h"

namespace loosefit::drape {
namespace {

using support::knit;
using support::shirt_for;

/// An adult with a moderately loose shirt on a coarse mesh of one level.
struct Wearer {
  body::BodyParameters parameters = support::adult_parameters();
  fabric::Material material = knit();
  garment::GarmentHierarchy garment;

  Wearer()
      : garment(garment::build_hierarchy(shirt_for(support::standing(parameters, 25), 0.10), 0.03,
                                         material)) {}

  /// From one arm angle to another [degrees].
  body::BodyPath path(double from, double to) const {
    return support::arms_path(parameters, from, to);
  }
  int cuts_body(const std::vector<Vec3>& x, double arms) const {
    const body::Body body = support::standing(parameters, arms);
    return static_cast<int>(geometry::mesh_intersections(x, garment.finest().triangles,
                                                         body.surface.vertices,
                                                         body.surface.triangles)
                                .size());
  }
  int cuts_self(const std::vector<Vec3>& x) const {
    return static_cast<int>(geometry::self_intersections(x, garment.finest().triangles).size());
  }
};

const Wearer& wearer() {
  static const Wearer one;
  return one;
}

/// The standing drape, settled once for all tests that look at it.
const Drape& standing_drape() {
  static const Drape drape = [] {
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    Progress silent;
    return drape_garment(wearer().garment, wearer().material, wearer().path(25, 25), {}, silent);
  }();
  return drape;
}

void expect_certificate_holds_under_independent_tests() {
  const Drape& d = standing_drape();
  EXPECT_TRUE(d.certificate.settled())
      << d.certificate.stop_reason << " " << d.certificate.residual << " "
      << d.certificate.intersections_body << " " << d.certificate.intersections_self;
  EXPECT_EQ(d.certificate.stop_reason, "converged");
  EXPECT_EQ(d.certificate.reason, StopReason::converged);
  EXPECT_GT(d.certificate.residual, 0);
  EXPECT_LE(d.certificate.residual, 1e-3);
  EXPECT_GT(d.certificate.residual_max, 0);
  EXPECT_EQ(d.certificate.intersections_self, wearer().cuts_self(d.positions));
  EXPECT_EQ(d.certificate.intersections_body, wearer().cuts_body(d.positions, 25));
  EXPECT_FALSE(d.unsettled.has_value());
  EXPECT_GT(d.report.total().iterations, 0);
  EXPECT_GT(d.report.total().factorisations, 0);
  EXPECT_GT(d.report.contacts_body, 100);
  // Force acts on a part of the cloth, which lies on the skin.
  EXPECT_GT(d.report.bearing_area, 0);
  EXPECT_LT(d.report.bearing_area, wearer().garment.finest().area);
  ASSERT_TRUE(d.report.bearing_distance.has_value());
  EXPECT_GT(*d.report.bearing_distance, 0);
  EXPECT_LT(*d.report.bearing_distance, d.report.largest_contact_offset + 1e-4);
  ASSERT_FALSE(d.report.history.empty());
  double last = 0;
  for (const SettleSample& s : d.report.history) {
    EXPECT_GE(s.seconds, last);
    last = s.seconds;
  }
}

void expect_body_carries_the_weight() {
  const Drape& d = standing_drape();
  Vec3 carried = Vec3::Zero();
  for (const Vec3& f : d.body_contact_force) carried += f;
  const double weight = wearer().garment.finest().mass * kGravity;
  EXPECT_NEAR(carried[2], weight, 0.01 * weight);
  EXPECT_LT(carried.head<2>().norm(), 0.01 * weight);
}

void expect_hangs_on_the_shoulders() {
  const Drape& d = standing_drape();
  const garment::Garment& g = wearer().garment.finest();
  const body::Body body = support::standing(wearer().parameters, 25);
  const geometry::ClosestPointTree tree(body.surface);
  int outside = 0;
  for (const Vec3& p : d.positions) {
    const double distance = tree.signed_distance(p);
    EXPECT_GT(distance, -1e-3);
    EXPECT_LT(distance, 0.25);
    outside += distance > 0;
  }
  EXPECT_GT(outside, static_cast<int>(0.99 * static_cast<double>(d.positions.size())));
  for (const char* side : {"_L", "_R"})
    for (int v : g.find_chain("front", std::string("shoulder") + side)->vertices) {
      EXPECT_LT(tree.query(d.positions[v]).distance, 0.02);
      EXPECT_GT(d.positions[v][2], body.joints.at(std::string("shoulder") + side)[2] - 0.03);
    }
}

void expect_two_threads_give_the_same_bits() {
  const Drape& one = standing_drape();
  const tbb::global_control two_threads(tbb::global_control::max_allowed_parallelism, 2);
  Progress silent;
  const Drape d =
      drape_garment(wearer().garment, wearer().material, wearer().path(25, 25), {}, silent);
  ASSERT_EQ(d.positions.size(), one.positions.size());
  EXPECT_EQ(
      std::memcmp(d.positions.data(), one.positions.data(), one.positions.size() * sizeof(Vec3)),
      0);
  EXPECT_EQ(d.report.total().iterations, one.report.total().iterations);
}

// One test, because each runs in a process of its own and would settle the shirt anew.
TEST(DrapeGarment, SettlesOnTheShouldersWithACertificateThatHoldsAndTheSameBitsOnTwoThreads) {
  expect_certificate_holds_under_independent_tests();
  expect_body_carries_the_weight();
  expect_hangs_on_the_shoulders();
  expect_two_threads_give_the_same_bits();
}

TEST(DrapeGarment, TimeBudgetEndsItHonestly) {
  Progress silent;
  DrapeOptions options;
  options.time_budget = 0.1;
  const Drape d =
      drape_garment(wearer().garment, wearer().material, wearer().path(25, 25), options, silent);
  EXPECT_FALSE(d.certificate.settled());
  EXPECT_EQ(d.certificate.stop_reason.find("time budget"), 0u) << d.certificate.stop_reason;
  EXPECT_EQ(d.certificate.reason, StopReason::time_budget);
  EXPECT_EQ(d.certificate.stop_reason.find("cut the body") != std::string::npos,
            d.certificate.intersections_body + d.certificate.intersections_self > 0);
  EXPECT_GT(d.certificate.residual, 1e-3);
  EXPECT_EQ(d.certificate.intersections_self, wearer().cuts_self(d.positions));
  EXPECT_EQ(d.certificate.intersections_body, wearer().cuts_body(d.positions, 25));
  for (const Vec3& p : d.positions) ASSERT_TRUE(p.allFinite());
  ASSERT_TRUE(d.unsettled.has_value());
  EXPECT_NEAR(d.unsettled->times_allowed, 1000 * d.certificate.residual,
              1e-9 * d.unsettled->times_allowed);
  ASSERT_FALSE(d.unsettled->worst.empty());
  EXPECT_NE(d.unsettled->why.find(d.unsettled->worst[0].panel), std::string::npos);
}

TEST(DrapeGarment, IterationsOfTheWholeDrapeEndItWithTheLowestResidual) {
  const int all = standing_drape().report.total().iterations;
  DrapeOptions options;
  options.max_iterations = all - 4;  // the last ones are those at rest
  Progress silent;
  const Drape d =
      drape_garment(wearer().garment, wearer().material, wearer().path(25, 25), options, silent);
  ASSERT_FALSE(d.certificate.settled());
  EXPECT_EQ(d.certificate.reason, StopReason::iteration_limit);
  EXPECT_EQ(d.certificate.stop_reason.find("iteration limit"), 0u) << d.certificate.stop_reason;
  // Levels, phases and recoveries share the limit, which is looked at between two balances.
  EXPECT_LE(d.report.total().iterations, options.max_iterations + 12);
  double lowest = 1e9;
  for (const SettleSample& s : d.report.history) lowest = std::min(lowest, s.residual);
  // States are kept when the residual has fallen by three tenths since the last one that was.
  ASSERT_EQ(d.certificate.intersections_body, 0) << "states that cut rank by their cuts";
  EXPECT_LT(d.certificate.residual, 1.5 * lowest);
  EXPECT_TRUE(d.unsettled.has_value());
}

/// The recoveries of a drape that has not settled until one of them is tried, and cuts the skin so
/// often until then.
class FailsAtFirst {
 public:
  /// `before`: called before it is tried.
  explicit FailsAtFirst(RecoveryKind kind, int cuts = 0, std::function<void()> before = {}) {
    for (Recovery& row : table_)
      if (row.kind == kind) {
        row.has_failed = [this, cuts, failed = row.has_failed](ClothState& state) {
          if (failing_) {
            state.certificate.residual = 1;  // as if it had not come to rest
            state.certificate.intersections_body = cuts;
          }
          return failed(state);
        };
        row.act = [this, before, act = row.act](ClothState& state) {
          failing_ = false;
          if (before) before();
          act(state);
        };
      }
  }
  const Recoveries& table() const { return table_; }

 private:
  Recoveries table_ = recoveries();
  bool failing_ = true;
};

/// A drape that has not settled before another start, with so many cuts.
struct Restarted {
  Progress silent;
  DrapeOptions options;
  std::vector<ClothLayer> layers{{&wearer().garment, wearer().material}};
  std::shared_ptr<const WornCloth> worn;

  Drape drape(int cuts, const body::BodyPath& path, std::function<void()> before = {}) {
    const FailsAtFirst failing(RecoveryKind::another_start, cuts, std::move(before));
    ClothState state(layers, options, failing.table(), silent);
    state.movements = {{.friction_share = 0.2}};
    return dress_and_settle(state, path, {}, worn);
  }
  Drape drape(int cuts) { return drape(cuts, wearer().path(25, 25)); }
};

/// The same drape without a failure.
const Drape& undisturbed() {
  static const Drape kDrape = [] {
    Restarted with;
    ClothState state(with.layers, with.options, recoveries(), with.silent);
    state.movements = {{.friction_share = 0.2}};
    return dress_and_settle(state, wearer().path(25, 25), {}, with.worn);
  }();
  return kDrape;
}

void expect_undisturbed(const Drape& d, const WornCloth& worn) {
  EXPECT_TRUE(d.report.was_tried(RecoveryKind::another_start));
  EXPECT_EQ(d.positions, undisturbed().positions);
  EXPECT_TRUE(d.certificate.settled()) << d.certificate.stop_reason;
  // Certifying renews contacts; friction at a fifth would tell by far more.
  EXPECT_NEAR(d.certificate.residual, undisturbed().certificate.residual, 5e-5);
  EXPECT_EQ(worn.levels.size(), wearer().garment.levels.size());
  EXPECT_EQ(worn.levels.back().x, d.positions);
}

TEST(DrapeGarment, IsPutOnOnceMoreFromAShiftedStartWhereFewTrianglesCut) {
  Restarted first, again, many;
  const int few = first.options.tuning.certify.few_triangles;
  const Drape d = first.drape(few);
  EXPECT_TRUE(d.report.was_tried(RecoveryKind::another_start));
  EXPECT_EQ(std::count_if(d.report.parts.begin(), d.report.parts.end(),
                          [](const PartWork& p) { return p.part == "dress"; }),
            2);
  EXPECT_TRUE(d.certificate.settled()) << d.certificate.stop_reason;
  EXPECT_EQ(wearer().cuts_body(d.positions, 25), 0);
  EXPECT_NE(d.positions, undisturbed().positions) << "it went another way";
  double farthest = 0;
  for (std::size_t i = 0; i < d.positions.size(); ++i)
    farthest = std::max(farthest, (d.positions[i] - undisturbed().positions[i]).norm());
  EXPECT_LT(farthest, 0.05) << "but not far";
  // What followers take up is of the second start alone.
  EXPECT_EQ(first.worn->levels.size(), wearer().garment.levels.size());
  EXPECT_LT(first.worn->iterations, undisturbed().report.total().iterations);
  // A drape can be repeated.
  EXPECT_EQ(again.drape(few).positions, d.positions);
  // Where many cut there is no room.
  EXPECT_FALSE(many.drape(few + 1).report.was_tried(RecoveryKind::another_start));
}

TEST(DrapeGarment, KeepsTheFirstDrapeWhereTheSecondStartHasNoIterationsToComeToRest) {
  Restarted cut_short;
  const int first = undisturbed().report.total().iterations;
  const Drape d = cut_short.drape(3, wearer().path(25, 25),
                                  [&] { cut_short.options.max_iterations = first + 5; });
  expect_undisturbed(d, *cut_short.worn);
}

TEST(DrapeGarment, KeepsTheFirstDrapeWhereTheSecondCannotBePutOn) {
  Restarted without_room;
  bool second = false;
  const body::BodyPath path = [&](double share) {
    if (second && share == 0) throw GeometryError("no room");
    return wearer().path(25, 25)(share);
  };
  const Drape d = without_room.drape(3, path, [&] { second = true; });
  expect_undisturbed(d, *without_room.worn);
}

TEST(DrapeGarment, IsNotPutOnAgainWhereLessThanTheFirstStartTookIsLeft) {
  Restarted scarce;
  scarce.options.max_iterations = 2 * undisturbed().report.total().iterations - 20;
  EXPECT_FALSE(scarce.drape(3).report.was_tried(RecoveryKind::another_start));
}

TEST(DrapeGarment, DoesNotTryAgainWhatIsAtRestByItsOwnLooserTolerance) {
  Progress silent;
  DrapeOptions options;
  options.residual_tolerance = 0.05;
  const Drape d =
      drape_garment(wearer().garment, wearer().material, wearer().path(25, 25), options, silent);
  ASSERT_EQ(d.certificate.intersections_body, 0);
  EXPECT_LE(d.certificate.residual, 0.05);
  EXPECT_EQ(d.certificate.allowed_residual, 0.05);
  EXPECT_TRUE(d.certificate.settled());
  EXPECT_EQ(d.report.parts.back().part, "settle");
}

/// Asks to stop at the n-th update.
class Impatient : public Progress {
 public:
  explicit Impatient(int updates) : left_(updates) {}
  void stage(const std::string& name) override { stages += name + " "; }
  void update(double fraction, const std::string&) override {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    if (--left_ == 0) request_cancel();
  }
  std::string stages;

 private:
  int left_;
};

TEST(DrapeGarment, CancellingThrowsWhereverItIs) {
  const DrapeOptions options;
  for (int updates : {1, 60}) {
    Impatient progress(updates);
    EXPECT_THROW(drape_garment(wearer().garment, wearer().material, wearer().path(25, 25), options,
                               progress),
                 Cancelled)
        << updates;
  }
}

TEST(DrapeGarment, IsCarriedAlongToAnotherPostureWithoutSelfIntersections) {
  Impatient progress(-1);  // never
  const DrapeOptions options;
  const Drape d =
      drape_garment(wearer().garment, wearer().material, wearer().path(40, 25), options, progress);
  EXPECT_EQ(progress.stages, "dress settle ");
  EXPECT_EQ(wearer().cuts_self(d.positions), 0);
  EXPECT_EQ(d.certificate.intersections_self, 0);
  EXPECT_TRUE(d.certificate.settled()) << d.certificate.stop_reason << d.certificate.residual << " "
                                       << d.certificate.intersections_body;
  EXPECT_EQ(d.certificate.intersections_body, wearer().cuts_body(d.positions, 25));
}

TEST(DrapeGarment, ArmsThatHangAreAnErrorNotADrape) {
  Progress silent;
  EXPECT_THROW(drape_garment(wearer().garment, wearer().material, wearer().path(5, 5),
                             DrapeOptions{}, silent),
               GeometryError);
}

}  // namespace
}  // namespace loosefit::drape
