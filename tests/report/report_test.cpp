#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/report/html.h"
#include "loosefit/report/page_viewer.h"
#include "loosefit/report/sections.h"
#include "loosefit/report/write_report.h"
#include "support/scratch_folder.h"
#include "support/tube_garment.h"

namespace loosefit::report {
namespace {

class Report : public ::testing::Test {
 protected:
  void SetUp() override {
    result_.scenario = io::default_scenario();
    body::Body body = testing::cylinder_body(0.12, 1.0, 100, 20);
    body.measured = {{"chest", 0.754}, {"waist", 0.70}};
    result_.body.body = body;
    result_.body.asked = {{"chest", 0.75, 0.754}};
    const garment::Garment tube = testing::tube_garment(2 * kPi * 0.13, 0.4, 100, 40);
    result_.studied().hierarchy.levels = {tube};
    result_.studied().drape = testing::settled_drape(tube, [](const Vec2& uv) {
      const double a = uv.x() / 0.13;
      return Vec3(0.13 * std::cos(a), 0.13 * std::sin(a), 0.35 + uv.y());
    });
    result_.studied().drape.report.history = {
        {0.1, 0, 1, 2.0}, {0.5, 0, 9, 0.03}, {1.5, 1, 30, 1e-4}};
    result_.studied().pattern.fit = {{"chest", 0.0833}};
    result_.studied().pattern.girths = {{"chest", 0.8168}};
    result_.seconds = {{"body", 0.25}, {"settle", 1.5}};
    result_.studied().maps.worn =
        maps::relate(tube, result_.studied().drape.positions, result_.body.body);
    const fabric::Material cloth;
    for (maps::PerformanceMap& map :
         maps::compute_maps(tube, result_.studied().drape, result_.studied().maps.worn,
                            maps::default_map_names(), {.material = &cloth})) {
      pipeline::CaseMap entry;
      entry.overall = maps::statistics(map.values, result_.studied().maps.worn.areas);
      entry.regional = maps::regional_statistics(map.values, result_.studied().maps.worn.areas,
                                                 result_.studied().maps.worn.regions);
      entry.map = std::move(map);
      result_.studied().maps.maps.push_back(std::move(entry));
    }
    placement::Site site;
    site.name = "<left> scapula";
    site.panel = "tube";
    site.map_values["distance_mm"] = {10.25, 11.5};
    result_.sites = {site};
  }
  static int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++n;
    return n;
  }
  pipeline::CaseResult result_;
  const support::ScratchFolder dir_;
};

TEST_F(Report, LeadsWithYarnStrainAndShearAndSaysWhatPrincipalStrainIs) {
  const std::string html = map_section(result_);
  const auto last = html.rfind("<table"), end = html.rfind("</table");
  ASSERT_NE(last, std::string::npos);
  std::size_t before = last;
  for (const char* title : {"Strain along warp", "Strain along weft", "Trellis shear angle",
                            "Greatest principal strain", "Body-garment distance"}) {
    const auto at = html.find(title, last);
    EXPECT_GT(at, before) << title;
    EXPECT_LT(at, end) << title;
    before = at;
  }
  EXPECT_EQ(count(html, "mostly shear"), 1);
  result_.studied().maps.maps.resize(3);
  EXPECT_EQ(count(map_section(result_), "mostly shear"), 0) << "no principal strain, no sentence";
}

TEST_F(Report, IsOneSelfContainedPage) {
  const auto picture = dir_ / "distance-front.png";
  std::ofstream(picture, std::ios::binary) << "not really a picture";
  write_report(dir_, result_, CaseForms(result_), {{"distance", render::View::front, picture}});
  std::ifstream f(dir_ / "report.html");
  const std::string html{std::istreambuf_iterator<char>(f), {}};
  EXPECT_EQ(html.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_NE(html.find("data:image/png;base64," + base64("not really a picture")),
            std::string::npos);
  // What would fetch something; scripts stand in the page.
  for (const char* outside :
       {"<script src", "<link", "@import", "url(http", "src=\"http", "<iframe"})
    EXPECT_EQ(count(html, outside), 0) << outside;
  for (const char* tag : {"table", "div", "dl", "figure", "ul", "details", "svg", "tr"})
    EXPECT_EQ(count(html, std::string("<") + tag + ">") + count(html, std::string("<") + tag + " "),
              count(html, std::string("</") + tag + ">"))
        << tag;
}

/// The text of the element with this id, as JSON.
nlohmann::json embedded_json(const std::string& html, const std::string& id) {
  const std::size_t at = html.find("id=\"" + id + "\">");
  if (at == std::string::npos) return nullptr;
  const std::size_t from = html.find('>', at) + 1;
  return nlohmann::json::parse(html.substr(from, html.find("</script>", from) - from));
}

TEST_F(Report, CarriesTheCaseForItsViewer) {
  ASSERT_TRUE(has_viewer()) << "web/ was not built into this program";
  result_.sites[0].at = {0.1, 0.2};
  const std::string html = report_html(result_, {});
  const nlohmann::json data = embedded_json(html, "case");
  const nlohmann::json& scene = data["scene"];
  EXPECT_EQ(scene["garment"]["vertices"], result_.studied().mesh().vertex_count);
  EXPECT_EQ(scene["states"].size(), 1u);
  EXPECT_EQ(scene["states"][0]["maps"].size(), result_.studied().maps.maps.size());
  EXPECT_EQ(scene["maps"]["distance_mm"]["high"], 40);
  EXPECT_GT(scene["maps"]["distance_mm"]["meaning"].get<std::string>().size(), 20u);
  EXPECT_EQ(data["places"]["sites"][0]["name"], "<left> scapula");
  EXPECT_EQ(data["places"]["sites"][0]["at"][1], 0.2);
  // The tube is sewn to itself: its seam has a corner on either side.
  EXPECT_GT(scene["garment"]["vertex"]["count"], result_.studied().mesh().vertex_count);
  EXPECT_EQ(scene["garment"]["triangles"]["count"], 3 * result_.studied().mesh().triangles.size());
}

TEST_F(Report, NamesCannotEndTheScriptThatHoldsThem) {
  result_.sites[0].name = "</script><script>alert(1)//";
  result_.studied().pattern.pattern.name = "</SCRIPT><!--";
  const std::string html = report_html(result_, {});
  EXPECT_EQ(embedded_json(html, "case")["places"]["sites"][0]["name"], result_.sites[0].name);
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_EQ(html.find("</SCRIPT>"), std::string::npos);
}

TEST_F(Report, EveryDefinedWordHasItsDefinition) {
  result_.studied().maps.wrinkles[body::Region::mid_back] = {radians(-3), 0.9, radians(12)};
  const std::string html = report_html(result_, {});
  const std::string start = "href=\"#def-";
  int links = 0;
  for (std::size_t at = html.find(start); at != std::string::npos; at = html.find(start, at + 1)) {
    const std::size_t from = at + start.size();
    const std::string term = html.substr(from, html.find('"', from) - from);
    EXPECT_EQ(count(html, "<dt id=\"def-" + term + "\">"), 1) << term;
    ++links;
  }
  EXPECT_GT(links, 20);
}

TEST_F(Report, AnUnsettledDrapeSaysSoBeforeItIsShown) {
  EXPECT_LT(report_html(result_, {}).find("id=\"viewer\""),
            report_html(result_, {}).find("Certificate</h2>"));
  result_.studied().drape.certificate.residual = 0.2;
  const std::string html = report_html(result_, {});
  EXPECT_GT(html.find("id=\"viewer\""), html.find("Certificate</h2>"));
  EXPECT_NE(html.find("\"verdict bad\">Not settled"), std::string::npos);
}

TEST_F(Report, ShowsThePreviewOfAPictureWhereThereIsOne) {
  const std::string html =
      report_html(result_, {{"distance", render::View::front, dir_ / "none.png", "jpeg bytes"}});
  EXPECT_NE(html.find("data:image/jpeg;base64," + base64("jpeg bytes")), std::string::npos);
}

TEST_F(Report, ShowsTheNumbersOfTheResult) {
  const std::string html = report_html(result_, {});
  EXPECT_NE(html.find("Settled."), std::string::npos);
  EXPECT_NE(html.find(">10.2<"), std::string::npos);                    // site
  EXPECT_NE(html.find("<td>817</td><td>754</td>"), std::string::npos);  // garment and body girth
  EXPECT_NE(html.find("+8.33 %"), std::string::npos);
  EXPECT_NE(html.find("&lt;left&gt; scapula"), std::string::npos);
  EXPECT_NE(html.find("edge_length = 0.01"), std::string::npos);  // resolved scenario
  EXPECT_NE(html.find("<polyline"), std::string::npos);           // residual history
}

TEST_F(Report, ShowsThePressureByBothEstimates) {
  EXPECT_EQ(report_html(result_, {}).find("two estimates"), std::string::npos);  // none is known
  maps::PressureField& field = result_.studied().maps.pressure.field;
  field.contact = {500, 0};
  field.membrane = {450, 0};
  field.area = {0.01, 0.01};
  field.touching = {1, 0};
  result_.studied().maps.pressure.overall = maps::compare_pressures(field, {});
  result_.studied().maps.pressure.regional[body::Region::upper_back] =
      result_.studied().maps.pressure.overall;
  const std::string html = report_html(result_, {});
  EXPECT_NE(html.find("two estimates"), std::string::npos);
  // 1 dm² touches; 0.5 and 0.45 kPa; 5 and 4.5 N; they differ by 0.05 kPa; no correlation of one.
  EXPECT_NE(html.find("<td>1.00</td><td>0.500</td><td>0.450</td><td>5.00</td><td>4.50</td>"
                      "<td>0.050</td><td>–</td>"),
            std::string::npos);
  EXPECT_NE(html.find("upper back"), std::string::npos);
  EXPECT_NE(html.find("<td>50.0 %</td><td>0.0 %</td><td>50.0 %</td>"), std::string::npos);
}

TEST_F(Report, ShowsWhereTheFoldsRun) {
  EXPECT_EQ(report_html(result_, {}).find("Wrinkles"), std::string::npos);
  result_.studied().maps.wrinkles[body::Region::mid_back] = {radians(-3), 0.9, radians(12)};
  result_.studied().maps.wrinkles[body::Region::lower_back] = {radians(40), 0.05, radians(8)};
  const std::string html = report_html(result_, {});
  EXPECT_NE(html.find("mid back</th><td>12.0</td><td>\u22123</td><td>0.90</td>"),
            std::string::npos);
  // A direction that hardly any fold has is not shown.
  EXPECT_NE(html.find("lower back</th><td>8.0</td><td>–</td><td>0.05</td>"), std::string::npos);
}

TEST_F(Report, ShowsTheSpreadOverRepeats) {
  EXPECT_EQ(repeat_section(result_), "");
  result_.repeats.spread["maps.distance_mm.area_mean"] = {9.81, 0.44, 3};
  result_.repeats.spread["maps.strain_vertical.area_mean"] = {0.0123, 0.0021, 3};
  result_.repeats.spread["sites.<left> scapula.distance_mm"] = {10.31, 0.62, 3};
  const std::string html = report_html(result_, {}, nullptr);
  for (const char* text : {"9.8 ± 0.4", "1.23 ± 0.21", "10.3 ± 0.6", "of 3 drapes"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
}

TEST_F(Report, SealedDrapeGetsTheBannerAndNoNumbers) {
  result_.studied().drape.certificate.residual = 0.2;
  result_.studied().maps = {};
  result_.sites.clear();
  ASSERT_TRUE(result_.sealed());
  const std::string html = report_html(result_, {});
  EXPECT_NE(html.find("SEALED"), std::string::npos);
  EXPECT_NE(html.find("box bad"), std::string::npos);
  EXPECT_EQ(html.find("Sensor sites"), std::string::npos);
}

TEST_F(Report, EveryPostureTellsWhetherItHasSettled) {
  result_.wear.postures = {"standing", "forward-bend-15", "forward-bend-30"};
  result_.wear.donnings.resize(1);
  for (int posture : {1, 2}) {
    pipeline::CaseState& bent = result_.wear.states.emplace_back();
    bent.id.posture = posture;
    bent.name = result_.wear.postures[posture];
    bent.drapes = {result_.studied().drape};
    if (posture == 2) bent.drapes.front().certificate.residual = 0.01;
  }
  const std::string html = wear_section(result_);
  EXPECT_EQ(count(html, ">settled<"), 2);
  EXPECT_EQ(count(html, "not settled"), 2);  // one of them in the text
}

TEST_F(Report, UnsettledDrapeSaysWhy) {
  EXPECT_EQ(report_html(result_, {}).find("Why it did not settle"), std::string::npos);
  result_.studied().drape.certificate.residual = 0.2;
  drape::Unsettled u;
  u.why = "6 triangles cut the body: front the torso (6)";
  u.hint = "more <room>";
  u.worst.push_back({.vertex = 4711, .panel = "sleeve", .near = "left forearm", .net = 0.25});
  u.worst[0].force[3] = 1.75;
  u.cuts.push_back({.triangle = 815, .panel = "front", .with = "torso", .body = true});
  result_.studied().drape.unsettled = u;
  const std::string html = report_html(result_, {});
  for (const char* text :
       {"Why it did not settle", u.why.c_str(), "more &lt;room&gt;", "4711", "left forearm",
        "<td>0.25</td>", "<td>1.8</td>", "815", "the body: torso", "friction on the body [N]"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
}

TEST_F(Report, UnsettledMapsCarryAWarning) {
  result_.studied().drape.certificate.intersections_self = 2;
  const std::string html = report_html(result_, {});
  EXPECT_NE(html.find("NOT SETTLED"), std::string::npos);
  EXPECT_EQ(html.find("Settled.</strong>"), std::string::npos);
}

TEST_F(Report, MissingPictureOrFolderIsAnError) {
  EXPECT_THROW(report_html(result_, {{"distance", render::View::front, dir_ / "none.png"}}),
               IoError);
  EXPECT_THROW(write_report(dir_ / "none", result_, CaseForms(result_), {}), IoError);
}

TEST(Html, Base64MatchesRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Html, NumbersReadWell) {
  EXPECT_EQ(number(12.3456), "12.3");
  EXPECT_EQ(number(15234.6), "15235");
  EXPECT_EQ(number(-0.05), "\u22120.05");
  EXPECT_EQ(number(std::nan("")), "–");
  EXPECT_EQ(fixed(-0.0004, 2), "0.00");
  EXPECT_EQ(fixed(-1.25, 1), "\u22121.2");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(signed_number(3), "+3");
  EXPECT_EQ(signed_number(-3), "\u22123");
  EXPECT_EQ(escaped("<a href='x'>&"), "&lt;a href=&#39;x&#39;&gt;&amp;");
}

}  // namespace
}  // namespace loosefit::report
