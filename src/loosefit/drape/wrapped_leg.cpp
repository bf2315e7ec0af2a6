#include "loosefit/drape/wrapped_leg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "loosefit/drape/band_ring.h"
#include "loosefit/drape/skirt_width.h"

namespace loosefit::drape {
namespace {

constexpr double kLeastWidth = 0.10;   ///< between edges of an inseam [m]
constexpr double kLeastInseam = 0.10;  ///< [m]
constexpr double kClear = 0.025;       ///< of the panel from the body [m]
constexpr double kFromMiddle = 0.006;  ///< of its edges from the middle of the body [m]
constexpr double kInwards = 0.03;      ///< of its edges from the middle of the leg [m]
constexpr double kSlice = 0.02;        ///< of height, by which outlines are taken [m]
constexpr int kNear = 4;               ///< slices that see what lies at a height
constexpr double kFar = 1e3;           ///< [m]

/// Numbers at heights, a slice apart.
class Profile {
 public:
  Profile(double lowest, double highest)
      : lowest_(lowest), size_(2 + static_cast<int>((highest - lowest) / kSlice)) {}
  int size() const { return size_; }
  double height(int k) const { return lowest_ + k * kSlice; }
  std::vector<double> filled(double value) const { return std::vector<double>(size_, value); }
  /// Slices within `reach` of this height.
  std::vector<int> near(double z, int reach) const {
    const int k = static_cast<int>(std::lround((z - lowest_) / kSlice));
    std::vector<int> found;
    for (int i = std::max(0, k - reach); i <= std::min(size_ - 1, k + reach); ++i)
      found.push_back(i);
    return found;
  }
  /// Linear between slices.
  double at(const std::vector<double>& values, double z) const {
    const double s = std::clamp((z - lowest_) / kSlice, 0.0, size_ - 1.001);
    const int k = static_cast<int>(s);
    return values[k] + (s - k) * (values[k + 1] - values[k]);
  }

 private:
  double lowest_;
  int size_;
};

}  // namespace

std::vector<int> find_wrapped_legs(const garment::OpenSeams& open, const std::vector<int>& side) {
  const garment::Garment& g = open.garment;
  std::map<int, std::pair<double, double>> inseam;  // lowest and highest v, by panel
  for (const std::vector<int>& of : open.partners)
    for (std::size_t i = 1; i < of.size(); ++i) {
      const int k = g.vertex_panel[of[i]];
      if (g.vertex_panel[of[i - 1]] != k || side[k] == 0) continue;
      const auto &a = g.vertex_uv[of[i - 1]], &b = g.vertex_uv[of[i]];
      if (std::hypot(a[0] - b[0], a[1] - b[1]) < kLeastWidth) continue;
      const double v = 0.5 * (a[1] + b[1]);
      const auto [at, is_new] = inseam.try_emplace(k, v, v);
      at->second = {std::min(at->second.first, v), std::max(at->second.second, v)};
    }
  std::vector<int> found;
  for (const auto& [k, reach] : inseam)
    if (reach.second - reach.first > kLeastInseam && !BandRing::find(open, k)) found.push_back(k);
  return found;
}

bool wrap_leg(const garment::OpenSeams& open, int panel, int side, const body::PosedBody& body,
              std::vector<Vec3>& x) {
  std::vector<int> of;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (int v = 0; v < open.garment.vertex_count; ++v) {
    if (open.garment.vertex_panel[v] != panel) continue;
    of.push_back(v);
    lowest = std::min(lowest, x[v].z()), highest = std::max(highest, x[v].z());
  }
  const Vec3 neck = body->joints.at("neck");
  const std::string name = side > 0 ? "_L" : "_R";
  const Vec3 &knee = body->joints.at("knee" + name), &ankle = body->joints.at("ankle" + name),
             &hip = body->joints.at("hip" + name);
  const auto out_of = [&](const Vec3& p) { return side * (p.x() - neck.x()); };

  // What lies at each height, on this side of the body: wider where it is wider near by.
  const Profile levels(lowest, highest);
  std::vector<double> front = levels.filled(kFar), back = levels.filled(-kFar),
                      outer = levels.filled(-kFar), low = levels.filled(kFar),
                      high = levels.filled(-kFar);
  for (std::size_t i = 0; i < body->surface.vertices.size(); ++i) {
    const Vec3& p = body->surface.vertices[i];
    if (is_of_arm(body.body(), i) || out_of(p) < 0) continue;
    for (int k : levels.near(p.z(), kNear)) {
      front[k] = std::min(front[k], p.y()), back[k] = std::max(back[k], p.y());
      outer[k] = std::max(outer[k], out_of(p));
    }
  }
  for (int v : of)
    for (int k : levels.near(x[v].z(), 1))
      low[k] = std::min(low[k], x[v].y()), high[k] = std::max(high[k], x[v].y());

  std::vector<double> radius, middle, centre, wider;
  for (int k = 0; k < levels.size(); ++k) {
    if (!(front[k] < back[k]) || !(low[k] < high[k])) return false;
    radius.push_back(0.5 * (back[k] - front[k]) + kClear);
    middle.push_back(0.5 * (back[k] + front[k]));
    const double quarter = radius[k] * kPi / 2, half = 0.5 * (high[k] - low[k]);
    centre.push_back(std::max(outer[k] + kClear - radius[k], half - quarter + kFromMiddle));
    // Its edges come to the inner side of the leg, or threads would draw them along the outer one.
    const double z = levels.height(k);
    const Vec3 &upper = z > knee.z() ? hip : knee, &lower = z > knee.z() ? knee : ankle;
    const double t = (upper.z() - z) / (upper.z() - lower.z());
    const double inner = std::max(kFromMiddle, out_of(upper + t * (lower - upper)) - kInwards);
    const double in = centre[k] - inner;
    const double needed =
        in > 0 ? quarter + in : radius[k] * std::acos(std::min(1.0, -in / radius[k]));
    wider.push_back(z < hip.z() ? std::max(1.0, needed / half) : 1.0);
  }
  for (int v : of) {
    const double z = x[v].z(), r = levels.at(radius, z), quarter = r * kPi / 2;
    const double c =
        levels.at(wider, z) * (x[v].y() - 0.5 * (levels.at(low, z) + levels.at(high, z)));
    const double straight = std::max(0.0, std::abs(c) - quarter);
    const double angle = std::clamp(c, -quarter, quarter) / r;
    const double out = levels.at(centre, z) + r * std::cos(angle) - straight;
    x[v].x() = neck.x() + side * std::max(out, kFromMiddle);
    x[v].y() = levels.at(middle, z) + r * std::sin(angle);
  }
  return true;
}

}  // namespace loosefit::drape
