#include "loosefit/io/run_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>

#include "loosefit/base/error.h"
#include "loosefit/base/sha256.h"
#include "loosefit/io/replace_files.h"
#include "loosefit/io/text_file.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace fs = std::filesystem;
namespace {

/// A fresh folder per test, removed at the end.
struct RunFolderTest : ::testing::Test {
  const support::ScratchFolder base;
  void write(const std::string& name, const std::string& content) const {
    fs::create_directories((base / name).parent_path());
    write_text_file((base / name).string(), content);
  }
  std::string text(const std::string& name) const {
    return read_text_file((base / "run" / name).string(), 1000);
  }
  /// Writes a whole output, as the program does.
  void make_run(const std::map<std::string, std::string>& files) const {
    RunFolder folder = RunFolder::create(base / "run");
    for (const auto& [name, content] : files) {
      fs::create_directories((folder.path() / name).parent_path());
      write_text_file((folder.path() / name).string(), content);
    }
    folder.commit();
  }
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
  make_run({{"summary.json", "old"}, {"maps/old.png", "old"}});
  RunFolder folder = RunFolder::create(base / "run" / "");
  write_text_file(folder.path() / "summary.json", "new");
  EXPECT_EQ(text("summary.json"), "old") << "until the commit";
  folder.commit();
  EXPECT_EQ(text("summary.json"), "new");
  EXPECT_FALSE(fs::exists(base / "run" / "maps"));
  EXPECT_EQ(entries(), 1);
}

TEST_F(RunFolderTest, ASummaryAloneIsNoEarlierOutput) {
  write("run/summary.json", "{\"title\": \"My thesis\"}");
  write("run/chapter.tex", "dear");
  EXPECT_THROW(RunFolder::create(base / "run"), InvalidInput);
  write("run/.loosefit-output.json", "{\"format\": \"other\", \"version\": 1}");
  EXPECT_THROW(RunFolder::create(base / "run"), InvalidInput);
  EXPECT_EQ(text("summary.json"), "{\"title\": \"My thesis\"}");
  EXPECT_EQ(text("chapter.tex"), "dear");
}

TEST_F(RunFolderTest, ForeignFilesInAnOutputStay) {
  make_run({{"summary.json", "old"}, {"maps/a.png", "old"}});
  write("run/case.toml", "mine");
  write("run/maps/mine.png", "mine");
  write("run/ranking-ecg.csv", "mine");
  make_run({{"summary.json", "new"}});
  EXPECT_EQ(text("case.toml"), "mine");
  EXPECT_EQ(text("maps/mine.png"), "mine");
  EXPECT_EQ(text("ranking-ecg.csv"), "mine");
  EXPECT_FALSE(fs::exists(base / "run/maps/a.png"));
}

TEST_F(RunFolderTest, RankingsMadeLaterOutliveTheNextRun) {
  make_run({{"summary.json", "old"}});
  RunFolder ranking = RunFolder::update(base / "run", "ranking");
  write_text_file(ranking.path() / "ranking-ecg.csv", "best");
  ranking.commit();
  make_run({{"summary.json", "new"}});
  EXPECT_EQ(text("ranking-ecg.csv"), "best");
}

TEST_F(RunFolderTest, ChangedFilesAreNamedBeforeTheWork) {
  make_run({{"summary.json", "old"}, {"report.html", "old"}, {"scenario.toml", "old"}});
  write("run/report.html", "edited");
  const RunFolder folder = RunFolder::create(base / "run");
  folder.announce({"summary.json", "scenario.toml"});
  try {
    folder.announce({"summary.json", "report.html"});
    FAIL() << "an edited file would be lost";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("run: report.html: found"), std::string::npos)
        << error.what();
  }
}

TEST_F(RunFolderTest, WhatIsEditedDuringTheRunStaysAndTheNewOutputToo) {
  make_run({{"summary.json", "old"}});
  RunFolder folder = RunFolder::create(base / "run");
  write_text_file(folder.path() / "summary.json", "new");
  write("run/summary.json", "edited");
  EXPECT_THROW(folder.commit(), InvalidInput);
  EXPECT_EQ(text("summary.json"), "edited");
  EXPECT_EQ(read_text_file(base / "run.new-1/summary.json", 10), "new");
}

TEST_F(RunFolderTest, LinkToAFolderStaysALinkAndIsWrittenThrough) {
  fs::create_directory(base / "real");
  fs::create_directory_symlink("real", base / "run");
  make_run({{"summary.json", "old"}});
  make_run({{"summary.json", "new"}});
  EXPECT_TRUE(fs::is_symlink(base / "run"));
  EXPECT_EQ(read_text_file(base / "real/summary.json", 10), "new");
  EXPECT_EQ(entries(), 2);
}

