#include "loosefit/kinds/trousers/trousers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

#include "loosefit/base/error.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/recognise.h"
#include "loosefit/kinds/trousers/trousers_draft.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"
#include "support/shirt_on_body.h"

namespace loosefit::kinds {
namespace {

/// Plausible people by measures alone.
std::vector<NamedValues> people() {
  return {{{"waist", 0.72},
           {"hip", 0.97},
           {"waist_level", 1.03},
           {"hip_level", 0.85},
           {"crotch_height", 0.79},
           {"thigh", 0.52},
           {"knee", 0.34},
           {"calf", 0.35},
           {"ankle", 0.19}},
          {{"waist", 0.86},
           {"hip", 1.02},
           {"waist_level", 1.10},
           {"hip_level", 0.92},
           {"crotch_height", 0.84}},
          {{"waist", 1.15},
           {"hip", 1.14},
           {"waist_level", 1.06},
           {"hip_level", 0.90},
           {"crotch_height", 0.78}},
          {{"waist", 0.58},
           {"hip", 0.70},
           {"waist_level", 0.82},
           {"hip_level", 0.70},
           {"crotch_height", 0.62}}};
}

DraftedGarment drafted(const GarmentKind& kind, const NamedValues& measures,
                       const NamedValues& fit = {}) {
  return kind.draft({measures, "", fit, {}});
}

double level(const GarmentKind& kind, const DraftedGarment& made, const std::string& name) {
  for (const FitLevel& l : kind.levels(made.pattern, made.measures, made.fit))
    if (l.name == name && l.body) return l.garment / *l.body - 1;
  return -99;
}

double length_of(const pattern::Pattern& p, const pattern::Stitch::Side& side) {
  return pattern::EdgePath(p.panels[side.panel], side.edge).length();
}

/// Length of an edge of a piece.
double length_of(const pattern::Pattern& p, const char* part, const char* edge) {
  const pattern::Panel& panel = p.panels[p.find_part(part)];
  return pattern::EdgePath(panel, pattern::find_edge_part(panel, edge)).length();
}

/// Height of the end of the crotch curve.
double crotch_end(const pattern::Pattern& p, const char* part) {
  const pattern::Panel& panel = p.panels[p.find_part(part)];
  const pattern::EdgePath inseam(panel, pattern::find_edge_part(panel, "inseam"));
  return std::max(inseam.at(0).y(), inseam.at(1).y());
}

body::BodyParameters stout_man() {
  body::BodyParameters p;
  p.sex = 1;
  p.age = 55;
  p.weight = 0.95;
  p.muscle = 0.3;
  return p;
}

/// Seams beside and inside the legs, front and back, may differ by 2 mm (trousers_seams.h), and no
/// piece crosses itself.
void expect_legs_close(const pattern::Pattern& p) {
  EXPECT_NO_THROW(pattern::check_pattern(p));
  for (const char* seam : {"inseam", "outseam"})
    EXPECT_NEAR(length_of(p, "back_L", seam), length_of(p, "front_L", seam), 0.002) << seam;
}

TEST(Trousers, HaveTheAskedGirthsAtEveryLevel) {
  for (const GarmentKind& kind : {trousers(), leggings()})
    for (const NamedValues& person : people()) {
      SCOPED_TRACE(kind.name);
      const NamedValues fit = {{"hip", 0.12},  {"thigh", 0.2}, {"knee", 0.3},
                               {"calf", 0.35}, {"hem", 0.8},   {"waistband", -0.1}};
      const DraftedGarment made = drafted(kind, person, fit);
      EXPECT_NEAR(level(kind, made, "waistband"), -0.1, 1e-9);
      EXPECT_NEAR(level(kind, made, "knee"), 0.3, 1e-6);
      EXPECT_NEAR(level(kind, made, "calf"), 0.35, 1e-6);
      EXPECT_NEAR(level(kind, made, "hem"), 0.8, 1e-6);
      EXPECT_NEAR(level(kind, made, "thigh"), 0.2, 1e-6);
      EXPECT_NEAR(level(kind, made, "hip"), 0.12, 1e-6);
    }
}

TEST(Trousers, SeamsAreAsLongAsEachOtherButForTheGatheredWaist) {
  for (const GarmentKind& kind : {trousers(), leggings()})
    for (const NamedValues& person : people()) {
      const DraftedGarment made = drafted(kind, person);
      const pattern::Pattern& p = made.pattern;
      const double gathered = (1 + made.fit.at("waist")) / (1 + made.fit.at("waistband"));
      ASSERT_EQ(p.stitches.size(), 12u);
      for (const pattern::Stitch& s : p.stitches) {
        SCOPED_TRACE(s.name);
        const double a = length_of(p, s.first), b = length_of(p, s.second);
        if (s.name.starts_with("waistband_front_") || s.name.starts_with("waistband_back_"))
          EXPECT_NEAR(a, gathered * b, 1e-7);  // equally before and behind
        else
          EXPECT_NEAR(a, b, 1e-7);
      }
    }
}

// The back reaches farther under the body, so its inseam is the longer one by itself.
TEST(Trousers, LegsOfFrontAndBackCanBeSewnTogetherForFitsAndCrotchWidths) {
  for (const GarmentKind& kind : {trousers(), leggings()})
    for (const NamedValues& person : people())
      for (const double width : {0.06, 0.12, 0.16, 0.20, 0.26})
        for (const double ease : {0.0, 0.05, 0.10, 0.15}) {
          SCOPED_TRACE(fmt::format("{} for hip {}: crotch_width {}, ease {}", kind.name,
                                   person.at("hip"), width, ease));
          const NamedValues fit = {{"crotch_width", width}, {"hip", ease},  {"thigh", ease},
                                   {"knee", ease},          {"calf", ease}, {"hem", ease}};
          const DraftedGarment made = drafted(kind, person, fit);
          expect_legs_close(made.pattern);
          EXPECT_NEAR(level(kind, made, "thigh"), ease, 1e-6);
          EXPECT_NEAR(level(kind, made, "knee"), ease, 1e-6);
          EXPECT_NEAR(crotch_end(made.pattern, "back_L"), crotch_end(made.pattern, "front_L"),
                      0.0201);
          // Only one key is asked for.
          expect_legs_close(drafted(kind, person, {{"crotch_width", width}}).pattern);
          expect_legs_close(drafted(kind, person, {{"thigh", ease}}).pattern);
          expect_legs_close(drafted(kind, person, {{"hip", ease}}).pattern);
        }
}

TEST(Trousers, LegsOfFrontAndBackCanBeSewnTogetherForWomanManChildAndStoutMan) {
  body::BodyParameters man;
  man.sex = 1;
  for (const body::BodyParameters& person :
       {support::adult_parameters(), man, support::slim_child_parameters(), stout_man()})
    for (const GarmentKind& kind : {trousers(), leggings()}) {
      const NamedValues measures = draft_measures(kind, support::standing(person, 40).measured);
      for (const NamedValues& fit :
           {NamedValues{}, NamedValues{{"thigh", 0}}, NamedValues{{"thigh", 0.15}},
            NamedValues{{"crotch_width", 0.26}}, NamedValues{{"hip", 0.3}, {"thigh", 0.1}},
            NamedValues{{"leg_length", 0.4}}}) {
        SCOPED_TRACE(kind.name);
        expect_legs_close(drafted(kind, measures, fit).pattern);
      }
    }
}

TEST(Trousers, DefaultsAreDraftedForEverybody) {
  std::mt19937 random(3);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * double(random() % 100001) / 1e5;
  };
  for (int i = 0; i < 300; ++i) {
    const double crotch = uniform(0.5, 1.0), hip = crotch * uniform(0.95, 1.9);
    NamedValues m = {{"hip", hip},
                     {"waist", hip * uniform(0.65, 1.15)},
                     {"crotch_height", crotch},
                     {"hip_level", crotch * uniform(1.05, 1.2)}};
    m["waist_level"] = m["hip_level"] + 0.05 + crotch * uniform(0.2, 0.3);
    if (i % 4) {
      m["thigh"] = hip * uniform(0.48, 0.64);
      m["knee"] = hip * uniform(0.29, 0.40);
      m["calf"] = hip * uniform(0.28, 0.40);
      m["ankle"] = std::max(0.09, hip * uniform(0.15, 0.24));
    }
    for (const GarmentKind& kind : {trousers(), leggings()}) {
      SCOPED_TRACE(fmt::format("{} for hip {}, crotch {}", kind.name, hip, crotch));
      ASSERT_NO_THROW(expect_legs_close(drafted(kind, m).pattern));
    }
  }
}

TEST(Trousers, ATightThighIsTakenInInFrontMoreThanBehind) {
  const DraftedGarment tight = drafted(trousers(), people()[0], {{"thigh", 0}});
  const double y = kThighLevel * 0.79;
  const auto width = [&](const char* part) {
    return width_at(tight.pattern.panels[tight.pattern.find_part(part)], y);
  };
  EXPECT_NEAR(width("front_L") + width("back_L"), 0.52, 1e-6);
  EXPECT_GT(width("back_L"), 1.2 * width("front_L"));
  EXPECT_GT(width("front_L"), 0.3 * 0.52 - 1e-9);
  // Half a centimetre to two, as tailors do.
  EXPECT_NEAR(crotch_end(tight.pattern, "front_L") - crotch_end(tight.pattern, "back_L"), 0.0125,
              0.0076);
}

TEST(Trousers, LegsThatCannotBeSewnTogetherAreRefusedByTheKeyThatWasAskedFor) {
  const auto refusal = [](const NamedValues& fit) -> std::pair<std::string, std::string> {
    try {
      drafted(trousers(), people()[0], fit);
    } catch (const InvalidInput& error) {
      return {error.place().key, error.what()};
    }
    return {"", "drafted"};
  };
  const auto advised = [](const std::string& said) {
    const std::size_t at = said.find("at most ");
    return at == std::string::npos ? -1 : std::stod(said.substr(at + 8));
  };
  for (const auto& [key, value] : {std::pair{"crotch_width", 0.26}, {"hip", 1.6}}) {
    NamedValues fit = {{key, value}};
    if (std::string(key) == "crotch_width") fit["leg_length"] = 0.5, fit["hip"] = 0.6;
    const auto [told, said] = refusal(fit);
    EXPECT_EQ(told, std::string("fit.") + key) << said;
    EXPECT_NE(said.find(fmt::format("found {:.4g}", value)), std::string::npos) << said;
    EXPECT_NE(said.find("seam of the back is"), std::string::npos) << said;
    fit[key] = advised(said);
    EXPECT_GT(fit[key], 0.1) << said;
    EXPECT_EQ(refusal(fit).second, "drafted");
  }
}

TEST(Trousers, WhatARefusalAdvisesIsDraftedAsItIsWritten) {
  int advised = 0;
  for (const GarmentKind& kind : {trousers(), leggings()})
    for (const NamedValues& person : people())
      for (const double hip : {0.9, 1.6})
        for (const double length : {0.5, 0.9})
          for (const double width : {0.16, 0.26}) {
            NamedValues fit = {{"hip", hip}, {"leg_length", length}, {"crotch_width", width}};
            SCOPED_TRACE(fmt::format("{} for hip {}: {}, {}, {}", kind.name, person.at("hip"), hip,
                                     length, width));
            try {
              drafted(kind, person, fit);
            } catch (const InvalidInput& error) {
              const std::string said = error.what();
              const std::size_t at = said.find("at most ");
              if (at == std::string::npos) continue;
              ++advised;
              fit[error.place().key.substr(4)] = std::stod(said.substr(at + 8));
              EXPECT_NO_THROW(drafted(kind, person, fit)) << said;
            }
          }
  EXPECT_GT(advised, 10);
}

TEST(Trousers, AWaistAsNarrowAsARefusalSaysIsDrafted) {
  for (const NamedValues& person : people())
    for (const double hip : {0.05, 0.08, 0.12, 0.17}) {
      NamedValues fit = {{"hip", hip}, {"waist", -0.34}};
      try {
        drafted(trousers(), person, fit);
        ADD_FAILURE() << "a waist of −34 %";
      } catch (const InvalidInput& error) {
        const std::string said = error.what();
        ASSERT_NE(said.find("at least "), std::string::npos) << said;
        const double least = std::stod(said.substr(said.find("at least ") + 9));
        fit["waist"] = least;
        EXPECT_NO_THROW(drafted(trousers(), person, fit)) << said;
        // Nor does it give way farther than that.
        fit["waist"] = -0.34;
        EXPECT_EQ(trousers().draft({person, "", fit, {"fit.waist"}}).fit.at("waist"), least);
      }
    }
}

TEST(Trousers, TheSeamsTakeInAsMuchAboveTheHipAsTheDocumentSays) {
  const DraftedGarment made = drafted(trousers(), people()[0]);
  const auto intake = [&](const char* part) {
    const pattern::Panel& piece = made.pattern.panels[made.pattern.find_part(part)];
    return width_at(piece, 0.85) - length_of(made.pattern, part, "waist");
  };
  EXPECT_NEAR(intake("front_L"), 0.034, 1e-4);
  std::ifstream file(std::string(LOOSEFIT_SOURCE_DIR) + "/docs/garments.md");
  std::stringstream text;
  text << file.rdbuf();
  std::string document = text.str();
  std::replace(document.begin(), document.end(), '\n', ' ');
  const std::string words = fmt::format("up to {:.0f} mm of each front and {:.0f} mm of each back",
                                        1000 * intake("front_L"), 1000 * intake("back_L"));
  EXPECT_NE(document.find(words), std::string::npos) << words;
}

TEST(Trousers, TheCrotchSeamIsSmoothWhereTheFourPiecesMeet) {
  const pattern::Pattern p = drafted(trousers(), people()[0]).pattern;
  for (const pattern::Panel& panel : p.panels) {
    const int e = pattern::find_edge_part(panel, "centre");
    if (e < 0) continue;
    const pattern::EdgePath centre(panel, e);
    const bool from_waist = centre.at(0).y() > centre.at(1).y();
    const Vec2 tip = centre.at(from_waist ? 1 : 0), near = centre.at(from_waist ? 0.999 : 0.001);
    EXPECT_NEAR((near - tip).normalized().y(), 0, 0.02) << panel.name;
  }
}

TEST(Trousers, AskedWaistThatNoSeamCanTakeInIsRefusedOrGivesWay) {
  const GarmentKind kind = trousers();
  const NamedValues fit = {{"waist", -0.1}};
  try {
    kind.draft({people()[0], "", fit, {}});
    FAIL() << "a waist of −10 % above this hip";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "fit.waist");
  }
  const DraftedGarment wide = kind.draft({people()[0], "", fit, {"fit.waist"}});
  // Half of hip 1.08 × 0.97, less 34 mm of each front, which has 48 % of it.
  const double least = (1.08 * 0.97 - 2 * 0.034 / 0.48) / 0.72 - 1;
  const double told = wide.fit.at("waist");  // in thousandths
  EXPECT_GE(told, least);
  EXPECT_LT(told, least + 0.001);
  EXPECT_NEAR(level(kind, wide, "waist"), told, 1e-9);
  ASSERT_EQ(wide.notes.size(), 1u);
  EXPECT_EQ(wide.notes[0].rfind(fmt::format("fit.waist: {:.3g} instead of -0.1, ", told), 0), 0u)
      << wide.notes[0];
  const auto refused = [&](const NamedValues& measures, const std::string& size) {
    try {
      kind.draft({measures, size, {}, {}});
    } catch (const InvalidInput& error) {
      return error.place().key;
    }
    return std::string("drafted");
  };
  NamedValues impossible = people()[0];
  impossible["waist_level"] = 0.80;
  EXPECT_EQ(refused(impossible, ""), "measures.waist_level");
  EXPECT_EQ(refused(people()[0], "women-38"), "size");
}

