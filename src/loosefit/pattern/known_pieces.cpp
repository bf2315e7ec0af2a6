#include "loosefit/pattern/known_pieces.h"

#include <algorithm>
#include <cmath>

namespace loosefit::pattern {
namespace {

constexpr double kSameLength = 0.02;  // of lengths that mirror each other
constexpr double kCapBulge = 0.08;    // of a sleeve's cap, at least
constexpr double kAlike = 0.01;       // lengths of pieces that are [m]
constexpr double kShortLeg = 0.4;     // of an outseam not told from the hem by lengths
constexpr double kConcave = -0.01;    // bulge of what is cut out
constexpr double kOverHead = 0.1;     // bulge by which the back of a hood is told from its face
constexpr double kLongerThanWide = 2.5;
constexpr double kEndsAlike = 0.05, kSidesAlike = 0.15;  // of strips, relative differences
constexpr double kStraightEnd = 0.05;                    // bulge of an end, at most

double difference(double a, double b) { return std::abs(a - b) / std::max({a, b, 1e-9}); }

/// Sections counted from `first` on.
std::vector<Section> from(const std::vector<Section>& sections, std::size_t first) {
  std::vector<Section> turned = sections;
  std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
  return turned;
}

Vec2 middle(const Section& s) { return (s.from + s.to) / 2; }

}  // namespace

bool are_alike(const KnownPiece& a, const KnownPiece& b) {
  return std::ranges::equal(a.sections, b.sections, [](const Section& s, const Section& t) {
    return std::abs(s.length - t.length) < kAlike &&
           std::abs(s.bulge - t.bulge) * s.length < kAlike;
  });
}

std::optional<KnownPiece> as_trunk(const std::vector<Section>& sections) {
  const std::size_t n = sections.size(), across = n / 2;
  if (n != 6 && n != 8) return {};
  double best = kSameLength;
  std::optional<KnownPiece> found;
  for (std::size_t i = 0; i < across; ++i) {
    double worst = 0;
    for (std::size_t k = 1; k < across; ++k)
      worst = std::max(worst,
                       difference(sections[(i + k) % n].length, sections[(i + n - k) % n].length));
    if (worst >= best) continue;
    const bool hem_first = sections[i].chord() > sections[i + across].chord();
    KnownPiece piece;
    piece.sections = from(sections, hem_first ? i : i + across);
    const auto& s = piece.sections;
    // A neckline and armholes are cut out, a hem is not.
    if (s[across].bulge > -kConcave || s[2].bulge > kCapBulge || s[n - 2].bulge > kCapBulge)
      continue;
    piece.upright = middle(s[across]).y() > middle(s[0]).y();
    best = worst;
    found = piece;
  }
  return found;
}

std::optional<KnownPiece> as_raglan_sleeve(const std::vector<Section>& sections) {
  if (sections.size() != 6) return {};
  std::size_t neck = 0;
  for (std::size_t i = 1; i < 6; ++i)
    if (sections[i].length < sections[neck].length) neck = i;
  KnownPiece piece;
  piece.role = PieceRole::sleeve;
  piece.sections = from(sections, (neck + 3) % 6);
  const auto& s = piece.sections;
  if (difference(s[1].length, s[5].length) > kSameLength) return {};
  piece.upright = middle(s[3]).y() > middle(s[0]).y();
  return piece;
}

std::optional<KnownPiece> as_sleeve(const std::vector<Section>& sections) {
  if (sections.size() != 4) return {};
  std::optional<KnownPiece> found;
  for (std::size_t i = 0; i < 4; ++i) {
    const Section &cuff = sections[i], &cap = sections[(i + 2) % 4];
    if (cap.bulge < kCapBulge || cap.bulge < cuff.bulge + kCapBulge ||
        difference(sections[(i + 1) % 4].length, sections[(i + 3) % 4].length) > kSameLength)
      continue;
    if (found) return {};
    KnownPiece piece;
    piece.role = PieceRole::sleeve;
    piece.sections = from(sections, i);
    piece.upright = middle(cap).y() > middle(cuff).y();
    found = piece;
  }
  return found;
}

std::optional<KnownPiece> as_skirt(const std::vector<Section>& sections) {
  if (sections.size() != 4) return {};
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (middle(sections[i]).y() < middle(sections[lowest]).y()) lowest = i;
  KnownPiece piece;
  piece.sections = from(sections, lowest);
  if (difference(piece.sections[1].length, piece.sections[3].length) > kSameLength) return {};
  return piece;
}

std::optional<KnownPiece> as_leg(const std::vector<Section>& sections) {
  if (sections.size() != 5) return {};
  std::size_t cut_out = 0;
  for (std::size_t i = 1; i < 5; ++i)
    if (sections[i].bulge < sections[cut_out].bulge) cut_out = i;
  // Hem and outseam are not next to the crotch. The outseam is longer than the hem of all but short
  // trousers, and runs along the warp, y, where the hem runs across.
  const std::size_t a = (cut_out + 2) % 5, b = (cut_out + 3) % 5;
  const auto outseam_is = [&](std::size_t i, std::size_t hem) {
    const Section &s = sections[i], &h = sections[hem];
    if (difference(s.length, h.length) > kShortLeg) return s.length > h.length;
    return std::abs((s.to - s.from).y()) * h.chord() > std::abs((h.to - h.from).y()) * s.chord();
  };
  KnownPiece piece;
  piece.sections = from(sections, outseam_is(a, b) ? b : a);
  const auto& s = piece.sections;
  // From the hem the crotch comes third or second.
  const bool outseam_next = !outseam_is(a, b);
  const Section &crotch = outseam_next ? s[3] : s[2], &waist = outseam_next ? s[2] : s[3];
  const Section &outseam = outseam_next ? s[1] : s[4], &inseam = outseam_next ? s[4] : s[1];
  if (crotch.bulge > kConcave || crotch.bulge > waist.bulge + kConcave ||
      outseam.length < inseam.length)
    return {};
  piece.side = outseam_next ? 1 : -1;  // as a front; a back is the other way round
  piece.upright = middle(waist).y() > middle(s[0]).y();
  return piece;
}

std::optional<KnownPiece> as_whole_leg(const std::vector<Section>& sections) {
  if (sections.size() != 6) return {};
  double longest = 0;
  std::optional<KnownPiece> found;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto s = from(sections, i);
    if (difference(s[1].length, s[5].length) > kSameLength || s[2].bulge > kConcave ||
        s[4].bulge > kConcave || s[1].length + s[5].length <= longest)
      continue;
    longest = s[1].length + s[5].length;
    KnownPiece piece;
    piece.sections = s;
    piece.upright = middle(s[3]).y() > middle(s[0]).y();
    found = piece;
  }
  return found;
}

