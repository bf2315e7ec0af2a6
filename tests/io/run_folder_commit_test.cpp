#include <gtest/gtest.h>
#include <sys/wait.h>

#include <filesystem>
#include <map>
#include <new>

#include "loosefit/base/error.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/text_file.h"
#include "support/fault_plan.h"
#include "support/scratch_folder.h"

// What happens to an output while its files are being replaced.
namespace loosefit::io {
namespace fs = std::filesystem;
namespace {

using Files = std::map<std::string, std::string>;

struct RunFolderCommit : ::testing::Test {
  const support::ScratchFolder base;
  void SetUp() override { start(); }
  void TearDown() override { faults::plan = {}; }
  void start() const {
    faults::plan = {};
    base.clear();
    base_run({{"summary.json", "old"}, {"maps/old.png", "old"}, {"report.html", "old"}}).commit();
  }
  RunFolder base_run(const Files& files) const {
    RunFolder folder = RunFolder::create(base / "run");
    for (const auto& [name, content] : files) {
      fs::create_directories((folder.path() / name).parent_path());
      write_text_file(folder.path() / name, content);
    }
    return folder;
  }
  std::string text(const std::string& name) const {
    return fs::exists(base / name) ? read_text_file(base / name, 1000) : "nothing";
  }
  int entries() const {
    return static_cast<int>(std::distance(fs::directory_iterator(base), fs::directory_iterator()));
  }
  void expect_old() const {
    for (const char* name : {"summary.json", "maps/old.png", "report.html"})
      EXPECT_EQ(text(std::string("run/") + name), "old") << name;
  }
};

bool is_rename(const std::string& what) { return what == "rename" || what == "renameat2"; }

/// Saves a file just before the n-th rename, as an editor does; what stood there before.
struct Editor {
  fs::path file;
  int at = 0;
  int renames = 0;
  std::string found = "never";
  int operator()(const std::string& what) {
    if (!is_rename(what) || ++renames != at) return 0;
    found = fs::exists(file) ? read_text_file(file, 100) : "nothing";
    write_text_file(file, "edited");
    return 0;
  }
};

TEST_F(RunFolderCommit, WhatIsSavedBetweenTwoRenamesIsNotLost) {
  for (const char* name : {"summary.json", "maps/old.png"}) {
    int refused = 0;
    for (int n = 1; n < 50; ++n) {
      SCOPED_TRACE(std::string(name) + " before rename " + std::to_string(n));
      start();
      RunFolder folder = base_run({{"summary.json", "new"}, {"report.html", "new"}});
      Editor editor{base / "run" / name, n, 0, "never"};
      faults::plan.before = [&](const std::string& what, const std::string&) {
        return fs::exists(editor.file.parent_path()) ? editor(what) : 0;
      };
      bool committed = true;
      try {
        folder.commit();
      } catch (const InvalidInput&) {
        committed = false;
      }
      faults::plan = {};
      if (editor.found == "never") break;
      EXPECT_EQ(text(std::string("run/") + name), "edited") << editor.found;
      if (editor.found == "old") {
        EXPECT_FALSE(committed);
      }
      EXPECT_EQ(text(committed ? "run/report.html" : "run.new-1/report.html"), "new");
      EXPECT_EQ(text(committed ? "run.new-1/report.html" : "run/report.html"),
                committed ? "nothing" : "old");
      refused += !committed;
    }
    EXPECT_GE(refused, 2) << name;
  }
}

TEST_F(RunFolderCommit, WhatIsSavedThroughAnOpenFileIsNotLost) {
  RunFolder folder = base_run({{"summary.json", "new"}});
  std::FILE* open = std::fopen((base / "run/summary.json").c_str(), "r+");
  ASSERT_TRUE(open);
  faults::plan.before = [&](const std::string& what, const std::string& path) {
    if (open && is_rename(what) && path == base / "run/summary.json") {  // the new one comes
      std::fputs("edited", open);
      std::fclose(open);
      open = nullptr;
    }
    return 0;
  };
  EXPECT_THROW(folder.commit(), InvalidInput);
  EXPECT_EQ(text("run/summary.json"), "edited");
  EXPECT_EQ(text("run/report.html"), "old");
  EXPECT_EQ(text("run.new-1/summary.json"), "new");
  EXPECT_EQ(entries(), 3) << "the hidden folder of a commit that has not ended";
}

TEST_F(RunFolderCommit, AnyExceptionMovesEverythingBack) {
  {
    RunFolder folder = base_run({{"summary.json", "new"}, {"maps/new.png", "new"}});
    bool thrown = false;
    faults::plan.before = [&](const std::string& what, const std::string& path) {
      const bool moved = text("run/summary.json") == "new";
      if (thrown || !moved || what != "fsync" || path != base / "run") return 0;
      thrown = true;
      throw std::bad_alloc();
    };
    EXPECT_THROW(folder.commit(), std::bad_alloc);
    faults::plan = {};
  }
  expect_old();
  EXPECT_EQ(entries(), 1);
}

TEST_F(RunFolderCommit, WhatCannotBeMovedBackWaitsForTheNextProcess) {
  const pid_t child = fork();
  if (child == 0) {
    int code = 1;
    try {
      RunFolder folder = base_run({{"summary.json", "new"}, {"maps/new.png", "new"}});
      bool thrown = false, refused = false;
      faults::plan.before = [&](const std::string& what, const std::string&) {
        if (thrown && !refused && is_rename(what)) {  // back to the hidden folder
          refused = true;
          return EIO;
        }
        if (thrown || text("run/summary.json") != "new" || what != "fsync") return 0;
        thrown = true;
        throw std::bad_alloc();
      };
      folder.commit();
    } catch (const std::exception&) {
      code = 0;
    }
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  repair_output(base / "run");
  expect_old();
  EXPECT_EQ(text("run/maps/new.png"), "nothing");
  EXPECT_EQ(entries(), 1);
}

TEST_F(RunFolderCommit, FailingToMoveThereAndBackLeavesTheOldFiles) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      RunFolder folder = base_run({{"summary.json", "new"}});
      int struck = 0;
      // Moving there fails, moving back fails, and then everything works again.
      faults::plan.before = [&](const std::string& what, const std::string& path) {
        if (is_rename(what) && path == base / "run/summary.json" && ++struck <= 2) return EIO;
        return 0;
      };
      folder.commit();
    } catch (const std::exception&) {
    }
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  repair_output(base / "run");
  expect_old();
  EXPECT_EQ(entries(), 1);
}

/// Nothing can be made in `folder` or moved into it.
auto refuses(const fs::path& folder) {
  return [folder](const std::string& what, const std::string& path) {
    const bool makes = is_rename(what) || what == "mkdir";
    return makes && fs::path(path).parent_path() == folder ? EACCES : 0;
  };
}

TEST_F(RunFolderCommit, AFinishedOutputGoesIntoTheFolderWhereNothingCanBeMadeBesideIt) {
  faults::plan.before = refuses(base);
  RunFolder folder = base_run({{"summary.json", "new"}});
  write_text_file(base / "run/summary.json", "edited");
  std::string hint;
  try {
    folder.commit();
  } catch (const InvalidInput& error) {
    hint = error.hint();
  }
  EXPECT_NE(hint.find((base / "run/run.new-1").string()), std::string::npos) << hint;
  EXPECT_EQ(text("run/summary.json"), "edited");
  EXPECT_EQ(text("run/run.new-1/summary.json"), "new");
}

TEST_F(RunFolderCommit, AFinishedOutputThatCannotBeMovedAnywhereStaysInItsHiddenFolder) {
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    std::string hint = "none";
    try {
      RunFolder folder = base_run({{"summary.json", "new"}});
      write_text_file(base / "run/summary.json", "edited");
      faults::plan.before = [](const std::string& what, const std::string& path) {
        return is_rename(what) && path.find("run.new-") != std::string::npos ? EACCES : 0;
      };
      folder.commit();
    } catch (const InvalidInput& error) {
      hint = error.hint();
    }
    _exit(write(pipe_ends[1], hint.data(), hint.size()) < 0);
  }
  close(pipe_ends[1]);
  char hint[5000] = "";
  EXPECT_GT(read(pipe_ends[0], hint, sizeof hint - 1), 0);
  close(pipe_ends[0]);
  waitpid(child, nullptr, 0);
  const fs::path left = ".run.writing-" + std::to_string(child);
  EXPECT_NE(std::string(hint).find((base / left / "new").string()), std::string::npos) << hint;
  write_text_file(base / "run/summary.json", "old");
  base_run({{"summary.json", "newer"}}).commit();
  EXPECT_EQ(text("run/summary.json"), "newer");
  EXPECT_EQ(text((left / "new/summary.json").string()), "new") << "the next one leaves it alone";
}

TEST_F(RunFolderCommit, MarksAreOnTheDiskBeforeAnythingElseHappens) {
  RunFolder folder = base_run({{"summary.json", "new"}});
  std::vector<std::string> after_a_mark;
  bool waits = false;
  faults::plan.before = [&](const std::string& what, const std::string& path) {
    if (waits) after_a_mark.push_back(what + " " + path);
    waits = is_rename(what) && fs::path(path).filename() == ".loosefit-output.json";
    return 0;
  };
  folder.commit();
  const std::string synced = "fsync " + (base / "run").string();
  EXPECT_EQ(after_a_mark, std::vector<std::string>(2, synced));
}

}  // namespace
}  // namespace loosefit::io
