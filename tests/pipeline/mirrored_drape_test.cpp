#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "support/only_draped.h"

namespace loosefit::pipeline {
namespace {

/// What leggings bear and how far they hang from the skin, in one posture from one start.
struct Hang {
  double force = 0;     ///< over the weight [–]
  double distance = 0;  ///< mean of the vertices [m]
};

Hang hang(const std::string& posture, int seed) {
  const CaseResult result = support::only_draped(
      fmt::format("[body]\nsex = \"male\"\nage = 30\nheight = 1.75\nposture = \"{}\"\n[garment]\n"
                  "pattern = \"leggings\"\n[material]\nname = \"compression-knit\"\n[simulation]\n"
                  "edge_length = 0.04\nseed = {}\nstart_perturbation = 0.001\n",
                  posture, seed));
  const drape::Drape& drape = result.studied().drape;
  Hang found;
  for (const double force : drape.body_normal_force) found.force += force;
  found.force /= result.studied().mesh().mass * kGravity;
  for (const Vec3& p : drape.positions)
    found.distance +=
        result.body.body.tree().signed_distance(p) / static_cast<double>(drape.positions.size());
  return found;
}

// The mirrored case hangs as its mirror image does, as far as two starts of one case agree.
TEST(MirroredDrape, HangsAsItsMirrorImageWithinTheSpreadOfStarts) {
  std::mt19937 random(61);
  const int angle = 20 + static_cast<int>(random() % 40);
  std::vector<Hang> left, right;
  for (const int seed : {1, 2}) {
    left.push_back(hang(fmt::format("left-hip-flexion-{}", angle), seed));
    right.push_back(hang(fmt::format("right-hip-flexion-{}", angle), seed));
  }
  const auto apart = [&](double Hang::*figure, double least) {
    const auto mean = [&](const std::vector<Hang>& of) {
      return 0.5 * (of[0].*figure + of[1].*figure);
    };
    const double spread =
        std::abs(left[0].*figure - left[1].*figure) + std::abs(right[0].*figure - right[1].*figure);
    EXPECT_LT(std::abs(mean(left) - mean(right)), std::max(spread, least * mean(left)))
        << mean(left) << " and " << mean(right) << ", spread of starts " << spread;
  };
  apart(&Hang::force, 0.05);
  apart(&Hang::distance, 0.03);
}

}  // namespace
}  // namespace loosefit::pipeline
