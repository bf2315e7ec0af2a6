#include "loosefit/io/run_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"

namespace loosefit {
namespace fs = std::filesystem;
namespace {

/// A fresh folder per test, removed at the end.
struct RunFolderTest : ::testing::Test {
  fs::path base =
      fs::temp_directory_path() / ("loosefit-" + std::to_string(getpid()) + "-" +
                                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override {
    fs::remove_all(base);
    fs::create_directories(base);
  }
  void TearDown() override { fs::remove_all(base); }
  int entries() const {
    return static_cast<int>(std::distance(fs::directory_iterator(base), fs::directory_iterator()));
  }
};

TEST_F(RunFolderTest, AppearsOnlyWhenCommitted) {
  {
    RunFolder folder = RunFolder::create(base / "run");
    write_text_file(folder.path() / "summary.json", "{}");
    EXPECT_FALSE(fs::exists(base / "run"));
    folder.commit();
  }
  EXPECT_EQ(read_text_file(base / "run" / "summary.json", 10), "{}");
  EXPECT_EQ(entries(), 1);
}

TEST_F(RunFolderTest, LeavesNothingWhenAbandoned) {
  try {
    RunFolder folder = RunFolder::create(base / "run");
    write_text_file(folder.path() / "half", "x");
    throw Cancelled();
  } catch (const Cancelled&) {
  }
  EXPECT_EQ(entries(), 0);
}

TEST_F(RunFolderTest, ReplacesAnEarlierOutputAsAWhole) {
  fs::create_directories(base / "run" / "maps");
  write_text_file(base / "run" / "summary.json", "old");
  write_text_file(base / "run" / "maps" / "old.png", "old");
  RunFolder folder = RunFolder::create(base / "run" / "");
  write_text_file(folder.path() / "summary.json", "new");
  EXPECT_EQ(read_text_file(base / "run" / "summary.json", 10), "old") << "until the commit";
  folder.commit();
  EXPECT_EQ(read_text_file(base / "run" / "summary.json", 10), "new");
  EXPECT_FALSE(fs::exists(base / "run" / "maps"));
  EXPECT_EQ(entries(), 1);
}

TEST_F(RunFolderTest, NeverTouchesAForeignFolderOrFile) {
  fs::create_directories(base / "thesis");
  write_text_file(base / "thesis" / "chapter.tex", "dear");
  EXPECT_THROW(RunFolder::create(base / "thesis"), InvalidInput);
  EXPECT_THROW(RunFolder::create(base / "thesis" / "chapter.tex"), InvalidInput);
  EXPECT_THROW(RunFolder::create(base / "thesis" / "chapter.tex" / "run"), IoError);
  EXPECT_THROW(RunFolder::update(base / "thesis"), InvalidInput);
  EXPECT_EQ(read_text_file(base / "thesis" / "chapter.tex", 10), "dear");
  EXPECT_EQ(entries(), 1);
}

TEST_F(RunFolderTest, UpdateKeepsTheOtherFiles) {
  fs::create_directories(base / "run" / "maps");
  write_text_file(base / "run" / "summary.json", "{}");
  write_text_file(base / "run" / "maps" / "a.png", "a");
  RunFolder folder = RunFolder::update(base / "run");
  write_text_file(folder.path() / "maps" / "b.png", "b");
  folder.commit();
  EXPECT_TRUE(fs::exists(base / "run" / "maps" / "a.png"));
  EXPECT_TRUE(fs::exists(base / "run" / "maps" / "b.png"));
}

TEST(TextFile, DiskFullIsAnIoError) {
  if (!fs::exists("/dev/full")) GTEST_FAIL() << "no /dev/full";
  EXPECT_THROW(write_text_file("/dev/full", std::string(100000, 'x')), IoError);
}

}  // namespace
}  // namespace loosefit
