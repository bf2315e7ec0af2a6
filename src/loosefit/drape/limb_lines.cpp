#include "loosefit/drape/limb_lines.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "loosefit/body/stumps.h"

namespace loosefit::drape {
namespace {

constexpr double kChest = 0.6;   ///< of the way from hip to neck, where limbs begin: a neckline may
                                 ///< slip past the neck's own joint
constexpr double kAbove = 0.5;   ///< of the way from hip to neck, beyond the neck: over the crown
constexpr double kHand = 0.8;    ///< of the forearm's length, from the wrist to past the fingertips
constexpr double kStump = 0.02;  ///< beyond the end of a limb that is missing from there on [m]
constexpr double kFoot = 1.5;  ///< of the shank's length, beyond the ankle: hems reach to the floor

/// Of the discs' middles, so that a limb in the very middle does not meet all spokes at once [m].
const Vec3 kOff(1.3e-4, 1.7e-4, 1.1e-4);

/// +1 or −1 where the way from p to q goes through the triangle, 0 where it does not.
int crossing(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto volume = [](const Vec3& u, const Vec3& v, const Vec3& w) { return u.dot(v.cross(w)); };
  const bool from = volume(a - p, b - p, c - p) > 0, to = volume(a - q, b - q, c - q) > 0;
  if (from == to) return 0;
  const Vec3 way = q - p;
  const bool ab = volume(way, a - p, b - p) > 0, bc = volume(way, b - p, c - p) > 0,
             ca = volume(way, c - p, a - p) > 0;
  if (ab != bc || bc != ca) return 0;
  return from ? 1 : -1;
}

/// Ends the line of joints where its limb does. `names`: of its points.
void end_at_stump(std::vector<Vec3>& line, const std::vector<std::string>& names,
                  const std::string& end, const std::map<std::string, Vec3>& at) {
  const auto stump = at.find(end);
  if (stump == at.end()) return;
  std::size_t kept = 0;
  while (kept < names.size() && !body::is_beyond_end(at, names[kept])) ++kept;
  // A joint next to the end would turn the line back.
  while (kept > 2 && (line[kept - 1] - stump->second).norm() < 2 * kStump) --kept;
  line.resize(kept);
  const Vec3 along = (stump->second - line.back()).normalized();
  line.push_back(stump->second + kStump * along);
}

LimbNumbers normal_form(LimbNumbers n) {
  const auto how_many = [&](int value) { return std::count(n.begin(), n.end(), value); };
  const int most = *std::max_element(n.begin(), n.end(),
                                     [&](int a, int b) { return how_many(a) < how_many(b); });
  for (int& k : n) k -= most;
  const auto first = std::find_if(n.begin(), n.end(), [](int k) { return k != 0; });
  if (first != n.end() && *first < 0)
    for (int& k : n) k = -k;
  return n;
}

}  // namespace

LimbLines limb_lines(const body::Body& body) { return limb_lines(body.joints); }

LimbLines limb_lines(const std::map<std::string, Vec3>& at) {
  LimbLines lines;
  for (const std::string side : {"_L", "_R"})
    for (const char* joint : {"shoulder", "elbow", "wrist", "hip", "knee", "ankle"})
      if (!at.count(joint + side)) return lines;
  if (!at.count("neck")) return lines;
  const Vec3 neck = at.at("neck"), hip = 0.5 * (at.at("hip_L") + at.at("hip_R"));
  const Vec3 chest = hip + kChest * (neck - hip);
  lines[kHead] = {chest, neck, neck + kAbove * (neck - hip)};
  for (const auto& [side, arm, leg] : {std::tuple(std::string("_L"), kLeftArm, kLeftLeg),
                                       {std::string("_R"), kRightArm, kRightLeg}}) {
    const Vec3 elbow = at.at("elbow" + side), wrist = at.at("wrist" + side);
    const Vec3 knee = at.at("knee" + side), ankle = at.at("ankle" + side);
    // Straight on through the hand's joint, be that in the palm or at the fingertips.
    const auto hand = at.find("hand" + side);
    Vec3 along = wrist - elbow;
    const double reach = kHand * along.norm();
    double known = 0;
    if (hand != at.end() && (hand->second - wrist).norm() > 1e-3)
      along = hand->second - wrist, known = along.norm();
    const Vec3 tip = wrist + std::max(reach, known) * along.normalized();
    lines[arm] = {chest, at.at("shoulder" + side), elbow, wrist, tip};
    lines[leg] = {chest, hip, at.at("hip" + side), knee, ankle, ankle + kFoot * (ankle - knee)};
    end_at_stump(lines[arm], {"chest", "shoulder" + side, "elbow" + side, "wrist" + side},
                 "arm_end" + side, at);
    end_at_stump(lines[leg], {"chest", "hips", "hip" + side, "knee" + side, "ankle" + side},
                 "leg_end" + side, at);
  }
  return lines;
}

bool lacks_end(Limb limb, const body::Body& body) {
  constexpr const char* kEnds[] = {"", "arm_end_L", "arm_end_R", "leg_end_L", "leg_end_R"};
  return body.joints.count(kEnds[limb]) > 0;
}

LimbNumbers limbs_through_openings(const std::vector<int>& loop, const std::vector<Vec3>& x,
                                   const LimbLines& lines) {
  Vec3 middle = kOff;
  for (int v : loop) middle += x[v] / static_cast<double>(loop.size());
  LimbNumbers numbers{};
  for (int limb = 0; limb < kLimbs; ++limb)
    for (std::size_t i = 0; i + 1 < lines[limb].size(); ++i)
      for (std::size_t k = 0; k < loop.size(); ++k)
        numbers[limb] += crossing(lines[limb][i], lines[limb][i + 1], middle, x[loop[k]],
                                  x[loop[(k + 1) % loop.size()]]);
  return normal_form(numbers);
}

LimbNumbers round_limb(Limb limb) {
  LimbNumbers numbers{};
  numbers[limb] = 1;
  return numbers;
}

const char* limb_name(Limb limb) {
  static const char* const names[] = {"the head", "the left arm", "the right arm", "the left leg",
                                      "the right leg"};
  return names[limb];
}

std::string round_what(const LimbNumbers& numbers) {
  if (numbers == kRoundTrunk) return "the trunk";
  if (numbers == kRoundNothing) return "no part of the body";
  std::string text;
  for (int limb = 0; limb < kLimbs; ++limb)
    if (numbers[limb] != 0)
      text += (text.empty() ? "" : " and ") + std::string(limb_name(Limb(limb)));
  return text;
}

}  // namespace loosefit::drape
