#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/io/garmentcode_frame.h"
#include "loosefit/io/garmentcode_read.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "loosefit/kinds/shirt/shirt_levels.h"
#include "loosefit/pattern/outline.h"
#include "support/fuzz_cases.h"
#include "support/fuzz_tally.h"
#include "support/shirt_kind.h"
#include "support/sound_pieces.h"

namespace loosefit::io {
namespace {

const std::string kData = std::string(LOOSEFIT_SOURCE_DIR) + "/tests/data/patterns/";

Vec3 placed(const pattern::Panel& p, const Vec2& x) {
  return p.rotation * Vec3(x.x(), x.y(), 0) + p.translation;
}

std::string text_of(const std::string& file) {
  std::ifstream in(kData + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

pattern::Pattern read(const std::string& file) { return read_garmentcode(kData + file).pattern; }

TEST(GarmentCode, DraftedShirtSurvivesTheRoundTrip) {
  kinds::ShirtFit fit;
  fit.waist = 0.1;
  const pattern::Pattern shirt = kinds::draft_shirt({}, fit);
  const std::string text = garmentcode_text(shirt);
  const PatternFile again = parse_garmentcode(text, "shirt.json");
  EXPECT_TRUE(again.warnings.empty());
  const pattern::Pattern& back = again.pattern;
  ASSERT_EQ(back.panels.size(), shirt.panels.size());
  ASSERT_EQ(back.stitches.size(), 12u) << "twelve seams stay twelve";
  EXPECT_EQ(back.panel_order, shirt.panel_order);
  for (std::size_t p = 0; p < shirt.panels.size(); ++p) {
    const pattern::Panel &a = shirt.panels[p], &b = back.panels[p];
    SCOPED_TRACE(a.name);
    EXPECT_EQ(b.name, a.name);
    EXPECT_EQ(b.label, a.label);
    EXPECT_LT((b.translation - a.translation).norm(), 1e-10);
    EXPECT_LT((b.rotation - a.rotation).norm(), 1e-9);
    ASSERT_EQ(b.edges.size(), a.edges.size());
    for (std::size_t e = 0; e < a.edges.size(); ++e) {
      EXPECT_EQ(b.edges[e].name, a.edges[e].name);
      const pattern::EdgePath before(a, static_cast<int>(e)), after(b, static_cast<int>(e));
      EXPECT_NEAR(after.length(), before.length(), 1e-10);
      for (const double f : {0., .13, .5, .77, 1.})
        EXPECT_LT((after.at(f) - before.at(f)).norm(), 1e-10);
    }
  }
  for (std::size_t s = 0; s < 12; ++s) {
    EXPECT_EQ(back.stitches[s].name, shirt.stitches[s].name);
    EXPECT_EQ(back.stitches[s].first.edge, shirt.stitches[s].first.edge);
    EXPECT_EQ(back.stitches[s].second.edge, shirt.stitches[s].second.edge);
  }
  // Rounding in the last bit may move the mesher to another, equally good mesh.
  EXPECT_NEAR(garment::assemble(back, .02, {}).area, garment::assemble(shirt, .02, {}).area, 1e-9);
}

TEST(GarmentCode, ExampleFilesAreTheSizesTheyAreNamedAfter) {
  for (const std::string name : {"women-38", "child-142"}) {
    SCOPED_TRACE(name);
    const PatternFile file =
        read_garmentcode(std::string(LOOSEFIT_SOURCE_DIR) +
                         "/examples/patterns/long-sleeve-shirt-" + name + ".json");
    EXPECT_TRUE(file.warnings.empty());
    EXPECT_EQ(file.pattern.stitches.size(), 12u);
    const support::ShirtSize size = support::shirt_size(name);
    const auto read = kinds::shirt_girths(file.pattern, size.body.hps_to_waist);
    const auto drafted =
        kinds::shirt_girths(kinds::draft_shirt(size.body, size.fit), size.body.hps_to_waist);
    ASSERT_EQ(read.size(), drafted.size());
    for (const auto& [level, girth] : drafted) EXPECT_NEAR(read.at(level), girth, 1e-9) << level;
  }
}

TEST(GarmentCode, OtherToolsSeeOneCurveAnEdgeAndEqualStitches) {
  // Without our extra names every file edge is its own seam unit, as other programs read it.
  std::string text = garmentcode_text(kinds::draft_shirt({}));
  for (std::size_t at; (at = text.find(",\"name\":\"")) != std::string::npos;)
    text.erase(at, text.find('"', at + 9) + 1 - at);
  const pattern::Pattern plain = parse_garmentcode(text, "plain.json").pattern;
  // Sides, shoulders and sleeve tops are one curve each, underarm and armhole seams three.
  EXPECT_EQ(plain.stitches.size(), 2u + 2u + 2u + 2u * 3u + 4u * 3u);
  for (const pattern::Stitch& s : plain.stitches) {
    const double a = pattern::EdgePath(plain.panels[s.first.panel], s.first.edge).length();
    const double b = pattern::EdgePath(plain.panels[s.second.panel], s.second.edge).length();
    EXPECT_NEAR(a, b, 1e-6);
  }
  for (const pattern::Panel& panel : plain.panels)
    for (const pattern::PanelEdge& edge : panel.edges) EXPECT_EQ(edge.curves.size(), 1u);
  const garment::Garment g = garment::assemble(plain, .02, {});
  EXPECT_NEAR(g.area, .820, .002);
}

TEST(GarmentCode, EveryCurveTypeHasItsLength) {
  const pattern::Pattern p = read("curves.json");
  const pattern::Panel& panel = p.panels[0];
  const auto length = [&](const char* name) {
    return pattern::EdgePath(panel, pattern::find_edge(panel, name)).length();
  };
  // Chord 20 cm, control point at (.5, -.5): a parabola of closed-form length.
  const double parabola = .1 * (std::sqrt(2) + std::asinh(1));
  EXPECT_NEAR(length("edge_0"), parabola, 1e-9) << "quadratic, old list form";
  EXPECT_NEAR(length("edge_1"), parabola, 1e-9) << "quadratic, dictionary";
  EXPECT_NEAR(length("edge_2"), kPi * .1, 1e-9) << "half circle";
  EXPECT_NEAR(length("edge_4"), .2, 1e-12) << "cubic whose control points lie on the chord";
  EXPECT_NEAR(length("edge_3"), 2.0 / 3 * kPi * .2 / std::sqrt(3.0), 1e-9) << "120 degree arc";
  // All bulge outwards except edge_3, which is an arc with the other sweep.
  EXPECT_LT(pattern::EdgePath(panel, 0).at(.5).y(), -.04);
  EXPECT_GT(pattern::EdgePath(panel, 2).at(.5).x(), .4);
}

TEST(GarmentCode, AbsoluteCoordinatesEqualRelativeOnes) {
  const pattern::Pattern relative = read("quadratic_relative.json"),
                         absolute = read("quadratic_absolute.json");
  for (int e = 0; e < 4; ++e)
    for (const double f : {.2, .5, .9})
      EXPECT_LT((pattern::EdgePath(relative.panels[0], e).at(f) -
                 pattern::EdgePath(absolute.panels[0], e).at(f))
                    .norm(),
                1e-12);
}

TEST(GarmentCode, UnitsOf300InAMetreGiveTheSameSize) {
  const pattern::Pattern cm = read("tube_cm.json"), third = read("tube_300.json");
  ASSERT_EQ(cm.panels.size(), third.panels.size());
  for (std::size_t p = 0; p < cm.panels.size(); ++p) {
    for (std::size_t v = 0; v < cm.panels[p].vertices.size(); ++v)
      EXPECT_LT((cm.panels[p].vertices[v] - third.panels[p].vertices[v]).norm(), 1e-12);
    EXPECT_LT((cm.panels[p].translation - third.panels[p].translation).norm(), 1e-12);
  }
  EXPECT_NEAR(2 * cm.panels[0].vertices[1].x(), .46, 1e-12);
}

TEST(GarmentCode, ClockwiseBackPanelKeepsPlaceAndOutside) {
  const pattern::Pattern p = read("tube_cm.json");
  ASSERT_EQ(p.panels[1].name, "back");
  for (const pattern::Panel& panel : p.panels) {
    EXPECT_GT(pattern::signed_area(pattern::outline_polygon(panel)), 0);
    EXPECT_NEAR(panel.rotation.determinant(), 1, 1e-12);
  }
  // Front outside faces -y (forwards), back outside +y; both seams close without crossing.
  EXPECT_NEAR(p.panels[0].rotation.col(2).y(), -1, 1e-12);
  EXPECT_NEAR(p.panels[1].rotation.col(2).y(), 1, 1e-12);
  for (const pattern::Stitch& s : p.stitches) {
    const pattern::EdgePath a(p.panels[s.first.panel], s.first.edge),
        b(p.panels[s.second.panel], s.second.edge);
    const Vec3 a0 = placed(p.panels[s.first.panel], a.at(0)),
               b1 = placed(p.panels[s.second.panel], b.at(1));
    EXPECT_NEAR((a0 - b1).norm(), .45, 1e-9);  // only the gap between front and back
    EXPECT_NEAR(a0.x(), b1.x(), 1e-9);
    EXPECT_NEAR(a0.z(), b1.z(), 1e-9);
  }
  const garment::Garment g = garment::assemble(p, .02, {});
  EXPECT_EQ(g.find_chain("front", "edge_1")->vertices.size(), 16u);
}

TEST(GarmentCode, FrameTurnsYUpIntoZUp) {
  EXPECT_EQ(frame_from_y_up() * Vec3(1, 2, 3), Vec3(1, -3, 2));
}

TEST(GarmentCode, RotationOrderIsRzRyRx) {
  // x axis about fixed x by 90° stays; then fixed y by 90° → −z; then fixed z leaves it.
  EXPECT_LT((rotation_from_euler_deg({90, 90, 0}) * Vec3(1, 0, 0) - Vec3(0, 0, -1)).norm(), 1e-12);
  EXPECT_LT((rotation_from_euler_deg({90, 90, 0}) * Vec3(0, 1, 0) - Vec3(1, 0, 0)).norm(), 1e-12);
  for (const Vec3& angles : {Vec3(10, 20, 30), Vec3(-170, -80, 95), Vec3(33, 90, 0),
                             Vec3(12, -90, 0), Vec3(0, 0, 0), Vec3(180, 0, 0), Vec3(0, 180, 0)}) {
    const Mat3 r = rotation_from_euler_deg(angles);
    EXPECT_LT((rotation_from_euler_deg(euler_deg_from_rotation(r)) - r).norm(), 1e-7) << angles;
  }
  const Vec3 back = euler_deg_from_rotation(rotation_from_euler_deg({10, 20, 30}));
  EXPECT_LT((back - Vec3(10, 20, 30)).norm(), 1e-9);
}

TEST(GarmentCode, ObliquePanelsLandWhereTheFileMeansThem) {
  const pattern::Pattern p = read("oblique.json");
  // Point (10, 0) cm turned by (0, 90, 45): first about y to (0, 0, −10), then z leaves it.
  const Vec3 file = frame_from_y_up().transpose() * placed(p.panels[0], {.10, 0});
  EXPECT_LT((file - Vec3(.05, 1.0, -.10)).norm(), 1e-12);
  // Point (0, 10): about y unchanged, then about z by 45° → (−7.07, 7.07, 0).
  const Vec3 other = frame_from_y_up().transpose() * placed(p.panels[0], {0, .10});
  EXPECT_LT((other - Vec3(.05 - .10 * std::sqrt(.5), 1.0 + .10 * std::sqrt(.5), 0)).norm(), 1e-12);
}

TEST(GarmentCode, RightWrongDartAndGatherAreRead) {
  const PatternFile file = read_garmentcode(kData + "lapel_dart_gather.json");
  const pattern::Pattern& p = file.pattern;
  ASSERT_EQ(p.stitches.size(), 3u);
  EXPECT_FALSE(p.stitches[0].right_wrong);
  EXPECT_EQ(p.stitches[0].first.panel, p.stitches[0].second.panel) << "dart";
  EXPECT_TRUE(p.stitches[1].right_wrong);
  const garment::Garment g = garment::assemble(p, .01, {});
  EXPECT_EQ(g.find_chain("body", "edge_4")->vertices, g.find_chain("lapel", "edge_2")->vertices);
  const pattern::Stitch& gather = p.stitches[2];
  const double a = pattern::EdgePath(p.panels[gather.first.panel], gather.first.edge).length();
  const double b = pattern::EdgePath(p.panels[gather.second.panel], gather.second.edge).length();
  EXPECT_NEAR(std::max(a, b) / std::min(a, b), 1.54, 1e-9);
  EXPECT_EQ(p.panel_order, (std::vector<int>{2, 0, 1})) << "as listed, the rest by position";
}

TEST(GarmentCode, LoopsMayCloseByPosition) {
  const pattern::Pattern p = read("repeated_vertex.json");
  EXPECT_EQ(p.panels[0].edges.size(), 4u);
  EXPECT_EQ(p.panels[0].vertices.size(), 4u);
  EXPECT_NEAR(pattern::signed_area(pattern::outline_polygon(p.panels[0])), .01, 1e-12);
}

TEST(GarmentCode, MissingKeysAreWarnings) {
  const PatternFile file = parse_garmentcode(
      R"({"pattern": {"panels": {"p": {"vertices": [[0,0],[10,0],[10,10]],
          "edges": [{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,0]}]}}}})",
      "bare.json");
  EXPECT_EQ(file.warnings.size(), 4u);  // properties, translation, rotation, stitches
  EXPECT_NEAR(file.pattern.panels[0].vertices[1].x(), .1, 1e-15);
}

