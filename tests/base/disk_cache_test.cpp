#include "loosefit/base/disk_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "loosefit/base/sha256.h"
#include "support/scratch_folder.h"

namespace loosefit {
namespace {

namespace fs = std::filesystem;

class DiskCache : public ::testing::Test {
 protected:
  const support::ScratchFolder scratch;
  const fs::path base = scratch / "cache";
  const std::string key = sha256_hex("a key");
  void SetUp() override {
    setenv("LOOSEFIT_CACHE", base.c_str(), 1);
    disk_cache::turn_on(true);
  }
  void TearDown() override {
    disk_cache::turn_on(false);
    unsetenv("LOOSEFIT_CACHE");
  }
};

TEST_F(DiskCache, GivesBackWhatWasStored) {
  const std::string bytes("\0a\nb\xff", 5);
  EXPECT_EQ(disk_cache::load(key), std::nullopt);
  disk_cache::store(key, bytes);
  EXPECT_EQ(disk_cache::load(key), bytes);
  EXPECT_EQ(disk_cache::load(sha256_hex("another")), std::nullopt);
  disk_cache::store(key, "");
  EXPECT_EQ(disk_cache::load(key), "");
  EXPECT_EQ(disk_cache::size().files, 1u);
}

TEST_F(DiskCache, ADamagedFileCountsAsAbsent) {
  disk_cache::store(key, "the result");
  for (const char* damage :
       {"", "short", "the result that is not the one that was stored, and longer"}) {
    for (const auto& file : fs::directory_iterator(base)) std::ofstream(file.path()) << damage;
    EXPECT_EQ(disk_cache::load(key), std::nullopt) << damage;
  }
}

TEST_F(DiskCache, AFileLargerThanTheWholeCacheCountsAsAbsent) {
  disk_cache::store(key, "x");
  fs::resize_file(base / (key + ".lfc"), disk_cache::kMostBytes + 1);  // sparse
  EXPECT_EQ(disk_cache::load(key), std::nullopt);
}

TEST_F(DiskCache, AFolderInItsPlaceCountsAsAbsent) {
  fs::create_directories(base / (key + ".lfc"));
  EXPECT_EQ(disk_cache::load(key), std::nullopt);
}

TEST_F(DiskCache, IsOffUntilAProgramTurnsItOn) {
  disk_cache::turn_on(false);
  disk_cache::store(key, "x");
  EXPECT_FALSE(fs::exists(base));
  disk_cache::turn_on(true);
  setenv("LOOSEFIT_CACHE", "off", 1);
  EXPECT_TRUE(disk_cache::folder().empty());
  disk_cache::store(key, "x");
  EXPECT_EQ(disk_cache::load(key), std::nullopt);
}

TEST_F(DiskCache, AFolderThatCannotBeWrittenIsNoError) {
  std::ofstream(base) << "a file in its place";
  disk_cache::store(key, "x");
  EXPECT_EQ(disk_cache::load(key), std::nullopt);
}

TEST_F(DiskCache, WhatNobodyAskedForLongestMakesRoom) {
  disk_cache::store(sha256_hex("old"), "x");
  const auto old = base / (sha256_hex("old") + ".lfc");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1));
  std::ofstream(base / "unfinished.lfc-new").put('x');
  fs::resize_file(base / "unfinished.lfc-new", disk_cache::kMostBytes);  // sparse
  fs::last_write_time(base / "unfinished.lfc-new",
                      fs::file_time_type::clock::now() - std::chrono::minutes(30));
  for (int k = 0; k < 64; ++k) disk_cache::store(key, "new");
  EXPECT_EQ(disk_cache::load(key), "new");
  EXPECT_FALSE(fs::exists(old));
  EXPECT_EQ(disk_cache::size().files, 1u);
}

}  // namespace
}  // namespace loosefit
