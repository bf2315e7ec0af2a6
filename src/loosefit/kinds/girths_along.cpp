#include "loosefit/kinds/girths_along.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/body/floor_under.h"
#include "loosefit/body/section.h"
#include "loosefit/body/stumps.h"
#include "loosefit/body/tape_paths.h"
#include "loosefit/kinds/fit_stations.h"

namespace loosefit::kinds {
namespace {

double measure(const body::Body& body, const char* name) {
  const auto found = body.measured.find(name);
  return found == body.measured.end() ? 0 : found->second;
}

/// Trunk of the body by length of a tape down the back.
class TrunkTape {
 public:
  explicit TrunkTape(const body::Body& body) : body_(body), hps_(body.landmarks.at("hps_L")) {
    // A tape gets longer by at least what it goes down: heights a few centimetres apart will do.
    constexpr double kStep = 0.03;
    const double lowest = body.joints.at("hip_L").z() - 0.10;
    for (double z = hps_.z() - kStep; z > lowest; z -= kStep)
      down_.push_back({body::back_tape(body.surface, hps_, z), z});
  }

  double height(double along) const {
    for (std::size_t i = 1; i < down_.size(); ++i) {
      const auto& [a, za] = down_[i - 1];
      const auto& [b, zb] = down_[i];
      if (along <= b) return za + (along - a) / (b - a) * (zb - za);
    }
    return down_.back()[1];
  }
  double length() const { return down_.back()[0]; }
  /// 0 where the section would go through the arms too, and below the crotch.
  double girth(double along) const {
    constexpr double kMost = 1.15;  // of the fullest girth
    double fullest = 0;
    for (const char* name : {"chest", "waist", "hip"})
      fullest = std::max(fullest, measure(body_, name));
    try {
      const double girth = body::trunk_girth(body_.surface, height(along));
      return fullest == 0 || girth < kMost * fullest ? girth : 0;
    } catch (const GeometryError&) {
      return 0;
    }
  }

 private:
  const body::Body& body_;
  Vec3 hps_;
  std::vector<std::array<double, 2>> down_;  // length of the tape, height z
};

/// One arm, bent as it is.
class Arm {
 public:
  Arm(const body::Body& body, const std::string& side)
      : body_(body),
        shoulder_(body.joints.at("shoulder" + side)),
        elbow_(body.joints.at("elbow" + side)),
        wrist_(body.joints.at("wrist" + side)),
        length_(body.measured.at("arm_length")) {
    const auto measured = body.measured.find("elbow_length");
    const double upper = (elbow_ - shoulder_).norm(), fore = (wrist_ - elbow_).norm();
    to_elbow_ =
        measured != body.measured.end() ? measured->second : length_ * upper / (upper + fore);
  }
  double to_elbow() const { return to_elbow_; }
  double length() const { return length_; }

  /// 0 where the section would go round the trunk too.
  double girth(double along) const {
    constexpr double kRound = 0.03, kMost = 1.35;  // bend of the elbow [m]; of the upper arm
    const Vec3 upper = (elbow_ - shoulder_).normalized(), fore = (wrist_ - elbow_).normalized();
    const Vec3 place =
        along < to_elbow_
            ? Vec3(shoulder_ + along / to_elbow_ * (elbow_ - shoulder_))
            : Vec3(elbow_ + (along - to_elbow_) / (length_ - to_elbow_) * (wrist_ - elbow_));
    const double turn = std::clamp(0.5 + 0.5 * (along - to_elbow_) / kRound, 0.0, 1.0);
    try {
      const double girth =
          body::girth_round(body_.surface, place, (1 - turn) * upper + turn * fore);
      return girth < kMost * body_.measured.at("upper_arm") ? girth : 0;
    } catch (const GeometryError&) {
      return 0;
    }
  }

