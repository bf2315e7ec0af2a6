#include "loosefit/drape/rest_levels.h"

#include <algorithm>
#include <limits>

namespace loosefit::drape {
namespace {

/// Shares of stature where a body brings no landmark (Drillis and Contini 1966; hip and chest:
/// means of the body model).
constexpr double kChest = 0.72, kWaist = 0.62, kHip = 0.51, kCrotch = 0.47, kKnee = 0.285,
                 kAnkle = 0.039;

bool is_arm(body::Segment s) {
  return s == body::Segment::upper_arm || s == body::Segment::forearm || s == body::Segment::hand;
}

}  // namespace

RestLevels::RestLevels(body::PosedBody body) : body_(std::move(body)) {
  const auto& skin = body_->surface.vertices;
  double top = -std::numeric_limits<double>::infinity();
  soles_ = -top;
  for (std::size_t v = 0; v < skin.size(); ++v) {
    const double z = in_rest(static_cast<int>(v), skin[v]).z();
    top = std::max(top, z);
    soles_ = std::min(soles_, z);
  }
  height = top - soles_;
  const auto landmark = [&](const char* name, double share) {
    const auto found = body_->landmark_vertex.find(name);
    if (found == body_->landmark_vertex.end()) return share * height;
    return in_rest(found->second, skin[found->second]).z() - soles_;
  };
  chest = landmark("sternum", kChest);
  waist = 0.5 * (landmark("back_waist", kWaist) + landmark("front_waist", kWaist));
  crotch = landmark("crotch", kCrotch);
  hip = crotch + (kHip - kCrotch) / (kWaist - kCrotch) * (waist - crotch);
}

Vec3 RestLevels::in_rest(int vertex, const Vec3& p) const {
  if (body_->pose_from_rest.size() != body_->surface.vertices.size()) return p;
  const auto& pose = body_->pose_from_rest[vertex];
  return pose.leftCols<3>().inverse() * (p - pose.col(3));
}

std::map<std::string, Vec3> RestLevels::joints() const {
  std::map<std::string, Vec3> at = body_->joints;
  for (auto& [name, p] : at) {
    // All bones that meet in a joint move it alike, so any skin next to it brings it back.
    const geometry::ClosestPoint skin = body_.tree().query(p);
    p = in_rest(body_->surface.triangles[skin.triangle][0], p) - soles_ * Vec3::UnitZ();
  }
  return at;
}

double RestLevels::of(const Vec3& p) const { return at_rest(p).z(); }

Vec3 RestLevels::at_rest(const Vec3& p) const {
  const auto& corners = body_->surface.triangles;
  const bool parted = body_->segment.size() == body_->surface.vertices.size();
  const geometry::ClosestPoint at = body_.tree().query(
      p, std::numeric_limits<double>::infinity(),
      [&](int triangle) { return !parted || !is_arm(body_->segment[corners[triangle][0]]); });
  const Vec3 rest = at.triangle < 0 ? p : in_rest(corners[at.triangle][0], p);
  return rest - soles_ * Vec3::UnitZ();
}

double RestLevels::of(const std::vector<int>& vertices, const std::vector<Vec3>& x) const {
  double sum = 0;
  for (int v : vertices) sum += of(x[v]);
  return sum / static_cast<double>(std::max<std::size_t>(1, vertices.size()));
}

double RestLevels::distance(const Vec3& p) const {
  return (body_.tree().query(p).point - p).norm();
}

std::string level_name(double level, const RestLevels& levels) {
  const double knee = kKnee / kCrotch * levels.crotch, ankle = kAnkle * levels.height;
  if (level < -ankle) return "below the soles";
  if (level < 2 * ankle) return "the feet";
  if (level < 0.75 * knee) return "the calves";
  if (level < 1.25 * knee) return "the knees";
  if (level < levels.crotch) return "the thighs";
  if (level < 0.5 * (levels.crotch + levels.waist)) return "the hips";
  if (level < 0.5 * (levels.waist + levels.chest)) return "the waist";
  return "the chest";
}

}  // namespace loosefit::drape
