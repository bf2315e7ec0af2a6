#include "loosefit/render/mannequin.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "loosefit/render/clipped_surface.h"
#include "loosefit/render/garment_lines.h"

namespace loosefit {
namespace {
constexpr double kNeckShare =
    0.4;  // of the way from the neck joint to the head joint: below the jaw
constexpr double kInsideCloth = 0.03;  // the form ends this far above the hem [m]
constexpr double kThighStub = 0.10;    // of a thigh that is lifted [m]
constexpr double kHanging = 0.8;       // cosine between a thigh and the trunk, below which it is

std::optional<Vec3> joint(const Body& body, const char* name) {
  const auto found = body.joints.find(name);
  return found == body.joints.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

bool below_waist(Segment s) {
  return s == Segment::thigh || s == Segment::shank || s == Segment::foot;
}

bool on_arm(Segment s) {
  return s == Segment::upper_arm || s == Segment::forearm || s == Segment::hand;
}

bool on_trunk(const Body& body, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  Segment segment = Segment::torso;
  for (std::size_t v = 0; v < body.surface.vertices.size(); ++v)
    if (const double d = (body.surface.vertices[v] - p).squaredNorm(); d < nearest) {
      nearest = d;
      segment = body.segment[v];
    }
  return segment == Segment::torso || below_waist(segment);
}

/// Height along the trunk axis at which the form ends: a little above the mean of the hem.
double hem_height(const Body& body, const Garment& garment, const std::vector<Vec3>& positions,
                  const Vec3& axis, const Vec3& hips, const Vec3& neck) {
  const double middle = 0.5 * (hips + neck).dot(axis);
  double sum = 0;
  int count = 0;
  for (const auto& edge : garment_lines(garment).boundary)
    if (const Vec3& p = positions[edge[0]]; p.dot(axis) < middle && on_trunk(body, p)) {
      sum += p.dot(axis);
      ++count;
    }
  return (count > 0 ? sum / count : hips.dot(axis)) + kInsideCloth;
}

/// A thigh that is lifted against the trunk, as that of a sitter.
struct LiftedThigh {
  int side = 0;  ///< as in Body::side
  Vec3 hip, along;
  double beyond_stub(const Vec3& p) const { return (p - hip).dot(along) - kThighStub; }
};

std::vector<LiftedThigh> lifted_thighs(const Body& body, const Vec3& axis) {
  std::vector<LiftedThigh> lifted;
  for (const auto& [side, suffix] : {std::pair{1, "_L"}, {-1, "_R"}}) {
    const auto hip = joint(body, (std::string("hip") + suffix).c_str());
    const auto knee = joint(body, (std::string("knee") + suffix).c_str());
    if (!hip || !knee) continue;
    const Vec3 along = (*knee - *hip).normalized();
    if (along.dot(-axis) < kHanging) lifted.push_back({side, *hip, along});
  }
  return lifted;
}

/// A body that is cut piece by piece; lids come last.
class Form {
 public:
  explicit Form(const Body& body) : mesh_(body.surface), origin_(body.surface.vertices.size()) {
    std::iota(origin_.begin(), origin_.end(), 0);
  }
  using Rim = std::vector<std::array<Vec3, 2>>;

  /// Leaves where keep(vertex of the body, place) ≥ 0.
  template <class Keep>
  Rim cut(const Keep& keep) {
    std::vector<double> at(origin_.size());
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = keep(origin_[i], mesh_.vertices[i]);
    ClippedSurface part = clipped(mesh_, at);
    for (int& v : part.origin) v = origin_[v];
    mesh_ = std::move(part.mesh);
    origin_ = std::move(part.origin);
    return std::move(part.rim);
  }
  TriangleMesh& mesh() { return mesh_; }

 private:
  TriangleMesh mesh_;
  std::vector<int> origin_;
};

}  // namespace

TriangleMesh mannequin(const Body& body, const Garment& garment,
                       const std::vector<Vec3>& positions) {
  const std::vector<Vec3>& points = body.surface.vertices;
  const auto neck = joint(body, "neck"), head = joint(body, "head");
  const auto hip_left = joint(body, "hip_L"), hip_right = joint(body, "hip_R");
  double floor = 0, top = 0;
  for (const Vec3& p : points) top = std::max(top, p.z());
  const Vec3 hips = hip_left && hip_right ? Vec3(0.5 * (*hip_left + *hip_right))
                                          : Vec3(0, 0, floor + 0.5 * (top - floor));
  const Vec3 nape = neck.value_or(Vec3(0, 0, floor + 0.85 * (top - floor)));
  const Vec3 axis = (nape - hips).normalized();
  const double hem = hem_height(body, garment, positions, axis, hips, nape);
  const std::vector<LiftedThigh> lifted = lifted_thighs(body, axis);

  Form form(body);
  const auto is_of = [&](const LiftedThigh& thigh, int v) {
    return below_waist(body.segment[v]) && (body.side[v] >= 0) == (thigh.side > 0);
  };
  form.cut([&](int v, const Vec3& p) {
    if (body.segment[v] != Segment::torso && !below_waist(body.segment[v])) return 1.0;
    for (const LiftedThigh& thigh : lifted)
      if (is_of(thigh, v)) return 1.0;
    return p.dot(axis) - hem;
  });
  std::vector<std::pair<Form::Rim, Vec3>> lids;
  for (const LiftedThigh& thigh : lifted) {
    // The trunk beside it is not cut, so near the groin the edges between the two are.
    Form::Rim rim = form.cut([&](int v, const Vec3& p) {
      const double keep = -thigh.beyond_stub(p);
      return is_of(thigh, v) ? keep : std::max(keep, 1e-6);
    });
    lids.emplace_back(std::move(rim), thigh.along);
  }
  if (neck && head) {
    // Across the trunk's axis, not the neck's, which leans forward: seen edge-on from the front.
    const double height = (*neck + kNeckShare * (*head - *neck)).dot(axis);
    const double reach = 0.6 * (*head - *neck).norm() + 0.15;  // a scan's arms may have no name
    Form::Rim rim = form.cut([&](int v, const Vec3& p) {
      const Vec3 from = p - *neck;
      const bool far = (from - from.dot(axis) * axis).norm() > reach;
      return far || on_arm(body.segment[v]) ? 1.0 : height - p.dot(axis);
    });
    lids.emplace_back(std::move(rim), axis);
  }
  for (const auto& [rim, outwards] : lids) close_with_fan(form.mesh(), rim, outwards);
  return std::move(form.mesh());
}

}  // namespace loosefit
