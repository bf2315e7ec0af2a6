#include "loosefit/render/mannequin.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "loosefit/geometry/convex_hull.h"
#include "loosefit/render/clipped_surface.h"
#include "loosefit/render/garment_lines.h"

namespace loosefit::render {
namespace {
constexpr double kNeckShare =
    0.4;  // of the way from the neck joint to the head joint: below the jaw
constexpr double kInsideCloth = 0.03;  // the form ends this far above the hem [m]
constexpr double kAboveCloth = 0.02;   // … and this far above what is worn round the hips [m]
constexpr double kLeastLength = 0.1;   // of a garment, from its top to a hem [m]
constexpr double kThighStub = 0.10;    // of a thigh that is lifted [m]
constexpr double kHanging = 0.8;       // cosine between a thigh that hangs and the vertical

std::optional<Vec3> joint(const body::Body& body, const char* name) {
  const auto found = body.joints.find(name);
  return found == body.joints.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

bool below_waist(body::Segment s) {
  return s == body::Segment::thigh || s == body::Segment::shank || s == body::Segment::foot;
}

bool on_arm(body::Segment s) {
  return s == body::Segment::upper_arm || s == body::Segment::forearm || s == body::Segment::hand;
}

body::Segment nearest_segment(const body::Body& body, const Vec3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  body::Segment segment = body::Segment::torso;
  for (std::size_t v = 0; v < body.surface.vertices.size(); ++v)
    if (const double d = (body.surface.vertices[v] - p).squaredNorm(); d < nearest) {
      nearest = d;
      segment = body.segment[v];
    }
  return segment;
}

bool on_lower_leg(const body::Body& body, const Vec3& p) {
  const body::Segment segment = nearest_segment(body, p);
  return segment == body::Segment::shank || segment == body::Segment::foot;
}

Vec3 lowest(const std::vector<Vec3>& positions, const Vec3& axis) {
  return *std::min_element(positions.begin(), positions.end(),
                           [&](const Vec3& a, const Vec3& b) { return a.dot(axis) < b.dot(axis); });
}

/// Height along the trunk axis up to which there is cloth.
double cloth_top(const std::vector<Vec3>& positions, const Vec3& axis) {
  double top = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : positions) top = std::max(top, p.dot(axis));
  return top;
}

/// The edges of a garment round trunk and legs that are no waist or neck, along the trunk axis.
struct Hem {
  double mean = 0, lowest = 0;
  bool round_shanks = false;  ///< most of it
};

/// `below`: where edges are no waist or neck. Nothing for a garment without such edges.
std::optional<Hem> find_hem(const body::Body& body, const garment::Garment& garment,
                            const std::vector<Vec3>& positions, const Vec3& axis, double below) {
  Hem hem{0, std::numeric_limits<double>::infinity()};
  int count = 0, round_shanks = 0;
  for (const auto& edge : garment_lines(garment).boundary) {
    const Vec3& p = positions[edge[0]];
    if (p.dot(axis) >= below) continue;
    const body::Segment segment = nearest_segment(body, p);
    if (segment != body::Segment::torso && !below_waist(segment)) continue;
    hem.mean += p.dot(axis);
    hem.lowest = std::min(hem.lowest, p.dot(axis));
    ++count;
    round_shanks += segment == body::Segment::shank || segment == body::Segment::foot;
  }
  if (count == 0) return {};
  hem.mean /= count;
  hem.round_shanks = 2 * round_shanks > count;
  return hem;
}

/// A thigh that is lifted, as that of a sitter.
struct LiftedThigh {
  int side = 0;  ///< as in Body::side
  Vec3 hip, along;
  bool has(const body::Body& body, int v) const {
    return below_waist(body.segment[v]) && (body.side[v] >= 0) == (side > 0);
  }
  /// How far from the end of the stub towards the hip.
  double within_stub(const Vec3& p) const { return kThighStub - (p - hip).dot(along); }
};

std::vector<LiftedThigh> lifted_thighs(const body::Body& body) {
  std::vector<LiftedThigh> lifted;
  for (const auto& [side, suffix] : {std::pair{1, "_L"}, {-1, "_R"}}) {
    const auto hip = joint(body, (std::string("hip") + suffix).c_str());
    const auto knee = joint(body, (std::string("knee") + suffix).c_str());
    if (!hip || !knee) continue;
    const Vec3 along = (*knee - *hip).normalized();
    if (-along.z() < kHanging) lifted.push_back({side, *hip, along});
  }
  return lifted;
}

/// Where the neck ends.
struct NeckCut {
  Vec3 centre, normal;
  double reach;  ///< beyond which it cuts nothing: a scan's raised arms may have no name
  double below(const Vec3& p) const {
    const Vec3 from = p - centre;
    const double along = from.dot(normal);
    return (from - along * normal).norm() > reach ? 1.0 : -along;
  }
};

/// Across the trunk's axis, for it is then seen edge-on from the front, tilted towards the neck's
/// only as far as it takes to leave no jaw: heads lean forward.
NeckCut neck_cut(const body::Body& body, const Vec3& neck, const Vec3& head, const Vec3& axis) {
  const double length = (head - neck).norm();
  NeckCut cut{neck + kNeckShare * (head - neck), axis, 0.6 * length + 0.15};
  const Vec3 along = (head - neck) / length;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    cut.normal = (axis + share * (along - axis)).normalized();
    bool jaw = false;
    for (std::size_t v = 0; v < body.surface.vertices.size() && !jaw; ++v)
      jaw = body.segment[v] == body::Segment::head && cut.below(body.surface.vertices[v]) > 0;
    if (!jaw) break;
  }
  return cut;
}

/// A body that is cut piece by piece.
class Form {
 public:
  explicit Form(geometry::TriangleMesh surface)
      : mesh_(std::move(surface)), origin_(mesh_.vertices.size()) {
    std::iota(origin_.begin(), origin_.end(), 0);
  }

