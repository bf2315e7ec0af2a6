#include "loosefit/drape/skirt_width.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "loosefit/body/floor_under.h"
#include "loosefit/drape/rest_levels.h"

namespace loosefit::drape {
namespace {

constexpr double kFromHands = 0.04;   ///< of a skirt that is sewn, from the hands [m]
constexpr double kBesideBody = 0.03;  ///< from the outside of the legs [m]
constexpr double kAboveFloor = 0.04;  ///< of cloth that is sewn, above the floor [m]
constexpr double kSlice = 0.03;       ///< of height, by which widths are compared [m]

/// Half widths by slice of height [m].
class HalfWidths {
 public:
  explicit HalfWidths(double middle) : middle_(middle) {}
  void take(const Vec3& p) {
    double& half = half_[slice(p.z())];
    half = std::max(half, std::abs(p.x() - middle_));
  }
  /// The widest in the slice of this height and beside it: a mesh need not have a vertex in each.
  /// 0: there is nothing.
  double at(double z) const {
    double most = 0;
    for (int k = slice(z) - 1; k <= slice(z) + 1; ++k)
      if (const auto found = half_.find(k); found != half_.end())
        most = std::max(most, found->second);
    return most;
  }

 private:
  static int slice(double z) { return static_cast<int>(std::floor(z / kSlice)); }
  double middle_;
  std::map<int, double> half_;
};

}  // namespace

bool is_of_arm(const body::Body& body, std::size_t vertex) {
  if (vertex >= body.segment.size()) return false;
  const body::Segment s = body.segment[vertex];
  return s == body::Segment::upper_arm || s == body::Segment::forearm || s == body::Segment::hand;
}

void squeeze_between_hands(std::vector<Vec3>& x, const std::vector<int>& of,
                           const body::PosedBody& body) {
  const double waist = RestLevels(body).waist, middle = body->joints.at("neck").x();
  const double wrist = 0.5 * (body->joints.at("wrist_L").z() + body->joints.at("wrist_R").z());
  double room = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < body->surface.vertices.size(); ++i)
    if (const Vec3& p = body->surface.vertices[i]; is_of_arm(body.body(), i) && p.z() < waist)
      room = std::min(room, std::abs(p.x() - middle) - kFromHands);
  double widest = 0;
  for (int v : of)
    if (x[v].z() < waist) widest = std::max(widest, std::abs(x[v].x() - middle));
  if (!(room > 0 && widest > room) || !(waist > wrist)) return;
  for (int v : of) {
    const double down = std::clamp((waist - x[v].z()) / (waist - wrist), 0.0, 1.0);
    x[v].x() = middle + (1 - (1 - room / widest) * down) * (x[v].x() - middle);
  }
}

void squeeze_above_floor(std::vector<Vec3>& x, const std::vector<int>& of,
                         const body::PosedBody& body) {
  const std::optional<double> floor = body::floor_under(body.body());
  if (!floor) return;
  const double least = *floor + kAboveFloor, crotch = *floor + RestLevels(body).crotch;
  double lowest = crotch;
  for (int v : of) lowest = std::min(lowest, x[v].z());
  if (!(lowest < *floor)) return;
  const double share = (crotch - least) / (crotch - lowest);
  for (int v : of)
    if (x[v].z() < crotch) x[v].z() = crotch - share * (crotch - x[v].z());
}

void stretch_round_body(std::vector<Vec3>& x, const std::vector<int>& of,
                        const body::PosedBody& body) {
  const double crotch = RestLevels(body).crotch, middle = body->joints.at("neck").x();
  HalfWidths skin(middle), cloth(middle);
  for (std::size_t i = 0; i < body->surface.vertices.size(); ++i)
    if (const Vec3& p = body->surface.vertices[i]; !is_of_arm(body.body(), i) && p.z() <= crotch)
      skin.take(p);
  for (int v : of)
    if (x[v].z() <= crotch) cloth.take(x[v]);
  for (int v : of) {
    const double z = x[v].z();
    if (z > crotch || skin.at(z) == 0) continue;
    const double has = cloth.at(z), wants = skin.at(z) + kBesideBody;
    if (has > 0 && has < wants) x[v].x() = middle + wants / has * (x[v].x() - middle);
  }
}

}  // namespace loosefit::drape
