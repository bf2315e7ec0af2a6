#include "loosefit/pipeline/place_in_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/pipeline/edge_distances.h"

namespace loosefit::pipeline {
namespace {

using placement::BodySegment;

std::string region_words(body::Region region) {
  std::string words = body::name(region);
  std::string side;
  if (words.ends_with("_L")) side = "left ";
  if (words.ends_with("_R")) side = "right ";
  if (!side.empty()) words.resize(words.size() - 2);
  std::replace(words.begin(), words.end(), '_', ' ');
  if (words == "scapula") words = "shoulder blade";
  if (words == "side") words = "flank";
  return "the " + side + words;
}

std::string centimetres(double metres) { return fmt::format("{:.0f} cm", std::abs(100 * metres)); }

/// "12 cm below the nape", "at the nape".
std::string height_words(double above, const std::string& mark) {
  constexpr double kAt = 0.005;  // [m]
  if (std::abs(above) < kAt) return "at " + mark;
  return centimetres(above) + (above > 0 ? " above " : " below ") + mark;
}

std::string on_trunk(const placement::BodyAddress& address, const placement::SegmentAxes& axes,
                     body::Region region) {
  constexpr double kMiddle = 0.01;  // [m]
  const Vec3 extent = axes.high - axes.low;
  const double right = (address.percent.x() - 50) / 100 * extent.x();
  const bool chest = address.segment == BodySegment::chest;
  const double along = address.percent.z() / 100 * extent.z();
  const std::string across = std::abs(right) < kMiddle
                                 ? "in the middle"
                                 : centimetres(right) + " to the wearer's " +
                                       (right > 0 ? "right" : "left") + " of the middle";
  return region_words(region) + ", " + across + ", " +
         (chest ? height_words(-along, "the nape") : height_words(along, "the navel"));
}

std::string on_limb(const placement::BodyAddress& address, const placement::SegmentAxes& axes) {
  // From medial to lateral on either side of the body.
  const double lateral = address.side > 0 ? 100 - address.percent.x() : address.percent.x();
  const double front = address.percent.y();
  const bool sideways = std::abs(lateral - 50) > std::abs(front - 50);
  const char* face =
      sideways ? (lateral > 50 ? "outer side" : "inner side") : (front > 50 ? "front" : "back");
  const double above = address.percent.z() / 100 * (axes.high - axes.low).z();
  std::string limb = placement::name(address.segment);
  std::replace(limb.begin(), limb.end(), '_', ' ');
  const char* mark = "";
  switch (address.segment) {
    case BodySegment::upper_arm:
      mark = "the elbow";
      break;
    case BodySegment::forearm:
      mark = "the wrist";
      break;
    case BodySegment::thigh:
      mark = "the knee";
      break;
    default:
      mark = "the ankle";
  }
  return fmt::format("the {} of the {} {}, {}", face, address.side > 0 ? "left" : "right", limb,
                     height_words(above, mark));
}

}  // namespace

std::string place_on_body(const body::Body& body, body::Region region,
                          const std::optional<placement::BodyAddress>& address) {
  if (!address) return region_words(region);
  const auto axes = placement::BodyAddresses(body).axes(address->segment, address->side);
  if (!axes) return region_words(region);
  return placement::has_side(address->segment) ? on_limb(*address, *axes)
                                               : on_trunk(*address, *axes, region);
}

std::string place_on_panel(const pattern::Pattern& pattern, const std::string& panel,
                           const Vec2& at) {
  std::string words = "panel " + panel;
  const int index = pattern.find_panel(panel);
  if (index < 0) return words;
  const pattern::Panel& piece = pattern.panels[index];
  const char* link = ", ";
  for (const EdgeDistance& distance : edge_distances(piece, at)) {
    words += fmt::format("{}{:.1f} cm from {}", link, 100 * distance.length,
                         piece.edges[distance.edge].name);
    link = " and ";
  }
  return words;
}

}  // namespace loosefit::pipeline
