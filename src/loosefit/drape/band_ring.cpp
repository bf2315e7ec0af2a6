#include "loosefit/drape/band_ring.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "loosefit/drape/rolled_panel.h"

namespace loosefit::drape {
namespace {

constexpr double kWhole = 0.8;       ///< share of a strip's width over which its ends are sewn
constexpr double kEndToEnd = 0.75;   ///< share of its length that lies between sewn vertices
constexpr double kNarrow = 2.5;      ///< length over width
constexpr double kBeside = 0.01;     ///< of its side from that of its partners, along the limb [m]
constexpr double kFromSkin = 0.006;  ///< at least [m]
constexpr double kStep = 0.005;      ///< by which it is widened [m]
constexpr int kSteps = 40;

Vec3 flat(const garment::OpenSeams& open, int v) {
  return {open.garment.vertex_uv[v][0], open.garment.vertex_uv[v][1], 0};
}

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double s) { low = std::min(low, s), high = std::max(high, s); }
  double length() const { return std::max(0.0, high - low); }
};

}  // namespace

std::optional<BandRing> BandRing::find(const garment::OpenSeams& open, int panel) {
  const std::vector<int>& of = open.garment.vertex_panel;
  BandRing band;
  band.panel_ = panel;
  for (int v = 0; v < open.garment.vertex_count; ++v)
    if (of[v] == panel) band.vertices_.push_back(v);
  std::vector<std::pair<Vec3, Vec3>> ends;
  std::set<int> sewn_to;
  for (const std::vector<int>& partners : open.partners) {
    std::vector<int> own, other;
    for (int v : partners) (of[v] == panel ? own : other).push_back(v);
    if (own.size() > 1) ends.emplace_back(flat(open, own.front()), flat(open, own.back()));
    if (own.empty() || other.empty()) continue;
    for (int v : own) band.side_.push_back({v, other});
    for (int v : other) sewn_to.insert(of[v]);
  }
  if (ends.size() < 2 || band.side_.size() < 3) return {};
  band.sewn_to_.assign(sewn_to.begin(), sewn_to.end());

  Vec3 sum = Vec3::Zero();
  for (auto& [a, b] : ends) {
    if ((b - a).dot(sum) < 0) std::swap(a, b);
    sum += b - a;
  }
  const double girth = sum.norm() / static_cast<double>(ends.size());
  if (girth < 1e-6) return {};
  band.across_ = sum.normalized();
  const Vec3 along = Vec3::UnitZ().cross(band.across_);
  Extent length, width, sewn;
  for (int v : band.vertices_) {
    length.take(flat(open, v).dot(band.across_));
    width.take(flat(open, v).dot(along));
  }
  for (const auto& [a, b] : ends) sewn.take(0.5 * (a + b).dot(along));
  if (girth < kEndToEnd * length.length() || sewn.length() < kWhole * width.length() ||
      length.length() < width.length())
    return {};
  band.narrow_ = length.length() >= kNarrow * width.length();
  return band;
}

Vec3 BandRing::middle(const std::vector<Vec3>& x) const {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Seam& seam : side_)
    for (int v : seam.to) sum += x[v], ++count;
  return sum / count;
}

void BandRing::place(const garment::OpenSeams& open, const Polyline& limb,
                     const body::PosedBody& body, std::vector<Vec3>& x) const {
  const auto target = [&](const Seam& seam) {
    Vec3 sum = Vec3::Zero();
    for (int v : seam.to) sum += x[v] / static_cast<double>(seam.to.size());
    return sum;
  };
  const Polyline::Place centre = limb.at(limb.project(middle(x)));
  // Two directions square to the limb, the first as much sideways as it can be.
  const Vec3 t = centre.tangent;
  const Vec3 reference = std::abs(t.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 e = (reference - reference.dot(t) * t).normalized(), f = t.cross(e);
  const auto angle_of = [&](const Vec3& p) {
    return std::atan2((p - centre.point).dot(f), (p - centre.point).dot(e));
  };

  // Its sewn side in order from end to end; angles of the partners, counter-clockwise about the
  // limb, turn one way or the other, which tells which way up the band is sewn.
  std::vector<std::pair<double, const Seam*>> order;
  Extent extent;
  for (const Seam& seam : side_) order.emplace_back(flat(open, seam.vertex).dot(across_), &seam);
  for (int v : vertices_) extent.take(flat(open, v).dot(across_));
  std::sort(order.begin(), order.end());
  double turn = 0;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const double d = angle_of(target(*order[i + 1].second)) - angle_of(target(*order[i].second));
    turn += std::remainder(d, 2 * kPi);
  }
  const double sense = turn < 0 ? -1 : 1;
  // In the plane of the panel, along the limb's tangent: outside out, across_ turns with `sense`.
  const Vec3 along = sense * Vec3::UnitZ().cross(across_);

  // The angle at the middle of the band: the mean over its side.
  const double middle_of_band = 0.5 * (extent.low + extent.high);
  double c = 0, s = 0;
  for (const auto& [u, seam] : order) {
    const double own = sense * (u - middle_of_band) / extent.length() * 2 * kPi;
    const double phase = angle_of(target(*seam)) - own;
    c += std::cos(phase), s += std::sin(phase);
  }
  const double phase = std::atan2(s, c);
  const Vec3 outwards = std::cos(phase) * e + std::sin(phase) * f;

  // Turned into the world, then rolled.
  Mat3 in_plane, in_world;
  in_plane << along, Vec3::UnitZ(), along.cross(Vec3::UnitZ());
  in_world << t, outwards, t.cross(outwards);
  const Mat3 rotation = in_world * in_plane.transpose();
  std::vector<Vec3> placed(x.size(), Vec3::Zero());
  Vec3 from = Vec3::Zero();
  for (int v : vertices_) placed[v] = rotation * flat(open, v);
  for (const Seam& seam : side_) from += placed[seam.vertex] / static_cast<double>(side_.size());
  Extent band_reach, sewn_reach;
  for (int v : vertices_) band_reach.take((placed[v] - from).dot(t));
  for (const Seam& seam : side_)
    for (int v : seam.to) sewn_reach.take(limb.project(x[v]));
  // It lies beyond all of the places that it is sewn to.
  const bool onwards = band_reach.high > -band_reach.low;
  const double offset = onwards ? sewn_reach.high + kBeside : sewn_reach.low - kBeside;
  const RolledPanel rolled(open, placed, panel_, from, t, outwards);
  if (!rolled.goes_round()) return;

  double wider_e = 0, wider_f = 0;
  for (int step = 0; step < kSteps; ++step) {
    rolled.place(limb, offset, 0, x);
    bool at_e = false, at_f = false;
    for (int v : vertices_) {
      const Vec3 off = x[v] - limb.at(limb.project(x[v])).point;
      const double along_e = off.dot(e), along_f = off.dot(f), r = std::hypot(along_e, along_f);
      if (!(r > 0)) continue;
      x[v] += wider_e * along_e / r * e + wider_f * along_f / r * f;
      if (body.tree().signed_distance(x[v], nullptr, 1.0) > kFromSkin) continue;
      (std::abs(along_e) > std::abs(along_f) ? at_e : at_f) = true;
    }
    if (!at_e && !at_f) return;
    if (at_e) wider_e += kStep;
    if (at_f) wider_f += kStep;
  }
}

}  // namespace loosefit::drape
