#include "loosefit/pattern/propose_seams.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/pattern/known_bands.h"
#include "loosefit/pattern/least_cost.h"
#include "loosefit/pattern/open_rims.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

constexpr double kOpen = 0.12;  // cost of leaving a side open
constexpr double kNever = 1e3;
constexpr double kLongerThanEnd = 1.2;  // a long side of a strip, over an end
constexpr double kOnItsHead = 0.06;
constexpr double kLevel = 0.5;          // steepness below which a side is level
constexpr double kMostGathered = 0.15;  // of lengths that are paired by themselves
constexpr std::size_t kMostSections = 300;
constexpr double kSameOutline = 0.002;  // between a piece and its mirrored twin

struct Side {
  int panel = 0;
  Section section;
  std::vector<double> notches;  ///< shares of its length
  double steep = 0;             ///< 0: across the grain, 1: along it
  double rise = 0;              ///< the same, negative where the outline runs down
};

double difference(double a, double b) { return std::abs(a - b) / std::max({a, b, 1e-9}); }

class Pairing {
 public:
  Pairing(const Pattern& pattern, const std::vector<Notch>& notches) : pattern_(pattern) {
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
      const Panel& panel = pattern.panels[p];
      words_.push_back(words_of(panel));
      lengths_.push_back(edge_lengths(panel));
      strip_end_.push_back(0);
      for (const Section& section : outline_sections(panel)) {
        Side side{static_cast<int>(p), section, {}, 0, 0};
        const Vec2 along = section.to - section.from;
        side.rise = along.y() / std::max(1e-9, along.norm());
        side.steep = std::abs(side.rise);
        double begin = 0;
        for (const Stitch::Side& edge : section.sides(panel, side.panel)) {
          for (const Notch& notch : notches)
            if (notch.panel == edge.panel && notch.edge == edge.edge)
              side.notches.push_back((begin + notch.along * lengths_[p][edge.edge]) /
                                     section.length);
          begin += lengths_[p][edge.edge];
        }
        std::sort(side.notches.begin(), side.notches.end());
        sides_.push_back(side);
      }
      if (const auto strip = as_strip(outline_sections(panel)))
        strip_end_.back() =
            kLongerThanEnd * std::max(strip->first_end.length, strip->second_end.length);
    }
    find_twins();
  }

  std::vector<SeamProposal> pair() const {
    std::vector<SeamProposal> found;
    const std::size_t n = sides_.size();
    if (n > kMostSections) return found;
    std::vector<std::vector<double>> cost(n, std::vector<double>(n, kNever));
    for (std::size_t i = 0; i < n; ++i) {
      cost[i][i] = kOpen;
      for (std::size_t j = 0; j < i; ++j) cost[i][j] = cost[j][i] = cost_of(sides_[i], sides_[j]);
    }
    const std::vector<int> assigned = least_cost_assignment(cost);
    // An assignment may run in circles; the cheapest pairs of a circle are taken.
    std::vector<std::pair<double, std::pair<int, int>>> pairs;
    for (std::size_t i = 0; i < n; ++i)
      if (const int j = assigned[i]; j != static_cast<int>(i) && cost[i][j] < 2 * kOpen)
        pairs.push_back({cost[i][j], {std::min<int>(i, j), std::max<int>(i, j)}});
    std::sort(pairs.begin(), pairs.end());
    std::set<int> taken;
    std::vector<SidePair> kept;
    for (const auto& [c, ij] : pairs)
      if (!taken.count(ij.first) && !taken.count(ij.second)) {
        taken.insert(ij.first), taken.insert(ij.second);
        kept.push_back(ij);
      }
    std::vector<int> panels;
    for (const Side& side : sides_) panels.push_back(side.panel);
    keep_open(panels, levels(), kept);
    const KnownBands bands = bands_at(rims_of(panels, kept), kept);
    std::erase_if(kept, [&](const SidePair& ij) {
      return std::ranges::any_of(bands.bands, [&](const KnownBand& band) {
        return sides_[ij.first].panel == band.panel || sides_[ij.second].panel == band.panel;
      });
    });
    for (const auto& [i, j] : kept) {
      const Side &a = sides_[i], &b = sides_[j];
      SeamProposal proposal;
      proposal.seam.name = fmt::format("seam_{}", found.size() + 1);
      proposal.seam.first = a.section.sides(pattern_.panels[a.panel], a.panel);
      proposal.seam.second = b.section.sides(pattern_.panels[b.panel], b.panel);
      proposal.first = a.section.length;
      proposal.second = b.section.length;
      proposal.cost = cost[i][j];
      proposal.why = fmt::format("lengths differ by {:.1f} %{}",
                                 100 * difference(a.section.length, b.section.length),
                                 a.notches.empty() || b.notches.empty() ? ""
                                 : a.notches.size() == b.notches.size() ? ", notches agree"
                                                                        : ", notches do not agree");
      found.push_back(std::move(proposal));
    }
    for (const KnownBand& band : bands.bands)
      for (const ChainSeam* seam : {&band.side, &band.ends}) {
        SeamProposal proposal;
        proposal.seam = *seam;
        proposal.first = chain_length(pattern_, seam->first);
        proposal.second = chain_length(pattern_, seam->second);
        proposal.why = "a strip as long as an open edge";
        found.push_back(std::move(proposal));
      }
    return found;
  }

 private:
  /// Of every side, how long it is where it lies level in the drawing, as hems and waists do; 0 of
  /// others.
  std::vector<double> levels() const {
    std::vector<double> level;
    for (const Side& side : sides_) level.push_back(side.steep < kLevel ? side.section.length : 0);
    return level;
  }

  /// Strips whose long sides are open, sewn to rims of others, the highest ones first.
  KnownBands bands_at(const std::vector<Rim>& rims, const std::vector<SidePair>& pairs) const {
    std::vector<int> strips;
    for (int p = 0; p < static_cast<int>(pattern_.panels.size()); ++p) {
      const auto strip = as_strip(outline_sections(pattern_.panels[p]));
      const bool sewn = std::ranges::any_of(pairs, [&](const SidePair& ij) {
        return (sides_[ij.first].panel == p) != (sides_[ij.second].panel == p);
      });
      if (strip && !sewn) strips.push_back(p);
    }
    std::vector<std::pair<double, OpenLoop>> loops;
    for (const Rim& rim : rims) {
      const int first = sides_[rim.front()].panel;
      const bool one_panel =
          std::ranges::all_of(rim, [&](int i) { return sides_[i].panel == first; });
      if (one_panel && std::ranges::count(strips, first)) continue;
      OpenLoop loop{"", LoopKind::hem, 0, {}};
      double height = 0;
      for (const int i : rim) {
        const Side& side = sides_[i];
        const auto edges = side.section.sides(pattern_.panels[side.panel], side.panel);
        loop.edges.insert(loop.edges.end(), edges.begin(), edges.end());
        height += height_in_panel(side) / static_cast<double>(rim.size());
      }
      loops.emplace_back(height, std::move(loop));
    }
    std::ranges::stable_sort(loops, std::greater{}, [](const auto& loop) { return loop.first; });
    std::vector<OpenLoop> ordered;
    for (auto& [height, loop] : loops) {
      loop.name = fmt::format("rim_{}", ordered.size() + 1);
      loop.kind = height > 0.5 ? LoopKind::waist : LoopKind::hem;
      ordered.push_back(std::move(loop));
    }
    return know_bands(pattern_, strips, ordered);
  }

  /// 0 at the lower end of its panel in the drawing, 1 at the upper one.
  double height_in_panel(const Side& side) const {
    Eigen::AlignedBox2d box;
    for (const Vec2& p : outline_polygon(pattern_.panels[side.panel], 4)) box.extend(p);
    const double y = (side.section.from.y() + side.section.to.y()) / 2;
    return (y - box.min().y()) / std::max(1e-9, box.sizes().y());
  }

  /// The mirrored copy of each panel, itself where its outline mirrors itself; −1.
  void find_twins() {
    const std::size_t n = pattern_.panels.size();
    twin_.assign(n, -1);
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = 0; q < n && twin_[p] < 0; ++q) {
        const auto &a = lengths_[p], &b = lengths_[q];
        if (a.size() != b.size()) continue;
        // Mirrored the edges run the other way round, from anywhere.
        for (std::size_t shift = 0; shift < a.size() && twin_[p] < 0; ++shift) {
          bool same = true;
          for (std::size_t e = 0; e < a.size() && same; ++e)
            same = std::abs(a[e] - b[(shift + a.size() - e) % a.size()]) < kSameOutline;
          const bool like_it = p == q;
          if (same && (like_it ||
                       pattern_.panels[q].name.find(pattern_.panels[p].name) != std::string::npos ||
                       pattern_.panels[p].name.find(pattern_.panels[q].name) != std::string::npos))
            twin_[p] = static_cast<int>(q);
        }
      }
  }

  double cost_of(const Side& a, const Side& b) const {
    const double lengths = difference(a.section.length, b.section.length);
    if (lengths > kMostGathered) return kNever;
    // Sleeves are for two arms; front and back of one are sewn to each other.
    const PieceWords &u = words_[a.panel], &v = words_[b.panel];
    const bool twins = twin_[a.panel] == b.panel || twin_[b.panel] == a.panel;
    const bool halves = u.front != v.front || u.back != v.back;
    if (a.panel != b.panel && u.sleeve && v.sleeve && twins && !halves) return kNever;
    // A strip is sewn end to end, not shut along its length.
    if (a.panel == b.panel && strip_end_[a.panel] > 0 && a.section.length > strip_end_[a.panel])
      return kNever;
    double cost = lengths;
    // The end of one meets the start of the other: notches count from opposite ends.
    if (!a.notches.empty() || !b.notches.empty()) {
      if (a.notches.size() == b.notches.size()) {
        double off = 0;
        for (std::size_t k = 0; k < a.notches.size(); ++k)
          off += std::abs(a.notches[k] - (1 - b.notches[b.notches.size() - 1 - k]));
        cost += off / static_cast<double>(a.notches.size());
      } else {
        cost += 0.1;
      }
    }
    double role = 0;
    if (a.panel == b.panel)
      role = u.sleeve || u.cuff || u.neck || u.waist || u.leg ? 0.02 : 0.1;
    else if ((u.front && v.front) || (u.back && v.back))
      role = twin_[a.panel] == b.panel ? 0.02 : 0.08;
    if (u.left != v.left && u.right != v.right) role += 0.1;
    cost += role;
    // Two that run up are those of a piece and of one on its head.
    if (a.panel != b.panel && a.rise * b.rise > kLevel * kLevel) cost += kOnItsHead;
    cost += 0.5 * std::max(0.0, std::abs(a.steep - b.steep) - 0.2) * 0.3;
    // A curve that is cut out is not sewn to a hem, but to what bulges or is cut out alike.
    cost += 0.1 * std::min(1.0, std::abs(std::abs(a.section.bulge) - std::abs(b.section.bulge)));
    const bool twin_a = twin_[a.panel] >= 0, twin_b = twin_[b.panel] >= 0;
    if (twin_a != twin_b) cost += 2 * 0.02;
    return cost;
  }

  const Pattern& pattern_;
  std::vector<PieceWords> words_;
  std::vector<std::vector<double>> lengths_;
  std::vector<double>
      strip_end_;  ///< per panel: longer sides are long ones of a strip; 0: no strip
  std::vector<Side> sides_;
  std::vector<int> twin_;
};

}  // namespace

SeamProposals propose_seams(const Pattern& pattern, const std::vector<Notch>& notches) {
  SeamProposals result;
  result.known = know_garment(pattern);
  if (result.known.kind.empty()) {
    result.seams = Pairing(pattern, notches).pair();
  } else {
    for (const ChainSeam& seam : result.known.seams) {
      SeamProposal proposal;
      proposal.seam = seam;
      proposal.first = chain_length(pattern, seam.first);
      proposal.second = chain_length(pattern, seam.second);
      proposal.cost = difference(proposal.first, proposal.second);
      proposal.why = "so it is sewn in any " + result.known.kind;
      result.seams.push_back(std::move(proposal));
    }
  }
  std::set<int> sewn;
  for (const SeamProposal& proposal : result.seams)
    for (const auto* chain : {&proposal.seam.first, &proposal.seam.second})
      for (const Stitch::Side& side : *chain) sewn.insert(side.panel);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p)
    if (!sewn.count(static_cast<int>(p))) result.unsewn.push_back(pattern.panels[p].name);
  return result;
}

}  // namespace loosefit::pattern
