#include "loosefit/io/valentina.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "support/dxf_text.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace {

namespace fs = std::filesystem;

/// A folder that is all of PATH but for /bin, and a pattern file. A script there stands in for
/// Valentina, so that what it is asked for and what becomes of its answers can be seen.
class Valentina : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const char* path = std::getenv("PATH")) path_ = path;
    setenv("PATH", (folder_.string() + ":/bin").c_str(), 1);
    write_text_file((folder_ / "skirt.val").string(), "<pattern/>");
    write_text_file((folder_ / "made.dxf").string(), gerber_like_dxf());
  }
  void TearDown() override { setenv("PATH", path_.c_str(), 1); }
  void install(const std::string& script) const {
    const fs::path program = folder_ / "valentina";
    write_text_file(program.string(), "#!/bin/sh\n" + script);
    fs::permissions(program, fs::perms::owner_all);
  }
  std::string refusal() const {
    try {
      read_valentina(folder_ / "skirt.val");
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }
  const support::ScratchFolder folder_;
  std::string path_;
};

TEST_F(Valentina, IsAskedForItsPiecesAndTheyAreRead) {
  install("echo \"$*\" > '" + (folder_ / "asked").string() + "'\ncp '" +
          (folder_ / "made.dxf").string() + "' \"$4/pieces.dxf\"\n");
  const PatternFile file = read_valentina(folder_ / "skirt.val");
  EXPECT_EQ(file.pattern.name, "skirt");
  EXPECT_FALSE(file.pattern.panels.empty());
  EXPECT_EQ(file.about.front().rfind("Valentina or Seamly2D, exported by Valentina as ", 0), 0u);
  const std::string asked = read_text_file((folder_ / "asked").string(), 10000);
  EXPECT_EQ(asked.rfind("-b pieces -d ", 0), 0u) << asked;
  EXPECT_NE(asked.find(" -f 16 --exportOnlyDetails /"), std::string::npos) << asked;
}

TEST_F(Valentina, SaysWhatItComplainsOf) {
  install("echo 'CRITICAL: the measurement file is missing' >&2\nexit 66\n");
  const std::string said = refusal();
  EXPECT_NE(said.find("exit code 66"), std::string::npos) << said;
  EXPECT_NE(said.find("the measurement file is missing"), std::string::npos) << said;
}

TEST_F(Valentina, IsNamedWhereItIsNotInstalled) {
  if (fs::exists("/bin/valentina")) GTEST_SKIP() << "Valentina is installed";
  const std::string said = refusal();
  EXPECT_NE(said.find("Valentina"), std::string::npos) << said;
  EXPECT_NE(said.find("skirt.val"), std::string::npos) << said;
}

}  // namespace
}  // namespace loosefit::io
