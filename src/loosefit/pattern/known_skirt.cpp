#include "loosefit/pattern/known_skirt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "loosefit/base/text.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

constexpr double kSameLength = 0.02;  // of lengths that are sewn
constexpr double kNarrower = 0.01;    // [m]
constexpr double kHeadMayPass = 0.4;  // rim of a hole in cloth that gives [m] (judgement)

struct Gore {
  int panel = 0;
  KnownPiece piece;
  bool strip = false;
  PieceWords words;
  /// Places in the way round: before, left side, behind, right side; within it.
  int place = 0, within = 0;
};

double side_of(const Gore& gore) { return gore.piece.sections[1].length; }

bool alike(double a, double b) { return std::abs(a - b) <= kSameLength * std::max(a, b); }

/// Those with like sides.
std::vector<Gore> group_of(const std::vector<Gore>& all) {
  std::vector<Gore> best;
  const auto worth = [](const std::vector<Gore>& group) {
    const auto strips = std::ranges::count_if(group, &Gore::strip);
    return std::tuple(group.size(), -strips, group.empty() ? 0.0 : side_of(group.front()));
  };
  for (const Gore& first : all) {
    std::vector<Gore> group;
    for (const Gore& gore : all)
      if (alike(side_of(first), side_of(gore))) group.push_back(gore);
    if (worth(group) > worth(best)) best = std::move(group);
  }
  return best;
}

/// Tells where each goes and brings them into the order of the way round.
void order(std::vector<Gore>& gores, KnownSkirt& skirt, const Pattern& pattern) {
  const auto says = [](const Gore& g) {
    return g.words.front || g.words.back || g.words.left || g.words.right;
  };
  if (std::ranges::any_of(gores, says)) {
    for (Gore& g : gores) {
      const int side = int(g.words.left) - int(g.words.right);
      g.place = g.words.front ? 0 : g.words.back ? 2 : side > 0 ? 1 : side < 0 ? 3 : 0;
      g.within = g.place == 0 ? side : g.place == 2 ? -side : 0;
      if (!says(g))
        skirt.doubts.push_back("where piece " + printable(pattern.panels[g.panel].name) +
                               " goes is not told by its name");
    }
    std::ranges::stable_sort(gores, {}, [](const Gore& g) { return std::pair(g.place, g.within); });
  } else {
    skirt.unnamed = true;
    for (std::size_t i = 0; i < gores.size(); ++i) gores[i].place = 2 * i >= gores.size() ? 2 : 0;
    skirt.doubts.push_back(
        "no name says which gores are before and which behind the wearer: they are taken in the "
        "order of the file");
  }
  for (std::size_t i = 1; i < gores.size(); ++i) {
    const Gore &a = gores[i - 1], &b = gores[i];
    if (a.place == b.place && a.within == b.within && !are_alike(a.piece, b.piece))
      skirt.doubts.push_back("which of " + printable(pattern.panels[a.panel].name) + " and " +
                             printable(pattern.panels[b.panel].name) +
                             " comes first on the way round is not told");
  }
}

}  // namespace

KnownSkirt know_skirt(const Pattern& pattern, const std::vector<int>& panels) {
  KnownSkirt skirt;
  std::vector<Gore> gores;
  for (const int p : panels) {
    const std::vector<Section> sections = outline_sections(pattern.panels[p]);
    if (auto piece = as_skirt(sections))
      gores.push_back(
          {p, *std::move(piece), as_strip(sections).has_value(), words_of(pattern.panels[p])});
  }
  gores = group_of(gores);
  if (gores.size() < 2) return skirt;
  order(gores, skirt, pattern);
  OpenLoop waist{"waist", LoopKind::waist, 0, {}}, hem{"hem", LoopKind::hem, 0, {}};
  const std::size_t n = gores.size();
  const auto sides = [&](const Gore& g, int section) {
    return g.piece.sections[section].sides(pattern.panels[g.panel], g.panel);
  };
  for (std::size_t i = 0; i < n; ++i) {
    Gore& gore = gores[i];
    for (const std::string& why : way_up_doubt(pattern.panels[gore.panel], gore.piece))
      skirt.doubts.push_back(why);
    // Seen from outside, the next on the way round is at the right.
    skirt.seams.push_back(
        {fmt::format("gore_{}", i + 1), sides(gore, 1), sides(gores[(i + 1) % n], 3), false});
    const auto of_hem = sides(gore, 0), of_waist = sides(gores[n - 1 - i], 2);
    hem.edges.insert(hem.edges.end(), of_hem.begin(), of_hem.end());
    waist.edges.insert(waist.edges.end(), of_waist.begin(), of_waist.end());
    gore.piece.role = gore.place == 0   ? PieceRole::front_skirt
                      : gore.place == 2 ? PieceRole::back_skirt
                                        : PieceRole::side_skirt;
    gore.piece.side = gore.place == 1 ? 1 : gore.place == 3 ? -1 : 0;
    skirt.pieces.emplace_back(gore.panel, gore.piece);
  }
  skirt.loops = {std::move(waist), std::move(hem)};
  return skirt;
}

std::vector<std::string> way_up_doubt(const Panel& panel, const KnownPiece& piece) {
  if (piece.sections[0].chord() >= piece.sections[2].chord() - kNarrower) return {};
  return {
      "piece " + printable(panel.name) +
      " is narrower at its lower end than at its upper one: either it tapers, or it lies on its "
      "head"};
}

bool may_be_neck(const PanelHole& hole) {
  const PieceWords words = words_of(hole.name);
  return words.neck || (!words.pocket && rim_length(hole) >= kHeadMayPass);
}

std::vector<std::string> top_doubts(const Pattern& pattern, const std::vector<KnownPiece>& pieces) {
  std::vector<std::string> doubts;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (pieces[p].role == PieceRole::unknown) continue;
    const Panel& panel = pattern.panels[p];
    const PieceWords words = words_of(panel);
    if (words.top && !words.skirt)
      doubts.push_back("piece " + printable(panel.name) +
                       " is of a top by its name, of a skirt by its shape");
    for (const PanelHole& hole : panel.holes)
      if (may_be_neck(hole))
        doubts.push_back("piece " + printable(panel.name) +
                         " has a hole that may be a neck: " + printable(hole.name));
  }
  return doubts;
}

}  // namespace loosefit::pattern