std::optional<KnownPiece> as_hood_half(const std::vector<Section>& sections) {
  if (sections.size() != 3) return {};
  std::size_t back = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (sections[i].bulge > sections[back].bulge) back = i;
  const Section &after = sections[(back + 1) % 3], &before = sections[(back + 2) % 3];
  if (sections[back].bulge < std::max(after.bulge, before.bulge) + kOverHead) return {};
  KnownPiece piece;
  piece.role = PieceRole::hood;
  piece.side = before.length < after.length ? 1 : -1;
  piece.sections = from(sections, piece.side > 0 ? (back + 2) % 3 : (back + 1) % 3);
  return piece;
}

std::optional<Strip> as_strip(const std::vector<Section>& s) {
  if (s.size() != 4) return {};
  const std::size_t i = s[0].length + s[2].length > s[1].length + s[3].length ? 0 : 1;
  const Section &a = s[i], &b = s[i + 2], &end_a = s[i + 1], &end_b = s[(i + 3) % 4];
  if (difference(a.length, b.length) > kSidesAlike ||
      difference(end_a.length, end_b.length) > kEndsAlike ||
      std::min(a.length, b.length) < kLongerThanWide * std::max(end_a.length, end_b.length) ||
      std::max(std::abs(end_a.bulge), std::abs(end_b.bulge)) > kStraightEnd)
    return {};
  if (a.length >= b.length) return Strip{a, end_a, b, end_b};
  return Strip{b, end_b, a, end_a};
}

}  // namespace loosefit::pattern
