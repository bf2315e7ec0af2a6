#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "loosefit/base/text.h"
#include "loosefit/io/config_node.h"
#include "loosefit/io/read_pattern.h"
#include "loosefit/io/seams_file.h"
#include "loosefit/io/text_file.h"
#include "support/scratch_folder.h"
#include "support/side_file.h"

// Files that do not say where their pieces go, or what these are.
namespace loosefit::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string kShared = LOOSEFIT_SOURCE_DIR "/../shared/garments/";

class UnplacedPatterns : public testing::Test {
 protected:
  const support::ScratchFolder base_;
  fs::path file(const std::string& name, const std::string& text) const {
    write_text_file((base_ / name).string(), text);
    return base_ / name;
  }
};

enum class Taken { zero, missing };

std::string without_places(const std::string& name, Taken taken) {
  Json json = Json::parse(read_text_file(kShared + name, 1 << 24));
  for (auto& [key, panel] : json["pattern"]["panels"].items())
    for (const char* pose : {"translation", "rotation"}) {
      if (taken == Taken::missing)
        panel.erase(pose);
      else
        panel[pose] = {0, 0, 0};
    }
  return json.dump();
}

double facing(const pattern::Pattern& pattern, const std::string& panel) {
  return pattern.panels[pattern.find_panel(panel)].rotation.col(2).y();
}
Vec3 middle(const pattern::Pattern& pattern, const std::string& name) {
  const pattern::Panel& panel = pattern.panels[pattern.find_panel(name)];
  Vec2 sum = Vec2::Zero();
  for (const Vec2& v : panel.vertices) sum += v / static_cast<double>(panel.vertices.size());
  return panel.rotation * Vec3(sum.x(), sum.y(), 0) + panel.translation;
}

TEST_F(UnplacedPatterns, PanelsOfGarmentCodeInAHeapAreArrangedByWhatTheyAre) {
  if (!fs::exists(kShared)) GTEST_SKIP() << "no " << kShared;
  for (const Taken taken : {Taken::zero, Taken::missing}) {
    const PatternFile tee =
        read_pattern(file("tee_specification.json", without_places("gpg_tee.json", taken)));
    ASSERT_TRUE(tee.placed) << tee.not_placed;
    EXPECT_LT(facing(tee.pattern, "front"), -0.9);
    EXPECT_GT(facing(tee.pattern, "back"), 0.9);
    for (const char* name : {"lfsleeve", "rfsleeve"}) EXPECT_LT(facing(tee.pattern, name), -0.9);
    for (const char* name : {"lbsleeve", "rbsleeve"}) EXPECT_GT(facing(tee.pattern, name), 0.9);
    // Beyond the trunk, which is 43 cm wide, on their sides and at the height of the armholes.
    for (const char* name : {"lfsleeve", "lbsleeve"}) {
      EXPECT_GT(middle(tee.pattern, name).x(), 0.2) << name;
      EXPECT_GT(middle(tee.pattern, name).z(), middle(tee.pattern, "front").z()) << name;
    }
    for (const char* name : {"rfsleeve", "rbsleeve"})
      EXPECT_LT(middle(tee.pattern, name).x(), -0.2) << name;
    const auto told = std::ranges::count_if(tee.warnings, [](const std::string& line) {
      return line.find("arranged by what they are") != std::string::npos;
    });
    EXPECT_EQ(told, 1);
    for (const std::string& line : tee.warnings)
      EXPECT_EQ(line.find("missing, taken as"), std::string::npos) << line;
  }
}

TEST_F(UnplacedPatterns, SoAreTrousersSkirtsAndHoods) {
  if (!fs::exists(kShared)) GTEST_SKIP() << "no " << kShared;
  const auto read = [&](const std::string& name) {
    return read_pattern(file(name, without_places(name, Taken::zero))).pattern;
  };
  const pattern::Pattern pants = read("gpg_pants_straight_sides.json");
  for (const char* name : {"Lfront", "Rfront"}) EXPECT_LT(facing(pants, name), -0.9);
  for (const char* name : {"Lback", "Rback"}) EXPECT_GT(facing(pants, name), 0.9);
  for (const char* name : {"Lfront", "Lback"}) EXPECT_GT(middle(pants, name).x(), 0.05) << name;
  for (const char* name : {"Rfront", "Rback"}) EXPECT_LT(middle(pants, name).x(), -0.05) << name;
  for (const char* name : {"Lfront", "Rfront", "Lback", "Rback"})
    EXPECT_GT(pants.panels[pants.find_panel(name)].rotation(2, 1), 0.99) << name << " upright";
  const pattern::Pattern skirt = read("gpg_skirt_4_panels.json");
  EXPECT_GT(skirt.panels[skirt.find_panel("left")].rotation.col(2).x(), 0.9);
  EXPECT_LT(skirt.panels[skirt.find_panel("right")].rotation.col(2).x(), -0.9);
  const pattern::Pattern hooded = read("gpg_jacket_hood.json");
  EXPECT_GT(hooded.panels[hooded.find_panel("Lhood")].rotation.col(2).x(), 0.9);
  EXPECT_GT(middle(hooded, "Lhood").z(), middle(hooded, "back").z() + 0.2) << "upright on the neck";
  EXPECT_GT(middle(hooded, "Rhood").z(), middle(hooded, "back").z() + 0.2) << "upright on the neck";
}

