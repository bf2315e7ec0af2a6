#pragma once
#include <string>

namespace loosefit::render {

/// Where the camera stands, seen from the wearer: `left` looks at the wearer's left side.
enum class View { front, back, left, right };
const char* name(View view);
/// \throws InvalidInput for anything but front, back, left, right.
View view_from_name(const std::string& text);

}  // namespace loosefit::render
