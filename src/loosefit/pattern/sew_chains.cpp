#include "loosefit/pattern/sew_chains.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/pattern/curve_chain.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::pattern {
namespace {

constexpr double kSameEnd = 0.003;  ///< [m]
constexpr double kSmallestShare = 1e-6;

double length_of(const Pattern& pattern, const Stitch::Side& side) {
  return EdgePath(pattern.panels[side.panel], side.edge).length();
}

/// Where the edges of a run end, as shares of its length, without its own end.
std::vector<double> joints(const Pattern& pattern, const std::vector<Stitch::Side>& chain) {
  const double total = chain_length(pattern, chain);
  std::vector<double> at;
  double sum = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    sum += length_of(pattern, chain[i]);
    at.push_back(sum / total);
  }
  return at;
}

/// The edge as two, the second right behind it.
void cut_edge(Pattern& pattern, int panel_index, int edge_index, double share,
              const std::string& name, int part) {
  Panel& panel = pattern.panels[panel_index];
  PanelEdge edge = panel.edges[edge_index];
  CurveChain chain;
  chain.start = panel.vertices[edge.start];
  chain.curves = edge.curves;
  chain.knots = edge.knots;
  chain.knots.push_back(panel.vertices[edge.end]);
  const auto [before, after] = chain.cut(share * chain.length());
  PanelEdge second = edge;
  second.start = static_cast<int>(panel.vertices.size());
  panel.vertices.push_back(before.end());
  edge.end = second.start;
  edge.curves = before.curves;
  edge.knots.assign(before.knots.begin(), before.knots.end() - 1);
  second.curves = after.curves;
  second.knots.assign(after.knots.begin(), after.knots.end() - 1);
  edge.name = fmt::format("{}_{}", name, part);
  second.name = fmt::format("{}_{}", name, part + 1);
  panel.edges[edge_index] = edge;
  panel.edges.insert(panel.edges.begin() + edge_index + 1, second);
}

/// Points of outlines that seams, and edges that follow each other in a run, lay together.
class JoinedPoints {
 public:
  JoinedPoints(const Pattern& pattern, const std::vector<ChainSeam>& seams) : pattern_(pattern) {
    for (const ChainSeam& seam : seams) {
      for (const auto* run : {&seam.first, &seam.second})
        for (std::size_t i = 0; i + 1 < run->size(); ++i)
          join(end((*run)[i]), start((*run)[i + 1]));
      if (seam.begin > 0 || seam.first.empty() || seam.second.empty()) continue;
      const Point a = start(seam.first.front()), b = end(seam.first.back()),
                  c = start(seam.second.front()), d = end(seam.second.back());
      join(a, seam.reversed ? c : d);
      join(b, seam.reversed ? d : c);
    }
  }

  /// Whether a run ends where it begins.
  bool closed(const std::vector<Stitch::Side>& run) {
    return root(end(run.back())) == root(start(run.front()));
  }

 private:
  using Point = std::pair<int, int>;  // panel, vertex

  Point start(const Stitch::Side& side) const {
    return {side.panel, pattern_.panels[side.panel].edges[side.edge].start};
  }
  Point end(const Stitch::Side& side) const {
    return {side.panel, pattern_.panels[side.panel].edges[side.edge].end};
  }
  Point root(Point p) {
    for (auto it = parent_.find(p); it != parent_.end(); it = parent_.find(p)) p = it->second;
    return p;
  }
  void join(Point a, Point b) {
    a = root(a), b = root(b);
    if (a != b) parent_[a] = b;
  }

  const Pattern& pattern_;
  std::map<Point, Point> parent_;
};

/// Cuts edges and keeps everything that counts edges in step.
class Cutter {
 public:
  Cutter(Pattern& pattern, std::vector<ChainSeam>& seams, std::vector<Notch>& notches)
      : pattern_(pattern), seams_(seams), notches_(notches) {}

