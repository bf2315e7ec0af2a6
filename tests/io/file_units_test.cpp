#include "loosefit/io/pieces/file_units.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/svg/svg_read.h"
#include "loosefit/pattern/outline.h"

// What a file states of its unit comes before what a garment usually measures.
namespace loosefit::io {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string joined(const PatternFile& file) {
  std::string all;
  for (const std::string& warning : file.warnings) all += warning + "\n";
  return all;
}

/// Longest side of the largest piece [m].
double longest(const PatternFile& file) {
  double side = 0;
  for (const pattern::Panel& panel : file.pattern.panels) {
    Vec2 low = Vec2::Constant(1e9), high = -low;
    for (const Vec2& p : pattern::outline_polygon(panel))
      low = low.cwiseMin(p), high = high.cwiseMax(p);
    side = std::max(side, (high - low).maxCoeff());
  }
  return side;
}

/// A rectangle of w × h mm in a drawing whose unit measures `mm`.
std::string drawing(const std::string& head, double w, double h, double mm,
                    const std::string& before = {}) {
  return "<?xml version=\"1.0\"?>\n" + before +
         "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
         head + fmt::format("><path id=\"front\" d=\"M0 0H{}V{}H0Z\"/></svg>", w / mm, h / mm);
}

std::string page(double mm, const std::string& unit, double in_unit) {
  return fmt::format("width=\"{0}{1}\" height=\"{0}{1}\" viewBox=\"0 0 {2} {2}\"", 2000 / in_unit,
                     unit, 2000 / mm);
}

TEST(FileUnits, OneDesignIsOneSizeInEveryDialectOfSvg) {
  const double inch = 25.4;
  const std::string illustrator = "<!-- Generator: Adobe Illustrator 27.0.0 -->\n";
  // A sleeve, a sock, a cup and a coat: what is large or small is no reason to doubt a unit.
  for (const double h : {620.0, 230.0, 90.0, 1650.0}) {
    const double w = 0.4 * h;
    const std::vector<std::string> drawings = {
        drawing(page(1, "mm", 1), w, h, 1),
        drawing(page(10, "cm", 10), w, h, 10),
        drawing(page(inch, "in", inch), w, h, inch),
        drawing(page(inch / 72, "pt", inch / 72), w, h, inch / 72),
        drawing(page(0.37, "mm", 1), w, h, 0.37),
        drawing("inkscape:version=\"0.91 r13725\" width=\"8000\" height=\"8000\"", w, h, inch / 90),
        drawing("inkscape:version=\"0.48.4\" width=\"2000mm\" height=\"2000mm\"", w, h, inch / 90),
        drawing("inkscape:version=\"0.48.4 r9939\" " + page(5, "px", inch / 90), w, h, 5),
        drawing("inkscape:version=\"0.91 r13725\" " + page(1, "mm", 1), w, h, 1),
        drawing("inkscape:version=\"0.92.5\" width=\"8000\" height=\"8000\"", w, h, inch / 96),
        drawing("inkscape:version=\"1.2.2 (b0a8486541)\" " + page(5, "", inch / 96), w, h, 5),
        drawing("viewBox=\"0 0 9000 9000\"", w, h, inch / 72, illustrator),
    };
    for (const std::string& text : drawings) {
      SCOPED_TRACE(text.substr(0, 300));
      const PatternFile file = parse_svg_pattern(text, "d.svg");
      EXPECT_NEAR(longest(file), h / 1000, 1e-9);
      EXPECT_FALSE(holds(joined(file), "does not name")) << joined(file);
    }
    for (const auto& [unit, mm] : {std::pair{"mm", 1.0}, {"cm", 10.0}, {"inch", inch}})
      EXPECT_NEAR(longest(parse_svg_pattern(drawing("", w, h, mm), "d.svg", {"", unit})), h / 1000,
                  1e-9);
  }
}

TEST(FileUnits, ADrawingWithoutAUnitIsToldByItsSizeAndToldSo) {
  const PatternFile pixels = parse_svg_pattern(drawing("", 300, 620, 25.4 / 96), "d.svg");
  EXPECT_NEAR(longest(pixels), 0.62, 1e-9);
  EXPECT_TRUE(
      holds(joined(pixels), "the file does not name its units; taken as pixels of 1/96 inch"));
  const PatternFile millimetres =
      parse_svg_pattern(drawing("viewBox=\"0 0 900 900\"", 300, 620, 1), "d.svg");
  EXPECT_NEAR(longest(millimetres), 0.62, 1e-9);
  EXPECT_TRUE(holds(joined(millimetres), "taken as millimetres")) << joined(millimetres);
  // The program's pixel is told in any case, since the page does not name a length.
  EXPECT_TRUE(
      holds(joined(parse_svg_pattern(
                drawing("inkscape:version=\"0.91\" width=\"9\"", 300, 620, 25.4 / 90), "d")),
            "Inkscape 0.91, whose pixels are 1/90 inch"));
}

TEST(FileUnits, EnglishOfCloIsNeverTakenForInches) {
  const auto units = [](double extent, const std::string& maker, const std::string& asked = {}) {
    return choose_units(asked, {"ENGLISH", {}, maker}, extent, "c.dxf");
  };
  for (const double extent : {10.0, 17.0, 24.0}) {
    EXPECT_EQ(units(extent, "Gerber").name, "inches");
    for (const char* maker : {" CLO Virtual Fashion Inc.", " Marvelous Designer"}) {
      const FileUnits taken = units(extent, maker);
      EXPECT_EQ(taken.name, "centimetres");
      EXPECT_NE(taken.warning.find("writes centimetres"), std::string::npos) << taken.warning;
      EXPECT_NE(taken.warning.find("--units"), std::string::npos) << taken.warning;
    }
    EXPECT_EQ(units(extent, " CLO 7", "cm").name, "centimetres");
  }
  EXPECT_EQ(units(26, " CLO 7").name, "centimetres");
  EXPECT_EQ(units(62, " CLO 7").name, "centimetres");
}

TEST(FileUnits, SmallPiecesAreNoDoubtOfAUnitThatIsNamed) {
  for (const double extent : {60.0, 120.0, 230.0, 700.0, 2500.0})
    for (const SaidUnits& says :
         {SaidUnits{"mm", {}}, SaidUnits{"Millimeters", {}}, SaidUnits{"", 4}}) {
      const FileUnits units = choose_units("", says, extent, "f");
      EXPECT_EQ(units.name, "millimetres") << extent;
      EXPECT_EQ(units.warning, "") << extent;
    }
  EXPECT_EQ(choose_units("", {"cm", {}}, 23, "f").name, "centimetres");
  EXPECT_EQ(choose_units("", {"Zoll", {}}, 9, "f").name, "inches");
  EXPECT_NEAR(choose_units("", {"", 2}, 2, "f").metre, 0.3048, 1e-12) << "feet";
}

TEST(FileUnits, AStatementIsKeptWithAWarningThatNamesBoth) {
  const auto kept = [](const SaidUnits& says, double extent, const std::string& name,
                       const std::string& words) {
    const FileUnits units = choose_units("", says, extent, "f");
    EXPECT_EQ(units.name, name) << extent;
    EXPECT_TRUE(holds(units.warning, words)) << units.warning;
    EXPECT_TRUE(holds(units.warning, "--units says otherwise")) << units.warning;
  };
  kept({"METRIC", {}}, 230, "millimetres", "0.23 m is unusual");
  kept({"METRIC", {}}, 70, "millimetres", "it would be 0.7 m in centimetres");
  kept({"ENGLISH", {}}, 118, "inches", "it would be 1.18 m in centimetres");
  kept({"ENGLISH", {}}, 62, "inches", "0.62 m in centimetres");
  kept({"", 5}, 700, "centimetres", "it would be 0.7 m in millimetres");
  // Two statements: the one that makes a garment, text before header.
  kept({"METRIC", 5}, 70, "centimetres", "Units: METRIC and the header says centimetres");
  kept({"METRIC", 1}, 700, "millimetres", "Units: METRIC and the header says inches");
  kept({"ENGLISH", 4}, 700, "millimetres", "Units: ENGLISH and the header says millimetres");
  // CLO: centimetres or millimetres under METRIC.
  const SaidUnits clo{"METRIC", {}, " CLO Virtual Fashion Inc."};
  kept(clo, 118, "centimetres", "writes centimetres too");
  EXPECT_EQ(choose_units("", clo, 700, "f").warning, "");
}

TEST(FileUnits, TheSystemOfTheHeaderDecidesWhereNothingElseDoes) {
  SaidUnits says;
  EXPECT_THROW(choose_units("", says, 40, "f"), InvalidInput) << "40 cm or 40 inches";
  says.metric = true;
  EXPECT_EQ(choose_units("", says, 40, "f").name, "centimetres");
  says.metric = false;
  const FileUnits units = choose_units("", says, 40, "f");
  EXPECT_EQ(units.name, "inches");
  EXPECT_TRUE(holds(units.warning, "$MEASUREMENT")) << units.warning;
  says.claimed = "ells";
  EXPECT_TRUE(holds(choose_units("", says, 40, "f").warning, "which is no unit that is known"));
}

TEST(FileUnits, PagesAreReadWithDecimalCommasAndUnitsInAnyLetterCase) {
  for (const auto& [unit, mm] : {std::pair{"mm", 1.0},
                                 {"cm", 10.0},
                                 {"MM", 1.0},
                                 {"in", 25.4},
                                 {"inch", 25.4},
                                 {" mm", 1.0}})
    for (const char* sign : {".", ","}) {
      const std::string side = "400" + std::string(sign) + "5" + unit;
      const double wide = mm > 5 ? 200 : 2000;
      const PatternFile file = parse_svg_pattern(
          drawing("width=\"" + side + "\" height=\"" + side + "\" viewBox=\"0 0 4005 4005\"", wide,
                  wide, 1),
          "x.svg");
      EXPECT_NEAR(longest(file), 1e-3 * wide * 0.1 * mm, 1e-9) << side;
    }
  try {
    parse_svg_pattern(drawing("width=\"40 cubits\" height=\"40mm\" viewBox=\"0 0 4 4\"", 1, 1, 1),
                      "x.svg");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_TRUE(holds(error.what(), "width: found \"40 cubits\"")) << error.what();
  }
}

}  // namespace
}  // namespace loosefit::io
