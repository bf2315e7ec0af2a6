#include "loosefit/report/case_figure.h"

#include <gtest/gtest.h>

#include <optional>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/report/run_into_folder.h"
#include "support/scratch_folder.h"

namespace loosefit::report {
namespace {

namespace fs = std::filesystem;

/// One run that all tests look at: a shirt as it is put on, without time to settle.
class CaseFigure : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = scratch_.emplace() / "slim shirt";
    Progress silent;
    run_into_folder(io::parse_scenario("[output]\npreset_sites = false\nmaps = [\"distance\"]\n"
                                       "[simulation]\nedge_length = 0.05\ntime_budget = 0.1\n",
                                       "case.toml"),
                    folder_, {.allow_unsettled = true}, false, silent);
  }
  static void TearDownTestSuite() { scratch_.reset(); }
  FigureWish wish() const {
    FigureWish wish;
    wish.folders = {folder_};
    wish.width = 120;
    wish.height = 130;
    wish.allow_unsettled = true;
    return wish;
  }
  std::vector<std::string> captions(const FigureWish& wish) {
    std::vector<std::string> found;
    for (const render::FigurePanel& panel : case_figure(wish, silent_).panels)
      found.push_back(panel.caption);
    return found;
  }
  using Words = std::vector<std::string>;
  static std::optional<support::ScratchFolder> scratch_;
  static fs::path folder_;
  Progress silent_;
};
std::optional<support::ScratchFolder> CaseFigure::scratch_;
fs::path CaseFigure::folder_;

TEST_F(CaseFigure, ShowsTheMapsOfTheRunWhenNothingIsSaid) {
  const render::Figure figure = case_figure(wish(), silent_);
  ASSERT_EQ(figure.panels.size(), 1u);
  EXPECT_EQ(figure.panels[0].picture.width, 120);
  EXPECT_EQ(figure.panels[0].caption, "") << "nothing varies";
  ASSERT_EQ(figure.legends.size(), 1u);
  EXPECT_EQ(figure.legends[0].style.array, "distance_mm");
  EXPECT_GT(figure.legends[0].style.range_high, 0);
}

TEST_F(CaseFigure, ARowShowsOneMapFromAllSides) {
  FigureWish asked = wish();
  asked.maps = {"distance", "drape"};
  asked.cameras = {render::camera(render::View::front), {45, 0}};
  EXPECT_EQ(captions(asked), (Words{"Body-garment distance, front", "Body-garment distance, 45°",
                                    "drape, front", "drape, 45°"}));
  EXPECT_EQ(case_figure(asked, silent_).columns, 2);
}

TEST_F(CaseFigure, RunsAreNamedByTheirFoldersOrByLabels) {
  FigureWish asked = wish();
  asked.maps = {"drape"};
  asked.folders = {folder_, folder_ / "."};
  EXPECT_EQ(case_figure(asked, silent_).columns, 2);
  asked.labels = {"loose", "tight"};
  EXPECT_EQ(captions(asked), (Words{"loose", "tight"}));
  asked.labels = {"loose"};
  EXPECT_THROW(case_figure(asked, silent_), InvalidInput);
}

TEST_F(CaseFigure, OneRangeHoldsForPicturesAndLegend) {
  FigureWish asked = wish();
  const render::Image fixed = case_figure(asked, silent_).panels[0].picture;
  asked.range = {0, 4000};
  const render::Figure wide = case_figure(asked, silent_);
  EXPECT_EQ(wide.legends[0].style.range_high, 4000);
  EXPECT_FALSE(wide.legends[0].values_above);
  EXPECT_NE(wide.panels[0].picture.pixels, fixed.pixels);
  asked.maps = {"distance", "angular-deviation"};
  EXPECT_THROW(case_figure(asked, silent_), InvalidInput) << "millimetres and degrees";
  asked.maps = {"distance"};
  asked.range = {3, 3};
  EXPECT_THROW(case_figure(asked, silent_), InvalidInput);
}

TEST_F(CaseFigure, WhatARunHasNotIsAnError) {
  FigureWish asked = wish();
  asked.postures = {"reference"};
  EXPECT_EQ(captions(asked).size(), 1u);
  asked.postures = {"sitting"};
  EXPECT_THROW(case_figure(asked, silent_), InvalidInput);
  asked = wish();
  for (const char* word : {"slip", "distance_cm", ""}) {
    asked.maps = {word};
    EXPECT_THROW(case_figure(asked, silent_), InvalidInput) << word;
  }
  asked = wish();
  asked.allow_unsettled = false;
  EXPECT_THROW(case_figure(asked, silent_), Error) << "maps of a drape that did not settle";
  asked.maps = {"drape"};
  EXPECT_EQ(captions(asked).size(), 1u) << "plain cloth can be looked at";
  asked.folders = {folder_ / "none"};
  EXPECT_THROW(case_figure(asked, silent_), IoError);
}

TEST_F(CaseFigure, ATurnShowsAllSidesAtOneSize) {
  FigureWish asked = wish();
  asked.maps = {"drape"};
  asked.cameras = {{0, 20}};
  const Turntable turn = turntable(asked, 3, 1.5, silent_);
  EXPECT_EQ(turn.file.substr(1, 3), "PNG");
  std::size_t frames = 0;
  for (std::size_t at = 0; (at = turn.file.find("fcTL", at)) != std::string::npos; ++at) ++frames;
  EXPECT_EQ(frames, 3u);
  EXPECT_GE(turn.size.width, 120);
  asked.cameras.push_back({});
  EXPECT_THROW(turntable(asked, 3, 1.5, silent_), InvalidInput);
}

}  // namespace
}  // namespace loosefit::report
