#include "loosefit/io/staging_folder.h"

#include <gtest/gtest.h>

#include "loosefit/io/text_file.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace fs = std::filesystem;
namespace {

/// Hidden folders of a process that is long gone: no process has this number.
struct LeftOvers : ::testing::Test {
  const support::ScratchFolder base;
  fs::path hidden = base / ".out.writing-99999999";
  void SetUp() override { fs::create_directories(hidden); }
};

TEST_F(LeftOvers, OfAProcessThatHadHardlyBegunGo) {
  clear_left_overs(base / "out");
  EXPECT_FALSE(fs::exists(hidden));
  fs::create_directories(hidden);
  write_text_file((hidden / ".loosefit-writing").string(), "");
  clear_left_overs(base / "out");
  EXPECT_FALSE(fs::exists(hidden));
}

TEST_F(LeftOvers, InWhichSomethingElseLiesStay) {
  write_text_file((hidden / "mine").string(), "");
  clear_left_overs(base / "out");
  EXPECT_TRUE(fs::exists(hidden / "mine"));
}

// A link to itself, as a folder to which one has no access: what is behind it is not known.
TEST_F(LeftOvers, ThatCannotBeLookedAtStayAndStopNothing) {
  fs::create_symlink(".loosefit-writing", hidden / ".loosefit-writing");
  EXPECT_NO_THROW(clear_left_overs(base / "out"));
  EXPECT_TRUE(fs::is_symlink(hidden / ".loosefit-writing"));
}

}  // namespace
}  // namespace loosefit::io
