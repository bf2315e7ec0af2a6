#include "loosefit/io/whole_file.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace {

namespace fs = std::filesystem;

struct WholeFile : ::testing::Test {
  const support::ScratchFolder folder;
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
};

TEST_F(WholeFile, ReplacesOnlyWhatItMay) {
  write_whole_file(folder / "a.png", "one", false);
  EXPECT_THROW(write_whole_file(folder / "a.png", "two", false), InvalidInput);
  EXPECT_EQ(read_text_file(folder / "a.png", 100), "one");
  write_whole_file(folder / "a.png", "two", true);
  EXPECT_EQ(read_text_file(folder / "a.png", 100), "two");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WholeFile, LeavesNothingWhereItFails) {
  fs::create_directory(folder / "b.png");
  EXPECT_THROW(write_whole_file(folder / "b.png", "x", true), InvalidInput);
  EXPECT_THROW(write_whole_file(folder / "none" / "c.png", "x", true), IoError);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WholeFile, ReplacesALinkNotWhatItLeadsTo) {
  write_text_file(folder / "precious", "data");
  fs::create_symlink(folder / "precious", folder / "c.png");
  EXPECT_THROW(write_whole_file(folder / "c.png", "x", false), InvalidInput);
  write_whole_file(folder / "c.png", "x", true);
  EXPECT_EQ(read_text_file(folder / "precious", 100), "data");
  EXPECT_FALSE(fs::is_symlink(folder / "c.png"));
}

TEST_F(WholeFile, ReplacesNoDevice) {
  fs::create_symlink("/dev/null", folder / "d.png");
  EXPECT_THROW(write_whole_file(folder / "d.png", "x", true), InvalidInput);
  EXPECT_TRUE(fs::is_symlink(folder / "d.png"));
}

}  // namespace
}  // namespace loosefit::io
