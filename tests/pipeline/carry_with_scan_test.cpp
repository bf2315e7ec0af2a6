#include "loosefit/pipeline/carry_with_scan.h"

#include <gtest/gtest.h>

namespace loosefit::pipeline {
namespace {

/// A box of a person's size that was scanned at `place` and turned half round, and a panel before
/// its chest.
struct Fitting {
  body::Body body;
  pattern::Pattern pattern;

  Fitting(const Vec3& place, bool turned) {
    body::RigidMotion& motion = body.from_world;
    if (turned) motion.linear() << -1, 0, 0, 0, -1, 0, 0, 0, 1;
    motion.translation() = -(motion.linear() * place);
    for (const double x : {-0.25, 0.25})
      for (const double y : {-0.12, 0.12})
        for (const double z : {0., 1.7}) body.surface.vertices.emplace_back(x, y, z);
    for (const double y : {-0.2, 0.2}) {
      pattern::Panel panel;
      panel.vertices = {{-0.3, 0}, {0.3, 0}, {0.3, 0.6}, {-0.3, 0.6}};
      panel.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
      panel.translation = Vec3(0, y, 0.9);
      pattern.panels.push_back(panel);
    }
  }
  Vec3 corner(std::size_t panel, std::size_t vertex) const {
    const pattern::Panel& p = pattern.panels[panel];
    const Vec2& v = p.vertices[vertex];
    return p.rotation * Vec3(v.x(), v.y(), 0) + p.translation;
  }
  void move_pattern(const body::RigidMotion& by) {
    for (pattern::Panel& panel : pattern.panels) {
      panel.translation = by * panel.translation;
      panel.rotation = by.linear() * panel.rotation;
    }
  }
};

TEST(CarryWithScan, PanelsKeepTheirPlaceOnThePerson) {
  // Beside the origin, from the pelvis, far off in the room; facing either way.
  for (const Vec3& place : {Vec3(0.2, -0.1, 0), Vec3(0, 0, -0.95), Vec3(2, 3, 0.1)}) {
    for (const bool turned : {false, true}) {
      const Fitting wanted(place, turned);
      Fitting made = wanted;
      made.move_pattern(made.body.from_world.inverse());  // as the file has it
      std::vector<std::string> warnings;
      carry_with_scan(made.pattern, made.body, warnings);
      // In doubt is only what a person over the origin could wear too, and lies otherwise there.
      const double aside = place.head<2>().norm();
      const bool either = aside < 1 && (turned || aside > 0);
      EXPECT_EQ(warnings.size(), either ? 1u : 0u) << place.transpose();
      for (const std::size_t panel : {0, 1})
        for (std::size_t v = 0; v < 4; ++v)
          EXPECT_LT((made.corner(panel, v) - wanted.corner(panel, v)).norm(), 1e-12);
    }
  }
}

TEST(CarryWithScan, SaysThatAPatternMayBeTurnedBackToFront) {
  Fitting made(Vec3(0.001, 0, 0), true);  // drafted to face -y, scanned facing +y
  std::vector<std::string> warnings;
  carry_with_scan(made.pattern, made.body, warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("turned by 180 degrees"), std::string::npos) << warnings[0];

  Fitting in_place(Vec3(0.001, 0, -0.5), false);  // only up: the floor was elsewhere
  in_place.move_pattern(in_place.body.from_world.inverse());
  warnings.clear();
  carry_with_scan(in_place.pattern, in_place.body, warnings);
  EXPECT_TRUE(warnings.empty());
}

TEST(CarryWithScan, APatternForABodyOverTheOriginStays) {
  const Fitting wanted(Vec3(3, 2, 0), false);
  Fitting made = wanted;
  std::vector<std::string> warnings;
  carry_with_scan(made.pattern, made.body, warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("over the origin"), std::string::npos);
  EXPECT_EQ(made.corner(0, 2), wanted.corner(0, 2));
}

TEST(CarryWithScan, APatternThatLiesStraightOverTheOriginStays) {
  // Scanned a little aside and turned by 10 degrees: the box of the panels is round the scan, too.
  Fitting wanted(Vec3(0.1, 0.05, 0), false);
  wanted.body.from_world.linear() = Eigen::AngleAxisd(radians(10), Vec3::UnitZ()).matrix();
  Fitting made = wanted;
  std::vector<std::string> warnings;
  carry_with_scan(made.pattern, made.body, warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("over the origin"), std::string::npos) << warnings[0];
  EXPECT_EQ(made.corner(0, 2), wanted.corner(0, 2));
}

}  // namespace
}  // namespace loosefit::pipeline