TEST(Trousers, ShortOnesEndAboveTheKnee) {
  const GarmentKind kind = trousers();
  const DraftedGarment shorts = drafted(kind, people()[0], {{"leg_length", 0.3}});
  double low = 1e9;
  for (const pattern::Panel& panel : shorts.pattern.panels)
    if (!panel.part.starts_with("waistband"))
      for (const Vec2& v : panel.vertices) low = std::min(low, v.y());
  EXPECT_NEAR(low, 0.7 * 0.79, 1e-9);
  EXPECT_NEAR(level(kind, shorts, "hem"), 0.9, 1e-6);
}

TEST(Trousers, AreKnownAgainByTheirSeams) {
  for (const GarmentKind& kind : {trousers(), leggings()})
    for (const double band : {0.035, 0.0}) {
      pattern::Pattern p = drafted(kind, people()[1], {{"waistband_width", band}}).pattern;
      const std::vector<pattern::Panel> before = p.panels;
      for (pattern::Panel& panel : p.panels) {
        panel.name = "piece_" + panel.name.substr(0, 1) + std::to_string(panel.vertices.size());
        panel.part.clear();
        for (pattern::PanelEdge& edge : panel.edges) edge.part.clear();
      }
      ASSERT_TRUE(kind.note_parts(p));
      for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(p.panels[i].part, before[i].part);
    }
}

