#include "loosefit/study/report_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/io/text_file.h"
#include "loosefit/study/set_aside.h"
#include "support/scratch_folder.h"

namespace loosefit::study {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class ReportFiles : public ::testing::Test {
 protected:
  std::string read(const std::string& name) const {
    return io::read_text_file((folder / name).string(), 10000);
  }
  void append(const std::string& name, const std::string& text) const {
    io::write_text_file((folder / name).string(), read(name) + text);
  }
  /// Names that things have now that were set aside.
  std::vector<std::string> write(const std::string& html, const std::string& json) const {
    std::vector<std::string> aside;
    write_report_files(folder, html, json,
                       [&](const fs::path& file) { aside.push_back(file.filename().string()); });
    return aside;
  }
  int files() const {
    return static_cast<int>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  const support::ScratchFolder folder;
  const std::string page = "study-report.html", document = "study-report.json";
};

TEST_F(ReportFiles, TakeThePlaceOfTheirOwn) {
  EXPECT_TRUE(write("<p>one</p>\n", "{1}").empty());
  EXPECT_TRUE(write("<p>two</p>\n", "{2}").empty());
  EXPECT_EQ(read(document), "{2}");
  EXPECT_TRUE(read(page).starts_with("<p>two</p>\n<!-- Loosefit "));
  EXPECT_EQ(files(), 2);
}

TEST_F(ReportFiles, WhatSomebodyHasChangedIsSetAside) {
  write("<p>one</p>\n", "{1}");
  append(page, "my note");
  EXPECT_EQ(write("<p>two</p>\n", "{2}"), Names{page + ".changed-1"});
  EXPECT_TRUE(read(page + ".changed-1").ends_with("my note"));
  append(document, "mine");
  EXPECT_EQ(write("<p>two</p>\n", "{2}"), Names{document + ".changed-1"});
  EXPECT_EQ(read(document + ".changed-1"), "{2}mine");
  // A note before the last line, and one in it.
  std::string text = read(page);
  io::write_text_file((folder / page).string(), "note" + text);
  EXPECT_EQ(write("<p>two</p>\n", "{2}").size(), 1u);
  text = read(page);
  io::write_text_file((folder / page).string(), text.substr(0, text.size() - 6) + "note -->\n");
  EXPECT_EQ(write("<p>two</p>\n", "{2}"), Names{page + ".changed-3"});
  EXPECT_TRUE(write("<p>two</p>\n", "{2}").empty());
  EXPECT_EQ(read(page + ".changed-2").substr(0, 4), "note");
}

TEST_F(ReportFiles, ADocumentWithoutItsPageIsKnownByItsText) {
  write("<p>one</p>\n", "{1}");
  fs::rename(folder / page, folder / "moved.html");
  EXPECT_TRUE(write("<p>one</p>\n", "{1}").empty());
  // As a process leaves it that was killed before the page.
  io::write_text_file((folder / document).string(), "{2}");
  EXPECT_TRUE(write("<p>two</p>\n", "{2}").empty());
  io::write_text_file((folder / ("." + page + ".writing-7")).string(), "half");
  EXPECT_TRUE(write("<p>two</p>\n", "{2}").empty());
  EXPECT_EQ(files(), 3) << "page, document, and the page that was moved";
  // A page that was cut off in its last line.
  const std::string text = read(page);
  io::write_text_file((folder / page).string(),
                      text.substr(0, text.rfind(document) + document.size()));
  EXPECT_EQ(write("<p>two</p>\n", "{2}"), Names{page + ".changed-1"});
}

TEST_F(ReportFiles, ForeignFilesOfTheirNamesStay) {
  io::write_text_file((folder / page).string(), "mine");
  io::write_text_file((folder / document).string(), "mine too");
  EXPECT_EQ(write("<p>one</p>\n", "{1}").size(), 2u);
  EXPECT_EQ(read(page + ".changed-1"), "mine");
  EXPECT_EQ(read(document + ".changed-1"), "mine too");
}

TEST_F(ReportFiles, SettingAsideTakesAFreeNumberForAllOfIt) {
  const auto write = [&](const std::string& name) {
    io::write_text_file((folder / name).string(), name);
  };
  for (const char* name : {"a", "a-journal", "a.damaged-1", "a.damaged-2-journal"}) write(name);
  EXPECT_EQ(set_aside(folder / "a", "damaged", {"-journal"}), folder / "a.damaged-3");
  EXPECT_EQ(read("a.damaged-3"), "a");
  EXPECT_EQ(read("a.damaged-3-journal"), "a-journal");
  EXPECT_EQ(read("a.damaged-1"), "a.damaged-1");
}

}  // namespace
}  // namespace loosefit::study
