#pragma once
#include <string>

namespace loosefit::render {

/// Where the camera stands, seen from the wearer: `left` looks at the wearer's left side.
enum class View { front, back, left, right };
const char* name(View view);
/// \throws InvalidInput for anything but front, back, left, right.
View view_from_name(const std::string& text);

/// A direction from which a drape is looked at.
struct Camera {
  double azimuth = 0;    ///< [deg] about the vertical: 0 the wearer's front, 90 the wearer's left
  double elevation = 0;  ///< [deg] above the horizon, at most kLargestElevation either way
  static constexpr double kLargestElevation = 80;
};
Camera camera(View view);
/// "front", "back", "left", "right", or degrees: "30", "30,15" (azimuth, elevation).
/// \throws InvalidInput.
Camera camera_from_text(const std::string& text);
/// "front", "30°", "30°, 15° up".
std::string str(const Camera& camera);

}  // namespace loosefit::render
