#include "loosefit/body/facing_skin.h"

namespace loosefit::body {
namespace {

constexpr double kOpposite = -0.5;  // cosine between the normals, at most

}  // namespace

bool faces_skin(const geometry::ClosestPointTree& skin, const std::function<Vec3(int)>& normal_of,
                const Vec3& p, const Vec3& n) {
  return skin.query(p + kFacingSkin / 2 * n, kFacingSkin / 2,
                    [&](int t) { return normal_of(t).dot(n) < kOpposite; })
             .triangle >= 0;
}

}  // namespace loosefit::body
