#include "loosefit/base/version.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "loosefit/base/paths.h"

namespace loosefit {
namespace {

TEST(Versions, EveryLibraryStatesANumber) {
  for (const auto& [name, text] : versions()) {
    EXPECT_NE(text.find('.'), std::string::npos) << name << " = " << text;
    EXPECT_NE(text.find_first_of("0123456789"), std::string::npos) << name << " = " << text;
  }
}

TEST(DataDirectory, HoldsTheMaterialsAndFollowsTheEnvironment) {
  EXPECT_TRUE(std::filesystem::is_directory(data_directory() / "materials"));
  setenv("LOOSEFIT_SHARE", "/nowhere", 1);
  EXPECT_EQ(data_directory(), "/nowhere");
  unsetenv("LOOSEFIT_SHARE");
}

}  // namespace
}  // namespace loosefit