  /// Cuts the run so that it has joints at these shares.
  void cut(std::vector<Stitch::Side>& chain, const std::vector<double>& wanted) {
    const double total = chain_length(pattern_, chain);
    for (const double share : wanted) {
      double begin = 0;
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const double length = length_of(pattern_, chain[i]);
        const double at = share * total - begin;
        begin += length;
        if (at > length - kSameEnd) continue;
        if (at < kSameEnd) break;
        const Stitch::Side side = chain[i];
        split(side, std::clamp(at / length, kSmallestShare, 1 - kSmallestShare));
        // split() has moved what lies behind, and chain[i] is the first part.
        chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     {side.panel, side.edge + 1});
        break;
      }
    }
  }

  /// Turns a closed run until it begins at this share of its length.
  void begin_at(std::vector<Stitch::Side>& chain, double share) {
    const double total = chain_length(pattern_, chain);
    cut(chain, {share});
    double sum = 0;
    std::size_t first = 0;
    while (first < chain.size() && sum < share * total - kSameEnd)
      sum += length_of(pattern_, chain[first++]);
    std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(first), chain.end());
  }

 private:
  void split(const Stitch::Side& side, double share) {
    auto& [name, parts] = names_[{side.panel, pattern_.panels[side.panel].edges[side.edge].name}];
    const std::string now = pattern_.panels[side.panel].edges[side.edge].name;
    if (name.empty()) name = now;
    const int part = parts == 0 ? 1 : parts;
    parts = part + 1;
    const std::string base = name;
    cut_edge(pattern_, side.panel, side.edge, share, base, part);
    // The last part goes on being cut under the same name.
    names_[{side.panel, fmt::format("{}_{}", base, part + 1)}] = {base, part + 1};
    const auto behind = [&](Stitch::Side& other) {
      if (other.panel == side.panel && other.edge > side.edge) ++other.edge;
    };
    for (ChainSeam& seam : seams_) {
      for (Stitch::Side& other : seam.first) behind(other);
      for (Stitch::Side& other : seam.second) behind(other);
    }
    for (Stitch& stitch : pattern_.stitches) behind(stitch.first), behind(stitch.second);
    for (Notch& notch : notches_) {
      if (notch.panel != side.panel) continue;
      if (notch.edge > side.edge)
        ++notch.edge;
      else if (notch.edge == side.edge && notch.along > share)
        ++notch.edge, notch.along = (notch.along - share) / (1 - share);
      else if (notch.edge == side.edge)
        notch.along = notch.along / share;
    }
  }

  Pattern& pattern_;
  std::vector<ChainSeam>& seams_;
  std::vector<Notch>& notches_;
  std::map<std::pair<int, std::string>, std::pair<std::string, int>> names_;
};

}  // namespace

double chain_length(const Pattern& pattern, const std::vector<Stitch::Side>& chain) {
  double sum = 0;
  for (const Stitch::Side& side : chain) sum += length_of(pattern, side);
  return sum;
}

void sew_chains(Pattern& pattern, std::vector<ChainSeam> seams, std::vector<Notch>& notches) {
  JoinedPoints joined(pattern, seams);
  for (const ChainSeam& seam : seams)
    if (seam.begin > 0 && !seam.second.empty() && !joined.closed(seam.second))
      throw GeometryError({{}, 0, seam.name},
                          "a second side that does not end where it begins, which other seams say",
                          "one that goes all the way round, since begin is given");
  Cutter cutter(pattern, seams, notches);
  for (std::size_t s = 0; s < seams.size(); ++s) {
    ChainSeam& seam = seams[s];
    if (seam.first.empty() || seam.second.empty())
      throw GeometryError({{}, 0, seam.name}, "a seam with one side", "two sides");
    if (seam.begin > 0) cutter.begin_at(seam.second, seam.begin);
    if (seam.first.size() > 1 || seam.second.size() > 1) {
      std::vector<double> a = joints(pattern, seam.first), b = joints(pattern, seam.second);
      if (!seam.reversed) {
        for (double& share : a) share = 1 - share;
        for (double& share : b) share = 1 - share;
        std::reverse(a.begin(), a.end());
        std::reverse(b.begin(), b.end());
      }
      cutter.cut(seam.first, b);
      cutter.cut(seam.second, a);
    }
    if (seam.first.size() != seam.second.size())
      throw GeometryError(
          {{}, 0, seam.name},
          fmt::format("runs that part into {} and {} edges", seam.first.size(), seam.second.size()),
          "joints that face each other");
    const std::size_t n = seam.first.size();
    for (std::size_t i = 0; i < n; ++i) {
      Stitch stitch;
      stitch.first = seam.first[i];
      stitch.second = seam.second[seam.reversed ? i : n - 1 - i];
      stitch.right_wrong = seam.reversed;
      stitch.name = n == 1 ? seam.name : fmt::format("{}_{}", seam.name, i + 1);
      pattern.stitches.push_back(stitch);
    }
  }
}

}  // namespace loosefit::pattern
