#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/svg/svg_read.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

PatternFile read(const std::string& body, const std::string& size = {}) {
  return parse_svg_pattern(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"2000mm\" "
      "height=\"900mm\" viewBox=\"0 0 2000 900\">\n" +
          body + "</svg>\n",
      "p.svg", {size, ""});
}

bool tells(const std::vector<std::string>& lines, const std::string& words) {
  for (const std::string& line : lines)
    if (line.find(words) != std::string::npos) return true;
  return false;
}

std::string names(const PatternFile& file) {
  std::string all;
  for (const pattern::Panel& panel : file.pattern.panels) all += panel.name + ", ";
  return all;
}

/// Of the first piece, all of which are half as high again as wide [m].
double width(const PatternFile& file) {
  const double area = pattern::signed_area(pattern::outline_polygon(file.pattern.panels.at(0)));
  return std::sqrt(area / 1.5);
}

std::string group(const std::string& label, const std::string& body) {
  return "<g inkscape:label=\"" + label + "\">" + body + "</g>\n";
}

/// Round the point (x, 400), half as high again as wide [mm].
std::string outline(const std::string& attributes, double wide, double x = 400) {
  return "<rect " + attributes + " x=\"" + std::to_string(x - wide / 2) + "\" y=\"" +
         std::to_string(400 - 0.75 * wide) + "\" width=\"" + std::to_string(wide) + "\" height=\"" +
         std::to_string(1.5 * wide) + "\"/>";
}

std::string label(const std::string& text) { return "inkscape:label=\"" + text + "\""; }

// Sizes 20 mm apart in width, an allowance of 15 mm: the sew line of L lies in the cut line of M.
constexpr double kS = 400, kM = 420, kL = 440, kAllowance = 30;

TEST(SvgSizes, SewLineOfALargerSizeIsNotTaken) {
  const auto in_groups = [](bool seam_of_m) {
    std::string body;
    for (const auto& [size, wide] : {std::pair{"S", kS}, {"M", kM}, {"L", kL}})
      body += group(std::string("size ") + size,
                    outline(label("front"), wide) + (seam_of_m || wide != kM
                                                         ? outline(label("seam"), wide - kAllowance)
                                                         : std::string()));
    return body;
  };
  const auto in_one_group = [](bool sizes_at_seams, bool sizes_in_one_group) {
    std::string body;
    int id = 0;
    for (const auto& [size, wide] : {std::pair{"S", kS}, {"M", kM}, {"L", kL}}) {
      const std::string seam = sizes_at_seams ? std::string("seam ") + size : "seam";
      const std::string both = outline(label(size), wide) + outline(label(seam), wide - kAllowance);
      body +=
          sizes_in_one_group ? both : "<g id=\"g" + std::to_string(++id) + "\">" + both + "</g>";
    }
    return group("front", body);
  };
  for (const auto& [size, wide] : {std::pair{"S", kS}, {"M", kM}, {"L", kL}}) {
    SCOPED_TRACE(size);
    const double sewn = (wide - kAllowance) / 1000;
    for (const std::string& body : {in_groups(true), in_one_group(true, true),
                                    in_one_group(false, false), in_one_group(false, true)}) {
      const PatternFile file = read(body, size);
      EXPECT_NEAR(width(file), sewn, 1e-9) << body;
      EXPECT_FALSE(tells(file.warnings, "of which size")) << body;
    }
  }
  // M has none of its own: L's, which lies in it too, is none of M's.
  const PatternFile none = read(in_groups(false), "M");
  EXPECT_NEAR(width(none), kM / 1000, 1e-9);
  EXPECT_TRUE(tells(none.warnings, "no sew line"));
  EXPECT_NEAR(width(read(in_groups(false))), (kL - kAllowance) / 1000, 1e-9);
}

TEST(SvgSizes, SewLineThatMayBeOfAnySizeIsTold) {
  const std::string cuts =
      outline(label("S"), kS) + outline(label("M"), kM) + outline(label("L"), kL);
  const PatternFile one = read(group("front", cuts + outline(label("seam"), kS - kAllowance)), "M");
  EXPECT_NEAR(width(one), (kS - kAllowance) / 1000, 1e-9);
  EXPECT_TRUE(tells(one.warnings, "front: no label says of which size its sew line is"));
}

