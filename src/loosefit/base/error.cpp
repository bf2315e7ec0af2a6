#include "loosefit/base/error.h"

namespace loosefit {

std::string InputPlace::str() const {
  std::string text = file;
  if (line > 0) text += (text.empty() ? "line " : ":") + std::to_string(line);
  if (!key.empty()) text += (text.empty() ? "" : ": ") + key;
  return text;
}

InvalidInput::InvalidInput(const std::string& complaint, std::string hint)
    : Error(complaint, std::move(hint)), complaint_(complaint) {}

InvalidInput::InvalidInput(const InputPlace& place, const std::string& found,
                           const std::string& expected, std::string hint)
    : Error(place.str() + ": found " + found + ", expected " + expected, std::move(hint)),
      place_(place),
      complaint_("found " + found + ", expected " + expected),
      found_(found),
      expected_(expected) {}

InvalidInput InvalidInput::at(const InputPlace& place) const {
  const std::string where = place.str();
  InvalidInput moved(where.empty() ? complaint_ : where + ": " + complaint_, hint());
  moved.place_ = place;
  moved.complaint_ = complaint_;
  moved.found_ = found_;
  moved.expected_ = expected_;
  return moved;
}

}  // namespace loosefit
