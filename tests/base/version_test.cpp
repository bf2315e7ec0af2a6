#include "loosefit/base/version.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "loosefit/base/build_id.h"
#include "loosefit/base/paths.h"

namespace loosefit {
namespace {

TEST(Versions, EveryLibraryStatesANumber) {
  for (const auto& [name, text] : versions()) {
    if (name == "build") continue;
    EXPECT_NE(text.find('.'), std::string::npos) << name << " = " << text;
    EXPECT_NE(text.find_first_of("0123456789"), std::string::npos) << name << " = " << text;
  }
}

TEST(BuildId, IsWhatTheLinkerWroteIntoThisProgram) {
  EXPECT_EQ(build_id().size(), 40u);  // SHA-1, the usual of GNU ld
  EXPECT_EQ(build_id().find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(versions().at("build"), build_id());
  const std::string note = "readelf -n /proc/" + std::to_string(getpid()) + "/exe";
  FILE* listed = popen(note.c_str(), "r");
  ASSERT_TRUE(listed);
  std::string text;
  for (char buffer[256]; fgets(buffer, sizeof buffer, listed);) text += buffer;
  pclose(listed);
  EXPECT_NE(text.find("Build ID: " + build_id()), std::string::npos) << text;
}

TEST(DataDirectory, HoldsTheMaterialsAndFollowsTheEnvironment) {
  EXPECT_TRUE(std::filesystem::is_directory(data_directory() / "materials"));
  setenv("LOOSEFIT_SHARE", "/nowhere", 1);
  EXPECT_EQ(data_directory(), "/nowhere");
  unsetenv("LOOSEFIT_SHARE");
}

}  // namespace
}  // namespace loosefit
