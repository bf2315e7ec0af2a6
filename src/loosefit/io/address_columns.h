#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/placement/address.h"

namespace loosefit::io {

/// Columns of an anatomical address in every table: body_segment, body_side ("left", "right", or
/// empty on the trunk), body_x_percent, body_y_percent, body_z_percent.
const std::vector<std::string>& address_columns();

/// The fields to these columns; all empty for a place without an address.
std::vector<std::string> address_fields(const std::optional<placement::BodyAddress>& address);

/// "left", "right", or nothing on the trunk.
std::string side_name(const placement::BodyAddress& address);

}  // namespace loosefit::io
