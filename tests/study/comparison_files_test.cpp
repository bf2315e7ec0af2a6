#include "loosefit/study/comparison_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "support/scratch_folder.h"

namespace loosefit::study {
namespace {

namespace fs = std::filesystem;

class ComparisonFiles : public ::testing::Test {
 protected:
  int files() const {
    return static_cast<int>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  const support::ScratchFolder folder;
};

TEST_F(ComparisonFiles, AppearTogetherAndTakeTheirOwnPlacesAgain) {
  write_comparison({}, folder / "x.csv", false);
  EXPECT_TRUE(fs::exists(folder / "x.csv"));
  EXPECT_TRUE(fs::exists(folder / "x.limits.csv"));
  EXPECT_THROW(write_comparison({}, folder / "x.csv", false), InvalidInput);
  write_comparison({}, folder / "x.csv", true);
  EXPECT_EQ(files(), 2);
}

TEST_F(ComparisonFiles, AreBothAsTheyWereWhenOneCannotBeWritten) {
  io::write_text_file((folder / "x.csv").string(), "old");
  // A folder has the name under which the second one waits.
  fs::create_directories(folder / (".x.limits.csv." + std::to_string(getpid()) + ".part") /
                         "within");
  EXPECT_THROW(write_comparison({}, folder / "x.csv", true), IoError);
  EXPECT_EQ(io::read_text_file((folder / "x.csv").string(), 100), "old");
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace loosefit::study
