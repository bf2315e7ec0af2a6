#include "loosefit/base/error.h"

namespace loosefit {

std::string InputPlace::str() const {
  std::string text = file;
  if (line > 0) text += (text.empty() ? "line " : ":") + std::to_string(line);
  if (!key.empty()) text += (text.empty() ? "" : ": ") + key;
  return text;
}

InvalidInput::InvalidInput(const InputPlace& place, const std::string& found,
                           const std::string& expected, std::string hint)
    : Error(place.str() + ": found " + found + ", expected " + expected, std::move(hint)) {}

}  // namespace loosefit
