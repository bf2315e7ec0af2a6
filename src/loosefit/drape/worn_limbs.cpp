#include "loosefit/drape/worn_limbs.h"

#include <map>
#include <set>

namespace loosefit {
namespace {

constexpr double kChest = 0.6;                 ///< of the way from hip to neck, where arms begin:
                                               ///< a neckline may slip past the neck's own joint
constexpr double kHand = 0.5;                  ///< of the forearm's length, beyond the wrist
constexpr double kBelow = 0.5, kAbove = 0.25;  ///< of the trunk's line beyond hip and neck [m]

/// Of the discs' middles, so that a limb in the very middle does not meet all spokes at once [m].
const Vec3 kOff(1.3e-4, 1.7e-4, 1.1e-4);

using Line = std::vector<Vec3>;

std::vector<Line> limbs(const Body& body) {
  const auto& at = body.joints;
  for (const char* joint : {"neck", "hip_L", "hip_R", "shoulder_L", "shoulder_R", "elbow_L",
                            "elbow_R", "wrist_L", "wrist_R"})
    if (!at.count(joint)) return {};
  const Vec3 neck = at.at("neck"), hip = 0.5 * (at.at("hip_L") + at.at("hip_R"));
  const Vec3 up = (neck - hip).normalized();
  std::vector<Line> lines = {{hip - kBelow * up, hip, neck, neck + kAbove * up}};
  for (const std::string side : {"_L", "_R"}) {
    const Vec3 elbow = at.at("elbow" + side), wrist = at.at("wrist" + side);
    lines.push_back({hip + kChest * (neck - hip), at.at("shoulder" + side), elbow, wrist,
                     wrist + kHand * (wrist - elbow)});
  }
  return lines;
}

/// Closed chains of the edges that belong to one triangle, each from its least vertex.
std::vector<std::vector<int>> openings(const std::vector<Triangle>& triangles) {
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
  std::map<int, int> next;
  for (const auto& [a, b] : edges)
    if (!edges.count({b, a})) next[a] = b;
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int>& loop = loops.emplace_back();
    for (auto at = next.begin(); at != next.end();) {
      loop.push_back(at->first);
      const int to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return loops;
}

/// +1 or −1 where the way from p to q goes through the triangle, 0 where it does not.
int crossing(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto volume = [](const Vec3& u, const Vec3& v, const Vec3& w) { return u.dot(v.cross(w)); };
  const bool from = volume(a - p, b - p, c - p) > 0, to = volume(a - q, b - q, c - q) > 0;
  if (from == to) return 0;
  const Vec3 way = q - p;
  const bool ab = volume(way, a - p, b - p) > 0, bc = volume(way, b - p, c - p) > 0,
             ca = volume(way, c - p, a - p) > 0;
  if (ab != bc || bc != ca) return 0;
  return from ? 1 : -1;
}

}  // namespace

std::vector<int> limbs_through_openings(const std::vector<Triangle>& triangles,
                                        const std::vector<Vec3>& x, const Body& body) {
  const std::vector<Line> lines = limbs(body);
  std::vector<int> numbers;
  if (lines.empty()) return numbers;
  for (const std::vector<int>& loop : openings(triangles)) {
    Vec3 middle = kOff;
    for (int v : loop) middle += x[v] / static_cast<double>(loop.size());
    for (const Line& line : lines) {
      int number = 0;
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (std::size_t k = 0; k < loop.size(); ++k)
          number +=
              crossing(line[i], line[i + 1], middle, x[loop[k]], x[loop[(k + 1) % loop.size()]]);
      numbers.push_back(number);
    }
  }
  return numbers;
}

}  // namespace loosefit
