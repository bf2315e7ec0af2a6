#include "loosefit/body/scan_person.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/body/body_check.h"

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

constexpr const char* kSides[] = {"_L", "_R"};

Vec3 between(const Body& body, const char* from, const char* to, const char* side) {
  return body.joints.at(std::string(to) + side) - body.joints.at(std::string(from) + side);
}

/// Of both arms on average: upper arm to the downward vertical, in the frontal plane.
double abduction(const Body& body) {
  double sum = 0;
  for (const char* side : kSides) {
    const Vec3 arm = between(body, "shoulder", "elbow", side);
    sum += std::atan2(std::abs(arm.x()), -arm.z());
  }
  return sum / 2;
}

/// Of both elbows on average; 0 is a straight arm.
double elbow_bend(const Body& body) {
  double sum = 0;
  for (const char* side : kSides) {
    const Vec3 upper = between(body, "shoulder", "elbow", side),
               fore = between(body, "elbow", "wrist", side);
    sum += std::atan2(upper.cross(fore).norm(), upper.dot(fore));
  }
  return sum / 2;
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

}  // namespace

std::optional<ScanPerson> person_from_scan(const BodyModel& model, geometry::TriangleMesh mesh,
                                           ScanOptions options) try {
  options.widest_hole = kWidestHole, options.most_filled = kMostFilled;
  options.tell_crossings = false;  // the model's skin is used, not the scan's
  CheckedSurface checked = check_surface(std::move(mesh), options);
  RegisteredPerson registered = register_person(model, checked.mesh);
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
  made.parameters = std::move(registered.person.parameters);
  made.posture = nearest_posture(made.body, model.build(made.parameters, kStanding),
                                 model.build(made.parameters, model.rest_posture(made.parameters)));
  made.error = registered.error;
  made.warnings = std::move(checked.warnings);
  made.warnings.push_back(
      fmt::format("the body model lies on the scan: {:.1f} mm off in the median, {:.1f} mm at the "
                  "95th percentile of neck, trunk, arms and legs",
                  1e3 * made.error.median, 1e3 * made.error.p95));
  if (registered.hands_left_out)
    made.warnings.push_back(
        "a hand is closed, missing or held in another way than the model's: both hands are the "
        "model's, and arms are as long as the skin above the hands tells");
  if (off > kUsualStandOff)
    made.warnings.push_back(
        "it is taken for skin, although " + off_in_words(registered.stand_off) +
        ": an unusual figure, or clothes, which would be measured and dressed as skin");
  return made;
} catch (const GeometryError&) {  // of check_surface, or of a tape that does not close
  return std::nullopt;
}

}  // namespace loosefit::body
