#include "loosefit/pattern/known_half_sleeves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "loosefit/base/text.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

constexpr double kMostEase = 0.15;  // of a cap over its armhole
constexpr double kAsLong = 0.01;    // seams on top and below tell no hand within it [m]
constexpr double kAcross = 0.1;     // counted against a cap that runs along the grain

double difference(double a, double b) { return std::abs(a - b) / std::max({a, b, 1e-9}); }

struct Half {
  int panel = 0;
  bool front = false;
  int side = 0;
  Section cap, underarm, end, top;
  bool upright = true;
};

/// \param hole length of the side of the armhole that it is sewn to [m]
std::optional<Half> as_half(const Pattern& pattern, int panel, bool front, double hole) {
  const std::vector<Section> s = outline_sections(pattern.panels[panel]);
  if (s.size() != 4) return {};
  const auto height = [&](std::size_t i) { return (s[i % 4].from + s[i % 4].to).y(); };
  const auto unlike = [&](std::size_t i) {
    // Cap and end are farther apart along the grain than the seams on top and below are.
    const bool end_on =
        std::abs(height(i) - height(i + 2)) > std::abs(height(i + 1) - height(i + 3));
    return difference(s[i].length, hole) + (end_on ? 0 : kAcross);
  };
  std::size_t cap = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (unlike(i) < unlike(cap)) cap = i;
  if (unlike(cap) > kMostEase) return {};
  const Section &next = s[(cap + 1) % 4], &before = s[(cap + 3) % 4];
  const bool top_next = next.length > before.length;
  Half half{panel,
            front,
            0,
            s[cap],
            top_next ? before : next,
            s[(cap + 2) % 4],
            top_next ? next : before};
  // Seen from outside, the underarm comes next after the cap of a left front and a right back.
  half.side = top_next == front ? -1 : 1;
  half.upright = (half.cap.from + half.cap.to).y() > (half.end.from + half.end.to).y();
  return half;
}

}  // namespace

KnownHalfSleeves know_half_sleeves(const Pattern& pattern, const std::vector<int>& panels,
                                   const OpenArmhole& left, const OpenArmhole& right) {
  KnownHalfSleeves known;
  // By hand, left and right, then front and back.
  std::array<std::array<std::optional<Half>, 2>, 2> halves;
  for (const int p : panels) {
    const PieceWords w = words_of(pattern.panels[p]);
    if (!w.sleeve || w.cuff || w.front == w.back) continue;
    const OpenArmhole& either = w.right ? right : left;
    auto half =
        as_half(pattern, p, w.front, chain_length(pattern, w.front ? either.front : either.back));
    if (!half) return {};
    if (const int name = int(w.left) - int(w.right); name != 0 && name != half->side) {
      known.doubts.push_back("piece " + printable(pattern.panels[p].name) +
                             ": its name and its outline say different arms");
      half->side = name;
    } else if (name == 0 && std::abs(half->top.length - half->underarm.length) < kAsLong) {
      known.doubts.push_back(
          "piece " + printable(pattern.panels[p].name) +
          ": its two seams are as long, which lies on top of the arm is not told");
    }
    std::optional<Half>& of = halves[half->side > 0 ? 0 : 1][w.front ? 0 : 1];
    if (of) return {};
    of = std::move(half);
  }
  for (const auto& pair : halves)
    if (!pair[0] || !pair[1]) return {};
  for (int i = 0; i < 2; ++i) {
    const Half &front = *halves[i][0], &back = *halves[i][1];
    const OpenArmhole& hole = i == 0 ? left : right;
    const std::string name = i == 0 ? "_L" : "_R";
    const auto sides = [&](const Half& half, const Section& of) {
      return of.sides(pattern.panels[half.panel], half.panel);
    };
    known.seams.push_back({"armhole_front" + name, sides(front, front.cap), hole.front, false});
    known.seams.push_back({"armhole_back" + name, sides(back, back.cap), hole.back, false});
    known.seams.push_back(
        {"underarm" + name, sides(front, front.underarm), sides(back, back.underarm), false});
    known.seams.push_back(
        {"sleeve_top" + name, sides(front, front.top), sides(back, back.top), false});
    OpenLoop end{"wrist" + name, LoopKind::wrist, i == 0 ? 1 : -1, sides(front, front.end)};
    const auto behind = sides(back, back.end);
    end.edges.insert(end.edges.end(), behind.begin(), behind.end());
    known.loops.push_back(std::move(end));
    for (const Half* half : {&front, &back})
      known.pieces.emplace_back(half->panel,
                                KnownPiece{PieceRole::half_sleeve,
                                           half->side,
                                           half->upright,
                                           {half->cap, half->underarm, half->end, half->top}});
  }
  return known;
}

}  // namespace loosefit::pattern
