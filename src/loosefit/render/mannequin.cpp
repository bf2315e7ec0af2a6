#include "loosefit/render/mannequin.h"

#include <algorithm>
#include <optional>

#include "loosefit/render/clear_of_cloth.h"
#include "loosefit/render/cut_form.h"
#include "loosefit/render/form_extent.h"
#include "loosefit/render/smooth_skin.h"
#include "loosefit/render/smooth_solid.h"

namespace loosefit::render {
namespace {
constexpr double kNeckShare =
    0.4;  // of the way from the neck joint to the head joint: below the jaw
constexpr double kInsideCloth = 0.03;   // the form ends this far above the hem [m]
constexpr double kShortTop = 0.06;      // a hem this far above the hips shows the form there [m]
constexpr double kThighStub = 0.10;     // of a thigh that is lifted [m]
constexpr double kHanging = 0.8;        // cosine between a thigh that hangs and the vertical
constexpr double kArmHangs = 0.5;       // cosine between an arm that hangs and the trunk
constexpr double kPlateTilt = 0.5;      // of the shoulders' plates towards the arms
constexpr double kBesidePlate = 0.001;  // between plate and trunk [m]
constexpr double kWrist = 0.025;        // of the forearm that the mitten goes over [m]
constexpr double kPalm = 0.09;          // from the wrist [m]
constexpr double kPalmRadius = 0.034;   // [m]
constexpr double kNeckRing = 0.008;     // of the neck at its end that the plug is made like [m]
constexpr double kPlug = 0.05;          // length of the plug [m]
constexpr double kPlugFoot = 0.96, kPlugTop = 0.75;  // its width over the neck's
constexpr double kBelowAnkle = 0.0;                  // where the last begins [m]
constexpr std::size_t kSolid = 4;                    // points; who lacks a hand or foot has fewer
constexpr int kEggRounds = 60, kMittenRounds = 20, kLastRounds = 4;

std::optional<Vec3> joint(const body::Body& body, const std::string& name) {
  const auto found = body.joints.find(name);
  return found == body.joints.end() ? std::nullopt : std::optional<Vec3>(found->second);
}

bool below_waist(body::Segment s) {
  return s == body::Segment::thigh || s == body::Segment::shank || s == body::Segment::foot;
}

bool on_arm(body::Segment s) {
  return s == body::Segment::upper_arm || s == body::Segment::forearm || s == body::Segment::hand;
}

struct Side {
  bool left;
  const char* suffix;
  bool has(const body::Body& body, std::size_t v) const { return (body.side[v] >= 0) == left; }
};
constexpr Side kSides[] = {{true, "_L"}, {false, "_R"}};

/// A thigh that is lifted, as that of a sitter.
struct LiftedThigh {
  Side side;
  Vec3 hip, along;
  bool has(const body::Body& body, int v) const {
    return below_waist(body.segment[v]) && side.has(body, v);
  }
  /// How far from the end of the stub towards the hip.
  double within_stub(const Vec3& p) const { return kThighStub - (p - hip).dot(along); }
};

std::vector<LiftedThigh> lifted_thighs(const body::Body& body) {
  std::vector<LiftedThigh> lifted;
  for (const Side& side : kSides) {
    const auto hip = joint(body, std::string("hip") + side.suffix);
    const auto knee = joint(body, std::string("knee") + side.suffix);
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

geometry::TriangleMesh joined(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  geometry::TriangleMesh both = a;
  const int first = static_cast<int>(a.vertices.size());
  both.vertices.insert(both.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles)
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return both;
}

geometry::TriangleMesh smooth_surface(const body::Body& body,
                                      const geometry::ClosestPointTree& skin,
                                      const geometry::TriangleMesh& cloth) {
  const std::vector<Vec3> smooth = smooth_skin(body);
  return {
      clear_of_cloth(skin, smooth, geometry::vertex_normals(smooth, body.surface.triangles), cloth),
      body.surface.triangles};
}

/// Those of one side or, without one, of both.
std::vector<Vec3> points_of(const body::Body& body, body::Segment segment, const Side* side) {
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < body.segment.size(); ++v)
    if (body.segment[v] == segment && (!side || side->has(body, v)))
      points.push_back(body.surface.vertices[v]);
  return points;
}

/// The direction of a limb's last part, and where that ends.
struct LimbEnd {
  Vec3 end, along;
};

std::optional<LimbEnd> limb_end(const body::Body& body, const char* from, const char* to,
                                const Side& side) {
  const auto a = joint(body, from + std::string(side.suffix));
  const auto b = joint(body, to + std::string(side.suffix));
  if (!a || !b || *a == *b) return {};
  return LimbEnd{*b, (*b - *a).normalized()};
}

/// Feet like a shoemaker's lasts, without toes, below the ankles.
void add_lasts(std::vector<geometry::TriangleMesh>& parts, const body::Body& body) {
  for (const Side& side : kSides) {
    std::vector<Vec3> foot = points_of(body, body::Segment::foot, &side);
    if (const auto ankle = limb_end(body, "knee", "ankle", side))
      std::erase_if(
          foot, [&](const Vec3& p) { return (p - ankle->end).dot(ankle->along) < kBelowAnkle; });
    if (foot.size() >= kSolid) parts.push_back(smooth_solid(foot, {}, kLastRounds));
  }
}

/// Cuts lifted thighs to stubs, and the rest where the cloth ends.
void end_in_cloth(CutForm& form, const body::Body& body, const FormExtent& extent) {
  const std::vector<LiftedThigh> lifted = lifted_thighs(body);
  for (const LiftedThigh& thigh : lifted)
    form.cut(
        [&](int v, const Vec3& p) {
          const double keep = thigh.within_stub(p);
          // The trunk beside it is left whole.
          return thigh.has(body, v) ? keep : std::max(keep, 1e-6);
        },
        thigh.along);
  const double hips = extent.hips.dot(extent.axis);
  double end = hips + kInsideCloth;
  if (const auto& hem = extent.hem) {
    // Stubs end where the cloth does, for a cut inside it would leave half of them.
    end = lifted.empty() ? hem->mean + kInsideCloth : hem->lowest;
    if (hem->mean > hips + kShortTop) end = hips;
  }
  form.cut(
      [&](int v, const Vec3& p) {
        const body::Segment segment = body.segment[v];
        return segment == body::Segment::torso || below_waist(segment) ? p.dot(extent.axis) - end
                                                                       : 1.0;
      },
      -extent.axis);
}

/// Knobs of the size of a palm instead of hands.
void end_in_mittens(CutForm& form, std::vector<geometry::TriangleMesh>& parts,
                    const body::Body& body, const geometry::TriangleMesh& cloth) {
  for (const Side& side : kSides) {
    const auto wrist = limb_end(body, "elbow", "wrist", side);
    if (!wrist) continue;
    const Vec3 along = limb_end(body, "wrist", "hand", side).value_or(*wrist).along;
    // The palm, as round as a wrist: without the thumb.
    std::vector<Vec3> palm;
    for (const body::Segment segment : {body::Segment::forearm, body::Segment::hand})
      for (const Vec3& p : points_of(body, segment, &side)) {
        const double beyond = (p - wrist->end).dot(along);
        if (beyond < -kWrist || beyond > kPalm) continue;
        const Vec3 aside = p - wrist->end - beyond * along;
        palm.push_back(p + (std::min(1.0, kPalmRadius / aside.norm()) - 1) * aside);
      }
    form.cut(
        [&](int v, const Vec3&) {
          return body.segment[v] == body::Segment::hand && side.has(body, v) ? -1.0 : 1.0;
        },
        wrist->along);
    if (palm.size() >= kSolid) parts.push_back(smooth_solid(palm, cloth, kMittenRounds));
  }
}

/// Lifted arms cannot end in plates on the shoulders, which they bend.
bool arms_hang(const body::Body& body, const Vec3& axis) {
  return std::ranges::all_of(kSides, [&](const Side& side) {
    const auto upper_arm = limb_end(body, "shoulder", "elbow", side);
    return !upper_arm || -upper_arm->along.dot(axis) > kArmHangs;
  });
}

/// Flat plates on the shoulders instead of arms.
void end_at_shoulders(CutForm& form, const body::Body& body,
                      const geometry::TriangleMesh& surface) {
  for (const Side& side : kSides) {
    const auto shoulder = joint(body, std::string("shoulder") + side.suffix);
    const auto other = joint(body, side.left ? "shoulder_R" : "shoulder_L");
    const auto upper_arm = limb_end(body, "shoulder", "elbow", side);
    if (!shoulder || !other || !upper_arm) continue;
    const Vec3 out =
        ((*shoulder - *other).normalized() + kPlateTilt * upper_arm->along).normalized();
    const auto on_this_arm = [&](int v) { return on_arm(body.segment[v]) && side.has(body, v); };
    // As near as it can be without cutting into the trunk, which would leave no flat rim.
    double plate = shoulder->dot(out);
    for (const Triangle& t : surface.triangles) {
      const auto arms = std::ranges::count_if(t, on_this_arm);
      if (arms == 0 || arms == 3) continue;
      for (const int v : t) plate = std::max(plate, surface.vertices[v].dot(out));
    }
    plate += kBesidePlate;
    form.cut([&](int v, const Vec3& p) { return on_this_arm(v) ? plate - p.dot(out) : 1.0; }, out);
  }
}

void cut_neck(CutForm& form, const body::Body& body, const NeckCut& end) {
  form.cut([&](int v, const Vec3& p) { return on_arm(body.segment[v]) ? 1.0 : end.below(p); },
           end.normal);
}

/// An egg instead of a head, and a plug that goes on into it from the end of the neck.
void end_in_egg(CutForm& form, std::vector<geometry::TriangleMesh>& parts, const body::Body& body,
                const NeckCut& end, const geometry::TriangleMesh& cloth) {
  std::vector<Vec3> ring;
  for (const Vec3& p : points_of(body, body::Segment::neck, nullptr))
    if (std::abs(end.below(p)) < kNeckRing) ring.push_back(p);
  cut_neck(form, body, end);
  parts.push_back(smooth_solid(points_of(body, body::Segment::head, nullptr), cloth, kEggRounds));
  if (ring.empty()) return;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : ring) middle += p / static_cast<double>(ring.size());
  std::vector<Vec3> plug;
  for (const Vec3& p : ring) {
    const Vec3 from = p - middle, flat = from - from.dot(end.normal) * end.normal;
    plug.push_back(middle + kPlugFoot * flat - 0.3 * kPlug * end.normal);
    plug.push_back(middle + kPlugTop * flat + kPlug * end.normal);
  }
  parts.push_back(smooth_solid(plug, {}, 1));
}

}  // namespace

geometry::TriangleMesh mannequin(const body::Body& body, const garment::Garment& garment,
                                 const std::vector<Vec3>& positions,
                                 const geometry::TriangleMesh& under) {
  const geometry::TriangleMesh cloth = joined({positions, garment.triangles}, under);
  const geometry::ClosestPointTree skin(body.surface);
  const FormExtent extent = form_extent(body, skin, garment, positions, under.vertices);
  const geometry::TriangleMesh surface = smooth_surface(body, skin, cloth);
  CutForm form(surface);
  std::vector<geometry::TriangleMesh> parts;
  if (extent.legs)
    add_lasts(parts, body);
  else
    end_in_cloth(form, body, extent);
  if (extent.arms || !arms_hang(body, extent.axis))
    end_in_mittens(form, parts, body, cloth);
  else
    end_at_shoulders(form, body, surface);
  const auto neck = joint(body, "neck"), head = joint(body, "head");
  if (neck && head && *neck != *head) {
    const NeckCut end = neck_cut(body, *neck, *head, extent.axis);
    if (extent.head)
      end_in_egg(form, parts, body, end, cloth);
    else
      cut_neck(form, body, end);
  }
  geometry::TriangleMesh whole = form.mesh();
  for (const geometry::TriangleMesh& part : parts) whole = joined(whole, part);
  return whole;
}

}  // namespace loosefit::render