 private:
  const body::Body& body_;
  Vec3 shoulder_, elbow_, wrist_;
  double length_, to_elbow_ = 0;
};

bool has_all(const std::map<std::string, Vec3>& places, std::initializer_list<const char*> names) {
  return std::all_of(names.begin(), names.end(),
                     [&](const char* n) { return places.count(n) > 0; });
}

/// The arms that are whole; where none is, what there is of both.
std::vector<Arm> arms_of(const body::Body& body) {
  std::vector<Arm> arms, parts;
  if (!(measure(body, "arm_length") > 0 && measure(body, "upper_arm") > 0)) return arms;
  for (const std::string side : {"_L", "_R"}) {
    const bool has_joints = body.joints.contains("shoulder" + side) &&
                            body.joints.contains("elbow" + side) &&
                            body.joints.contains("wrist" + side);
    if (!has_joints) continue;
    (body::is_beyond_end(body.joints, "hand" + side) ? parts : arms).emplace_back(body, side);
  }
  return arms.empty() ? parts : arms;
}

/// Legs of a body by how far down from the crotch.
class Legs {
 public:
  explicit Legs(const body::Body& body)
      : body_(body), crotch_(body.measured.at("crotch_height")), floor_(*body::floor_under(body)) {}

  double length() const { return crotch_; }
  /// 0 where the section would go round both legs.
  double girth(double along) const {
    constexpr double kMost = 0.85;  // of the hip, round one leg
    double largest = 0;
    for (const std::string side : {"_L", "_R"}) try {
        const Vec3 hip = body_.joints.at("hip" + side), knee = body_.joints.at("knee" + side),
                   ankle = body_.joints.at("ankle" + side);
        const double z = floor_ + crotch_ - along;
        const bool thigh = z > knee.z();
        const Vec3 &above = thigh ? hip : knee, &below = thigh ? knee : ankle;
        const double share = std::clamp((above.z() - z) / (above.z() - below.z()), 0.0, 1.0);
        Vec3 place = above + share * (below - above);
        place.z() = z;
        largest = std::max(largest, body::girth_round(body_.surface, place, Vec3::UnitZ()));
      } catch (const GeometryError&) {
      }
    const double hip = measure(body_, "hip");
    return hip == 0 || largest < kMost * hip ? largest : 0;
  }

 private:
  const body::Body& body_;
  double crotch_, floor_;
};

/// What `girth` tells at round multiples of the step: the longest stretch without a gap.
GirthLine line_of(double last, const std::function<double(double)>& girth) {
  GirthLine longest, line;
  for (int k = 0; k * kStationStep <= last; ++k) {
    const double here = girth(k * kStationStep);
    if (here > 0)
      line.push_back({k * kStationStep, here});
    else
      line.clear();
    if (line.size() > longest.size()) longest = line;
  }
  return longest;
}

}  // namespace

GirthsAlong girths_along(const body::Body& open) {
  GirthsAlong girths;
  if (has_all(open.landmarks, {"hps_L"}) && has_all(open.joints, {"hip_L"})) {
    const TrunkTape trunk(open);
    const double chest = measure(open, "chest"), level = measure(open, "chest_level");
    const std::optional<double> floor = body::floor_under(open);
    girths.trunk = line_of(trunk.length(), [&](double along) {
      const double here = trunk.girth(along);
      const bool above = chest > 0 && level > 0 && floor && trunk.height(along) > level + *floor;
      return here > 0 && above ? chest : here;
    });
  }
  if (const std::vector<Arm> arms = arms_of(open); !arms.empty())
    girths.arm = line_of(arms[0].length(), [&](double along) {
      double largest = 0;
      for (const Arm& arm : arms) largest = std::max(largest, arm.girth(along));
      // What ends at the wrist is cut for its measure.
      const bool at_wrist = along > arms[0].length() - 0.5 * kStationStep;
      return at_wrist && measure(open, "wrist") > 0 ? measure(open, "wrist") : largest;
    });
  if (measure(open, "crotch_height") > 0 && body::floor_under(open) &&
      has_all(open.joints, {"hip_L", "hip_R", "knee_L", "knee_R", "ankle_L", "ankle_R"})) {
    const Legs legs(open);
    girths.leg = line_of(legs.length(), [&](double along) { return legs.girth(along); });
  }
  return girths;
}

}  // namespace loosefit::kinds
