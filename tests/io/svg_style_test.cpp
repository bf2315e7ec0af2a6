#include "loosefit/io/svg/svg_style.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "loosefit/io/svg/svg_document.h"

// What style sheets, attributes, definitions and symbols hide is not drawn, and is named.
namespace loosefit::io {
namespace {

std::string drawing(const std::string& body) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
         "width=\"500mm\" height=\"500mm\" viewBox=\"0 0 500 500\">" +
         body + "</svg>";
}

SvgDocument document(const std::string& body) { return parse_svg(drawing(body), "d.svg"); }

std::set<std::string> drawn(const SvgDocument& document) {
  std::set<std::string> ids;
  for (const SvgShape& shape : document.shapes) ids.insert(shape.id);
  return ids;
}

std::string path(const std::string& id, const std::string& attributes = {}) {
  return "<path id=\"" + id + "\" " + attributes + " d=\"M0 0h90v60h-90z\"/>";
}

bool told(const SvgDocument& document, const std::string& name, const std::string& reason) {
  return std::any_of(document.unused.begin(), document.unused.end(), [&](const std::string& line) {
    return line.find(name) != std::string::npos && line.find(reason) != std::string::npos;
  });
}

TEST(SvgStyle, EverySelectorThatHidesAPieceHidesThatOneAlone) {
  // The piece "b" stands in layer "old" and has the classes st1 and sizeL.
  const std::string body = path("a", "class=\"st0\"") + "<g id=\"old\" class=\"layer\">" +
                           path("b", "class=\"st1 sizeL\" data-size=\"L\"") + "</g>" +
                           path("c", "class=\"st10\"");
  for (const char* selector : {".st1",
                               "#b",
                               "path.st1",
                               ".st1.sizeL",
                               "*.sizeL",
                               "g path",
                               "g > path",
                               "svg g .st1",
                               ".none, .st1",
                               ".st1 , .none",
                               "#old path",
                               "g.layer>path",
                               "[data-size=L]",
                               "path[data-size='L']",
                               "path[data-size]",
                               "[class~=sizeL]",
                               "[class^=\"st1 \"]",
                               "#old",
                               "g",
                               "svg #old > #b"})
    for (const char* rule : {"display:none", "display : none !important ;", "DISPLAY: NONE",
                             "fill:red; visibility:hidden", "/* x */visibility : collapse"}) {
      SCOPED_TRACE(std::string(selector) + " {" + rule + "}");
      const SvgDocument d =
          document(std::string("<style type=\"text/css\"><![CDATA[ .st0{fill:none;} ") + selector +
                   " {" + rule + "} ]]></style>" + body);
      EXPECT_EQ(drawn(d), (std::set<std::string>{"a", "c"}));
      EXPECT_TRUE(told(d, "\"b\"", "hidden by ") || told(d, "\"old\" (1 shape)", "hidden by "));
    }
}

TEST(SvgStyle, WhatDoesNotMatchOrDoesNotHideDrawsAll) {
  const std::string body = "<g id=\"g1\">" + path("a", "class=\"st1\"") + "</g>";
  for (const char* sheet :
       {".st{display:none}", "#A{display:none}", "rect{display:none}", "path > .st1{display:none}",
        "svg > path{display:none}", ".st1{opacity:0}", ".st1{fill-opacity:0;stroke:none}",
        "@media print { .st1 { display:none } }", "@media print{*{display:none}} .st1{fill:red}",
        "/* .st1{display:none} */", ".st1{display:none} #a{display:inline}",
        ".st1{display:none} .st1{display:block}",
        ".st1{display:inline !important} #a{display:none}",
        "@font-face{font-family:x} .st1{fill:none}", ".st1{display:none", ""})
    if (std::string(sheet) != ".st1{display:none") {
      SCOPED_TRACE(sheet);
      EXPECT_EQ(drawn(document("<style>" + std::string(sheet) + "</style>" + body)),
                (std::set<std::string>{"a"}));
    }
  EXPECT_EQ(drawn(document("<style media=\"print\">.st1{display:none}</style>" + body)).size(), 1u);
  EXPECT_EQ(drawn(document("<style>@media screen{.st1{display:none}}</style>" + body)).size(), 0u);
}

TEST(SvgStyle, TheCascadeDecides) {
  // Attribute, then sheet, then style attribute, then important.
  const auto shown = [](const std::string& sheet, const std::string& attributes) {
    return drawn(document("<defs><style>" + sheet + "</style></defs>" + path("a", attributes)))
        .size();
  };
  EXPECT_EQ(shown("", "display=\"none\""), 0u);
  EXPECT_EQ(shown("path{display:inline}", "display=\"none\""), 1u);
  EXPECT_EQ(shown("path{display:none}", "style=\"display:inline\""), 1u);
  EXPECT_EQ(shown("path{display:none!important}", "style=\"display:inline\""), 0u);
  EXPECT_EQ(shown("path{display:none!important}", "style=\"display:inline!important\""), 1u);
  // A group that is not displayed shows nothing of what is in it; one that is not visible may.
  EXPECT_EQ(
      drawn(document("<g style=\"display:none\">" + path("a", "style=\"display:inline\"") + "</g>"))
          .size(),
      0u);
  EXPECT_EQ(drawn(document("<g visibility=\"hidden\">" + path("a") +
                           path("b", "visibility=\"visible\"") + "</g>")),
            (std::set<std::string>{"b"}));
}

TEST(SvgStyle, ADrawingInUtf16IsTheSameWhateverItsHeadSays) {
  for (const char* encoding : {"UTF-8", "UTF-16", "ISO-8859-1"}) {
    const std::string text =
        "<?xml version=\"1.0\" encoding=\"" + std::string(encoding) + "\"?>\n" +
        drawing("<style>.x{display:none}</style>" + path("a") + path("b", "class=\"x\""));
    std::string little = "\xff\xfe", big = "\xfe\xff";
    for (const char c : text) little += {c, '\0'}, big += {'\0', c};
    for (const std::string& bytes : {little, big, little.substr(2)})
      EXPECT_EQ(drawn(parse_svg(bytes, "d.svg")), (std::set<std::string>{"a"})) << encoding;
  }
}

TEST(SvgStyle, TheDrawingItselfMayBeInvisible) {
  EXPECT_TRUE(document("<style>svg{visibility:hidden}</style>" + path("a")).shapes.empty());
  EXPECT_EQ(drawn(document("<style>svg{visibility:hidden} #b{visibility:visible}</style>" +
                           path("a") + path("b"))),
            (std::set<std::string>{"b"}));
}

TEST(SvgStyle, SelectorsThatAreNotReadAreNamed) {
  const SvgDocument d = document(
      "<style>@import url(more.css); path:not(.x){display:none} a + "
      "path{visibility:hidden} path:hover{fill:red}</style>" +
      path("a"));
  EXPECT_EQ(drawn(d).size(), 1u);
  EXPECT_TRUE(told(d, "path:not(.x)", "not applied"));
  EXPECT_TRUE(told(d, "a + path", "not applied"));
  EXPECT_TRUE(told(d, "@import", "not applied"));
  EXPECT_FALSE(told(d, "hover", "")) << "it hides nothing";
}

TEST(SvgStyle, MarkersComeFromTheSheetToo) {
  const SvgDocument d = document(
      "<style>.fold{marker-start:url(#cutonfoldFrom)} .both{marker:url(#grainlineTo)}</style>" +
      path("a", "class=\"fold\"") + path("b", "class=\"both\""));
  EXPECT_EQ(d.shapes.at(0).marker, "url(#cutonfoldFrom)");
  EXPECT_EQ(d.shapes.at(1).marker, "url(#grainlineTo)");
}

TEST(SvgStyle, DefinitionsAndSymbolsAreDrawnWhereTheyAreUsedOnly) {
  const std::string definitions =
      "<defs>" + path("d1") + "<g id=\"d2\">" + path("in2") + "</g><clipPath id=\"clip\">" +
      path("cut") + "</clipPath></defs>" + "<symbol id=\"s1\">" + path("in_s1") + "</symbol>";
  const SvgDocument none = document(definitions + path("a"));
  EXPECT_EQ(drawn(none), (std::set<std::string>{"a"}));
  EXPECT_TRUE(told(none, "\"d1\"", "definitions that nothing uses"));
  EXPECT_TRUE(told(none, "\"d2\" (1 shape)", "definitions that nothing uses"));
  EXPECT_TRUE(told(none, "\"s1\" (1 shape)", "symbols that nothing uses"));
  const SvgDocument used =
      document(definitions + "<use href=\"#d1\"/><use xlink:href=\"#s1\" x=\"100\"/>");
  EXPECT_EQ(drawn(used), (std::set<std::string>{"d1", "in_s1"}));
  EXPECT_EQ(used.shapes[1].runs[0].start, Vec2(100, 0));
  EXPECT_FALSE(told(used, "\"d1\"", "")) << used.unused[0];
  EXPECT_FALSE(told(used, "\"s1\"", ""));
  EXPECT_TRUE(
      told(document("<use id=\"u\" href=\"#gone\"/>"), "\"u\"", "which is not in the file"));
  EXPECT_TRUE(told(document("<use id=\"u\" href=\"other.svg#a\"/>"), "other.svg#a", "\"u\""));
  const SvgDocument hidden = document(definitions + "<use href=\"#d1\" style=\"display:none\"/>");
  EXPECT_TRUE(hidden.shapes.empty());
}

TEST(SvgStyle, ASymbolIsFittedIntoTheBoxOfItsUse) {
  // A viewBox of 20 × 10 in a box of 200 × 300: scale 10, moved to the middle of the height.
  const auto corner = [](const std::string& how) {
    const SvgDocument d =
        document("<symbol id=\"s\" viewBox=\"5 5 20 10\"" + how +
                 "><path id=\"p\" d=\"M5 5h20v10h-20z\"/></symbol><use href=\"#s\" x=\"40\" "
                 "y=\"30\" width=\"200\" height=\"300\"/>");
    return std::pair(d.shapes.at(0).runs[0].start, d.shapes.at(0).runs[0].segments[1].to);
  };
  const auto near = [](const Vec2& a, const Vec2& b) { EXPECT_NEAR((a - b).norm(), 0, 1e-9); };
  near(corner("").first, {40, 30 + 100});
  near(corner("").second, {240, 30 + 200});
  near(corner(" preserveAspectRatio=\"xMinYMin meet\"").first, {40, 30});
  near(corner(" preserveAspectRatio=\"xMaxYMax slice\"").first, {40 - 400, 30});
  near(corner(" preserveAspectRatio=\"none\"").second, {240, 330});
}

TEST(SvgStyle, ManyHiddenThingsOfOneReasonAreOneLine) {
  std::string body = "<style>.x{display:none}</style>";
  for (int i = 0; i < 40; ++i) body += path(fmt::format("p{}", i), "class=\"x\"");
  const SvgDocument d = document(body);
  ASSERT_EQ(d.unused.size(), 1u);
  EXPECT_TRUE(told(d, "\"p0\", \"p1\"", "and 28 more")) << d.unused[0];
}

}  // namespace
}  // namespace loosefit::io
