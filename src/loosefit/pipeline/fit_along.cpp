#include "loosefit/pipeline/fit_along.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/body/section.h"
#include "loosefit/body/stumps.h"
#include "loosefit/body/tape_paths.h"

namespace loosefit::pipeline {
namespace {

/// A place with its level, for the names of stations.
struct NamedLevel {
  const char* name;
  double along;
};

const char* nearest_name(const std::vector<NamedLevel>& levels, double along) {
  const auto nearer = [&](const NamedLevel& a, const NamedLevel& b) {
    return std::abs(a.along - along) < std::abs(b.along - along);
  };
  return std::min_element(levels.begin(), levels.end(), nearer)->name;
}

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

}  // namespace

std::vector<StationFit> fit_along(const std::vector<kinds::FitStation>& stations,
                                  const body::Body& body) {
  std::vector<StationFit> fits;
  std::optional<TrunkTape> trunk;
  if (has_all(body.landmarks, {"hps_L"}) && has_all(body.joints, {"hip_L"})) trunk.emplace(body);
  const std::vector<Arm> arms = arms_of(body);
  const double waist = measure(body, "hps_to_waist"), hip = measure(body, "hps_to_hip");
  for (const kinds::FitStation& s : stations) {
    StationFit fit{s.limb, "", s.along, s.garment, 0, s.asked};
    if (s.limb == "trunk" && trunk && waist > 0 && hip > 0) {
      fit.body = trunk->girth(s.along);
      fit.place = nearest_name({{"chest", 0.55 * waist}, {"waist", waist}, {"hip", hip}}, s.along);
    } else if (s.limb == "arm" && !arms.empty()) {
      for (const Arm& arm : arms) fit.body = std::max(fit.body, arm.girth(s.along));
      const double length = arms[0].length(), to_elbow = arms[0].to_elbow();
      fit.place = nearest_name({{"upper arm", 0.5 * to_elbow},
                                {"elbow", to_elbow},
                                {"forearm", to_elbow + 0.35 * (length - to_elbow)},
                                {"wrist", length}},
                               s.along);
    }
    if (fit.body > 0) fits.push_back(fit);
  }
  return fits;
}

}  // namespace loosefit::pipeline
