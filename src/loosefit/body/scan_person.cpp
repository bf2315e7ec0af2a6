#include "loosefit/body/scan_person.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/body/body_check.h"
#include "loosefit/body/missing_limbs.h"
#include "loosefit/body/scan_parts.h"
#include "loosefit/body/stumps.h"
#include "loosefit/body/surface_topology.h"

namespace loosefit::body {
namespace {

constexpr double kWidestHole = 0.12, kMostFilled = 0.05;
constexpr double kRelaxed = radians(25);  // arms that hang lower are turned as people let them hang
constexpr double kUpright = radians(5);   // people differ by that when they stand upright
constexpr double kMostBent = radians(30);
constexpr double kLevel = radians(90);  // as far aside as arms can be asked for

// Of scans of people in tank top and leggings, T-shirt, hoodie or trousers 13 to 47 % stand off, of
// bare ones and of averages of other body models at most 2 % (docs/theory/body_model.md 8).
constexpr double kUsualStandOff = 0.04, kMostStandOff = 0.07;
// Of the neck alone: hair, scarves and hoods hide it, whatever else is bare.
constexpr double kMostStandOffNeck = 0.35;
constexpr double kLeastNeckSeen = 0.3;  // share of the neck that has to be there to tell
constexpr double kMostOffClothed =
    0.010;  // in the median, before the shift [m]: at most 6 mm there

/// Who lies so well on the model is a person of whom can be said what is missing [m].
constexpr RegistrationError kMostOffTold{0.006, 0.025};
constexpr double kMostForeign = 0.05;  // share of the area of parts that are not the person
constexpr double kMostInside = 0.2;    // share inside of others: more is a person twice

constexpr const char* kSides[] = {"_L", "_R"};

Vec3 between(const Body& body, const char* from, const char* to, const char* side) {
  return body.joints.at(std::string(to) + side) - body.joints.at(std::string(from) + side);
}

/// On average over the sides of the arms that have this joint, or over both where neither has it.
template <class Of>
double mean_of_arms(const Body& body, const char* joint, const Of& of) {
  double sum = 0, sum_of_all = 0;
  int count = 0;
  for (const char* side : kSides) {
    const double value = of(side);
    sum_of_all += value;
    if (is_beyond_end(body.joints, std::string(joint) + side)) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? sum / count : sum_of_all / 2;
}

/// Upper arm to the downward vertical, in the frontal plane.
double abduction(const Body& body) {
  return mean_of_arms(body, "elbow", [&](const char* side) {
    const Vec3 arm = between(body, "shoulder", "elbow", side);
    return std::atan2(std::abs(arm.x()), -arm.z());
  });
}

/// 0 is a straight arm.
double elbow_bend(const Body& body) {
  return mean_of_arms(body, "wrist", [&](const char* side) {
    const Vec3 upper = between(body, "shoulder", "elbow", side),
               fore = between(body, "elbow", "wrist", side);
    return std::atan2(upper.cross(fore).norm(), upper.dot(fore));
  });
}

/// Lean of the line from the back waist to C7, positive forward.
double lean(const Body& body) {
  const Vec3 back = body.landmarks.at("c7") - body.landmarks.at("back_waist");
  return std::atan2(-back.y(), back.z());
}

Posture nearest_posture(const Body& body, const Body& upright, const Body& rest) {
  Posture posture = kStanding;
  posture.elbow_extension = std::clamp(1 - elbow_bend(body) / elbow_bend(rest), 0.0, 1.0);
  const double bend = lean(body) - lean(upright);
  if (std::abs(bend) > kUpright) posture.forward_bend = std::clamp(bend, -kMostBent, kMostBent);
  posture.arm_abduction = std::clamp(abduction(body), radians(5), kLevel);
  if (posture.arm_abduction > kRelaxed) posture.relaxed_arms = 0;
  return posture;
}

const char* in_words(Segment segment) {
  switch (segment) {
    case Segment::neck:
      return "neck";
    case Segment::upper_arm:
      return "upper arms";
    case Segment::forearm:
      return "forearms";
    case Segment::thigh:
      return "thighs";
    case Segment::shank:
      return "lower legs";
    default:
      return "trunk";
  }
}

std::string off_in_words(const StandOff& off) {
  return fmt::format(
      "{:.0f} % of neck, trunk, arms and legs lie more than {:.0f} mm outside the person of the "
      "model who fits best, most of it at the {} ({:.0f} %)",
      100 * off.share, 1e3 * kStandOff, in_words(off.most), 100 * off.most_share);
}

InvalidInput clothed(const RegisteredPerson& registered, const ScanOptions& options) {
  return InvalidInput(
      {options.file, 0, ""},
      "clothes or hair that stand off the skin: " + off_in_words(registered.stand_off),
      "the skin of one person, bare or in tight clothes",
      "scan the person in tight clothes with the hair tied up, or make a body from measures "
      "instead");
}

/// Whether hair, a scarf or a hood lies where the skin of the neck would be.
bool hides_neck(const RegisteredPerson& registered) {
  return registered.of_model.median <= kMostOffClothed &&
         registered.stand_off.neck_seen >= kLeastNeckSeen &&
         registered.stand_off.neck_share > kMostStandOffNeck;
}

InvalidInput hidden_neck(const RegisteredPerson& registered, const ScanOptions& options) {
  return InvalidInput(
      {options.file, 0, ""},
      fmt::format("clothes or hair over the neck: {:.0f} % of it lie more than {:.0f} mm outside "
                  "the person of the model who fits best",
                  100 * registered.stand_off.neck_share, 1e3 * kStandOff),
      "the skin of one person with a bare neck",
      "scan the person with the hair tied up, or press the hair onto the skin of neck and back in "
      "a mesh editor (cut off or cropped, it leaves no skin to measure), or make a body from "
      "measures instead");
}

/// The person of a scan whose other parts are small and not the person.
std::optional<ScanPerson> person_without(const std::vector<ForeignPart>& foreign,
                                         const BodyModel& model, CheckedSurface checked,
                                         ScanOptions options) {
  double share = 0;
  for (const ForeignPart& part : foreign) share += part.share;
  if (share > kMostForeign)
    throw InvalidInput(
        {options.file, 0, ""},
        fmt::format("a surface that is not the person: {}{}", foreign.front().place,
                    foreign.size() > 1 ? fmt::format(" ({} such surfaces)", foreign.size()) : ""),
        "one person, in one surface or in parts",
        "delete what is not the person (floor, turntable, a second person)");
  std::vector<char> drop(checked.mesh.triangles.size(), 0);
  for (const ForeignPart& part : foreign)
    for (const int t : part.triangles) drop[std::size_t(t)] = 1;
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < drop.size(); ++t)
    if (!drop[t]) kept.push_back(checked.mesh.triangles[t]);
  checked.mesh.triangles = std::move(kept);
  options.units = "m", options.up = "z";
  std::optional<ScanPerson> made = person_from_scan(model, std::move(checked.mesh), options);
  if (!made) return made;
  made->body.from_world = made->body.from_world * checked.from_world;
  for (const ForeignPart& part : foreign)
    checked.warnings.push_back("a surface dropped that is not the person: " + part.place);
  made->warnings.insert(made->warnings.begin(), checked.warnings.begin(), checked.warnings.end());
  return made;
}

/// Head and a foot on the floor: without them nobody knows the stature, by which all else is told.
void require_whole_person(const RegisteredPerson& registered, const ScanOptions& options) {
  const std::vector<MissingLimb>& missing = registered.missing;
  const bool headless =
      std::ranges::any_of(missing, [](const MissingLimb& m) { return m.side == 0; });
  const auto legs = std::ranges::count_if(missing, [](const MissingLimb& m) { return m.of_leg(); });
  if (!headless && legs < 2) return;
  const bool form = missing.size() == 5;
  throw InvalidInput(
      {options.file, 0, ""},
      (form ? "a dress form or a trunk alone: " : "a person who is not there from head to foot: ") +
          in_words(missing),
      "one standing person with a head and at least one foot, whose height can be measured",
      form ? "scan a person, or make a body from the measures of the form"
           : "scan the whole person, hair tied up, or make a body from measures instead");
}

}  // namespace

std::optional<ScanPerson> person_from_scan(const BodyModel& model, geometry::TriangleMesh mesh,
                                           ScanOptions options) try {
  options.widest_hole = kWidestHole, options.most_filled = kMostFilled;
  options.tell_crossings = false;  // the model's skin is used, not the scan's
  options.take_parts = true;
  CheckedSurface checked = check_surface(std::move(mesh), options);
  const std::size_t parts = connected_pieces(checked.mesh).size();
  geometry::TriangleMesh skin = checked.mesh;
  if (parts > 1) {
    SkinOfParts outer = skin_of_parts(checked.mesh);
    if (outer.inside > kMostInside) return std::nullopt;
    skin = std::move(outer.mesh);
  }
  RegisteredPerson registered = register_person(model, skin);
  if (registered.error.median <= kMostOffTold.median && registered.error.p95 <= kMostOffTold.p95)
    require_whole_person(registered, options);
  if (hides_neck(registered)) throw hidden_neck(registered, options);
  const double off = registered.stand_off.share;
  if (!(registered.error.median <= kMostOff.median && registered.error.p95 <= kMostOff.p95)) {
    if (off > kMostStandOff && registered.of_model.median <= kMostOffClothed)
      throw clothed(registered, options);
    return std::nullopt;
  }
  ScanPerson made;
  made.body = model.build(registered.person);
  made.body.from_world = checked.from_world;
  if (const auto foreign = foreign_parts(checked.mesh, made.body.surface);
      parts > 1 && !foreign.empty())
    return person_without(foreign, model, std::move(checked), options);
  made.parameters = std::move(registered.person.parameters);
  made.posture = nearest_posture(made.body, model.build(made.parameters, kStanding),
                                 model.build(made.parameters, model.rest_posture(made.parameters)));
  made.error = registered.error;
  made.warnings = std::move(checked.warnings);
  if (parts > 1)
    made.warnings.push_back(
        fmt::format("{} surfaces are taken together as one person: what lies between them is the "
                    "body model's",
                    parts));
  made.warnings.push_back(
      fmt::format("the body model lies on the scan: {:.1f} mm off in the median, {:.1f} mm at the "
                  "95th percentile of neck, trunk, arms and legs",
                  1e3 * made.error.median, 1e3 * made.error.p95));
  if (!registered.missing.empty())
    made.warnings.push_back(fmt::format(
        "the scan has {}: the person is dressed without; garments hang there, and measures of that "
        "side are those of the other one, where it has them",
        in_words(registered.missing)));
  for (const ShortFoot& foot : registered.short_feet)
    made.warnings.push_back(
        fmt::format("the {} foot of the scan ends {:.2f} m before the toes: the forefoot is the "
                    "body model's",
                    foot.side > 0 ? "left" : "right", foot.by));
  if (registered.hands_left_out)
    made.warnings.push_back(
        "a hand is closed, ends in the palm, or is held in another way than the model's: both "
        "hands "
        "are the model's, and arms are as long as the skin above the hands tells");
  if (off > kUsualStandOff)
    made.warnings.push_back(
        "it is taken for skin, although " + off_in_words(registered.stand_off) +
        ": an unusual figure, or clothes, which would be measured and dressed as skin");
  return made;
} catch (const GeometryError&) {  // of check_surface, or of a tape that does not close
  return std::nullopt;
}

}  // namespace loosefit::body
