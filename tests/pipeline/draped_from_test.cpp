#include "loosefit/pipeline/draped_from.h"

#include <gtest/gtest.h>

#include <random>

#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"

namespace loosefit::pipeline {
namespace {

/// The text as earlier versions wrote it.
std::string with_certificate(std::string toml, const std::string& grade) {
  return toml.insert(toml.find("gravity = "), "certificate = \"" + grade + "\"\n");
}

// Of scenarios that were drawn: what an earlier version kept of them holds, and of no other.
TEST(DrapedFrom, DigestsOfEarlierVersionsHold) {
  std::mt19937 random(5);
  for (int k = 0; k < 8; ++k) {
    scenario::Scenario s = io::default_scenario(), other = s;
    s.simulation.edge_length = std::uniform_real_distribution<double>(0.005, 0.05)(random);
    s.simulation.seed = random() % 1000 + 2;
    s.studied().spec.fit["chest"] = std::uniform_real_distribution<double>(-0.1, 0.4)(random);
    const std::string grade = random() % 2 ? "A" : "B", toml = io::scenario_toml(s);
    EXPECT_TRUE(io::is_digest_of(sha256_hex(toml), toml));
    EXPECT_TRUE(io::is_digest_of(sha256_hex(with_certificate(toml, grade)), toml));
    EXPECT_FALSE(io::is_digest_of(sha256_hex(with_certificate(toml, "C")), toml));
    EXPECT_FALSE(io::is_digest_of(sha256_hex(io::scenario_toml(other)), toml));

    // The section that they kept of [simulation] held the key; an edge of another length is told.
    scenario::Scenario part;
    part.simulation = s.simulation;
    const std::map<std::string, std::string> kept = {
        {"simulation", sha256_hex(with_certificate(io::scenario_toml(part), grade))}};
    EXPECT_NO_THROW(check_draped_from("scenario.toml", kept, s));
    s.simulation.edge_length *= 1.5;
    EXPECT_THROW(check_draped_from("scenario.toml", kept, s), InvalidInput);
  }
}

}  // namespace
}  // namespace loosefit::pipeline
