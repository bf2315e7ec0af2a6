#pragma once
#include "loosefit/base/types.h"

namespace loosefit::io {

/// y up, facing +z (file) → z up, facing −y (ours): (x, y, z) → (x, −z, y).
Mat3 frame_from_y_up();

/// R = Rz(c) Ry(b) Rx(a) of angles (a, b, c) in degrees: about the fixed x axis first.
Mat3 rotation_from_euler_deg(const Vec3& angles);
/// Its inverse; b in [−90, 90]; at b = ±90 the angle c is 0.
Vec3 euler_deg_from_rotation(const Mat3& rotation);

}  // namespace loosefit::io
