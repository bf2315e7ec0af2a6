#include "loosefit/kinds/shirt/shirt_sizes.h"

#include <array>

#include "loosefit/kinds/shirt/shirt_values.h"

namespace loosefit::kinds {
namespace {

/// chest, waist, hip, neck base, upper arm, wrist, shoulder breadth, slope [deg], scye depth,
/// HPS to waist, HPS to hem, arm; girths and lengths in centimetres as size tables print them.
struct Row {
  const char* name;
  std::array<double, 12> cm;
  ShirtFit fit;
  const char* source;
};

constexpr const char* kWomen =
    "EU 38 = 88/72/96 (secondary copy of EN 13402-3); other sizes graded by the customary 4 cm "
    "step "
    "in girth; neck, arm and lengths are Aldrich-type values, recalled";
constexpr const char* kMen =
    "chest and waist: middle of the EN 13402-3 letter ranges; other sizes along the ANSUR II means "
    "(men) with neck base, shoulder and scye by judgement";
constexpr const char* kChild =
    "body: retail tables interpolated at 142 cm (chest 71, waist 61, hip 75), the rest a 140 cm "
    "child "
    "scaled; garment: finished long-sleeve shirt 140/146, chest 86, waist 84, hem 86, length 54, "
    "sleeve 49, upper arm 32, cuff 18 (recalled and judgement, within 3 cm)";

const ShirtFit kRegular = usual_shirt_fit();
// Finished girth / body girth − 1.
const ShirtFit kChildFit{.chest = 86.0 / 71 - 1,
                         .waist = 84.0 / 61 - 1,
                         .hip = 86.0 / 75 - 1,
                         .sleeve = 32.0 / 21.8 - 1,
                         .wrist = 18.0 / 14.7 - 1};

const std::array<Row, 10> kRows{{
    {"child-142", {71, 61, 75, 31.4, 21.8, 14.7, 33.9, 18, 12.2, 34.5, 54, 49}, kChildFit, kChild},
    {"women-36", {84, 68, 92, 35, 27.2, 15.5, 37.9, 20, 14.1, 42, 62.5, 58}, kRegular, kWomen},
    {"women-38", {88, 72, 96, 36, 28.4, 16, 38.5, 20, 14.5, 42.5, 63, 58.5}, kRegular, kWomen},
    {"women-40", {92, 76, 100, 37, 29.6, 16.5, 39.1, 20, 14.9, 43, 63.5, 58.8}, kRegular, kWomen},
    {"women-42", {96, 80, 104, 38, 30.9, 17, 39.7, 20, 15.3, 43.5, 64, 59.1}, kRegular, kWomen},
    {"women-44", {100, 84, 108, 39, 32.3, 17.5, 40.3, 20, 15.7, 44, 64.5, 59.4}, kRegular, kWomen},
    {"men-S", {90, 78, 92, 39.5, 28.5, 16.5, 43, 20, 15, 47.5, 70, 61}, kRegular, kMen},
    {"men-M", {98, 86, 97, 41, 31, 17.1, 44.5, 20, 15.7, 48.5, 71.5, 61.8}, kRegular, kMen},
    {"men-L", {106, 94, 102, 42.5, 33.3, 17.6, 46, 20, 16.4, 49.5, 73, 62.6}, kRegular, kMen},
    {"men-XL", {114, 102, 107, 44, 35.7, 18.2, 47.5, 20, 17.1, 50.5, 74.5, 63.4}, kRegular, kMen},
}};

ShirtMeasures body_of(const Row& row) {
  const std::array<double, 12>& v = row.cm;
  constexpr double kCm = 0.01;
  const ShirtMeasures known{.chest = v[0] * kCm,
                            .waist = v[1] * kCm,
                            .hip = v[2] * kCm,
                            .neck = v[3] * kCm,
                            .upper_arm = v[4] * kCm,
                            .wrist = v[5] * kCm,
                            .shoulder_breadth = v[6] * kCm,
                            .shoulder_slope = radians(v[7]),
                            .scye_depth = v[8] * kCm,
                            .hps_to_waist = v[9] * kCm,
                            .hps_to_hem = v[10] * kCm,
                            .arm_length = v[11] * kCm};
  return with_usual_measures(known);
}

}  // namespace

const std::vector<KindSize>& shirt_sizes() {
  static const std::vector<KindSize> kSizes = [] {
    std::vector<KindSize> sizes;
    for (const Row& row : kRows)
      sizes.push_back({row.name, named(body_of(row)), named(row.fit), row.source});
    return sizes;
  }();
  return kSizes;
}

}  // namespace loosefit::kinds
