#include "loosefit/body/missing_limbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "loosefit/body/lay_person.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::body {
namespace {

// Shares of the stature, where nothing else is said.
constexpr double kLeastHand = 0.025;  // a fist reaches some 4 % beyond the wrist
constexpr double kLeastFoot = 0.03;   // between the end of a leg and the sole
constexpr double kLeastToes = 0.4;    // of the way from the ankle to the toes: of two legs that
                                      // end alike, the soles are laid where they end
constexpr double kWholeFoot = 0.75;   // likewise: feet as long for their stature differ by less
constexpr double kLeastHead = 0.06;   // between the end of the scan and the crown
constexpr double kNear = 0.05;        // farther off the model's skin the scan tells of no limb
constexpr double kBehindEnd = 0.005;  // the last skin of a stump is its rounding
constexpr std::size_t kScanSamples = 40000;
constexpr std::size_t kStray = 3;  // points that noise may put beyond the end of a limb

constexpr double kWrist = 0.01;       // [m]
constexpr double kLeastShown = 0.75;  // of a limb's skin
constexpr double kShown = 0.009;      // that near, and facing the same way
constexpr double kExplained = 0.018;  // that near to the model, skin of the scan is the person's
constexpr double kSameSide = 0.4;     // least cosine between normals of skin that is the same
constexpr double kShoulder = 0.03;    // beyond the first joint, where a limb's own skin begins

/// A limb as a line of joints, outwards, with the part of the body that begins at each.
struct Limb {
  std::vector<Segment> parts;
  std::vector<const char*> bones, joint_names;
  int side = 0;
};

std::vector<Limb> all_limbs() {
  std::vector<Limb> limbs;
  for (const int side : {1, -1}) {
    limbs.push_back({{Segment::upper_arm, Segment::forearm, Segment::hand},
                     {"upperarm01", "lowerarm01", "wrist"},
                     {"shoulder", "elbow", "wrist"},
                     side});
  }
  for (const int side : {1, -1}) {
    limbs.push_back({{Segment::thigh, Segment::shank, Segment::foot},
                     {"upperleg01", "lowerleg01", "foot"},
                     {"hip", "knee", "ankle"},
                     side});
  }
  limbs.push_back({{Segment::head}, {"head"}, {"top of the neck"}, 0});
  return limbs;
}

/// Where along its limb each vertex of the model lies: metres outwards of the first joint.
class Stations {
 public:
  Stations(const BodyModel& model, const LaidSkin& laid, const Limb& limb) : limb_(limb) {
    for (const char* bone : limb.bones) {
      const std::string name =
          limb.side == 0 ? bone : std::string(bone) + (limb.side > 0 ? ".L" : ".R");
      joint_.push_back(laid.joints[std::size_t(model.data().bone(name))]);
    }
    part_.assign(laid.surface.size(), -1);
    for (std::size_t v = 0; v < part_.size(); ++v) {
      const auto found = std::ranges::find(limb.parts, model.segments()[v]);
      if (found != limb.parts.end() && limb.side * laid.rest[v].x() >= 0)
        part_[v] = int(found - limb.parts.begin());
    }
    // The last part goes to its farthest vertex; a foot goes on as the shank does, to the sole.
    const std::size_t last = joint_.size() - 1;
    Vec3 outwards = limb.side == 0 ? Vec3::UnitZ() : Vec3(joint_[last] - joint_[last - 1]);
    if (limb.parts.back() == Segment::hand) {
      double farthest = 0;
      for (std::size_t v = 0; v < part_.size(); ++v)
        if (part_[v] == int(last) && (laid.surface[v] - joint_[last]).norm() > farthest) {
          farthest = (laid.surface[v] - joint_[last]).norm();
          outwards = laid.surface[v] - joint_[last];
        }
    }
    for (std::size_t i = 0; i < joint_.size(); ++i) {
      const Vec3 way = i < last ? Vec3(joint_[i + 1] - joint_[i]) : outwards;
      along_.push_back(way.normalized());
      start_.push_back(i == 0 ? 0.0 : start_[i - 1] + (joint_[i] - joint_[i - 1]).norm());
    }
    if (limb.parts.back() == Segment::foot)
      for (std::size_t v = 0; v < part_.size(); ++v)
        if (part_[v] == int(last) && (laid.surface[v] - joint_[last]).norm() > toes_.norm())
          toes_ = laid.surface[v] - joint_[last];
    toes_.z() = 0;
    for (std::size_t v = 0; v < part_.size(); ++v)
      if (part_[v] == int(last)) end_ = std::max(end_, of(int(last), laid.surface[v]));
  }

