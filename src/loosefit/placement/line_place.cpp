#include "loosefit/placement/line_place.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::placement {
namespace {

constexpr double kMostCoordinate = 5;  // as of all places in the pattern [m]

[[noreturn]] void refuse(const std::string& text, const std::string& expected) {
  throw InvalidInput({"", 0, "place"}, "\"" + printable(text) + "\"", expected, "");
}

/// Numbers between commas, each within ± `most`; empty for anything else.
std::vector<double> numbers(const std::string& text, double most) {
  std::vector<double> values;
  const char* at = text.data();
  const char* end = at + text.size();
  while (true) {
    while (at != end && *at == ' ') ++at;
    double value = 0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !(std::abs(value) <= most)) return {};
    values.push_back(value);
    at = rest;
    while (at != end && *at == ' ') ++at;
    if (at == end) return values;
    if (*at++ != ',') return {};
  }
}

std::optional<BodyAddress> address_of(std::string words, const std::string& ratios) {
  BodyAddress address;
  for (const auto& [side, sign] : {std::pair("left ", 1), std::pair("right ", -1)})
    if (words.starts_with(side)) {
      words = words.substr(std::string(side).size());
      address.side = sign;
    }
  for (char& c : words)
    if (c == ' ') c = '_';
  for (const BodySegment segment : all_body_segments()) {
    if (name(segment) != words || has_side(segment) != (address.side != 0)) continue;
    address.segment = segment;
    const std::vector<double> percent = numbers(ratios, 300);
    if (percent.size() != 3) return std::nullopt;
    address.percent = Vec3(percent[0], percent[1], percent[2]);
    return address;
  }
  return std::nullopt;
}

}  // namespace

std::string LinePlace::str() const {
  if (!panel.empty()) return panel + ":" + shortest(at.x()) + "," + shortest(at.y());
  if (!landmark.empty()) return landmark;
  const std::string side = anatomy->side > 0 ? "left " : anatomy->side < 0 ? "right " : "";
  const Vec3& ratios = anatomy->percent;
  return side + name(anatomy->segment) + " [" + shortest(ratios.x()) + ", " + shortest(ratios.y()) +
         ", " + shortest(ratios.z()) + "]";
}

LinePlace parse_place(const std::string& text) {
  LinePlace place;
  if (const std::size_t colon = text.rfind(':'); colon != std::string::npos) {
    place.panel = text.substr(0, colon);
    const std::vector<double> at = numbers(text.substr(colon + 1), kMostCoordinate);
    if (place.panel.empty() || at.size() != 2)
      refuse(text, "a panel with u,v in metres, as in \"front:0.05,0.12\"");
    place.at = Vec2(at[0], at[1]);
    return place;
  }
  if (const std::size_t open = text.find('['); open != std::string::npos) {
    std::size_t end = open;
    while (end > 0 && text[end - 1] == ' ') --end;
    if (text.back() == ']')
      place.anatomy =
          address_of(text.substr(0, end), text.substr(open + 1, text.size() - open - 2));
    if (!place.anatomy)
      refuse(text,
             "a segment with three ratios in percent, as in \"left forearm [0, 50, 30]\" or "
             "\"chest [50, 100, 70]\"");
    return place;
  }
  if (text.empty()) refuse(text, "a landmark, a panel with u,v or a segment with ratios");
  place.landmark = text;
  return place;
}

}  // namespace loosefit::placement
