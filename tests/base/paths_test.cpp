#include "loosefit/base/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "support/scratch_folder.h"

namespace loosefit {
namespace {

namespace fs = std::filesystem;

/// A folder of its own; takes back what a test told the process.
class Paths : public ::testing::Test {
 protected:
  const support::ScratchFolder base;
  void SetUp() override { unsetenv("LOOSEFIT_DATA"); }
  void TearDown() override {
    use_data_folder({});
    use_installation({});
    unsetenv("LOOSEFIT_DATA");
  }
  fs::path folder(const std::string& name, bool body, bool materials) const {
    fs::create_directories(base / name);
    if (body) std::ofstream(base / name / "body.lfb") << "x";
    if (materials) fs::create_directories(base / name / "materials");
    return base / name;
  }
};

TEST_F(Paths, CallerGoesBeforeEnvironmentBeforeInstallation) {
  const fs::path installed = folder("share/loosefit", true, true);
  use_installation(base);
  EXPECT_EQ(default_body_data_path(), (installed / "body.lfb").string());
  const fs::path environment = folder("environment", true, false);
  setenv("LOOSEFIT_DATA", environment.c_str(), 1);
  EXPECT_EQ(default_body_data_path(), (environment / "body.lfb").string());
  const fs::path caller = folder("caller", true, false);
  use_data_folder(caller);
  EXPECT_EQ(default_body_data_path(), (caller / "body.lfb").string());
  EXPECT_EQ(data_directory(), installed) << "neither of the two has materials";
}

TEST_F(Paths, EachPartOfTheDataIsFoundWhereItIs) {
  setenv("LOOSEFIT_DATA", folder("cards", false, true).c_str(), 1);
  EXPECT_EQ(data_directory(), base / "cards");
  EXPECT_NE(fs::path(default_body_data_path()).parent_path(), base / "cards")
      << "a folder of materials does not hide the body found elsewhere";
}

TEST_F(Paths, NamedFolderWithoutDataIsNotPassedOver) {
  const fs::path empty = folder("empty", false, false);
  use_data_folder(empty);
  EXPECT_EQ(default_body_data_path(), (empty / "body.lfb").string());
  use_data_folder({});
  setenv("LOOSEFIT_DATA", "/nowhere/body.lfb", 1);
  EXPECT_EQ(default_body_data_path(), "/nowhere/body.lfb") << "a file may be named, too";
}

TEST_F(Paths, MessagesNameEveryPlace) {
  use_data_folder("/first");
  const std::string text = looked_in();
  EXPECT_EQ(text.rfind("looked in /first, ", 0), 0u) << text;
  for (const fs::path& place : data_folders())
    EXPECT_NE(text.find(place.string()), std::string::npos) << place;
}

}  // namespace
}  // namespace loosefit