  int part(int vertex) const { return part_[std::size_t(vertex)]; }
  double of(int part, const Vec3& p) const {
    const auto i = std::size_t(part);
    return start_[i] + along_[i].dot(p - joint_[i]);
  }
  double start(std::size_t part) const { return start_[part]; }
  double end() const { return end_; }
  double end_of(std::size_t part) const {
    return part + 1 < start_.size() ? start_[part + 1] : end_;
  }
  std::size_t part_at(double station) const {
    std::size_t i = start_.size() - 1;
    while (i > 0 && station < start_[i]) --i;
    return i;
  }
  Vec3 at(double station) const {
    const std::size_t i = part_at(station);
    return joint_[i] + (station - start_[i]) * along_[i];
  }
  const Limb& limb() const { return limb_; }
  /// From the ankle to the toes over the floor [m]; and how far a point lies that way.
  double toes() const { return toes_.norm(); }
  double ahead(const Vec3& p) const { return toes_.normalized().dot(p - joint_.back()); }

 private:
  const Limb& limb_;
  std::vector<Vec3> joint_, along_;
  std::vector<double> start_;
  std::vector<int> part_;  ///< per vertex; -1: of another limb
  Vec3 toes_ = Vec3::Zero();
  double end_ = 0;
};

bool reaches(const Stations& stations, double reach, double stature) {
  switch (stations.limb().parts.back()) {
    case Segment::hand:
      return reach > stations.start(2) + kLeastHand * stature;
    case Segment::foot:
      return reach > stations.end() - kLeastFoot * stature;
    default:
      return reach > stations.end() - kLeastHead * stature;
  }
}

std::string place_in_words(const Stations& stations, double reach) {
  const std::size_t i = stations.part_at(std::max(0.0, reach));
  const double below = reach - stations.start(i);
  const auto& names = stations.limb().joint_names;
  if (stations.limb().side == 0)
    return fmt::format("{:.2f} m {} the {}", std::abs(below), below < 0 ? "below" : "above",
                       names[0]);
  if (i + 1 < names.size() && stations.end_of(i) - reach < below)
    return fmt::format("{:.2f} m above the {}", stations.end_of(i) - reach, names[i + 1]);
  return fmt::format("{:.2f} m {} the {}", std::abs(below), below < 0 ? "above" : "below",
                     names[i]);
}

MissingLimb cut_at(const Stations& stations, double reach, const LaidSkin& laid, double stature) {
  const Limb& limb = stations.limb();
  MissingLimb found;
  const std::size_t ends_in = stations.part_at(reach);
  const bool half =
      reach - stations.start(ends_in) > 0.5 * (stations.end_of(ends_in) - stations.start(ends_in));
  found.first = limb.parts[std::min(limb.parts.size() - 1, ends_in + (half ? 1 : 0))];
  found.side = limb.side;
  found.end = stations.at(reach);
  found.beyond = stations.end() - reach;
  found.above_wrist = limb.parts.back() == Segment::hand && reach < stations.start(2) - kWrist;
  found.where = place_in_words(stations, reach);
  for (std::size_t v = 0; v < laid.surface.size(); ++v)
    if (const int part = stations.part(int(v));
        part >= 0 && stations.of(part, laid.surface[v]) > reach - kBehindEnd * stature)
      found.vertices.push_back(int(v));
  return found;
}

/// The farthest of some places along a limb but for those that noise may have put there.
double farthest(std::vector<double> places) {
  std::ranges::nth_element(places, places.begin() + (kStray - 1), std::greater<>());
  return places[kStray - 1];
}

double stature_of(const geometry::TriangleMesh& scan) {
  double stature = 0;
  for (const Vec3& p : scan.vertices) stature = std::max(stature, p.z());
  return stature;
}

/// From each vertex of the scan that is asked to the next.
std::size_t step_of(const geometry::TriangleMesh& scan) {
  return std::max<std::size_t>(1, scan.vertices.size() / kScanSamples);
}

/// A point of the scan, and the vertex of the model that it is nearest to.
struct Seen {
  int vertex;
  Vec3 point;
};

std::vector<Seen> seen_of(const LaidSkin& laid, const geometry::TriangleMesh& scan) {
  const double stature = stature_of(scan);
  const geometry::TriangleMesh mesh{laid.surface, laid.triangles};
  const geometry::ClosestPointTree tree(mesh);
  std::vector<Seen> seen;
  const std::size_t step = step_of(scan);
  for (std::size_t v = 0; v < scan.vertices.size(); v += step) {
    const geometry::ClosestPoint c = tree.query(scan.vertices[v], kNear * stature);
    if (c.triangle < 0) continue;
    Eigen::Index nearest = 0;
    c.barycentric.maxCoeff(&nearest);
    seen.push_back(
        {laid.triangles[std::size_t(c.triangle)][std::size_t(nearest)], scan.vertices[v]});
  }
  return seen;
}

/// How far the scan reaches along a limb, and along its foot.
struct Reach {
  double outwards = 0, ahead = 0;  ///< [m]
};

Reach reach_of(const Stations& stations, const std::vector<Seen>& seen) {
  std::vector<double> reached(kStray, 0.0), ahead(kStray, 0.0);
  for (const Seen& s : seen)
    if (const int part = stations.part(s.vertex); part >= 0) {
      reached.push_back(stations.of(part, s.point));
      if (part == 2) ahead.push_back(stations.ahead(s.point));
    }
  return {farthest(reached), farthest(ahead)};
}

}  // namespace

