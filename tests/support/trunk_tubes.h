#pragma once
#include <fmt/format.h>

#include <string>

namespace loosefit::support {

/// GarmentCode file of two equal panels sewn to a tube round the trunk: half girths at the top and
/// at the bottom, height, and where the lower edge is placed above the floor, all in cm.
inline std::string tube_file(double top, double bottom, double height, double above_floor) {
  const auto panel = [&](const char* name, int z, const char* corners) {
    return fmt::format(
        "\"{}\": {{\"vertices\": [[{},0],[{},0],[{},{}],[{},{}]], \"edges\": {}, "
        "\"translation\": [0,{},{}], \"rotation\": [0,0,0]}}",
        name, -bottom / 2, bottom / 2, top / 2, height, -top / 2, height, corners, above_floor, z);
  };
  const std::string there =
      R"([{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,3]},{"endpoints":[3,0]}])";
  const std::string back =
      R"([{"endpoints":[1,0]},{"endpoints":[0,3]},{"endpoints":[3,2]},{"endpoints":[2,1]}])";
  return "{\"pattern\": {\"panels\": {" + panel("front", 25, there.c_str()) + ", " +
         panel("back", -22, back.c_str()) +
         R"(}, "stitches": [[{"panel":"front","edge":1},{"panel":"back","edge":3}],)"
         R"([{"panel":"front","edge":3},{"panel":"back","edge":1}]]},)"
         R"("properties": {"units_in_meter": 100, "curvature_coords": "relative"}})";
}

/// Straight trousers of four panels: half the waist's girth and half a hem's girth, the leg's
/// length to the crotch, from there to the waist, and where the hems are placed above the floor,
/// all in cm.
inline std::string trousers_file(double waist, double hem, double inseam, double rise,
                                 double above_floor) {
  std::string panels;
  for (const int side : {1, -1})
    for (const bool front : {true, false}) {
      const double w = side * waist / 2, h = side * (2 + hem), top = inseam + rise;
      // waist at the middle, at the side, hem outside, hem inside, crotch
      const bool straight = front == (side < 0);
      panels += fmt::format(
          "{}\"{}_{}\": {{\"vertices\": [[0,{}],[{},{}],[{},0],[{},0],[{},{}]], \"edges\": {}, "
          "\"translation\": [{},{},{}], \"rotation\": [0,0,0]}}",
          panels.empty() ? "" : ", ", side > 0 ? "left" : "right", front ? "front" : "back", top, w,
          top, h, 2 * side, side, inseam,
          straight ? R"([{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,3]},)"
                     R"({"endpoints":[3,4]},{"endpoints":[4,0]}])"
                   : R"([{"endpoints":[0,4]},{"endpoints":[4,3]},{"endpoints":[3,2]},)"
                     R"({"endpoints":[2,1]},{"endpoints":[1,0]}])",
          2 * side, above_floor, front ? 25 : -22);
    }
  // Edge numbers: waist, side, hem, inseam, middle in the one turn, the reverse in the other.
  const auto sewn = [](const char* a, int i, const char* b, int j) {
    return fmt::format(R"([{{"panel":"{}","edge":{}}},{{"panel":"{}","edge":{}}}])", a, i, b, j);
  };
  return "{\"pattern\": {\"panels\": {" + panels + "}, \"stitches\": [" +
         sewn("left_front", 3, "left_back", 1) + "," + sewn("left_front", 1, "left_back", 3) + "," +
         sewn("right_front", 1, "right_back", 3) + "," + sewn("right_front", 3, "right_back", 1) +
         "," + sewn("left_front", 0, "right_front", 4) + "," +
         sewn("left_back", 4, "right_back", 0) +
         R"(]}, "properties": {"units_in_meter": 100, "curvature_coords": "relative"}})";
}

}  // namespace loosefit::support
