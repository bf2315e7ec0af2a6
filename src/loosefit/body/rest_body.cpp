#include "loosefit/body/rest_body.h"

namespace loosefit::body {

std::vector<Vec3> joint_positions(const BodyData& data, const std::vector<Vec3>& rows) {
  std::vector<Vec3> joints;
  joints.reserve(data.joints.size());
  for (const auto& list : data.joints) {
    Vec3 sum = Vec3::Zero();
    for (const int row : list) sum += rows[std::size_t(row)];
    joints.push_back(sum / double(list.size()));
  }
  return joints;
}

}  // namespace loosefit::body
