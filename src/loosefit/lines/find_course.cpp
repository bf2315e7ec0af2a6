#include "loosefit/lines/find_course.h"

#include <fmt/format.h>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::lines {
namespace {

using placement::BodyAddress;
using placement::BodySegment;
using placement::GarmentPoint;
using placement::LinePlace;
using placement::LineSpec;

bool is_trunk(BodySegment segment) { return !placement::has_side(segment); }

/// The address on that side of its segment, at the same level. \throws InvalidInput, key "over".
BodyAddress on_side(BodyAddress address, const std::string& side) {
  const bool trunk = is_trunk(address.segment);
  double &x = address.percent.x(), &y = address.percent.y();
  if (side == "front" || side == "back") {
    // The abdomen is told from front to back, all others from back to front.
    const bool high = (side == "front") != (address.segment == BodySegment::abdomen);
    y = high ? 100 : 0;
    x = trunk ? x : 50;
    return address;
  }
  const bool sideways = side == "left" || side == "right";
  if (trunk != sideways)
    throw InvalidInput({"", 0, "over"}, "\"" + printable(side) + "\" of the " + address.str(),
                       trunk ? "front, back, left or right" : "front, back, inside or outside", "");
  y = 50;
  // X runs from the wearer's left to the right on every segment.
  const bool right = trunk ? side == "right" : (side == "outside") == (address.side < 0);
  x = right ? 100 : 0;
  return address;
}

}  // namespace

std::string stop_key(std::size_t i, std::size_t n) {
  return i == 0 ? "from" : i + 1 == n ? "to" : "via";
}

CourseFinder::CourseFinder(const garment::Garment& garment, const std::vector<Vec3>& positions,
                           body::PosedBody body, const maps::WornGarment& worn)
    : garment_(garment),
      positions_(positions),
      body_(std::move(body)),
      over_skin_(garment, positions, body_, worn),
      points_(body_.body()),
      surface_(flat_surface(garment)) {}

geometry::ClosestPoint CourseFinder::skin(const LinePlace& place) const {
  return place.anatomy ? points_.addresses().skin(*place.anatomy)
                       : body_.tree().query(points_.at(place.landmark));
}

GarmentPoint CourseFinder::stop(const LinePlace& place, const std::string& key) const {
  try {
    if (!place.panel.empty()) return placement::pattern_point(garment_, place.panel, place.at);
    const auto over = over_skin_.over(skin(place));
    if (over.covered) return over.point;
    throw InvalidInput({"", 0, key}, "\"" + printable(place.str()) + "\": " + over.why_not,
                       "skin under the garment", "");
  } catch (const InvalidInput& error) {
    throw error.at({"", 0, key});
  }
}

GarmentPoint CourseFinder::side_stop(const LineSpec& line, const GarmentPoint& from,
                                     const GarmentPoint& to) const {
  const Vec3 middle = 0.5 * (over_skin_.under(from).exact.point + over_skin_.under(to).exact.point);
  try {
    auto address = points_.addresses().address(body_.tree().query(middle));
    if (!address)
      throw InvalidInput({"", 0, "over"}, "a body without landmarks there", "via, with places", "");
    const auto axes = points_.addresses().axes(address->segment, address->side);
    address->percent = axes->percent(middle);
    const BodyAddress wanted = on_side(*address, line.over);
    const auto over = over_skin_.over(points_.addresses().skin(wanted));
    if (over.covered) return over.point;
    throw InvalidInput({"", 0, "over"}, wanted.str() + ": " + over.why_not,
                       "skin under the garment", "");
  } catch (const InvalidInput& error) {
    throw error.at({"", 0, "over"});
  }
}

std::vector<GarmentPoint> CourseFinder::stops(const LineSpec& line) const {
  std::vector<GarmentPoint> found;
  for (std::size_t i = 0; i < line.stops.size(); ++i)
    found.push_back(stop(line.stops[i], stop_key(i, line.stops.size())));
  if (!line.over.empty()) found.insert(found.begin() + 1, side_stop(line, found[0], found[1]));
  return found;
}

LineCourse CourseFinder::find(const LineSpec& line) const {
  return lay_course(garment_, surface_, stops(line), line.course, line.part);
}

void check_stops(const garment::Garment& garment, const placement::SitePoints& points,
                 const LineSpec& line) {
  for (std::size_t i = 0; i < line.stops.size(); ++i) {
    const LinePlace& place = line.stops[i];
    try {
      if (!place.panel.empty())
        placement::pattern_point(garment, place.panel, place.at);
      else if (place.anatomy)
        points.addresses().skin(*place.anatomy);
      else
        points.at(place.landmark);
    } catch (const InvalidInput& error) {
      throw error.at({"", 0, stop_key(i, line.stops.size())});
    }
  }
}

}  // namespace loosefit::lines