TEST_F(RunFolderTest, LinksInAnOutputAreNeverFollowed) {
  make_run({{"summary.json", "old"}, {"maps/a.png", "a"}});
  fs::rename(base / "run/maps", base / "pictures");
  fs::create_directory_symlink(base / "pictures", base / "run/maps");
  make_run({{"summary.json", "new"}});
  EXPECT_EQ(read_text_file(base / "pictures/a.png", 10), "a");
  EXPECT_THROW(RunFolder::create(base / "run").announce({"maps/a.png"}), InvalidInput);
}

TEST_F(RunFolderTest, AddedFilesNeverReplaceForeignOnes) {
  write("run/body.obj", "a scan");
  RunFolder first = RunFolder::add(base / "run", "body");
  write_text_file(first.path() / "body.obj", "a body");
  EXPECT_THROW(first.commit(), InvalidInput);
  EXPECT_EQ(text("body.obj"), "a scan");
  RunFolder other = RunFolder::add(base / "run", "body");
  write_text_file(other.path() / "body.json", "old");
  other.commit();
  RunFolder again = RunFolder::add(base / "run", "body");
  write_text_file(again.path() / "body.json", "new");
  again.commit();
  EXPECT_EQ(text("body.json"), "new") << "but our own";
  EXPECT_EQ(text("body.obj"), "a scan");
}

// A run of Loosefit 0.1 has no mark: nobody knows what in it has been changed since.
TEST_F(RunFolderTest, UpdateOfARunWithoutAMarkSetsAsideWhatIsInTheWay) {
  write("run/summary.json", "old");
  write("run/scenario.toml", "edited");
  write("run/log.jsonl", "log");
  RunFolder folder = RunFolder::update(base / "run");
  folder.leave_if_edited("scenario.toml");
  folder.announce({"summary.json"});
  write_text_file(folder.path() / "summary.json", "new");
  write_text_file(folder.path() / "scenario.toml", "resolved");
  folder.commit();
  EXPECT_EQ(text("summary.json"), "new");
  EXPECT_EQ(text("scenario.toml"), "edited");
  EXPECT_EQ(text("log.jsonl"), "log");
  EXPECT_EQ(folder.aside(), "replaced-1");
  EXPECT_EQ(text("replaced-1/summary.json"), "old");

  RunFolder later = RunFolder::update(base / "run");
  later.announce({"log.jsonl"});
  write_text_file(later.path() / "log.jsonl", "new");
  later.commit();
  EXPECT_EQ(text("log.jsonl"), "new");
  EXPECT_EQ(text("replaced-2/log.jsonl"), "log");
  EXPECT_EQ(text("summary.json"), "new") << "our own by now";
}

TEST_F(RunFolderTest, UpdateOfARunWithoutAMarkRefusesEditedFilesOfAnEarlierUpdate) {
  write("run/summary.json", "old");
  write("run/log.jsonl", "old");
  RunFolder first = RunFolder::update(base / "run");
  write_text_file(first.path() / "summary.json", "new");
  first.commit();
  write("run/summary.json", "edited");
  RunFolder later = RunFolder::update(base / "run");
  later.announce({"log.jsonl"});
  EXPECT_THROW(later.announce({"summary.json"}), InvalidInput);
  write_text_file(later.path() / "summary.json", "newer");
  EXPECT_THROW(later.commit(), InvalidInput);
  EXPECT_EQ(text("summary.json"), "edited");
  EXPECT_FALSE(fs::exists(base / "run/replaced-2"));
}

