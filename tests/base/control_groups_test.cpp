#include "loosefit/base/control_groups.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>

#include "support/scratch_folder.h"

namespace loosefit {
namespace fs = std::filesystem;
namespace {

/// A machine's control groups as files.
struct Groups : ::testing::Test {
  const support::ScratchFolder base;
  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories((base / file).parent_path());
    std::ofstream(base / file) << text << "\n";
  }
  GroupLimits limits() const { return group_limits(base / "membership", base / "mounts"); }
};

TEST_F(Groups, WithoutAnyThereIsNoLimit) {
  EXPECT_FALSE(limits().cores);
  EXPECT_FALSE(limits().memory_bytes);
  write("membership", "0::/own");
  write("mounts/own/cpu.max", "max 100000");
  write("mounts/own/memory.max", "max");
  EXPECT_FALSE(limits().cores);
  EXPECT_FALSE(limits().memory_bytes);
}

TEST_F(Groups, OfVersion1ReadTheHierarchyOfTheController) {
  write("membership", "4:memory:/slice\n3:cpu,cpuacct:/slice\n1:name=systemd:/slice");
  write("mounts/cpu,cpuacct/slice/cpu.cfs_quota_us", "150000");
  write("mounts/cpu,cpuacct/slice/cpu.cfs_period_us", "100000");
  write("mounts/memory/slice/memory.limit_in_bytes", "500000000");
  ASSERT_TRUE(limits().cores && limits().memory_bytes);
  EXPECT_DOUBLE_EQ(*limits().cores, 1.5);
  EXPECT_DOUBLE_EQ(*limits().memory_bytes, 5e8);
  write("mounts/cpu,cpuacct/slice/cpu.cfs_quota_us", "-1");
  EXPECT_FALSE(limits().cores);
}

TEST_F(Groups, InAContainerTheRootIsTheOwnGroup) {
  write("membership", "0::/docker/0123");  // as the host names it; not to be seen here
  write("mounts/cpu.max", "50000 100000");
  ASSERT_TRUE(limits().cores);
  EXPECT_DOUBLE_EQ(*limits().cores, 0.5);
}

TEST_F(Groups, TheTightestOfANestCounts) {
  std::mt19937 random(61);
  for (int draw = 0; draw < 30; ++draw) {
    base.clear();
    const bool second = random() % 2;
    const fs::path root = second ? "mounts" : "mounts/cpu";
    fs::path group;
    std::optional<double> least;
    const int depth = 1 + static_cast<int>(random() % 4);
    for (int level = 0; level <= depth; ++level) {
      const int quota = 10000 + static_cast<int>(random() % 900000);
      const bool limited = random() % 3 != 0;
      const fs::path folder = root / group;
      if (second) {
        write(folder / "cpu.max", limited ? std::to_string(quota) + " 100000" : "max 100000");
      } else {
        write(folder / "cpu.cfs_quota_us", limited ? std::to_string(quota) : "-1");
        write(folder / "cpu.cfs_period_us", "100000");
      }
      if (limited) least = std::min(least.value_or(1e9), quota / 1e5);
      if (level < depth) group /= "g" + std::to_string(level);
    }
    write("membership", (second ? "0::/" : "5:cpu:/") + group.string());
    ASSERT_EQ(limits().cores.has_value(), least.has_value()) << draw;
    EXPECT_DOUBLE_EQ(limits().cores.value_or(0), least.value_or(0)) << draw;
  }
}

}  // namespace
}  // namespace loosefit
