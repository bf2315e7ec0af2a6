#include "loosefit/io/address_columns.h"

#include <cmath>

#include "loosefit/io/csv.h"

namespace loosefit::io {
namespace {

/// A tenth of a percent is a tenth of a scan's precision.
double to_a_tenth(double percent) { return std::round(10 * percent) / 10; }

}  // namespace

const std::vector<std::string>& address_columns() {
  static const std::vector<std::string> kAll = {"body_segment", "body_side", "body_x_percent",
                                                "body_y_percent", "body_z_percent"};
  return kAll;
}

std::vector<std::string> address_fields(const std::optional<placement::BodyAddress>& address) {
  if (!address) return std::vector<std::string>(address_columns().size());
  return {placement::name(address->segment), side_name(*address),
          csv_field(to_a_tenth(address->percent.x())), csv_field(to_a_tenth(address->percent.y())),
          csv_field(to_a_tenth(address->percent.z()))};
}

std::string side_name(const placement::BodyAddress& address) {
  return address.side > 0 ? "left" : address.side < 0 ? "right" : "";
}

}  // namespace loosefit::io
