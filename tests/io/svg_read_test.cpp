#include "loosefit/io/svg/svg_read.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/freesewing_json.h"
#include "loosefit/io/pattern_svg.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/pattern/known_garment.h"
#include "loosefit/pattern/outline.h"
#include "support/drawn_tshirt.h"

namespace loosefit::io {
namespace {

using namespace testing_support;

PatternFile read(const std::string& text, const PatternWish& wish = {}) {
  return parse_svg_pattern(text, "p.svg", wish);
}

double area(const pattern::Panel& panel) {
  return pattern::signed_area(pattern::outline_polygon(panel));
}

std::vector<double> lengths(const PatternFile& file, const std::string& panel) {
  return pattern::edge_lengths(file.pattern.panels.at(file.pattern.find_panel(panel)));
}

bool tells(const std::vector<std::string>& lines, const std::string& words) {
  for (const std::string& line : lines)
    if (line.find(words) != std::string::npos) return true;
  return false;
}

std::string svg(const std::string& head, const std::string& body) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
         head + ">\n" + body + "</svg>\n";
}

TEST(FreesewingSvg, HalvesAreUnfoldedAndSleevesCutTwice) {
  for (const bool marked : {false, true}) {
    SCOPED_TRACE(marked);
    const PatternFile file = read(freesewing_tshirt(marked));
    ASSERT_EQ(file.pattern.panels.size(), 4u);
    EXPECT_FALSE(file.placed);
    EXPECT_TRUE(tells(file.about, "2 half pieces unfolded"));
    const std::vector<double> front = lengths(file, "front");
    ASSERT_EQ(front.size(), 8u);
    // Hem, side, armhole, shoulder, neck and back; the neckline and the hem are one edge each.
    const auto known = pattern::know_garment(file.pattern);
    EXPECT_EQ(known.kind, "t-shirt");
    EXPECT_TRUE(known.certain()) << (known.doubts.empty() ? "" : known.doubts[0]);
    const auto& s = known.pieces[file.pattern.find_panel("front")].sections;
    EXPECT_NEAR(s[0].length, 0.500, 1e-6);
    EXPECT_NEAR(s[1].length, std::hypot(0.395, 0.010), 1e-6);
    EXPECT_NEAR(s[2].length, 0.18915, 2e-5);
    EXPECT_NEAR(s[3].length, std::hypot(0.110, 0.037), 1e-6);
    EXPECT_EQ(file.notches.size(), marked ? 2u : 0u);  // and its mirror image
    EXPECT_EQ(tells(file.unused, "seam allowances"), marked);
  }
}

TEST(FreesewingSvg, OutlineWithAGapIsClosedWithAWarningUnlessTheGapIsAFold) {
  EXPECT_FALSE(tells(read(freesewing_tshirt(false)).warnings, "outline is open"));
  for (const double gap : {0.5, 1.5, 20.0, 100.0}) {
    std::string text = freesewing_tshirt(false);
    const std::size_t at = text.find("<path", text.find("tee.sleeve"));
    ASSERT_NE(at, std::string::npos);
    text.replace(
        at, text.find("/>", at) - at,
        "<path class=\"fabric\" d=\"M 20,0 H 300 V 250 H 20 V " + std::to_string(gap) + "\"");
    const PatternFile file = read(text);
    EXPECT_TRUE(tells(file.warnings, "piece sleeve: its outline is open")) << gap;
  }
}

TEST(FreesewingSvg, PartsThatAreEmptyAndLinesThatAreInNoneAreTold) {
  // The sleeve's outline stands beside its part.
  std::string text = freesewing_tshirt(false);
  const std::size_t begin = text.find("<path class=\"fabric\" id=\"fs-sleeve\"");
  ASSERT_NE(begin, std::string::npos);
  const std::size_t end = text.find("/>", begin) + 2;
  const std::string sleeve = text.substr(begin, end - begin);
  text.erase(begin, end - begin);
  text.insert(text.rfind("</svg>"), sleeve + "\n");
  const PatternFile file = read(text);
  EXPECT_EQ(file.pattern.panels.size(), 2u);
  EXPECT_TRUE(tells(file.unused, "part tee.sleeve: it is empty"));
  EXPECT_TRUE(tells(file.warnings, "line of class \"fabric\" at line"));
  EXPECT_TRUE(tells(file.unused, "it stands in no part"));
}

TEST(FreesewingSvg, SaysTheSameAsItsJson) {
  const PatternFile drawn = read(freesewing_tshirt(true));
  const PatternFile json = parse_freesewing_json(freesewing_json(), "p.json");
  ASSERT_EQ(json.pattern.panels.size(), 4u);
  for (const char* name : {"front", "back", "sleeve", "sleeve_mirrored"}) {
    SCOPED_TRACE(name);
    const auto a = lengths(drawn, name), b = lengths(json, name);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t e = 0; e < a.size(); ++e) EXPECT_NEAR(a[e], b[e], 1e-6);
  }
  EXPECT_THROW(parse_freesewing_json("{\"settings\":{\"sa\":0},\"parts\":[]}", "p.json"),
               GeometryError);
  EXPECT_THROW(parse_freesewing_json("{\"settings\":{\"sa\":0},\"design\":\"x\"}", "p.json"),
               InvalidInput);
}

