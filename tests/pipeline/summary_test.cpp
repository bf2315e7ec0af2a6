#include "loosefit/pipeline/summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "loosefit/io/material_file.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/site_values.h"
#include "loosefit/pipeline/sites_csv.h"

namespace loosefit::pipeline {
namespace {

/// A result with one triangle of cloth and numbers that are easy to recognise.
CaseResult small_result() {
  CaseResult result;
  result.scenario = io::default_scenario();
  garment::Garment mesh;
  mesh.vertex_count = 3;
  mesh.triangles = {{0, 1, 2}};
  mesh.area = 0.25;
  mesh.mass = 0.03;
  result.studied().hierarchy.levels = {mesh};
  result.studied().drape.certificate = {5e-4, 2e-3, 0, 0, "converged"};
  body::Body body;
  body.measured = {{"chest", 0.88}, {"height", 1.68}};
  result.body.body = body;
  result.body.asked = {{"chest", 0.90, 0.88}};
  result.studied().pattern.fit = {{"chest", 0.1}};
  result.seconds = {{"body", 0.5}, {"settle", 2}};
  CaseMap map;
  map.map.array = "distance_mm";
  map.overall = {1, 2, 3, 4, 5, 2.5, 0.25, 7};
  map.regional[body::Region::mid_back] = {0, 0, 0.5, 0, 0, 0, 0, 0};
  map.overall.max = std::numeric_limits<double>::quiet_NaN();
  result.studied().maps.maps = {map};
  placement::Site site;
  site.name = "a, \"b\"";
  site.panel = "back";
  site.at = {0.1, -0.2};
  site.map_values["distance_mm"] = {6.5, 8};
  result.sites = {site};
  return result;
}

TEST(Summary, HasTheStableKeys) {
  const auto json = nlohmann::json::parse(summary_json(small_result()));
  EXPECT_EQ(json["settled"], true);
  EXPECT_EQ(json["sealed"], false);
  EXPECT_EQ(json["residual"], 5e-4);
  EXPECT_EQ(json["intersections"]["body"], 0);
  EXPECT_EQ(json["intersections"]["folded_edges"], 0);
  EXPECT_TRUE(json["stable"].is_null());
  EXPECT_EQ(json["vertices"], 3);
  EXPECT_EQ(json["triangles"], 1);
  EXPECT_EQ(json["seconds"]["settle"], 2.0);
  EXPECT_EQ(json["seconds"]["total"], 2.5);
  EXPECT_EQ(json["body"]["measured"]["chest"], 0.88);
  EXPECT_EQ(json["body"]["asked"]["chest"], 0.90);
  EXPECT_EQ(json["fit"]["measured"]["chest"], 0.1);
  EXPECT_EQ(json["garment"]["area_m2"], 0.25);
  EXPECT_EQ(json["garment"]["mass_kg"], 0.03);
  EXPECT_EQ(json["maps"]["distance_mm"]["area_mean"], 2.5);
  EXPECT_TRUE(json["maps"]["distance_mm"]["max"].is_null()) << "NaN has no place in JSON";
  EXPECT_EQ(json["maps"]["distance_mm"]["regions"]["mid_back"]["median"], 0.5);
  EXPECT_EQ(json["sites"]["a, \"b\""]["distance_mm"], 6.5);
  EXPECT_EQ(json["sites"]["a, \"b\""]["distance_mm_worst"], 8.0);
  EXPECT_TRUE(json["versions"].contains("loosefit"));
  EXPECT_EQ(json["scenario_sha256"].get<std::string>().size(), 64u);
}

TEST(Summary, PressureIsThereByBothEstimatesWhenTheForcesAreKnown) {
  CaseResult result = small_result();
  EXPECT_FALSE(nlohmann::json::parse(summary_json(result)).contains("pressure"));
  maps::PressureField& field = result.studied().maps.pressure.field;
  field.contact = {500, 500, 0};
  field.membrane = {450, 550, 0};
  field.area = {0.01, 0.01, 0.02};
  field.touching = {1, 1, 0};
  result.studied().maps.pressure.overall = maps::compare_pressures(field, {});
  result.studied().maps.pressure.regional[body::Region::chest] =
      result.studied().maps.pressure.overall;
  const auto json = nlohmann::json::parse(summary_json(result))["pressure"];
  EXPECT_DOUBLE_EQ(json["contact_area_m2"], 0.02);
  EXPECT_DOUBLE_EQ(json["mean_kPa"], 0.5);
  EXPECT_DOUBLE_EQ(json["mean_membrane_kPa"], 0.5);
  EXPECT_DOUBLE_EQ(json["normal_force_N"], 10);
  EXPECT_DOUBLE_EQ(json["normal_force_membrane_N"], 10);
  EXPECT_DOUBLE_EQ(json["rms_difference_kPa"], 0.05);
  EXPECT_TRUE(json["correlation"].is_null()) << "one of them does not vary";
  EXPECT_DOUBLE_EQ(json["area_share"]["none"], 0.5);
  EXPECT_DOUBLE_EQ(json["area_share"]["marginal"], 0.5);
  EXPECT_DOUBLE_EQ(json["regions"]["chest"]["mean_kPa"], 0.5);
}

TEST(Summary, WrinklesAndOtherDonningsHaveTheirFigures) {
  CaseResult result = small_result();
  EXPECT_FALSE(nlohmann::json::parse(summary_json(result)).contains("wrinkles"));
  result.studied().maps.wrinkles[body::Region::mid_back] = {radians(-30), 0.75, radians(12)};
  result.wear.postures = {"reference"};
  result.wear.donnings.resize(2);
  CaseState& again = result.wear.states.emplace_back();
  again.id.donning = 1;
  again.name = "reference";
  again.drapes.resize(1);
  again.drapes[0].certificate = result.certificate();
  again.maps.maps = result.studied().maps.maps;
  again.maps.maps[0].overall.area_mean = 4.5;
  again.maps.wrinkles[body::Region::lower_back] = {radians(88), 0.5, radians(6)};
  again.sites = result.sites;
  again.sites[0].map_values["distance_mm"] = {7.5, 9};
  const auto json = nlohmann::json::parse(summary_json(result));
  EXPECT_NEAR(json["wrinkles"]["mid_back"]["angle_deg"], -30, 1e-12);
  EXPECT_EQ(json["wrinkles"]["mid_back"]["coherence"], 0.75);
  EXPECT_NEAR(json["wrinkles"]["mid_back"]["slope_rms_deg"], 12, 1e-12);
  const auto& state = json["states"][0];
  EXPECT_EQ(state["donning"], 2);
  EXPECT_EQ(state["maps"]["distance_mm"]["area_mean"], 4.5);
  EXPECT_EQ(state["maps"]["distance_mm"]["regions"]["mid_back"]["median"], 0.5);
  EXPECT_NEAR(state["wrinkles"]["lower_back"]["angle_deg"], 88, 1e-12);
  EXPECT_EQ(state["sites"]["a, \"b\""]["distance_mm"], 7.5);
}

TEST(Summary, DigestFollowsTheScenarioOnly) {
  CaseResult a = small_result(), b = small_result();
  b.seconds.clear();
  const auto digest = [](const CaseResult& r) {
    return nlohmann::json::parse(summary_json(r))["scenario_sha256"].get<std::string>();
  };
  EXPECT_EQ(digest(a), digest(b));
  b.scenario.simulation.seed = 2;
  EXPECT_NE(digest(a), digest(b));
}

TEST(Summary, UnsettledWithoutMapsIsSealed) {
  CaseResult result = small_result();
  result.studied().maps = {};
  result.studied().drape.certificate.intersections_self = 1;
  const auto json = nlohmann::json::parse(summary_json(result));
  EXPECT_EQ(json["settled"], false);
  EXPECT_EQ(json["sealed"], true);
  EXPECT_FALSE(json["settle"].contains("unsettled"));
}

TEST(Summary, SaysWhyItIsUnsettled) {
  CaseResult result = small_result();
  drape::Unsettled u;
  u.why = "for a reason";
  u.worst.push_back({.vertex = 7, .panel = "front", .at = {0.1, 0.2}, .near = "torso", .net = 2});
  u.worst[0].force[3] = 3.5;
  u.cuts.push_back({.triangle = 9, .panel = "back", .with = "right upper arm", .body = true});
  result.studied().drape.unsettled = u;
  const auto json = nlohmann::json::parse(summary_json(result))["settle"]["unsettled"];
  EXPECT_EQ(json["why"], "for a reason");
  EXPECT_EQ(json["worst"][0]["vertex"], 7);
  EXPECT_EQ(json["worst"][0]["v_m"], 0.2);
  EXPECT_EQ(json["worst"][0]["near"], "torso");
  EXPECT_EQ(json["worst"][0]["net_N"], 2);
  EXPECT_EQ(json["worst"][0]["force_N"]["body contact"], 3.5);
  EXPECT_EQ(json["worst"][0]["force_N"]["gravity"], 0);
  EXPECT_EQ(json["cuts"][0]["triangle"], 9);
  EXPECT_EQ(json["cuts"][0]["cuts"], "body");
  EXPECT_EQ(json["cuts"][0]["with"], "right upper arm");
}

TEST(SitesCsv, NamesWithControlCharactersAreEscapedAndStayOnTheirLine) {
  CaseResult result = small_result();
  result.sites[0].name = "\x1b[2Jred\nline";
  result.sites[0].panel = "ba\rck, left";
  const std::string csv =
      sites_csv(result.sites, 0.014, {{"gone\x07", false, "the\tgarment ends"}});
  EXPECT_NE(csv.find("\n\\x1b[2Jred\\nline,chest,\"ba\\x0dck, left\","), std::string::npos) << csv;
  EXPECT_NE(csv.find("\ngone\\x07,"), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3) << "head and one line per site";
  for (const char control : {'\x1b', '\r', '\x07', '\t'})
    EXPECT_EQ(csv.find(control), std::string::npos) << int(control);
}

TEST(SitesCsv, QuotesAndKeepsColumnsAlike) {
  CaseResult result = small_result();
  result.sites.push_back({});
  result.sites[1].name = "plain";
  result.sites[0].angle = kPi / 2;
  result.sites[0].anatomy =
      placement::BodyAddress{placement::BodySegment::forearm, -1, {100, 50.04, 30.26}};
  const std::string csv = sites_csv(result.sites, 0.014);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "name,region,panel,u_m,v_m,x_m,y_m,z_m,angle_deg,body_segment,body_side,body_x_percent,"
            "body_y_percent,body_z_percent,footprint,distance_mm,distance_mm_worst,"
            "uncertainty.distance_mm,covered,why_not_covered");
  EXPECT_NE(csv.find("\"a, \"\"b\"\"\",chest,back,0.1,-0.2,0,0,0,90,forearm,right,100,50,30.3,disc "
                     "of 24 mm,6.5,8,0.51,yes,\n"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("plain,chest,,0,0,0,0,0,0,,,,,,disc of 24 mm,,,,yes,\n"), std::string::npos)
      << csv;
}

TEST(Summary, ClothIsNamedAfterItsConstants) {
  CaseResult result = small_result();
  result.scenario = io::parse_scenario("[material]\nthickness = 0.0004\n", "");
  const auto json = nlohmann::json::parse(summary_json(result))["material"];
  EXPECT_EQ(json["name"], "paper-cotton, changed: thickness");
  EXPECT_EQ(json["constants"]["thickness"]["value"], 0.0004);
  EXPECT_EQ(json["constants"]["thickness"]["unit"], "m");
  EXPECT_EQ(json["constants"]["thickness"]["from"], "scenario");
  EXPECT_EQ(json["constants"]["poisson"]["from"], "inherited from card paper-cotton");
  EXPECT_EQ(json["constants"].size(), io::material_keys().size());
}

TEST(SitesCsv, UncertaintyIsOfMeshAndDonnings) {
  CaseResult result = small_result();
  placement::Site& site = result.sites[0];
  site.samples = {{{"gap_mm", 2.0}}, {{"gap_mm", 4.0}}, {{"gap_mm", 6.0}}};
  const auto json = nlohmann::json::parse(summary_json(result))["sites"][site.name]["uncertainty"];
  EXPECT_NEAR(json["gap_mm"]["donnings"], 2, 1e-12);
  EXPECT_TRUE(json["gap_mm"]["mesh"].is_number());
  const std::map<std::string, Uncertainty> known = site_uncertainty(site, 0.014);
  EXPECT_NEAR(known.at("gap_mm").whole(), std::hypot(2, known.at("gap_mm").mesh.value()), 1e-12);
  EXPECT_FALSE(known.at("distance_mm").donnings.has_value());
  EXPECT_FALSE(site_uncertainty(site, 0.05).contains("distance_mm")) << "no such mesh was measured";
}

TEST(Summary, UncoveredSitesAreTold) {
  CaseResult result = small_result();
  result.sites[0].not_covering = "the cloth hangs 200 mm off the skin there";
  result.uncovered_sites = {{"wrist_L", true, "far"}, {"mine", false, "the garment ends"}};
  const auto json = nlohmann::json::parse(summary_json(result));
  EXPECT_EQ(json["sites"]["a, \"b\""]["covered"], false);
  EXPECT_EQ(json["uncovered_sites"]["mine"]["why"], "the garment ends");
  EXPECT_EQ(json["uncovered_sites"]["wrist_L"]["preset"], true);
  const std::string csv = sites_csv(result.sites, 0.014, result.uncovered_sites);
  EXPECT_NE(csv.find(",covered,why_not_covered\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",no,the cloth hangs 200 mm off the skin there\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nmine,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",no,the garment ends\n"), std::string::npos) << csv;
  EXPECT_EQ(csv.find("wrist_L"), std::string::npos) << "presets are many";
}

}  // namespace
}  // namespace loosefit::pipeline
