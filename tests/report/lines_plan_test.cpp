#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "loosefit/io/scenario.h"
#include "loosefit/io/text_file.h"
#include "loosefit/report/run_into_folder.h"
#include "loosefit/report/write_lines.h"
#include "support/scratch_folder.h"

namespace loosefit::report {
namespace {

namespace fs = std::filesystem;

/// Length of all polylines of one class on the sheet [mm].
double length_of(const std::string& svg, const std::string& name) {
  const std::regex line("<polyline class=\"" + name + "\" points=\"([^\"]*)\"");
  double length = 0;
  for (std::sregex_iterator found(svg.begin(), svg.end(), line), end; found != end; ++found) {
    std::istringstream words((*found)[1]);
    std::vector<Vec2> points;
    for (std::string word; words >> word;) {
      const std::size_t comma = word.find(',');
      points.emplace_back(std::stod(word.substr(0, comma)), std::stod(word.substr(comma + 1)));
    }
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

TEST(LinesPlan, ShowsEveryLineAtItsLength) {
  const support::ScratchFolder folder;
  Progress silent;
  // A shirt as it is put on, without time to settle.
  run_into_folder(io::parse_scenario(
                      "[output]\npreset_sites = false\nmaps = [\"distance\"]\n"
                      "[[site]]\nname = \"over <the> chest\"\nfrom = \"ecg_L\"\nto = \"waist_R\"\n"
                      "course = \"least-strain\"\n"
                      "[simulation]\nedge_length = 0.05\ntime_budget = 0.1\n",
                      "case.toml"),
                  folder, {.allow_unsettled = true}, false, silent);
  const std::string svg = io::read_text_file((folder / kLinesPlan).string(), 10000000);
  const auto summary =
      nlohmann::json::parse(io::read_text_file((folder / "summary.json").string(), 100000000));
  const auto& line = summary["lines"]["over <the> chest"];
  EXPECT_NEAR(length_of(svg, "sensor-line"), 1e3 * line["length_cut_m"].get<double>(), 0.5);
  double others = 0;
  for (std::size_t r = 1; r < line["routes"].size(); ++r)
    others += 1e3 * line["routes"][r]["length_cut_m"].get<double>();
  EXPECT_NEAR(length_of(svg, "other-route"), others, 1.0);
  EXPECT_NE(svg.find("over &lt;the&gt; chest"), std::string::npos);
  EXPECT_EQ(svg.find("<the>"), std::string::npos);
  EXPECT_NE(svg.find("on the shortest way of"), std::string::npos);
  // The same way for cutters and, as cables, for scenarios.
  const std::string cables = io::read_text_file((folder / kLinesCables).string(), 1000000);
  const scenario::Scenario with_cables = io::parse_scenario(cables, "cables.toml");
  ASSERT_FALSE(with_cables.attachments.empty());
  double length = 0;
  for (const garment::Attachment& a : with_cables.attachments) {
    const std::vector<Vec2>& path = std::get<garment::Cable>(a.part).path;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1] - path[i]).norm();
  }
  EXPECT_NEAR(length, line["length_cut_m"].get<double>(), 1e-3);
  const std::string dxf = io::read_text_file((folder / kLinesDxf).string(), 100000000);
  EXPECT_NE(dxf.find("over <the> chest"), std::string::npos);
  // And on the page: a row that leads to it, its routes, the data of its way.
  const std::string page = io::read_text_file((folder / "report.html").string(), 100000000);
  EXPECT_NE(page.find("data-line=\"over &lt;the&gt; chest\""), std::string::npos);
  EXPECT_NE(page.find("shortest, not taken"), std::string::npos);
  const std::string sites = io::read_text_file((folder / "sites.csv").string(), 1000000);
  EXPECT_NE(sites.find(",line,"), std::string::npos);
  EXPECT_LE(line["routes"][0]["mean_strain"].get<double>(),
            line["shortest"]["mean_strain"].get<double>() + 0.01);
}

}  // namespace
}  // namespace loosefit::report
