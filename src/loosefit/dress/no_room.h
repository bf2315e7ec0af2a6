#pragma once
#include "loosefit/base/error.h"

namespace loosefit::dress {

/// A garment finds no room round the body in the posture that it is to be put on in; it may in
/// another one.
class NoRoom : public GeometryError {
 public:
  explicit NoRoom(const std::string& complaint) : GeometryError(complaint) {}
};

}  // namespace loosefit::dress