TEST_F(UnplacedPatterns, PlacesThatAFileGivesAreKept) {
  if (!fs::exists(kShared)) GTEST_SKIP() << "no " << kShared;
  for (const auto& entry : fs::directory_iterator(kShared)) {
    if (entry.path().extension() != ".json") continue;
    for (const std::string& line : read_pattern(entry.path()).warnings)
      EXPECT_EQ(line.find("arranged by"), std::string::npos) << entry.path() << ": " << line;
  }
}

TEST_F(UnplacedPatterns, WhatNoNameTellsIsToldWithWhatToDo) {
  if (!fs::exists(kShared)) GTEST_SKIP() << "no " << kShared;
  std::string text = without_places("gpg_skirt_4_panels.json", Taken::zero);
  for (const auto& [from, to] : {std::pair{"\"front\"", "\"p1\""},
                                 {"\"back\"", "\"p2\""},
                                 {"\"left\"", "\"p3\""},
                                 {"\"right\"", "\"p4\""}})
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;)
      text.replace(at, std::string(from).size(), to);
  const PatternFile skirt = read_pattern(file("skirt.json", text));
  EXPECT_FALSE(skirt.placed);
  EXPECT_EQ(skirt.not_placed_hint.find("side file"), std::string::npos) << skirt.not_placed_hint;
  EXPECT_NE(skirt.not_placed_hint.find("front, back"), std::string::npos) << skirt.not_placed_hint;
}

/// Four gores and a waistband without names, as in Inkscape.
std::string unnamed_skirt() {
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1500mm\" height=\"800mm\" "
      "viewBox=\"0 0 1500 800\">\n";
  for (const int x : {10, 360, 710, 1060})
    svg += "<path d=\"M " + std::to_string(x + 70) + " 10 h 190 l 70 600 h -330 Z\"/>\n";
  return svg + "<path d=\"M 10 640 h 740 v 60 h -740 Z\"/>\n</svg>\n";
}

TEST_F(UnplacedPatterns, AnUnnamedSkirtIsWornAsItIsProposed) {
  const fs::path svg = file("skirt.svg", unnamed_skirt());
  PatternFile unsewn = read_unsewn(svg);
  std::string text =
      seams_text(unsewn.pattern, pattern::propose_seams(unsewn.pattern, unsewn.notches));
  EXPECT_NE(text.find("[pieces]"), std::string::npos) << text;
  const std::size_t at = text.find("confirmed = false");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 17, "confirmed = true");
  file("skirt.seams.toml", text);
  const PatternFile skirt = read_pattern(svg);
  ASSERT_TRUE(skirt.placed) << skirt.not_placed;
  int before = 0, behind = 0;
  for (int p = 0; p < 4; ++p) {
    before += skirt.pattern.panels[p].rotation.col(2).y() < -0.9;
    behind += skirt.pattern.panels[p].rotation.col(2).y() > 0.9;
  }
  EXPECT_EQ(before, 2);
  EXPECT_EQ(behind, 2);
}

