#pragma once
#include <string>

/// A T-shirt drawn by hand in millimetres, y down, for tests of readers: half front and half back
/// from the fold at x = 0 on, and the right sleeve seen from outside. Side 395.1, front armhole
/// 189.1, back armhole 186.9, cap 376.1 mm.
namespace loosefit::testing_support {

inline const char* const kFrontHalf =
    "M 0,600 L 250,600 L 240,205 C 225,205 205,195 200,180 C 185,150 170,110 190,45 L 80,8 "
    "C 72,50 40,95 0,95 Z";
inline const char* const kBackHalf =
    "M 0,600 L 250,600 L 240,205 C 225,205 205,195 200,180 C 188,150 180,110 190,45 L 80,8 "
    "C 75,22 40,28 0,28 Z";
inline const char* const kSleeve =
    "M -140,150 L 140,150 L 150,0 C 105,0 82.5,-101.72 0,-101.72 C -87,-101.72 -117,0 -150,0 Z";

inline std::string freesewing_part(const std::string& name, const std::string& d,
                                   const std::string& at, const std::string& more = {}) {
  return "<g id=\"fs-stack-tee." + name + "\" transform=\"translate(" + at + ")\">\n" +
         "<g id=\"fs-stack-tee." + name + "-part-tee." + name +
         "\" transform=\"translate(0, 0)\">\n<path class=\"fabric\" id=\"fs-" + name + "\" d=\"" +
         d + "\" />\n" + more + "</g>\n</g>\n";
}

/// As FreeSewing exports it. `marked`: with the marks of a complete pattern, seam allowances
/// included.
inline std::string freesewing_tshirt(bool marked) {
  const std::string fold =
      "<path class=\"note\" marker-start=\"url(#cutonfoldFrom)\" "
      "marker-end=\"url(#cutonfoldTo)\" d=\"M 0,130 L 15,130 L 15,500 L 0,500\" />\n";
  const std::string allowance =
      "<path class=\"fabric sa\" d=\"M 0,610 L 260,610 L 250,195 L 200,35 L 70,-2 L 0,85\" />\n";
  const std::string notch = "<use x=\"183\" y=\"120\" xlink:href=\"#notch\" />\n";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n<svg "
         "xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "freesewing=\"4.10.2\" width=\"900mm\" height=\"700mm\" viewBox=\"0 0 900 700\">\n"
         "<defs><g id=\"notch\"><circle r=\"2\"/></g></defs>\n<g id=\"fs-container\">\n" +
         freesewing_part("front", kFrontHalf, "2, 0", marked ? fold + allowance + notch : "") +
         freesewing_part("back", kBackHalf, "272, 0", marked ? fold + allowance : "") +
         freesewing_part("sleeve", kSleeve, "702, 104") + "</g>\n</svg>\n";
}

/// The same as the drafted design is written by Node: parts with paths of operations.
inline std::string freesewing_json() {
  const auto p = [](const char* key, const char* x, const char* y) {
    return std::string("\"") + key + "\":{\"x\":" + x + ",\"y\":" + y + "}";
  };
  const auto move = [&](const char* x, const char* y) {
    return "{\"type\":\"move\"," + p("to", x, y) + "},\n";
  };
  const auto line = [&](const char* x, const char* y) {
    return "{\"type\":\"line\"," + p("to", x, y) + "},\n";
  };
  const auto curve = [&](const char* a, const char* b, const char* c, const char* d, const char* x,
                         const char* y) {
    return "{\"type\":\"curve\"," + p("cp1", a, b) + "," + p("cp2", c, d) + "," + p("to", x, y) +
           "},\n";
  };
  const std::string close = "{\"type\":\"close\"}";
  const auto part = [](const char* name, const std::string& ops) {
    return std::string("\"tee.") + name +
           "\":{\"points\":{},\"paths\":{\"seam\":{\"hidden\":false,\"attributes\":{\"list\":"
           "{\"class\":[\"fabric\"]}},\"ops\":[\n" +
           ops + "]}}}";
  };
  const std::string trunk = move("0", "600") + line("250", "600") + line("240", "205") +
                            curve("225", "205", "205", "195", "200", "180");
  return "{\"parts\":[{\n" +
         part("front", trunk + curve("185", "150", "170", "110", "190", "45") + line("80", "8") +
                           curve("72", "50", "40", "95", "0", "95") + close) +
         ",\n" +
         part("back", trunk + curve("188", "150", "180", "110", "190", "45") + line("80", "8") +
                          curve("75", "22", "40", "28", "0", "28") + close) +
         ",\n" +
         part("sleeve", move("-140", "150") + line("140", "150") + line("150", "0") +
                            curve("105", "0", "82.5", "-101.72", "0", "-101.72") +
                            curve("-87", "-101.72", "-117", "0", "-150", "0") + close) +
         "}]}\n";
}

}  // namespace loosefit::testing_support
