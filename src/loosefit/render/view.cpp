#include "loosefit/render/view.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::render {
namespace {

constexpr View kViews[] = {View::front, View::back, View::left, View::right};

/// The whole text as a number.
bool read_degrees(const std::string& text, double& degrees) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, degrees);
  return error == std::errc{} && stop == end && std::isfinite(degrees);
}

}  // namespace

const char* name(View view) {
  switch (view) {
    case View::front:
      return "front";
    case View::back:
      return "back";
    case View::left:
      return "left";
    case View::right:
      return "right";
  }
  return "front";
}

View view_from_name(const std::string& text) {
  for (View view : kViews)
    if (text == name(view)) return view;
  throw InvalidInput("unknown view '" + text + "', expected front, back, left or right");
}

Camera camera(View view) {
  switch (view) {
    case View::front:
      return {0, 0};
    case View::back:
      return {180, 0};
    case View::left:
      return {90, 0};
    case View::right:
      return {270, 0};
  }
  return {};
}

Camera camera_from_text(const std::string& text) {
  for (View view : kViews)
    if (text == name(view)) return camera(view);
  const std::size_t comma = text.find(',');
  Camera camera;
  const bool read =
      read_degrees(text.substr(0, comma), camera.azimuth) &&
      (comma == std::string::npos || read_degrees(text.substr(comma + 1), camera.elevation));
  if (!read || std::abs(camera.azimuth) > 360 ||
      std::abs(camera.elevation) > Camera::kLargestElevation)
    throw InvalidInput(
        fmt::format("view: found '{}', expected front, back, left, right, or "
                    "AZIMUTH or AZIMUTH,ELEVATION in degrees, at most 360 and {}",
                    text, Camera::kLargestElevation));
  return camera;
}

std::string str(const Camera& seen) {
  for (View view : kViews)
    if (seen.azimuth == camera(view).azimuth && seen.elevation == 0) return name(view);
  std::string text = fmt::format("{:g}°", seen.azimuth);
  if (seen.elevation != 0)
    text += fmt::format(", {:g}° {}", std::abs(seen.elevation), seen.elevation > 0 ? "up" : "down");
  return text;
}

}  // namespace loosefit::render