std::string in_words(const std::vector<MissingLimb>& missing) {
  std::string words;
  for (const MissingLimb& limb : missing)
    words += fmt::format("{}no {} (the scan ends {})", words.empty() ? "" : ", ", limb.name(),
                         limb.where);
  return words;
}

std::vector<MissingLimb> doubtful_limbs(const BodyModel& model, const PosedPerson& person,
                                        const geometry::TriangleMesh& scan) {
  const LaidSkin laid = lay(model, person);
  const auto normals = geometry::vertex_normals(laid.surface, laid.triangles);
  const double stature = stature_of(scan);
  const geometry::ClosestPointTree tree(scan);
  const std::vector<Vec3> scan_normals = geometry::smooth_normals(scan);
  std::vector<MissingLimb> doubtful;
  const std::vector<Limb> limbs = all_limbs();
  for (const Limb& limb : limbs) {
    if (limb.side == 0) continue;
    const Stations stations(model, laid, limb);
    const double first =
        limb.parts[0] == Segment::thigh ? 0.5 * stations.start(1) : 2 * kShoulder * stature;
    std::size_t all = 0, shown = 0;
    for (int v = 0; v < model.data().body_vertices; ++v) {
      const int part = stations.part(v);
      const auto i = std::size_t(v);
      if (part < 0 || part > 1 || stations.of(part, laid.surface[i]) < first) continue;
      ++all;
      shown += tree.query(laid.surface[i], kShown * stature,
                          [&](int t) {
                            return scan_normals[std::size_t(t)].dot(normals[i]) > kSameSide;
                          })
                   .triangle >= 0;
    }
    if (double(shown) >= kLeastShown * double(all)) continue;
    doubtful.push_back(cut_at(stations, kShoulder * stature, laid, stature));
  }
  return doubtful;
}

double explained_share(const BodyModel& model, const PosedPerson& person,
                       const std::vector<MissingLimb>& missing,
                       const geometry::TriangleMesh& scan) {
  const LaidSkin laid = lay(model, person);
  const double stature = stature_of(scan);
  std::vector<char> lacks(laid.surface.size(), 0);
  for (const MissingLimb& limb : missing)
    for (const int v : limb.vertices) lacks[std::size_t(v)] = 1;
  const geometry::TriangleMesh mesh{laid.surface, laid.triangles};
  const geometry::ClosestPointTree tree(mesh);
  const std::size_t step = step_of(scan);
  std::size_t all = 0, near = 0;
  for (std::size_t v = 0; v < scan.vertices.size(); v += step) {
    ++all;
    near +=
        tree.query(scan.vertices[v], kExplained * stature,
                   [&](int t) { return !lacks[std::size_t(laid.triangles[std::size_t(t)][0])]; })
            .triangle >= 0;
  }
  return double(near) / double(all);
}

std::vector<MissingLimb> missing_limbs(const BodyModel& model, const PosedPerson& person,
                                       const geometry::TriangleMesh& scan) {
  const LaidSkin laid = lay(model, person);
  const double stature = stature_of(scan);
  const std::vector<Seen> seen = seen_of(laid, scan);
  std::vector<MissingLimb> missing;
  const std::vector<Limb> limbs = all_limbs();
  for (const Limb& limb : limbs) {
    const Stations stations(model, laid, limb);
    const Reach seen_to = reach_of(stations, seen);
    double reach = seen_to.outwards;
    const bool toeless =
        limb.parts.back() == Segment::foot && seen_to.ahead < kLeastToes * stations.toes();
    if (reaches(stations, reach, stature) && !toeless) continue;
    if (toeless) reach = std::min(reach, stations.start(2));
    missing.push_back(cut_at(stations, reach, laid, stature));
  }
  return missing;
}

std::vector<ShortFoot> short_feet(const BodyModel& model, const PosedPerson& person,
                                  const std::vector<MissingLimb>& missing,
                                  const geometry::TriangleMesh& scan) {
  const LaidSkin laid = lay(model, person);
  const std::vector<Seen> seen = seen_of(laid, scan);
  std::vector<ShortFoot> found;
  const std::vector<Limb> limbs = all_limbs();
  for (const Limb& limb : limbs) {
    const bool is_gone = std::ranges::any_of(
        missing, [&](const MissingLimb& m) { return m.of_leg() && m.side == limb.side; });
    if (limb.parts.back() != Segment::foot || is_gone) continue;
    const Stations stations(model, laid, limb);
    const double ahead = reach_of(stations, seen).ahead;
    if (ahead < kWholeFoot * stations.toes()) found.push_back({limb.side, stations.toes() - ahead});
  }
  return found;
}

}  // namespace loosefit::body