/// A piece in Inkscape's manner: within a layer, moved, turned by 90 degrees and scaled.
const char* const kInkscape =
    R"svg(<g inkscape:groupmode="layer" inkscape:label="Schnitt" id="layer1"
 transform="translate(20,30)">
<g id="g12" inkscape:label="Vorderteil" transform="rotate(90) scale(2)">
<path id="path3" d="m 0,0 h 100 v 150 h -100 z"/>
<path id="path4" inkscape:label="naht" d="m 5,5 h 90 v 140 h -90 z"/>
<path id="path5" inkscape:label="Fadenlauf" d="M 20,75 H 80"/>
<path id="path6" inkscape:label="Knips" d="M 5,75 l 3,0"/>
<circle cx="50" cy="75" r="10"/>
</g>
<path id="Kragen" d="M 400,0 l 60,0 0,300 -60,0 z"/>
</g>
<g inkscape:groupmode="layer" style="display:none"><path id="old" d="M0 0h500v500h-500z"/></g>
<rect id="rect1" x="0" y="0" width="600" height="500" style="fill:white"/>
)svg";

TEST(InkscapeSvg, NamesTransformsGrainSewLineAndNotchesAreRead) {
  const PatternFile file =
      read(svg("width=\"600mm\" height=\"500mm\" viewBox=\"0 0 600 500\"", kInkscape));
  ASSERT_EQ(file.pattern.panels.size(), 2u);
  const pattern::Panel& front = file.pattern.panels[file.pattern.find_panel("Vorderteil")];
  EXPECT_NEAR(area(front), 0.180 * 0.280, 1e-9);  // of the sew line, twice as large as drawn
  // The grain runs along the drawn x, so that the longer side lies across.
  Vec2 low = Vec2::Constant(1), high = -low;
  for (const Vec2& v : front.vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
  EXPECT_NEAR((high - low).x(), 0.280, 1e-9);
  EXPECT_NEAR((high - low).y(), 0.180, 1e-9);
  ASSERT_EQ(file.notches.size(), 1u);
  EXPECT_NEAR(file.notches[0].along, 0.5, 1e-9);
  EXPECT_GE(file.pattern.find_panel("Kragen"), 0);
  EXPECT_TRUE(tells(file.unused, "frames")) << "the white page";
  EXPECT_TRUE(tells(file.unused, "hidden"));
  EXPECT_TRUE(tells(file.unused, "closed lines within pieces: 1")) << "the circle";
  EXPECT_TRUE(tells(file.warnings, "1 pieces have no sew line"));
  EXPECT_TRUE(tells(file.warnings, "1 pieces have no grain line"));
}

TEST(InkscapeSvg, HalfPiecesAreUnfoldedAtALineCalledFold) {
  const PatternFile file = read(svg("width=\"400mm\" height=\"700mm\" viewBox=\"0 0 400 700\"",
                                    std::string("<g id=\"front\"><path d=\"") + kFrontHalf +
                                        "\"/><path id=\"fold\" d=\"M0 100 V 590\"/></g>"));
  ASSERT_EQ(file.pattern.panels.size(), 1u);
  EXPECT_EQ(file.pattern.panels[0].edges.size(), 8u);
  EXPECT_TRUE(tells(file.about, "1 half pieces unfolded"));
}

TEST(InkscapeSvg, AHalfPieceThatHangsTogetherByAPointIsLeftOutWithAWarning) {
  // Its shoulder comes down to the fold.
  for (const char* at_fold : {"0,8", "1e-300,8", "0.4,8"}) {
    SCOPED_TRACE(at_fold);
    std::string front = kFrontHalf;
    front.replace(front.find("80,8"), 4, at_fold);
    const PatternFile file =
        read(svg("width=\"800mm\" height=\"700mm\" viewBox=\"0 0 800 700\"",
                 "<g id=\"front\"><path d=\"" + front +
                     "\"/><path id=\"fold\" d=\"M0 100 V 590\"/></g><g id=\"back\"><path d=\"" +
                     kBackHalf + "\" transform=\"translate(400 0)\"/></g>"));
    ASSERT_EQ(file.pattern.panels.size(), 1u);
    EXPECT_TRUE(tells(file.warnings, "crosses itself"));
  }
}

TEST(InkscapeSvg, OpenLinesOfAGroupThatCloseTogetherAreAPiece) {
  const PatternFile file = read(svg("width=\"500mm\" height=\"500mm\" viewBox=\"0 0 500 500\"",
                                    "<g id=\"side\"><path d=\"M0 0 L300 0\"/>"
                                    "<line x1=\"300\" y1=\"0\" x2=\"300\" y2=\"400\"/>"
                                    "<polyline points=\"300,400 150,410 0,400\"/>"
                                    "<path d=\"M0 400V0\"/></g>"));
  ASSERT_EQ(file.pattern.panels.size(), 1u);
  EXPECT_EQ(file.pattern.panels[0].name, "side");
  EXPECT_EQ(file.pattern.panels[0].edges.size(), 4u);
}

TEST(FreesewingSvg, PartsOfOneHandAreNotMirroredWhereTheOtherHandsStandsInTheFile) {
  const auto drawing = [&](const std::vector<std::string>& parts) {
    std::string text =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" freesewing=\"4.10.2\" width=\"2000mm\" "
        "height=\"700mm\" viewBox=\"0 0 2000 700\">\n";
    for (std::size_t i = 0; i < parts.size(); ++i)
      text += freesewing_part(parts[i], parts[i].find("front") == 0 ? kFrontHalf : kSleeve,
                              std::to_string(200 + 320 * i) + ", 110");
    return text + "</svg>\n";
  };
  const auto names = [&](const std::vector<std::string>& parts) {
    std::string all;
    for (const pattern::Panel& panel : read(drawing(parts)).pattern.panels) all += panel.name + " ";
    return all;
  };
  EXPECT_EQ(names({"sleeve"}), "sleeve sleeve_mirrored ");
  EXPECT_EQ(names({"sleeveLeft"}), "sleeveLeft sleeveLeft_mirrored ")
      << "the other hand is missing";
  EXPECT_EQ(names({"sleeveLeft", "sleeveRight"}), "sleeveLeft sleeveRight ");
  EXPECT_EQ(names({"frontLeft", "frontRight", "sleeve"}),
            "frontLeft frontRight sleeve sleeve_mirrored ");
  std::string json = freesewing_json();
  json.replace(json.find("tee.front"), 9, "tee.sleeveLeft");
  json.replace(json.find("tee.back"), 8, "tee.sleeveRight");
  EXPECT_EQ(parse_freesewing_json(json, "p.json").pattern.panels.size(), 4u)
      << "one of them cut twice";
  for (const pattern::Panel& panel : read(drawing({"frontLeft", "frontRight"})).pattern.panels)
    EXPECT_LT(pattern::signed_area(pattern::outline_polygon(panel)), 0.15)
        << "a half, not unfolded";
}

TEST(InkscapeSvg, PiecesWhoseNamesSpeakOfFoldOrNotchArePieces) {
  const std::string page = "width=\"1500mm\" height=\"900mm\" viewBox=\"0 0 1500 900\"";
  const PatternFile file =
      read(svg(page,
               "<path inkscape:label=\"front on fold\" d=\"M0 0h300v600h-300z\"/>"
               "<path inkscape:label=\"notched collar\" d=\"M400 0h300v90h-300z\"/>"
               // Arrows and brackets, in a piece and across its side.
               "<path inkscape:label=\"grain\" d=\"M150 100l20 40h-10v260h-20v-260h-10z\"/>"
               "<path inkscape:label=\"fold\" d=\"M800 100h10v400h-10z\"/>"
               "<path inkscape:label=\"fold\" d=\"M1390 100h20v400h-20z\"/>"
               "<path id=\"back\" d=\"M1100 0h300v600h-300z\"/>"
               // A dart in a group that is called after its piece.
               "<g id=\"sleeve_on_fold\"><path d=\"M400 300h300v400h-300z\"/>"
               "<path d=\"M400 400l90 10\"/></g>"));
  std::string names;
  for (const pattern::Panel& panel : file.pattern.panels) names += panel.name + ", ";
  EXPECT_EQ(names, "front on fold, notched collar, fold, back, sleeve_on_fold, ");
  EXPECT_TRUE(tells(file.unused, "open lines that are no grain, fold or notch: 1"));
  EXPECT_TRUE(tells(file.warnings, "front on fold: its name speaks of a fold"));
  EXPECT_TRUE(tells(file.warnings, "4 pieces have no grain line"));
}

TEST(InkscapeSvg, OutlinesOfSeveralSizesInEachOtherAreToldAndCanBePicked) {
  std::string body;
  for (const auto& [size, wide] : {std::pair{"S", 400}, {"M", 440}, {"L", 480}}) {
    const std::string w = std::to_string(wide);
    body += std::string("<g inkscape:groupmode=\"layer\" inkscape:label=\"size ") + size +
            "\"><path inkscape:label=\"front\" d=\"M0 0h" + w + "l0 600h-" + w +
            "z\"/><rect inkscape:label=\"band\" x=\"600\" y=\"0\" width=\"" + w +
            "\" height=\"60\"/></g>\n";
  }
  body += "<path id=\"pocket\" d=\"M600 200h90v90h-90z\"/>";
  const std::string text = svg("width=\"1500mm\" height=\"900mm\" viewBox=\"0 0 1500 900\"", body);
  const auto widths = [&](const std::string& size) {
    const PatternFile file = read(text, {size, ""});
    EXPECT_EQ(file.pattern.panels.size(), 3u);
    return std::pair{area(file.pattern.panels[file.pattern.find_panel("front")]) / 0.6,
                     area(file.pattern.panels[file.pattern.find_panel("band")]) / 0.06};
  };
  for (const auto& [size, wide] : {std::pair{"", 0.48}, {"L", 0.48}, {"m", 0.44}, {"S", 0.40}}) {
    SCOPED_TRACE(size);
    EXPECT_NEAR(widths(size).first, wide, 1e-9);
    EXPECT_NEAR(widths(size).second, wide, 1e-9);
  }
  EXPECT_TRUE(
      tells(read(text).warnings, "front: the largest of 3 outlines that lie in each other"));
  EXPECT_TRUE(tells(read(text, {"M", ""}).about, "size M by the labels of 2 outlines"));
  EXPECT_TRUE(tells(read(text, {"M", ""}).unused, "outlines of other sizes: 4"));
  EXPECT_FALSE(tells(read(text, {"M", ""}).warnings, "lie in each other"));
  for (const char* wrong : {"XL", "size"}) try {
      read(text, {wrong, ""});
      ADD_FAILURE() << wrong;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("\"front in size S\""), std::string::npos)
          << error.what();
    }
  EXPECT_THROW(
      read(svg("width=\"600mm\" height=\"500mm\" viewBox=\"0 0 600 500\"", kInkscape), {"M", ""}),
      InvalidInput)
      << "in one size";
}

