#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"

// What a board is made of, in a site and in an attachment.
namespace loosefit::io {
namespace {

std::string in_site(const std::string& keys) {
  return "[[site]]\nname = \"imu\"\nlandmark = \"c7\"\nfootprint = { radius = 0.012 }\nboard = { " +
         keys + " }\n";
}
std::string in_attachment(std::string keys) {
  for (std::size_t at; (at = keys.find(", ")) != std::string::npos;) keys.replace(at, 2, "\n");
  return "[[attachment]]\nkind = \"board\"\nname = \"imu\"\npanel = \"back\"\nat = [0, 0]\n"
         "radius = 0.012\n" +
         keys + "\n";
}

garment::BoardMake make_of(const std::string& text) {
  const scenario::Scenario s = parse_scenario(text, "case.toml");
  return s.sites.empty() ? std::get<garment::Board>(s.attachments.at(0).part)
                         : static_cast<const garment::BoardMake&>(*s.sites[0].board);
}

TEST(BoardMake, IsRigidUnlessItSaysWhatItIsMadeOf) {
  for (const auto& put : {in_site, +[](const std::string& k) { return in_attachment(k); }}) {
    EXPECT_TRUE(make_of(put("mass = 0.01")).is_rigid());
    EXPECT_TRUE(make_of(put("mass = 0.01, thickness = 0.004, side = \"inside\"")).is_rigid());
    EXPECT_FALSE(make_of(put("bending = 0.001")).is_rigid());
    EXPECT_FALSE(make_of(put("membrane_factor = 3")).is_rigid());
    EXPECT_FALSE(make_of(put("material = \"fr4\", thickness = 0.001")).is_rigid());
  }
}

TEST(BoardMake, ComesBackFromTheWrittenScenario) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(0, 1);
  for (int k = 0; k < 24; ++k) {
    std::string keys = fmt::format("mass = {}, thickness = {}", 0.1 * u(rng), 0.01 * u(rng));
    if (u(rng) < 0.5) keys += ", side = \"inside\"";
    if (u(rng) < 0.3) keys += ", material = \"silicone\"";
    if (u(rng) < 0.3) keys += fmt::format(", bending = {}", u(rng));
    if (u(rng) < 0.3) keys += fmt::format(", membrane_factor = {}", 1 + u(rng));
    for (const std::string& text : {in_site(keys), in_attachment(keys)}) {
      const garment::BoardMake first = make_of(text);
      const scenario::Scenario written =
          parse_scenario(scenario_toml(parse_scenario(text, "case.toml")), "again.toml");
      const garment::BoardMake again = make_of(scenario_toml(written));
      EXPECT_EQ(again.mass, first.mass) << keys;
      EXPECT_EQ(again.thickness, first.thickness) << keys;
      EXPECT_EQ(again.side, first.side) << keys;
      EXPECT_EQ(again.material, first.material) << keys;
      EXPECT_EQ(again.bending, first.bending) << keys;
      EXPECT_EQ(again.membrane_factor, first.membrane_factor) << keys;
    }
  }
}

TEST(BoardMake, ASizeOfItsOwnIsTheFootprintWhereNoneIsGiven) {
  const std::string site = "[[site]]\nname = \"imu\"\nlandmark = \"c7\"\n";
  const auto read = [&](const std::string& keys) {
    return parse_scenario(scenario_toml(parse_scenario(site + keys, "case.toml")), "again.toml")
        .sites.at(0);
  };
  const placement::SiteSpec alone = read("board = { size = [0.04, 0.03] }\n");
  EXPECT_EQ(alone.board->size, Vec2(0.04, 0.03));
  EXPECT_EQ(alone.footprint.size, Vec2(0.04, 0.03));
  EXPECT_EQ(alone.footprint.kind, placement::FootprintShape::Kind::rectangle);
  const placement::SiteSpec both =
      read("footprint = { radius = 0.006 }\nboard = { size = [0.04, 0.03] }\n");
  EXPECT_EQ(both.board->size, Vec2(0.04, 0.03));
  EXPECT_EQ(both.footprint.radius, 0.006);
}

std::string refusal(const std::string& text) {
  try {
    parse_scenario(text, "case.toml");
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "accepted";
}

TEST(BoardMake, WrongOnesAreRefusedByTheirKey) {
  for (const auto& [keys, told] : std::vector<std::pair<std::string, std::string>>{
           {"material = \"wood\", thickness = 0.001", "material: found \"wood\", expected"},
           {"side = \"below\"", "side: found \"below\", expected"},
           {"thickness = 4", "thickness: found 4, expected metres from 0 to 0.1"},
           {"side = \"inside\", thickness = 0.02", "expected metres from 0 to 0.01"},
           {"bending = -1", "bending: found -1, expected N m from 0 to 10"}})
    for (const std::string& text : {in_site(keys), in_attachment(keys)})
      EXPECT_NE(refusal(text).find(told), std::string::npos) << refusal(text);
}

}  // namespace
}  // namespace loosefit::io
