#include "loosefit/io/measures_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/kinds/registry.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace {

kinds::NamedValues read_shirt_measures(const std::filesystem::path& path) {
  return read_measures(path, kinds::garment_kind("long-sleeve-shirt").measures);
}

class MeasuresFile : public testing::Test {
 protected:
  std::string error_of(const std::string& text) {
    write_text_file(path_.string(), text);
    try {
      read_shirt_measures(path_);
    } catch (const InvalidInput& e) {
      return std::string(e.what()).substr(path_.string().size());
    }
    return "accepted";
  }
  const support::ScratchFolder scratch_;
  const std::filesystem::path path_ = scratch_ / "measures.json";
};

const std::string kPlain =
    R"({"chest": 0.9, "waist": 0.7, "hip": 0.95, "neck": 0.36, "upper_arm": 0.28, "wrist": 0.16,
        "shoulder_breadth": 0.38, "shoulder_slope": 0.35, "scye_depth": 0.14,
        "hps_to_waist": 0.42, "hps_to_hip": 0.62, "arm_length": 0.58, "height": 1.7})";

TEST_F(MeasuresFile, ReadsPlainAndNestedObjects) {
  for (const std::string& text : {kPlain, "{\"measured\": " + kPlain + "}"}) {
    write_text_file(path_.string(), text);
    const kinds::NamedValues m = read_shirt_measures(path_);
    EXPECT_EQ(m.at("chest"), 0.9);
    EXPECT_EQ(m.at("upper_arm"), 0.28);
    EXPECT_EQ(m.at("shoulder_slope"), 0.35);
    EXPECT_EQ(m.at("hps_to_hem"), 0.62) << "hem at the hip unless given";
    EXPECT_EQ(m.count("elbow"), 0u);
  }
  write_text_file(path_.string(), R"({"elbow": 0.27, "hps_to_hem": 0.7, )" + kPlain.substr(1));
  EXPECT_EQ(read_shirt_measures(path_).at("elbow"), 0.27);
  EXPECT_EQ(read_shirt_measures(path_).count("forearm"), 0u) << "follows from the others";
  EXPECT_EQ(read_shirt_measures(path_).at("hps_to_hem"), 0.7);
}

TEST_F(MeasuresFile, IsReadFromEveryEditor) {
  std::string quoted = kPlain;
  quoted.replace(quoted.find("0.9,"), 4, "\"0,9\",");
  std::string utf16 = "\xff\xfe";
  for (const char c : kPlain) utf16 += {c, '\0'};
  for (const std::string& text : {quoted, utf16, "\xef\xbb\xbf" + kPlain}) {
    write_text_file(path_.string(), text);
    EXPECT_EQ(read_shirt_measures(path_).at("chest"), 0.9);
  }
}

TEST_F(MeasuresFile, NamesWhatIsWrong) {
  EXPECT_EQ(error_of(R"({"measured": {"waist": 1}})"),
            ": measured.chest: found nothing, expected this measure in metres");
  EXPECT_EQ(error_of(R"({"chest": "wide"})"),
            ": chest: found a value of type string, expected a number");
  EXPECT_EQ(error_of("chest"),
            ": found text that is not JSON, expected a JSON object with measures");
  // Every measure in its own unit.
  for (const auto& m : kinds::garment_kind("long-sleeve-shirt").measures) {
    if (!m.required) continue;
    std::string without = "{";
    for (const auto& other : kinds::garment_kind("long-sleeve-shirt").measures)
      if (other.name != m.name) without += "\"" + other.name + "\": 0.3, ";
    const std::string told = error_of(without + "\"x\": 0}");
    EXPECT_EQ(told, ": " + m.name + ": found nothing, expected this measure in " +
                        (m.unit == "rad" ? "radians" : "metres"));
  }
  // And what stands in another unit.
  const auto with = [](const std::string& name, double value) {
    std::string text = "{";
    for (const auto& m : kinds::garment_kind("long-sleeve-shirt").measures)
      if (m.required)
        text += "\"" + m.name +
                "\": " + std::to_string(m.name == name ? value : (m.low + m.high) / 2) + ", ";
    return text + "\"x\": 0}";
  };
  for (const auto& m : kinds::garment_kind("long-sleeve-shirt").measures) {
    if (!m.required) continue;
    SCOPED_TRACE(m.name);
    const double usual = (m.low + m.high) / 2;
    EXPECT_EQ(error_of(with(m.name, usual)), "accepted");
    EXPECT_EQ(error_of(with(m.name, m.high + 0.1 * (m.high - m.low))), "accepted")
        << "the body's own";
    for (const double times : {100.0, 1000.0})
      EXPECT_NE(error_of(with(m.name, times * usual)).find(m.name + ": found "), std::string::npos);
  }
  EXPECT_NE(error_of(with("shoulder_slope", 20)).find("found 20, expected this measure in radians"),
            std::string::npos);
  EXPECT_EQ(error_of("{\n\"waist\": 0.7,\n\"chest\": 0,95}"),
            ":3: found text that is not JSON, expected a JSON object with measures");
  EXPECT_EQ(error_of("<html>"), ": found a web page, expected a JSON object with measures");
  EXPECT_EQ(error_of("[garment]\n"), ": found a TOML file, expected a JSON object with measures");
  EXPECT_EQ(error_of(R"({"measured": 3})"),
            ": measured.chest: found nothing, expected this measure in metres");
  std::string deep = R"({"chest": )" + std::string(100000, '[') + std::string(100000, ']') + "}";
  EXPECT_EQ(error_of(deep), ": chest: found a value of type array, expected a number");
  EXPECT_THROW(read_shirt_measures("no/such/file.json"), IoError);
}

}  // namespace
}  // namespace loosefit::io