TEST_F(UnplacedPatterns, AConfirmedSideFileThatDoesNotDoIsToldWhatToChangeInIt) {
  const fs::path svg = file("skirt.svg", unnamed_skirt());
  const std::vector<pattern::Panel> panels = read_unsewn(svg).pattern.panels;
  std::string seams;
  const auto edge = [&](int p, int e) {
    return toml_quoted(panels[p].name + "." + panels[p].edges[e].name);
  };
  for (int p = 0; p < 4; ++p) {
    std::vector<int> steep;
    for (int e = 0; e < 4; ++e) {
      const Vec2 way =
          panels[p].vertices[panels[p].edges[e].end] - panels[p].vertices[panels[p].edges[e].start];
      if (std::abs(way.y()) > std::abs(way.x())) steep.push_back(e);
    }
    ASSERT_EQ(steep.size(), 2u);
    seams += "[[seam]]\nfirst = " + edge(p, steep[0]) + "\nsecond = ";
    const int next = (p + 1) % 4;
    int other = -1;
    for (int e = 0; e < 4; ++e) {
      const Vec2 way = panels[next].vertices[panels[next].edges[e].end] -
                       panels[next].vertices[panels[next].edges[e].start];
      if (std::abs(way.y()) > std::abs(way.x())) other = e;
    }
    seams += edge(next, other) + "\n";
  }
  const fs::path side =
      file("skirt.seams.toml", "leave_out = [" + toml_quoted(panels[4].name) + "]\n" + seams);
  const PatternFile skirt = read_pattern(svg);
  EXPECT_FALSE(skirt.placed);
  EXPECT_NE(skirt.not_placed_hint.find(side.string()), std::string::npos) << skirt.not_placed_hint;
  EXPECT_NE(skirt.not_placed_hint.find("[pieces]"), std::string::npos) << skirt.not_placed_hint;
  EXPECT_EQ(skirt.not_placed_hint.find("--propose-seams"), std::string::npos);
  // As it says.
  file("skirt.seams.toml", "leave_out = [" + toml_quoted(panels[4].name) + "]\n[pieces]\n" +
                               toml_quoted(panels[0].name) + " = \"front\"\n" +
                               toml_quoted(panels[1].name) + " = \"front\"\n" +
                               toml_quoted(panels[2].name) + " = \"back\"\n" +
                               toml_quoted(panels[3].name) + " = \"back\"\n" + seams);
  EXPECT_TRUE(read_pattern(svg).placed);
}

/// A skirt of two rectangles called front and back, with a notch in the waist to be told from hems.
std::string sideways_skirt() {
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1500mm\" height=\"800mm\" "
      "viewBox=\"0 0 1500 800\">\n";
  int x = 10;
  for (const char* name : {"front", "back"}) {
    svg += "<path id=\"" + std::string(name) + "\" d=\"M " + std::to_string(x) +
           " 10 h 500 v 250 l -30 125 l 30 125 h -500 Z\"/>\n";
    x += 600;
  }
  return svg + "</svg>\n";
}

TEST_F(UnplacedPatterns, ASideFileSaysWhichWayUpAPieceLies) {
  const fs::path svg = file("skirt.svg", sideways_skirt());
  const std::vector<pattern::Panel> panels = read_unsewn(svg).pattern.panels;
  ASSERT_EQ(panels.size(), 2u);
  std::string seams;
  for (const char* edges : {"1", "5"})
    seams += "[[seam]]\nfirst = \"front.e" + std::string(edges) + "\"\nsecond = \"back.e" +
             (edges[0] == '1' ? "5" : "1") + "\"\n";
  const auto up_of = [&](const std::string& said, const Vec3& side) {
    file("skirt.seams.toml", said + seams);
    const PatternFile skirt = read_pattern(svg);
    EXPECT_TRUE(skirt.placed) << skirt.not_placed;
    return (skirt.pattern.panels[skirt.pattern.find_panel("front")].rotation * side).z();
  };
  EXPECT_GT(up_of("", Vec3::UnitY()), 0.99);
  EXPECT_GT(up_of("[up]\nfront = \"right\"\nback = \"right\"\n", Vec3::UnitX()), 0.99);
  EXPECT_GT(up_of("[up]\nfront = \"down\"\nback = \"down\"\n", -Vec3::UnitY()), 0.99);
}

TEST_F(UnplacedPatterns, AFileThatIsNotThereIsToldBeforeWhatIsAskedOfIt) {
  for (const PatternWish& wish : {PatternWish{}, PatternWish{"M", ""}, PatternWish{"", "mm"}}) {
    EXPECT_THROW(read_pattern(base_ / "none.dxf", wish), IoError);
  }
}

TEST(SeamsFilePieces, MistakesAreTold) {
  const auto refused = [](const std::string& text) {
    return support::refusal_of([&] { support::tee_with_side_file(text); });
  };
  EXPECT_NE(refused("[pieces]\nFRNT = \"front\"\n").find("tee.seams.toml:2: pieces.FRNT"),
            std::string::npos)
      << refused("[pieces]\nFRNT = \"front\"\n");
  const std::string name = support::tee_with_side_file("").panels.front().name;
  EXPECT_NE(refused("[up]\nFRNT = \"left\"\n").find("tee.seams.toml:2: up.FRNT"),
            std::string::npos);
  EXPECT_NE(refused("[up]\n" + toml_quoted(name) + " = \"north\"\n").find("left"),
            std::string::npos);
  EXPECT_NE(refused("[pieces]\n" + toml_quoted(name) + " = \"blue\"\n").find("front, back"),
            std::string::npos);
  EXPECT_EQ(support::tee_with_side_file("[pieces]\n" + toml_quoted(name) + " = \"front left\"\n")
                .panels.front()
                .part,
            "front left");
}

}  // namespace
}  // namespace loosefit::io
