#include "loosefit/pattern/open_rims.h"

#include <algorithm>
#include <cstddef>
#include <map>

#include "loosefit/base/union_find.h"

namespace loosefit::pattern {
namespace {

class Outlines {
 public:
  explicit Outlines(const std::vector<int>& panels) : panels_(panels) {
    const int n = static_cast<int>(panels.size());
    next_.resize(panels.size()), before_.resize(panels.size());
    for (int first = 0; first < n;) {
      int end = first;
      while (end < n && panels[end] == panels[first]) ++end;
      for (int i = first; i < end; ++i) {
        next_[i] = i + 1 < end ? i + 1 : first;
        before_[next_[i]] = i;
      }
      first = end;
    }
  }
  int panel(int side) const { return panels_[side]; }
  int next(int side) const { return next_[side]; }
  int before(int side) const { return before_[side]; }
  int count() const { return static_cast<int>(panels_.size()); }

 private:
  const std::vector<int>& panels_;
  std::vector<int> next_, before_;
};

/// Rims of the panels that are sewn to `panel`.
std::size_t rims_with(const std::vector<int>& panels, const std::vector<SidePair>& pairs,
                      int panel) {
  UnionFind sewn(1 + *std::ranges::max_element(panels));
  for (const auto& [i, j] : pairs) sewn.unite(panels[i], panels[j]);
  const std::vector<Rim> rims = rims_of(panels, pairs);
  return static_cast<std::size_t>(std::ranges::count_if(
      rims, [&](const Rim& rim) { return sewn.find(panels[rim.front()]) == sewn.find(panel); }));
}

}  // namespace

std::vector<Rim> rims_of(const std::vector<int>& panels, const std::vector<SidePair>& pairs) {
  const Outlines outlines(panels);
  const int n = outlines.count();
  // Corners, called as the side that starts there.
  UnionFind corners(n);
  std::vector<char> sewn(panels.size(), 0);
  for (const auto& [i, j] : pairs) {
    corners.unite(i, outlines.next(j));
    corners.unite(j, outlines.next(i));
    sewn[i] = sewn[j] = 1;
  }
  std::multimap<int, int> starting;  // open sides by the corner where they start
  for (int i = 0; i < n; ++i)
    if (!sewn[i]) starting.emplace(corners.find(i), i);
  std::vector<Rim> rims;
  while (!starting.empty()) {
    Rim rim;
    for (auto at = starting.begin(); at != starting.end();
         at = starting.find(corners.find(outlines.next(rim.back())))) {
      rim.push_back(at->second);
      starting.erase(at);
    }
    rims.push_back(std::move(rim));
  }
  return rims;
}

void keep_open(const std::vector<int>& panels, const std::vector<double>& level,
               std::vector<SidePair>& pairs) {
  if (panels.empty()) return;
  const Outlines outlines(panels);
  const auto is_level = [&](const SidePair& pair) {
    return level[pair.first] > 0 && level[pair.second] > 0;
  };
  std::map<int, int> partner;
  for (const auto& [i, j] : pairs) partner[i] = j, partner[j] = i;
  const auto sewn_to = [&](int side, int panel) {
    const auto at = partner.find(side);
    return at != partner.end() && panels[at->second] == panel;
  };
  std::erase_if(pairs, [&](const SidePair& pair) {
    const auto [i, j] = pair;
    return is_level(pair) && panels[i] != panels[j] && sewn_to(outlines.before(i), panels[j]) &&
           sewn_to(outlines.next(i), panels[j]);
  });
  std::vector<SidePair> longest;
  std::ranges::copy_if(pairs, std::back_inserter(longest), is_level);
  std::ranges::stable_sort(longest, std::ranges::greater{},
                           [&](const SidePair& pair) { return level[pair.first]; });
  for (const SidePair& pair : longest) {
    const int panel = panels[pair.first];
    const std::size_t rims = rims_with(panels, pairs, panel);
    if (rims >= 2) continue;
    std::vector<SidePair> fewer = pairs;
    std::erase(fewer, pair);
    if (rims_with(panels, fewer, panel) > rims) pairs = std::move(fewer);
  }
}

}  // namespace loosefit::pattern