TEST(InkscapeSvg, WhichEndOfTheGrainLineIsDrawnFirstDoesNotMatter) {
  for (const char* grain : {"M200 100V500", "M200 500V100"}) {
    const PatternFile file =
        read(svg("width=\"500mm\" height=\"700mm\" viewBox=\"0 0 500 700\"",
                 std::string("<path id=\"a\" d=\"M100 0h200l100 600h-400z\"/><path id=\"grain\" "
                             "d=\"") +
                     grain + "\"/>"));
    const pattern::Panel& panel = file.pattern.panels.at(0);
    double below = 0;
    for (const Vec2& v : panel.vertices)
      if (v.y() < 1e-9) below = std::max(below, v.x());
    EXPECT_NEAR(below, 0.2, 1e-9) << grain;
  }
}

TEST(InkscapeSvg, UnitsComeFromThePage) {
  const std::string piece = "<path id=\"a\" d=\"M0 0h40v60h-40z\"/>";
  const auto height = [&](const std::string& head, const PatternWish& wish = {}) {
    const PatternFile file = read(svg(head, piece), wish);
    return std::sqrt(area(file.pattern.panels.at(0)) * 1.5);
  };
  EXPECT_NEAR(height("width=\"80cm\" height=\"90cm\" viewBox=\"0 0 80 90\""), 0.60, 1e-9);
  EXPECT_NEAR(height("width=\"40in\" height=\"60in\" viewBox=\"0 0 80 120\""), 0.60 * 1.27, 1e-9);
  EXPECT_NEAR(height("viewBox=\"0 0 80 90\"", {"", "cm"}), 0.60, 1e-9);
  EXPECT_NEAR(height("", {"", "inch"}), 60 * 0.0254, 1e-9);
  EXPECT_NEAR(height("width=\"800\" height=\"900\" viewBox=\"0 0 80 90\"", {"", "cm"}), 0.6, 1e-9);
  // Nobody says: 90 px of 1/96 inch are no garment, nor are 90 mm or 90 inches; 90 cm are.
  const PatternFile file = read(svg("", "<path id=\"a\" d=\"M0 0h40v90h-40z\"/>"));
  EXPECT_NEAR(area(file.pattern.panels[0]), 0.36, 1e-9);
  EXPECT_THROW(read(svg("", piece)), InvalidInput) << "60 cm or 60 inches";
  EXPECT_TRUE(tells(file.warnings, "taken as centimetres"));
  // Pixels that make a garment are taken, and told.
  const PatternFile pixels = read(svg("", "<path id=\"a\" d=\"M0 0h1500v2400h-1500z\"/>"));
  EXPECT_NEAR(area(pixels.pattern.panels[0]), 1500 * 2400 * std::pow(0.0254 / 96, 2), 1e-9);
  EXPECT_TRUE(tells(pixels.warnings, "pixels of 1/96 inch"));
}