TEST_F(RunFolderTest, AddCallsOnlyAnOutputWithAMarkThatOfARun) {
  const auto refusal = [this] {
    try {
      RunFolder::add(base / "run", "body");
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  write("run/summary.json", "{}");
  EXPECT_NE(refusal().find("a folder with a summary.json, perhaps"), std::string::npos);
  fs::remove_all(base / "run");
  make_run({{"summary.json", "{}"}});
  EXPECT_NE(refusal().find("the output of a run"), std::string::npos);
}

TEST_F(RunFolderTest, HiddenFolderOfAProcessThatIsGoneIsRemoved) {
  const pid_t killed = fork();
  if (killed == 0) {
    RunFolder folder = RunFolder::create(base / "run");
    write_text_file(folder.path() / "half", "x");
    kill(getpid(), SIGKILL);
  }
  waitpid(killed, nullptr, 0);
  ASSERT_EQ(entries(), 1) << "left behind";
  write(".run.writing-1/mine", "foreign");
  make_run({{"summary.json", "new"}});
  EXPECT_EQ(read_text_file(base / ".run.writing-1/mine", 10), "foreign");
  EXPECT_EQ(entries(), 2);
}

TEST_F(RunFolderTest, HiddenFolderOfALiveProcessStays) {
  {
    RunFolder slow = RunFolder::create(base / "run");
    write_text_file(slow.path() / "summary.json", "slow");
    make_run({{"summary.json", "quick"}});
    EXPECT_THROW(slow.commit(), MadeMeanwhile);
  }
  EXPECT_EQ(read_text_file(base / "run.new-1/summary.json", 10), "slow");
  EXPECT_EQ(entries(), 2);
}

TEST_F(RunFolderTest, AMarkCannotLeadOutOfItsFolder) {
  write("precious", "dear");
  for (const char* name : {"../precious", "/etc/passwd", "a/../../precious", ""}) {
    fs::remove_all(base / "run");
    write("run/.loosefit-output.json",
          std::string("{\"format\": \"loosefit-output\", \"version\": 1, \"sets\": {\"run\": {\"") +
              name + "\": \"" + sha256_hex("dear") + "\"}}, \"folders\": []}");
    EXPECT_THROW(RunFolder::create(base / "run"), InvalidInput) << name;
  }
  EXPECT_EQ(read_text_file(base / "precious", 10), "dear");
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
  make_run({{"summary.json", "{}"}, {"maps/a.png", "a"}});
  RunFolder folder = RunFolder::update(base / "run");
  fs::create_directories(folder.path() / "maps");
  write_text_file(folder.path() / "maps" / "b.png", "b");
  folder.commit();
  EXPECT_TRUE(fs::exists(base / "run" / "maps" / "a.png"));
  EXPECT_TRUE(fs::exists(base / "run" / "maps" / "b.png"));
}

// A report of the old drape would stand beside the new one.
TEST_F(RunFolderTest, AnUpdateOfADrapeThatAnotherRunHasReplacedMeanwhileIsRefused) {
  make_run({{"summary.json", "{}"}, {"drape.vtp", "old"}, {"report.html", "of old"}});
  RunFolder folder = RunFolder::update(base / "run");
  write_text_file(folder.path() / "report.html", "of old again");
  make_run({{"summary.json", "{}"}, {"drape.vtp", "new"}, {"report.html", "of new"}});
  EXPECT_THROW(folder.commit(), MadeMeanwhile);
  EXPECT_EQ(text("drape.vtp"), "new");
  EXPECT_EQ(text("report.html"), "of new");
}

// What `map` and `render` write of the same run side by side.
TEST_F(RunFolderTest, UpdatesOfOneRunDoNotHinderEachOther) {
  make_run({{"drape.vtp", "1"}, {"scenario.toml", "1"}});
  write("run/scenario.toml", "edited");
  RunFolder map = RunFolder::update(base / "run");
  map.leave_if_edited("scenario.toml");
  write_text_file(map.path() / "scenario.toml", "of other maps");
  RunFolder render = RunFolder::update(base / "run");
  write_text_file(render.path() / "picture.png", "picture");
  RunFolder again = RunFolder::create(base / "run");
  write_text_file(again.path() / "drape.vtp", "2");
  map.commit();
  render.commit();
  EXPECT_EQ(text("picture.png"), "picture");
  again.commit();
  EXPECT_EQ(text("drape.vtp"), "2") << "the run of the beginning, whatever was added to it";
}

// Of two runs into one folder the later one would take the place of what somebody may be reading.
TEST_F(RunFolderTest, ARunThatAnotherOneWasQuickerThanGoesBesideIt) {
  for (const std::string kind : {"run", "validation"})
    for (const bool into_earlier : {false, true}) {
      const auto write_one = [&](const std::string& what) {
        RunFolder one = RunFolder::create(base / "run", kind);
        write_text_file(one.path() / "result", what);
        return one;
      };
      base.clear();
      if (into_earlier) write_one("old").commit();
      RunFolder slow = write_one("slow");
      write_one("quick").commit();
      EXPECT_THROW(slow.commit(), MadeMeanwhile) << kind << into_earlier;
      EXPECT_EQ(text("result"), "quick");
      EXPECT_EQ(read_text_file(base / "run.new-1/result", 10), "slow");
    }
}

TEST(TextFile, DiskFullIsAnIoError) {
  if (!fs::exists("/dev/full")) GTEST_FAIL() << "no /dev/full";
  EXPECT_THROW(write_text_file("/dev/full", std::string(100000, 'x')), IoError);
}

}  // namespace
}  // namespace loosefit::io