TEST(GarmentCode, PanelOrderIsComputedWhenMissing) {
  // Top-middle points in the file frame: c at x 0, y 1.0; a at x 0.05 (equal), y 1.2; b at x 0.5.
  const pattern::Pattern p = parse_garmentcode(R"({"pattern": {"panels": {
      "a": {"vertices": [[0,0],[10,0],[10,20],[0,20]], "translation": [0,100,0], "rotation": [0,0,0],
            "edges": [{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,3]},{"endpoints":[3,0]}]},
      "b": {"vertices": [[0,0],[10,0],[10,20],[0,20]], "translation": [50,100,0], "rotation": [0,0,0],
            "edges": [{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,3]},{"endpoints":[3,0]}]},
      "c": {"vertices": [[0,0],[10,0],[10,20],[0,20]], "translation": [-5,80,0], "rotation": [0,0,0],
            "edges": [{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,3]},{"endpoints":[3,0]}]}},
      "stitches": []}, "properties": {"units_in_meter": 100, "curvature_coords": "relative"}})",
                                               "order.json")
                                 .pattern;
  EXPECT_EQ(p.panel_order, (std::vector<int>{2, 0, 1}));
}

std::string error_of(const std::string& text) {
  try {
    parse_garmentcode(text, "bad.json");
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "accepted";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(GarmentCode, ErrorsNameFileAndPath) {
  const std::string good = text_of("tube_cm.json");
  ASSERT_EQ(error_of(good), "accepted");
  EXPECT_EQ(error_of(replaced(good, "[23, 0]", "[23, \"x\"]")),
            "bad.json: pattern.panels.front.vertices[1][1]: found \"x\", expected a number");
  EXPECT_EQ(
      error_of(replaced(good, "\"endpoints\": [0, 1]", "\"endpoints\": [0, 99999999999999]")),
      "bad.json: pattern.panels.front.edges[0].endpoints[1]: found 99999999999999, expected an "
      "index of a vertex from 0 to 3");
  EXPECT_EQ(error_of(replaced(good, "\"panel\": \"back\"", "\"panel\": \"bakc\"")),
            "bad.json: pattern.stitches[0][1].panel: found \"bakc\", expected the name of a panel");
  EXPECT_EQ(
      error_of(replaced(good, "\"units_in_meter\": 100", "\"units_in_meter\": 0")),
      "bad.json: properties.units_in_meter: found 0, expected units in a metre, 0.001 to 1e6");
  EXPECT_NE(error_of(good.substr(0, good.size() / 2)).find("bad.json:"), std::string::npos);
  EXPECT_NE(error_of(replaced(good, "[23, 0]", "[1e9, 0]")).find("a number of at most"),
            std::string::npos);
  EXPECT_NE(error_of(replaced(good, "[23, 0]", "[1e999, 0]")).find("bad.json"), std::string::npos);
  EXPECT_NE(error_of(replaced(good, "[23, 0]", "[NaN, 0]")).find("bad.json:5: found"),
            std::string::npos)
      << error_of(replaced(good, "[23, 0]", "[NaN, 0]"));
  EXPECT_NE(error_of(replaced(good, "[23, 0]", "[0, 0]")).find("length 0 m"), std::string::npos)
      << error_of(replaced(good, "[23, 0]", "[0, 0]"));
  EXPECT_NE(
      error_of(replaced(good, "[23, 30], [0, 30]", "[0, 30], [23, 30]")).find("crosses itself"),
      std::string::npos);
  EXPECT_NE(error_of(replaced(good, "[23, 0]", "[9000, 0]"))
                .find("a piece of 90 m, expected at most 20 m"),
            std::string::npos);
  EXPECT_NE(error_of(replaced(good, "\"endpoints\": [2, 3]", "\"endpoints\": [3, 2]"))
                .find("panel front edge 1: found end at vertex 2"),
            std::string::npos);
  const std::string expected = ", expected GarmentCode JSON (NAME_specification.json)";
  EXPECT_EQ(error_of("[1, 2]"), "bad.json: found a JSON list" + expected);
  EXPECT_EQ(error_of("{}"), "bad.json: found a JSON object without keys" + expected);
  EXPECT_EQ(error_of("7"), "bad.json: found 7, expected an object");
}

TEST(GarmentCodeFuzz, NoMutilatedFileCrashesOrHangs) {
  std::string good = text_of("lapel_dart_gather.json");
  ASSERT_EQ(error_of(good), "accepted");
  unsigned state = 12345;
  const auto next = [&](std::size_t below) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % below;
  };
  const std::vector<std::string> shards = {
      "null", "[]",       "{}", "-1", "1e9", "1e308", "\"x\"", "true", "0", "99999999999999999999",
      "[[[[", "\xff\xfe", ",",  "}",  "NaN", "0.5",   "[0,0]"};
  const unsigned cases = fuzz_cases(2000);
  const std::string whole = pieces_text(parse_garmentcode(good, "good.json").pattern);
  FuzzTally tally("JSON of GarmentCode", cases);
  for (unsigned i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    std::string text = good;
    switch (next(4)) {
      case 0:
        text.resize(next(text.size()));
        break;
      case 1:
        text.insert(next(text.size()), shards[next(shards.size())]);
        break;
      case 2:
        text.erase(next(text.size() - 40), 1 + next(40));
        break;
      default: {  // replace a number
        std::size_t at = next(text.size());
        at = text.find_first_of("0123456789", at);
        if (at == std::string::npos) break;
        const std::size_t end = text.find_first_not_of("0123456789.", at);
        text.replace(at, end - at, shards[next(shards.size())]);
      }
    }
    tally.begin();
    try {
      const pattern::Pattern p = parse_garmentcode(text, "fuzz.json").pattern;
      EXPECT_EQ(wrong_pieces(p, kLargestPiece), "");
      garment::assemble(p, .03, {});
      tally.read(pieces_text(p) == whole);
    } catch (const InvalidInput&) {
      tally.refuse();
    }
  }
  tally.expect_real_damage(1.0 / 2);
}

TEST(GarmentCode, DeepNestingAndManyEdgesAreRefusedQuickly) {
  EXPECT_NE(error_of(std::string(1000000, '[')), "accepted");
  std::string many = R"({"pattern": {"panels": {"p": {"vertices": [[0,0],[1,0],[1,1]], "edges": [)";
  for (int i = 0; i < 10000; ++i) many += R"({"endpoints": [0, 1]},)";
  many += R"({"endpoints": [0, 1]}]}}}})";
  EXPECT_NE(error_of(many).find("an array of 2 to 500"), std::string::npos);
}

}  // namespace
}  // namespace loosefit::io