TEST(SvgSizes, PiecesAreNotCalledAfterTheirSize) {
  const auto nest = [](double x) {
    return outline(label("S"), kS, x) + outline(label("M"), kM, x) + outline(label("L"), kL, x);
  };
  const auto nest_in_groups = [](double x) {
    return group("S", outline("", kS, x)) + group("M", outline("", kM, x)) +
           group("L", outline("", kL, x));
  };
  for (const std::string& body :
       {group("front", nest(400)) + group("back", nest(1200)),
        group("front", nest_in_groups(400)) + group("back", nest_in_groups(1200))})
    for (const char* size : {"", "S", "m", "L"})
      EXPECT_EQ(names(read(body, size)), "front, back, ") << size;
  EXPECT_NEAR(width(read(group("front", nest(400)), "m")), kM / 1000, 1e-9);
  // Without a group it is all there is; labels that name the piece stay.
  EXPECT_EQ(names(read(nest(400), "M")), "M, ");
  EXPECT_EQ(names(read(group("Bluse", outline(label("front"), kM) + outline(label("x"), kS) +
                                          outline(label("back"), kM, 1200)))),
            "front, back, ");
  EXPECT_EQ(names(read(group("Bluse", outline(label("Teil 1"), kM) + outline(label("x"), kS) +
                                          outline(label("Teil 2"), kM, 1200)))),
            "Teil 1, Teil 2, ")
      << "the group holds both";
}

TEST(SvgSizes, IdsThatProgramsGaveAreNoSizes) {
  const std::string body =
      group("front", outline("id=\"path833\"", kS) + outline("id=\"path833-6\"", kM) +
                         outline("id=\"rect12-8\"", kL));
  try {
    read(body, "6");
    ADD_FAILURE() << "an id of the program";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("it is in those of 0"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(read("<g id=\"g6\">" + outline(label("front"), kM) + "</g><g id=\"layer-6\">" +
                        outline(label("front"), kS) + "</g>",
                    "6"),
               InvalidInput);
  EXPECT_NEAR(width(read(outline("id=\"size_6\"", kS) + outline("id=\"size_8\"", kM), "6")),
              kS / 1000, 1e-9);
}

TEST(SvgSizes, UnlabelledLinesInAGroupOfMarksAreMarks) {
  const std::string half = "<path inkscape:label=\"front\" d=\"M0 0h300v600h-300z\"/>";
  const auto width_with = [&](const std::string& marks) {
    const PatternFile file = read(group("front", half + marks));
    EXPECT_EQ(file.pattern.panels.size(), 1u) << marks;
    return pattern::signed_area(pattern::outline_polygon(file.pattern.panels.at(0))) / 0.6;
  };
  const std::string line = "<path id=\"path12\" d=\"M0 0V600\"/>";
  EXPECT_NEAR(width_with(group("front fold", line)), 0.6, 1e-9);
  EXPECT_NEAR(width_with(group("fold", line)), 0.6, 1e-9);
  const PatternFile grain =
      read(group("Vorderteil",
                 half + group("Fadenlauf Vorderteil", "<path id=\"path13\" d=\"M50 300H250\"/>")));
  EXPECT_FALSE(tells(grain.warnings, "no grain line"));
  const PatternFile notched = read(group(
      "front", half + group("front notches",
                            "<path d=\"M300 200h-6\"/><path id=\"path15\" d=\"M300 400h-6\"/>")));
  EXPECT_EQ(notched.notches.size(), 2u);
  EXPECT_FALSE(tells(notched.unused, "open lines"));
  // Where the piece stands in the group it is called after the piece, as deep as that may be.
  for (const std::string& piece : {half, "<g id=\"g7\">" + half + "</g>"})
    EXPECT_TRUE(tells(read(group("front on fold", piece + line)).unused, "open lines")) << piece;
}

}  // namespace
}  // namespace loosefit::io
