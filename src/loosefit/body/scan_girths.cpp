#include "loosefit/body/scan_girths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/body/scan_segments.h"
#include "loosefit/body/section.h"

namespace loosefit::body {
namespace {

/// What a tape meets at one level.
struct Cut {
  double z = 0;
  double girth = 0;
  double skin = 0;             ///< length of the section itself
  double left = 0, right = 0;  ///< reach from the midline
};

constexpr double kThinnest = 0.25;  // trunk, round it, share of the stature

class TrunkCuts {
 public:
  TrunkCuts(const ScanSections& s, const Body& body) : s_(s), body_(body) {
    for (std::size_t v = 0; v < body.segment.size(); ++v) {
      const Segment part = body.segment[v];
      on_arm_.push_back(part == Segment::upper_arm || part == Segment::forearm ||
                        part == Segment::hand);
    }
  }

  /// Nothing between the legs.
  std::optional<Cut> at(double z) const {
    const auto loops = plane_section(body_.surface, Vec3(0, 0, z), Vec3::UnitZ());
    const double middle = midline(z);
    const SectionLoop* trunk = trunk_loop(loops, middle);
    if (!trunk || trunk->length < kThinnest * s_.height) return std::nullopt;
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < trunk->points.size(); ++i) {
      const auto& [a, b] = trunk->edges[i];
      if (!on_arm_[std::size_t(a)] && !on_arm_[std::size_t(b)]) points.push_back(trunk->points[i]);
    }
    Cut cut;
    cut.z = z;
    cut.girth = hull_perimeter(points, Vec3::UnitZ());
    for (std::size_t i = 0; i < points.size(); ++i) {
      cut.skin += (points[(i + 1) % points.size()] - points[i]).norm();
      cut.left = std::max(cut.left, points[i].x() - middle);
      cut.right = std::max(cut.right, middle - points[i].x());
    }
    return cut;
  }

  double step() const { return s_.height / kSliceCount; }

  std::optional<Cut> fullest(double low, double high) const {
    const int steps = int(std::ceil((high - low) / step()));
    std::optional<Cut> best;
    for (int i = 0; i <= steps; ++i) {
      const auto cut = at(low + (high - low) * i / steps);
      if (cut && (!best || cut->girth > best->girth)) best = cut;
    }
    return best;
  }

  /// Greatest change of the girth from one cut to the next, within 1.5 % of the stature and clear
  /// of crotch and armpits.
  double jump_near(double z) const {
    const double low = std::max(z - 0.015 * s_.height, s_.crotch + 0.01 * s_.height);
    const double high = std::min(z + 0.015 * s_.height, s_.armpit - 0.02 * s_.height);
    double most = 0;
    std::optional<Cut> before = at(low);
    for (double next = low + step(); next <= high; next += step()) {
      const std::optional<Cut> cut = at(next);
      if (cut && before)
        most = std::max(most,
                        std::abs(cut->girth - before->girth) / std::min(cut->girth, before->girth));
      before = cut;
    }
    return most;
  }

 private:
  /// From between the legs to the neck.
  double midline(double z) const {
    const double neck_x = centre_at(s_, s_.neck).x();
    const double share = std::clamp((z - s_.crotch) / (s_.neck - s_.crotch), 0., 1.);
    return s_.crotch_x + share * (neck_x - s_.crotch_x);
  }

  const ScanSections& s_;
  const Body& body_;
  std::vector<char> on_arm_;
};

/// Where the parametric body has its waist, at 0.598 to 0.624 of the stature and 0.49 to 0.55 of
/// the way from crotch to armpit (women, men and children, slim and stout): the mean of the two
/// shares is within 0.8 % of the stature.
double natural_waist(const ScanSections& s) {
  constexpr double kOfStature = 0.612, kOfTrunk = 0.505;
  return 0.5 * (kOfStature * s.height + s.crotch + kOfTrunk * (s.armpit - s.crotch));
}

// What trunks show at most. On parametric ones (women, men and children, slim and stout) a tape
// covers 0.986 of the skin, across the buttocks 0.945; from one cut to the next it changes by 3 %.
constexpr double kLeastSkin = 0.95, kLeastSkinOfHip = 0.90, kMostAside = 1.25, kMostJump = 0.06;

/// Two signs that something else is in the section are one too many; one may be the person's own.
TrunkTape checked(const TrunkCuts& cuts, const std::optional<Cut>& taped, const std::string& name,
                  std::vector<std::string>& warnings) {
  if (!taped)
    throw GeometryError("found no closed section round the trunk at the " + name,
                        "look for gaps in the surface there");
  const Cut& cut = *taped;
  std::vector<std::string> signs;
  const double skin = cut.girth / cut.skin, jump = cuts.jump_near(cut.z);
  const double aside = std::max(cut.left, cut.right) / std::min(cut.left, cut.right);
  if (skin < (name == "hip" ? kLeastSkinOfHip : kLeastSkin))
    signs.push_back(fmt::format("the skin there is {:.0f} % longer", 100 / skin - 100));
  if (!(aside <= kMostAside))
    signs.push_back(
        fmt::format("it reaches {:.2f} m to the left of the midline and {:.2f} m to "
                    "the right",
                    cut.left, cut.right));
  if (jump > kMostJump)
    signs.push_back(fmt::format("it changes by {:.0f} % within {:.0f} mm of height", 100 * jump,
                                1000 * cuts.step()));
  if (signs.empty()) return {cut.z, cut.girth};
  std::string what = fmt::format(
      "a {} of {:.2f} m, taped {:.2f} m above the floor, that seems to "
      "go round more than the trunk",
      name, cut.girth, cut.z);
  for (std::size_t i = 0; i < signs.size(); ++i) what += (i == 0 ? ": " : ", and ") + signs[i];
  if (signs.size() > 1)
    throw GeometryError("found " + what,
                        "look for a hand, an arm or a thing held that has grown together with the "
                        "trunk there and cut it apart, or make a body from measures instead");
  warnings.push_back(what);
  return {cut.z, cut.girth};
}

}  // namespace

TrunkTapes tape_trunk(const ScanSections& s, const Body& labelled,
                      std::vector<std::string>& warnings) {
  const TrunkCuts cuts(s, labelled);
  const double h = s.height;
  TrunkTapes tapes;
  tapes.chest =
      checked(cuts, cuts.fullest(s.armpit - 0.07 * h, s.armpit - 0.02 * h), "chest", warnings);
  tapes.waist = checked(cuts, cuts.at(natural_waist(s)), "waist", warnings);
  tapes.hip =
      checked(cuts, cuts.fullest(s.crotch + 0.01 * h, s.crotch + 0.10 * h), "hip", warnings);
  return tapes;
}

}  // namespace loosefit::body