TEST(Trousers, AreLaidRoundEverybodyWithoutCuttingThemselves) {
  body::BodyParameters man;
  man.sex = 1;
  for (const body::BodyParameters& person :
       {support::adult_parameters(), man, support::slim_child_parameters(), stout_man()})
    for (const double edge : {0.02, 0.03}) {
      const body::Body body = support::standing(person, 40);
      const GarmentKind kind = trousers();
      const garment::Garment made = garment::assemble(
          drafted(kind, draft_measures(kind, body.measured)).pattern, edge, fabric::Material{});
      const auto x = dress::lay_round(made, body, kind.lay);
      EXPECT_TRUE(geometry::self_intersections(x, made.triangles).empty());
      for (const Triangle& t : made.triangles)
        EXPECT_GT(geometry::triangle_normal(x[t[0]], x[t[1]], x[t[2]]).norm(), 0);
      // The hem of the left leg lies round the left leg, its front before its back, below the
      // knee; the waist above the hip.
      const auto middle = [&](const char* part, const char* seam) {
        const auto* chain = made.find_part(part, seam);
        Vec3 sum = Vec3::Zero();
        for (const int v : chain->vertices) sum += x[v];
        return Vec3(sum / static_cast<double>(chain->vertices.size()));
      };
      const Vec3 front = middle("front_L", "hem"), back = middle("back_L", "hem");
      EXPECT_GT(front.x(), 0.03);
      EXPECT_LT(middle("front_R", "hem").x(), -0.03);
      EXPECT_LT(front.y(), back.y() - 0.02);
      EXPECT_LT(front.z(), 0.3 * body.measured.at("crotch_height"));
      EXPECT_GT(middle("front_L", "waist").z(), body.measured.at("hip_level"));
    }
}

}  // namespace
}  // namespace loosefit::kinds
