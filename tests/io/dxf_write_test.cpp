#include "loosefit/io/dxf/dxf_write.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/dxf_document.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/text_file.h"
#include "loosefit/kinds/registry.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/pattern/outline.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"
#include "support/simple_patterns.h"

namespace loosefit::io {
namespace {

void expect_same(const pattern::Pattern& was, const PatternFile& file) {
  ASSERT_EQ(file.pattern.panels.size(), was.panels.size());
  for (const pattern::Panel& panel : was.panels) {
    SCOPED_TRACE(panel.name);
    const int p = file.pattern.find_panel(panel.name);
    ASSERT_GE(p, 0);
    const pattern::Panel& again = file.pattern.panels[p];
    ASSERT_EQ(again.edges.size(), panel.edges.size());
    Vec2 low = Vec2::Constant(1e9), high = -low;
    for (const Vec2& q : pattern::outline_polygon(panel))
      low = low.cwiseMin(q), high = high.cwiseMax(q);
    const Vec2 origin((low.x() + high.x()) / 2, low.y());
    for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e) {
      const pattern::EdgePath a(panel, e), b(again, e);
      EXPECT_NEAR(a.length(), b.length(), 1e-5);
      for (const double at : {0.0, 0.13, 0.5, 0.77, 1.0})
        EXPECT_LT((a.at(at) - origin - b.at(at)).norm(), 1e-5) << e << " " << at;
    }
  }
}

TEST(DxfWrite, WhatIsReadBackIsTheSameWithinAHundredthOfAMillimetre) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const PatternFile file = parse_dxf_pattern(dxf_text(shirt), "p.dxf");
  expect_same(shirt, file);
  EXPECT_EQ(file.about.back(),
            std::to_string(shirt.panels.size()) + " pieces along their sew line");
  EXPECT_TRUE(file.warnings.empty()) << file.warnings[0];
  EXPECT_TRUE(file.unused.empty()) << file.unused[0];
  // Curves of every kind.
  const pattern::Pattern curves =
      read_garmentcode(std::string(LOOSEFIT_SOURCE_DIR) + "/tests/data/patterns/curves.json")
          .pattern;
  expect_same(curves, parse_dxf_pattern(dxf_text(curves), "c.dxf", {"", "mm"}));
}

TEST(DxfWrite, MarksAreOnALayerOfTheirOwn) {
  pattern::Pattern pattern;
  pattern.panels = {testing_support::rectangle_panel("front", 0.4, 0.6)};
  const std::vector<PatternMark> marks = {
      {"imu", "front", {{.1, .1}, {.15, .1}, {.15, .14}, {.1, .14}}, true},
      {"lead", "front", {{.15, .14}, {.2, .3}, {.2, .5}}, false},
      {"c7", "front", {{.2, .5}}, false}};
  const std::string text = dxf_text(pattern, {{0, 1, 0.25}}, marks);
  const DxfDocument document = parse_dxf(text, "p.dxf");
  ASSERT_EQ(document.blocks.size(), 1u);
  std::vector<DxfEntity> own;
  for (const DxfEntity& e : document.blocks[0].entities)
    if (e.layer == kMarkLayer) own.push_back(e);
  ASSERT_EQ(own.size(), 6u);  // each with its name
  EXPECT_TRUE(own[0].closed);
  EXPECT_EQ(own[1].text, "imu");
  EXPECT_FALSE(own[2].closed);
  EXPECT_EQ(own[2].points.size(), 3u);
  EXPECT_NEAR((own[2].points[1] - own[0].points[0]).x(), 100, 1e-3);
  EXPECT_EQ(own[4].kind, "POINT");
  const PatternFile file = parse_dxf_pattern(text, "p.dxf");
  ASSERT_EQ(file.notches.size(), 1u);
  EXPECT_EQ(file.notches[0].edge, 1);
  EXPECT_NEAR(file.notches[0].along, 0.25, 1e-6);
  ASSERT_EQ(file.unused.size(), 1u);
  EXPECT_NE(file.unused[0].find("sensor places"), std::string::npos);
  EXPECT_THROW(dxf_text(pattern, {}, {{"x", "back", {{0, 0}}, false}}), InvalidInput);
}

TEST(DxfWrite, NamesOfAnySortMakeNoOtherGroups) {
  pattern::Pattern pattern;
  pattern.name = "a\n  0\nEOF";
  pattern.panels = {testing_support::rectangle_panel("front\n  0\nENDBLK", 0.4, 0.6),
                    testing_support::rectangle_panel("Ärmel 1", 0.3, 0.6),
                    testing_support::rectangle_panel("Ärmel_1", 0.3, 0.6)};
  const PatternFile file = parse_dxf_pattern(dxf_text(pattern), "p.dxf");
  ASSERT_EQ(file.pattern.panels.size(), 3u);
  EXPECT_GE(file.pattern.find_panel("Ärmel 1"), 0);
}

/// An independent reader: python3-ezdxf, which the set-up installs.
TEST(DxfWrite, EzdxfReadsTheSameOutlines) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const support::ScratchFolder base;
  write_dxf(base / "p.dxf", shirt);
  write_text_file((base / "read.py").string(), R"(
import sys, ezdxf
doc = ezdxf.readfile(sys.argv[1])
assert not doc.audit().has_errors
for insert in doc.modelspace().query('INSERT'):
    block = doc.blocks[insert.dxf.name]
    name = [t.dxf.text[12:] for t in block.query('TEXT') if t.dxf.text.startswith('Piece Name: ')][0]
    points = []
    for line in block.query('POLYLINE[layer=="1"]'):
        points += [v.dxf.location for v in line.vertices][:-1]
    area = sum(a.x * b.y - a.y * b.x for a, b in zip(points, points[1:] + points[:1])) / 2
    print(name, '%.6f' % (area / 1e6))
)");
  const ProgramRun run = run_program("/usr/bin/python3 " + (base / "read.py").string() + " " +
                                     (base / "p.dxf").string());
  ASSERT_EQ(run.exit_code, 0) << run.output;
  std::istringstream lines(run.output);
  std::string name;
  double area = 0;
  std::size_t count = 0;
  while (lines >> name >> area) {
    const int p = shirt.find_panel(name);
    ASSERT_GE(p, 0) << name;
    EXPECT_NEAR(area, pattern::signed_area(pattern::outline_polygon(shirt.panels[p], 400)), 2e-6);
    ++count;
  }
  EXPECT_EQ(count, shirt.panels.size()) << run.output;
}

}  // namespace
}  // namespace loosefit::io
