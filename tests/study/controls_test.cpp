#include "loosefit/study/controls.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace loosefit::study {
namespace {

TEST(Controls, AreOneInTwentyByTheAddressAloneAndAtLeastOne) {
  std::vector<std::string> addresses;
  for (unsigned i = 0; i < 4000; ++i)
    addresses.push_back(fmt::format("{:06x}", (i * 2654435761u) >> 8));
  const std::vector<std::string> all = control_addresses(addresses);
  EXPECT_NEAR(double(all.size()), 200, 50);
  // Those of a part are among those of the whole.
  const std::vector<std::string> part(addresses.begin(), addresses.begin() + 1000);
  for (const std::string& address : control_addresses(part))
    EXPECT_NE(std::find(all.begin(), all.end(), address), all.end());
  EXPECT_EQ(control_addresses({"00000b", "000003", "000007"}), std::vector<std::string>{"000003"});
  EXPECT_TRUE(control_addresses({}).empty());
}

CaseRecord record(double gap, double score) {
  CaseRecord r;
  r.status = CaseStatus::done;
  for (int donning = 1; donning <= 2; ++donning) {
    SampleRecord sample;
    sample.modality = "imu";
    sample.site = "t3";
    sample.donning = donning;
    sample.score = score;
    sample.metrics = {{"gap_mm", gap * donning}};
    r.samples.push_back(sample);
  }
  return r;
}

TEST(Controls, TellTheGreatestChange) {
  const Control control = compared(record(1.0, 0.5), record(1.01, 0.48));
  EXPECT_TRUE(control.ran);
  EXPECT_NEAR(control.largest.at("gap_mm"), 0.02, 1e-12);
  EXPECT_NEAR(control.largest.at("score"), 0.02, 1e-12);
  CaseRecord sealed;
  sealed.status = CaseStatus::sealed;
  sealed.reason = "not settled: time budget";
  const Control bad = compared(record(1, 1), sealed);
  EXPECT_EQ(bad.failed, "not settled: time budget");
  ControlSummary summary;
  add(control, summary);
  add(bad, summary);
  add(Control{}, summary);
  EXPECT_EQ(summary.cases, 2);
  EXPECT_EQ(summary.failed, 1);
  EXPECT_NEAR(summary.largest.at("gap_mm"), 0.02, 1e-12);
}

}  // namespace
}  // namespace loosefit::study