TEST(InkscapeSvg, OurOwnSheetIsReadBack) {
  const pattern::Pattern shirt = kinds::draft_shirt({});
  const PatternFile file = read(pattern_svg(shirt));
  ASSERT_EQ(file.pattern.panels.size(), shirt.panels.size());
  for (const pattern::Panel& panel : shirt.panels) {
    SCOPED_TRACE(panel.name);
    const int p = file.pattern.find_panel(panel.name);
    ASSERT_GE(p, 0);
    EXPECT_NEAR(area(file.pattern.panels[p]), area(panel), 5e-5 * area(panel));
  }
}

TEST(Svg, WhatIsNoPatternIsRefusedWithThePlace) {
  const auto told = [](const std::string& text, const std::string& words) {
    try {
      read(text);
      ADD_FAILURE() << words;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).rfind("p.svg", 0), 0u) << error.what();
    }
  };
  told("<svg><path d=\"M0 0\"></svg>", "p.svg:1: XML: found mismatched tag");
  told("<html/>", "root is html");
  told(svg("", ""), "none of them a closed line");
  told(svg("viewBox=\"0 0 0 5\"", ""), "viewBox");
  told(svg("", "<path d=\"M0 0 1\"/>"), "p.svg:2: d:");
  told(svg("", "<polygon points=\"0 0 1\"/>"), "3 numbers");
  EXPECT_THROW(read(freesewing_tshirt(true), {"M", ""}), InvalidInput);
  // Entities that grow, and depth.
  std::string bomb = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c < 'k'; ++c) {
    bomb += std::string("<!ENTITY ") + c + " \"";
    for (int i = 0; i < 10; ++i) bomb += std::string("&") + static_cast<char>(c - 1) + ";";
    bomb += "\">";
  }
  told(bomb + "]><svg>&j;</svg>", "amplification");
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "<g>";
  told("<svg>" + deep, "200 elements in each other");
  // A drawing that uses itself ends.
  const PatternFile used = read(
      svg("width=\"500mm\" height=\"500mm\" viewBox=\"0 0 500 500\"",
          "<g id=\"a\"><path id=\"x\" d=\"M0 0h300v300h-300z\"/><use href=\"#a\" x=\"9\"/></g>"));
  EXPECT_GE(used.pattern.panels.size(), 1u);
}

}  // namespace
}  // namespace loosefit::io
