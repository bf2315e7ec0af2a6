#include "loosefit/drape/cut_on_sleeves.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/drape/openings.h"

namespace loosefit::drape {
namespace {

constexpr double kBeyondShoulder = 0.10;  ///< of an armhole that is a cuff [m]

std::set<int> panels_of(const Opening& opening, const garment::Garment& garment) {
  std::set<int> panels;
  for (const int v : opening.loop) panels.insert(garment.vertex_panel[v]);
  return panels;
}

}  // namespace

std::optional<double> cut_on_sleeve_angle(const garment::Garment& garment,
                                          const pattern::Pattern& pattern,
                                          const body::PosedBody& body) {
  const auto left = body->landmarks.find("acromion_L"), right = body->landmarks.find("acromion_R");
  if (left == body->landmarks.end() || right == body->landmarks.end()) return {};
  const double tip = 0.5 * (left->second.x() - right->second.x());
  const std::vector<Vec3> placed = placed_by_pattern(garment, pattern);
  const std::vector<Opening> openings = garment_openings(garment, pattern, body);
  const auto of_use = [&](kinds::OpeningUse use) {
    const auto found = std::ranges::find(openings, use, &Opening::use);
    return found == openings.end() ? nullptr : &*found;
  };
  const Opening *neck = of_use(kinds::OpeningUse::neck), *hem = of_use(kinds::OpeningUse::hem);
  if (!neck || !hem || placed.empty()) return {};
  const std::set<int> trunk = panels_of(*hem, garment);  // raglan sleeves reach the neck, too
  double sum = 0;
  for (const int side : {1, -1}) {
    const Opening* cuff =
        of_use(side > 0 ? kinds::OpeningUse::left_arm : kinds::OpeningUse::right_arm);
    if (!cuff || !std::ranges::includes(trunk, panels_of(*cuff, garment))) return {};
    const auto out = [&](int v) { return side * (placed[v].x() - neck->placed.x()); };
    const auto farther = [&](int a, int b) { return out(a) < out(b); };
    if (out(*std::ranges::min_element(cuff->loop, farther)) < tip + kBeyondShoulder) return {};
    const auto lower = [&](int a, int b) { return placed[a].z() < placed[b].z(); };
    const int from = *std::ranges::max_element(neck->loop, farther),
              to = *std::ranges::max_element(cuff->loop, lower);
    sum += std::atan2(out(to) - out(from), placed[from].z() - placed[to].z());
  }
  return sum / 2;
}

}  // namespace loosefit::drape
