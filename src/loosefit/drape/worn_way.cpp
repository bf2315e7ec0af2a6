#include "loosefit/drape/worn_way.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>

#include "loosefit/base/types.h"
#include "loosefit/drape/openings.h"
#include "loosefit/drape/rest_levels.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::drape {
namespace {

constexpr double kTurned = 60;  ///< degrees
constexpr double kWider = 1.25;

/// Share of the cloth's area whose outside faces the wearer [–].
double inside_out_share(const garment::Garment& garment, const std::vector<Vec3>& x,
                        const body::PosedBody& body) {
  double turned = 0, all = 0;
  for (const Triangle& t : garment.triangles) {
    const Vec3 normal = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
    const geometry::ClosestPoint skin = body.tree().query((x[t[0]] + x[t[1]] + x[t[2]]) / 3);
    const Triangle& under = body->surface.triangles[skin.triangle];
    const auto& s = body->surface.vertices;
    const Vec3 outward = (s[under[1]] - s[under[0]]).cross(s[under[2]] - s[under[0]]);
    all += normal.norm();
    if (normal.dot(outward) < 0) turned += normal.norm();
  }
  return all > 0 ? turned / all : 0;
}

/// From the middle of the pieces for the back to that of those for the front, horizontally, as if
/// the wearer stood upright; nothing where pieces of either are missing.
std::optional<Vec2> forward(const garment::Garment& garment, const std::vector<Vec3>& x,
                            const body::PosedBody& body) {
  std::vector<int> side;  // of each panel: +1 front, −1 back
  for (const std::string& name : garment.panel_names) {
    const pattern::PieceWords words = pattern::words_of(name);
    const bool aside = words.sleeve || words.hood || words.cuff || words.pocket;
    side.push_back(aside || words.front == words.back ? 0 : words.front ? 1 : -1);
  }
  const RestLevels levels(body);
  Vec2 sum[2] = {Vec2::Zero(), Vec2::Zero()};
  int count[2] = {0, 0};
  for (int v = 0; v < garment.vertex_count; ++v) {
    const int s = side[garment.vertex_panel[v]];
    if (s == 0) continue;
    sum[s > 0] += levels.at_rest(x[v]).head<2>();
    ++count[s > 0];
  }
  if (count[0] == 0 || count[1] == 0) return std::nullopt;
  return Vec2(sum[1] / count[1] - sum[0] / count[0]);
}

/// Of a tube for one limb the way up is known, for the wearer tells which end is the upper one.
std::string wider_at_the_top(const garment::Garment& garment, const pattern::Pattern& pattern,
                             const body::PosedBody& body) {
  std::map<int, std::vector<Opening>> of_piece;
  for (Opening& o : garment_openings(garment, pattern, body))
    if (o.use != kinds::OpeningUse::limb) of_piece[o.piece].push_back(std::move(o));
  for (const auto& [piece, ends] : of_piece) {
    if (ends.size() != 2) continue;
    const bool first = is_upper_end(ends[0], ends[1]);
    const Opening &upper = ends[first ? 0 : 1], &lower = ends[first ? 1 : 0];
    if (!upper.is_named_top() && upper.girth > kWider * lower.girth)
      return fmt::format(
          "the garment may be worn upside down: its upper end is {:.2f} m round, its lower end "
          "{:.2f} m, and no label says which is which",
          upper.girth, lower.girth);
  }
  return {};
}

}  // namespace

WayRound way_round(const garment::Garment& garment, const pattern::Pattern& pattern,
                   const std::vector<Vec3>& x, const body::PosedBody& body) {
  WayRound found;
  if (body->joints.empty()) return found;
  if (const double share = inside_out_share(garment, x, body); share > 0.5)
    found.inside_out = fmt::format(
        "the garment is worn inside out: the outside of {:.0f} % of its cloth faces the wearer",
        100 * share);
  if (const auto way = forward(garment, x, body)) {
    // The wearer faces −y, +x is the wearer's left.
    const double angle = degrees(std::atan2(way->x(), -way->y()));
    if (std::abs(angle) > kTurned)
      found.turned = fmt::format(
          "the garment is worn turned: the pieces for the front lie {:.0f}° to the {} of the "
          "wearer's front",
          std::abs(angle), angle > 0 ? "left" : "right");
  }
  found.upside_down = wider_at_the_top(garment, pattern, body);
  return found;
}

}  // namespace loosefit::drape
