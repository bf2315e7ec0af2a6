#include "loosefit/validate/air_gap_table.h"

#include <gtest/gtest.h>

#include <fstream>

#include "loosefit/base/error.h"
#include "loosefit/io/csv.h"
#include "loosefit/validate/air_gap_cells.h"
#include "support/scratch_folder.h"

namespace loosefit::validate {
namespace {

const char* const kHeader =
    "source,table,garment,fabric,fit,ease_chest_cm,ease_waist_cm,body,posture,region,gap_mm,"
    "gap_sd_mm,contact_pct,contact_sd_pct,g0_mm,averaging,donnings,read_by\n";

class AirGapTable : public ::testing::Test {
 protected:
  std::vector<AirGapRow> read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return read_air_gap_table(file_);
  }
  std::string complaint(const std::string& row) {
    try {
      read(kHeader + row);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  }
  const support::ScratchFolder scratch_;
  const std::filesystem::path file_ = scratch_ / "rows.csv";
};

TEST_F(AirGapTable, ReadsARowWithQuotesAndConvertsCentimetres) {
  const auto rows =
      read(std::string(kHeader) +
           "\"Somebody, a paper\",\"3, \"\"left\"\"\",long-sleeve-shirt,cotton-broad,loose,"
           "12,14.5,male height=1.80 chest=1.00 waist=0.86,standing,mid_back,21.5,3.2,"
           "12,4,1,mean,6,A. Reader\r\n\n");
  ASSERT_EQ(rows.size(), 1u);
  const AirGapRow& row = rows[0];
  EXPECT_EQ(row.line, 2);
  EXPECT_EQ(row.source, "Somebody, a paper");
  EXPECT_EQ(row.table, "3, \"left\"");
  EXPECT_DOUBLE_EQ(*row.ease_chest, 0.12);
  EXPECT_DOUBLE_EQ(*row.ease_waist, 0.145);
  EXPECT_DOUBLE_EQ(*row.gap, 21.5);
  EXPECT_DOUBLE_EQ(*row.contact_sd, 4);
  EXPECT_EQ(*row.donnings, 6);
  ASSERT_TRUE(row.person());
  EXPECT_EQ(row.person()->sex, "male");
  EXPECT_DOUBLE_EQ(row.person()->measures.at("chest"), 1.0);
  EXPECT_TRUE(row.is_gate());
  EXPECT_TRUE(read("\xEF\xBB\xBF" + std::string(kHeader)).empty()) << "a byte order mark";
}

TEST_F(AirGapTable, WithoutEaseOrPersonOrOurKindOfGarmentARowIsNoGate) {
  const auto is_gate = [&](const std::string& garment, const std::string& ease,
                           const std::string& body) {
    return read(kHeader +
                ("S,1," + garment + ",,," + ease + ",," + body + ",,chest,9,,,,,,,me\n"))[0]
        .is_gate();
  };
  const std::string man = "male height=1.80 chest=1.00";
  EXPECT_TRUE(is_gate("t-shirt", "10", man));
  EXPECT_FALSE(is_gate("t-shirt", "", man));
  EXPECT_FALSE(is_gate("t-shirt", "10", "manikin of an average man"));
  EXPECT_FALSE(is_gate("t-shirt", "10", "male height=1.80"));
  EXPECT_FALSE(is_gate("coverall", "10", man));
}

TEST_F(AirGapTable, ErrorsNameFileLineAndColumn) {
  const std::string at = file_.string() + ":2: ";
  EXPECT_EQ(complaint("S,1,t-shirt,,,,,,,chest,nine,,,,,,,me\n"),
            at + "gap_mm: found \"nine\", expected a number from 0 to 500, or nothing");
  EXPECT_EQ(complaint("S,1,t-shirt,,,,,,,chest,9,,120,,1,,,me\n"),
            at + "contact_pct: found \"120\", expected a number from 0 to 100, or nothing");
  EXPECT_EQ(complaint("S,1,t-shirt,,,,,,,chest,,,40,,,,,me\n"),
            at + "g0_mm: found nothing, expected the gap that the source calls contact");
  EXPECT_EQ(complaint("S,1,t-shirt,,,,,,,chest,,,,,,,,me\n"),
            at + "gap_mm: found neither gap nor contact, expected one of the two");
  EXPECT_EQ(complaint("S,1,t-shirt,,,,,,,belly,9,,,,,,,me\n"),
            at + "region: found \"belly\", expected a region of the body");
  EXPECT_EQ(complaint("S,1,t-shirt,,,,,,lying,chest,9,,,,,,,me\n"),
            at + "posture: found \"lying\", expected the name of a posture, or nothing");
  EXPECT_EQ(complaint("S,1,t-shirt,coton,,,,,,chest,9,,,,,,,me\n")
                .find(at + "fabric: found \"coton\", expected a material card, or nothing"),
            0u);
  // What begins as a person and is none would silently be no gate, or end a run half-way.
  EXPECT_EQ(complaint("S,1,t-shirt,,,10,,male height=1.80 chset=1.00,,chest,9,,,,,,,me\n")
                .find(at + "body: found \"chset=1.00\", expected a measure, as in height=1.80"),
            0u);
  for (const char* word : {"chest=100", "chest=1.0m", "chest=nan", "chest=-1", "chest="})
    EXPECT_EQ(complaint("S,1,t-shirt,,,10,,female " + std::string(word) + ",,chest,9,,,,,,,me\n"),
              at + "body: found \"" + word + "\", expected metres from 0.05 to 2.5, with a point");
  EXPECT_EQ(complaint("S,1,t-shirt,,,10,,male manikin of size=M,,chest,9,,,,,,,me\n"), "accepted");
  EXPECT_EQ(complaint("S,1,t-shirt,,,,,,,chest,9,,,,,,,\n"),
            at + "read_by: found nothing, expected a text");
  EXPECT_NE(complaint("S,1,t-shirt\n").find(at + "garment: found 3 fields, expected 18"),
            std::string::npos)
      << complaint("S,1,t-shirt\n");
  EXPECT_NE(complaint("S,\"1,t-shirt\n").find(at + "table: found a quote that is not closed"),
            std::string::npos);
  EXPECT_THROW(read("source,table,garment\n"), InvalidInput);
  EXPECT_THROW(read(""), InvalidInput);
  EXPECT_THROW(read_air_gap_table(file_.string() + ".none"), IoError);
}

TEST_F(AirGapTable, TheOneOfTheRepositoryCanBeRead) {
  EXPECT_NO_THROW(read_air_gap_table(air_gap_table_path()));
  EXPECT_TRUE(read(kHeader).empty());
}

TEST(RegionsNamed, AreOneOrBothSides) {
  EXPECT_EQ(regions_named("mid_back"), std::vector{body::Region::mid_back});
  EXPECT_EQ(regions_named("scapula"),
            (std::vector{body::Region::scapula_left, body::Region::scapula_right}));
  EXPECT_EQ(regions_named("upper_arm"),
            (std::vector{body::Region::upper_arm_left, body::Region::upper_arm_right}));
  EXPECT_TRUE(regions_named("belly").empty());
}

TEST(JudgeCells, TellsOrderShareWithinTwoDeviationsAndBiasPerSource) {
  std::vector<AirGapCell> cells;
  for (const auto& [published, draped] :
       {std::pair(5.0, 8.0), {10.0, 13.0}, {20.0, 23.0}, {30.0, 33.0}, {35.0, 45.0}})
    cells.push_back({"P 1", "gap", "mm", published, 2, draped});
  cells.push_back({"P 1", "contact", "%", 40, 0, 30});
  const std::vector<Finding> found = judge_cells(cells, "mesh");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].what, "P 1, gap: rank correlation over the regions");
  EXPECT_NEAR(found[0].obtained, 1, 1e-12);
  EXPECT_NEAR(found[1].obtained, 0.8, 1e-12) << "the last one lies five deviations off";
  EXPECT_TRUE(found[1].pass());
  EXPECT_NEAR(found[2].obtained, 4.4, 1e-12);
  EXPECT_EQ(found[2].unit, "mm");
  EXPECT_NEAR(found[3].obtained, -10, 1e-12);
  std::swap(cells[0].draped, cells[4].draped);
  EXPECT_FALSE(judge_cells(cells, "")[0].pass()) << "another order";
}

}  // namespace
}  // namespace loosefit::validate