  /// Leaves where keep(vertex of the body, place) ≥ 0; puts a lid on the cut if it has a direction.
  template <class Keep>
  void cut(const Keep& keep, const std::optional<Vec3>& lid = {}) {
    std::vector<double> at(origin_.size());
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = keep(origin_[i], mesh_.vertices[i]);
    ClippedSurface part = clipped(mesh_, at);
    for (int& v : part.origin) v = origin_[v];
    mesh_ = std::move(part.mesh);
    origin_ = std::move(part.origin);
    if (!lid || part.rim.empty()) return;
    const int beside = origin_[part.rim.front()[0]];
    close_with_fan(mesh_, part.rim, *lid);
    origin_.resize(mesh_.vertices.size(), beside);
  }
  /// Puts another surface beside it, which is of the same piece as a vertex of the body.
  void add(const geometry::TriangleMesh& surface, int beside) {
    const int first = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.insert(mesh_.vertices.end(), surface.vertices.begin(), surface.vertices.end());
    for (const Triangle& t : surface.triangles)
      mesh_.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    origin_.resize(mesh_.vertices.size(), beside);
  }
  geometry::TriangleMesh take() { return std::move(mesh_); }

 private:
  geometry::TriangleMesh mesh_;
  std::vector<int> origin_;
};

/// Feet like a shoemaker's lasts: the convex hulls of those of the body, which have no toes.
void add_lasts(Form& form, const body::Body& body) {
  for (const bool left : {true, false}) {
    std::vector<Vec3> foot;
    int one = 0;
    for (std::size_t v = 0; v < body.segment.size(); ++v)
      if (body.segment[v] == body::Segment::foot && (body.side[v] >= 0) == left) {
        foot.push_back(body.surface.vertices[v]);
        one = static_cast<int>(v);
      }
    if (!foot.empty()) form.add(geometry::convex_hull(foot), one);
  }
}

/// Cuts lifted thighs to stubs, and the rest where the cloth ends.
void end_in_cloth(Form& form, const body::Body& body, const Vec3& axis,
                  const std::optional<Hem>& hem, const Vec3& hips) {
  const std::vector<LiftedThigh> lifted = lifted_thighs(body);
  for (const LiftedThigh& thigh : lifted)
    form.cut(
        [&](int v, const Vec3& p) {
          const double keep = thigh.within_stub(p);
          // The trunk beside it is left whole.
          return thigh.has(body, v) ? keep : std::max(keep, 1e-6);
        },
        thigh.along);
  // Those stubs end where the cloth does, for a cut inside it would leave half of them.
  const double end =
      hem && !lifted.empty() ? hem->lowest : (hem ? hem->mean : hips.dot(axis)) + kInsideCloth;
  form.cut([&](int v, const Vec3& p) {
    const body::Segment segment = body.segment[v];
    return segment == body::Segment::torso || below_waist(segment) ? p.dot(axis) - end : 1.0;
  });
}

}  // namespace

geometry::TriangleMesh mannequin(const body::Body& body, const garment::Garment& garment,
                                 const std::vector<Vec3>& positions,
                                 const std::vector<Vec3>& under) {
  const std::vector<Vec3>& points = body.surface.vertices;
  const auto neck = joint(body, "neck"), head = joint(body, "head");
  const auto hip_left = joint(body, "hip_L"), hip_right = joint(body, "hip_R");
  double floor = 0, top = 0;
  for (const Vec3& p : points) top = std::max(top, p.z());
  const Vec3 hips = hip_left && hip_right ? Vec3(0.5 * (*hip_left + *hip_right))
                                          : Vec3(0, 0, floor + 0.5 * (top - floor));
  const Vec3 nape = neck.value_or(Vec3(0, 0, floor + 0.85 * (top - floor)));
  const Vec3 axis = (nape - hips).normalized();
  const double middle = 0.5 * (hips + nape).dot(axis);
  const double waist = std::max(cloth_top(positions, axis), cloth_top(under, axis));
  const std::optional<Hem> hem = find_hem(
      body, garment, positions, axis, std::min(middle, cloth_top(positions, axis) - kLeastLength));

  const bool with_legs =
      (hem && hem->round_shanks) || (!under.empty() && on_lower_leg(body, lowest(under, axis)));
  Form form(body.surface);
  if (with_legs)
    add_lasts(form, body);
  else
    end_in_cloth(form, body, axis, hem, hips);
  if (waist < middle) {
    // A form for trousers and skirts: nothing but hips and legs.
    form.cut(
        [&](int v, const Vec3& p) {
          return on_arm(body.segment[v]) ? -1.0 : waist + kAboveCloth - p.dot(axis);
        },
        axis);
  } else if (neck && head && *neck != *head) {
    const NeckCut end = neck_cut(body, *neck, *head, axis);
    form.cut([&](int v, const Vec3& p) { return on_arm(body.segment[v]) ? 1.0 : end.below(p); },
             end.normal);
  }
  return form.take();
}

}  // namespace loosefit::render
