#include "loosefit/body/scan_limbs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

#include "loosefit/body/section.h"
#include "loosefit/body/surface_distance.h"

namespace loosefit::body {
namespace {

constexpr double kStep = 0.006;       // between levels, share of the stature
constexpr double kShortLimb = 0.12;   // what sticks out less is a thumb, a breast, an ear
constexpr double kFootHeight = 0.15;  // the tip of a leg is lower

struct Node {
  int parent = -1;
  int level = 0;
  Vec3 centre = Vec3::Zero();
  double length = 0;
  int deepest = -1;  ///< vertex of its subtree farthest from the crown
  double reach = 0;  ///< way to that vertex
  std::vector<int> children;
  std::vector<Vec3> points;  ///< of its loop
};

std::uint64_t key_of(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return std::uint64_t(std::uint32_t(low)) << 32 | std::uint32_t(high);
}

/// The Reeb tree of the way from the crown: loops, each hanging on the loop it was reached from.
struct LoopTree {
  std::vector<double> way;
  std::vector<Node> nodes;   ///< parents before children; the crown is the first
  std::vector<int> node_of;  ///< per vertex

  LoopTree(const geometry::TriangleMesh& mesh, double step) {
    int crown = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (mesh.vertices[v].z() > mesh.vertices[std::size_t(crown)].z()) crown = int(v);
    }
    way = surface_distance(mesh, {crown});
    const auto near = neighbours_of(mesh);
    std::vector<int> order(mesh.vertices.size());
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = int(v);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return way[std::size_t(a)] < way[std::size_t(b)]; });
    const auto level_of = [&](int v) { return int(way[std::size_t(v)] / step); };
    nodes.push_back({});
    nodes[0].centre = mesh.vertices[std::size_t(crown)];
    node_of.assign(mesh.vertices.size(), 0);
    std::unordered_map<std::uint64_t, int> loop_at, below;  // only looked up, so order is no matter
    int level = 0;
    for (const int v : order) {
      if (!std::isfinite(way[std::size_t(v)])) break;
      while (level < level_of(v)) {
        below = std::exchange(loop_at, {});
        add_level(mesh, ++level, step, below, loop_at);
      }
      if (v == crown) continue;
      int from = near[std::size_t(v)][0];
      for (const int n : near[std::size_t(v)]) {
        if (way[std::size_t(n)] < way[std::size_t(from)]) from = n;
      }
      const auto crossed = loop_at.find(key_of(from, v));
      node_of[std::size_t(v)] = level_of(from) < level && crossed != loop_at.end()
                                    ? crossed->second
                                    : node_of[std::size_t(from)];
    }
    hang(order);
  }

  bool below(int node, int top) const {
    while (node > top) node = nodes[std::size_t(node)].parent;
    return node == top;
  }

 private:
  void add_level(const geometry::TriangleMesh& mesh, int level, double step,
                 const std::unordered_map<std::uint64_t, int>& before,
                 std::unordered_map<std::uint64_t, int>& loop_at) {
    for (const auto& loop : level_section(mesh, way, level * step)) {
      std::map<int, int> votes;
      for (const auto& e : loop.edges) {
        const int low = way[std::size_t(e[0])] < way[std::size_t(e[1])] ? e[0] : e[1];
        const auto long_edge = before.find(key_of(e[0], e[1]));
        ++votes[long_edge != before.end() ? long_edge->second : node_of[std::size_t(low)]];
      }
      Node node;
      node.level = level;
      node.centre = centroid(loop);
      node.length = loop.length;
      node.points = loop.points;
      node.parent = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                      return a.second < b.second;
                    })->first;
      const int index = int(nodes.size());
      for (const auto& e : loop.edges) loop_at[key_of(e[0], e[1])] = index;
      nodes.push_back(std::move(node));
    }
  }

  void hang(const std::vector<int>& order) {
    for (const int v : order) {
      if (!std::isfinite(way[std::size_t(v)])) break;
      Node& node = nodes[std::size_t(node_of[std::size_t(v)])];
      node.deepest = v, node.reach = way[std::size_t(v)];
    }
    for (std::size_t n = nodes.size(); n-- > 1;) {
      Node& parent = nodes[std::size_t(nodes[n].parent)];
      if (nodes[n].reach > parent.reach)
        parent.reach = nodes[n].reach, parent.deepest = nodes[n].deepest;
    }
    for (std::size_t n = 1; n < nodes.size(); ++n)
      nodes[std::size_t(nodes[n].parent)].children.push_back(int(n));
  }
};

/// A part of the tree that reaches far from where it parts from a deeper one.
struct Branch {
  int top = 0;  ///< its first node
  int tip = 0;  ///< vertex
};

std::vector<Branch> far_branches(const LoopTree& tree, double shortest, double step) {
  std::vector<Branch> found = {{0, tree.nodes[0].deepest}};
  for (const Node& node : tree.nodes) {
    for (const int child : node.children) {
      const Node& c = tree.nodes[std::size_t(child)];
      if (c.deepest != node.deepest && c.reach - c.level * step >= shortest)
        found.push_back({child, c.deepest});
    }
  }
  return found;
}

/// Nearest points of two loops: where they parted.
Vec3 between(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double nearest = std::numeric_limits<double>::infinity();
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : a) {
    for (const Vec3& q : b) {
      const double d = (p - q).squaredNorm();
      if (d < nearest) nearest = d, middle = 0.5 * (p + q);
    }
  }
  return middle;
}

/// The node on the way from the crown to `leaf` that hangs on `at`.
int child_towards(const LoopTree& tree, int leaf, int at) {
  while (leaf > 0 && tree.nodes[std::size_t(leaf)].parent != at)
    leaf = tree.nodes[std::size_t(leaf)].parent;
  return leaf;
}

int common_node(const LoopTree& tree, int a, int b) {
  while (a != b) {
    int& later = a > b ? a : b;
    later = tree.nodes[std::size_t(later)].parent;
  }
  return a;
}

LimbChain chain_of(const LoopTree& tree, int top, int other, const geometry::TriangleMesh& mesh,
                   double step) {
  LimbChain chain;
  const Node& start = tree.nodes[std::size_t(top)];
  std::map<int, LimbChain::Ring> by_level;
  for (std::size_t n = std::size_t(top); n < tree.nodes.size(); ++n) {
    const Node& node = tree.nodes[n];
    if (!tree.below(int(n), top)) continue;
    auto& ring =
        by_level.try_emplace(node.level, LimbChain::Ring{Vec3::Zero(), 0, 0}).first->second;
    ring.centre += node.length * node.centre;
    ring.length += node.length;
  }
  for (auto& [level, ring] : by_level) {
    ring.centre /= ring.length;
    ring.reach = level * step;
    chain.rings.push_back(ring);
  }
  chain.tip = mesh.vertices[std::size_t(start.deepest)];
  chain.fold = between(start.points, tree.nodes[std::size_t(other)].points);
  return chain;
}

constexpr double kLowFold = 0.725, kUsualFold = 0.745;  // shares of the stature

/// Whether a level cut just below where armpits usually are shows the arm beside the trunk.
bool apart_at_armpit(const geometry::TriangleMesh& mesh, double sign, double height) {
  const auto loops = plane_section(mesh, Vec3(0, 0, (kUsualFold - 0.01) * height), Vec3::UnitZ());
  const SectionLoop* trunk = trunk_loop(loops);
  return std::any_of(loops.begin(), loops.end(), [&](const SectionLoop& loop) {
    return &loop != trunk && loop.length > 0.08 * height &&
           sign * centroid(loop).x() > 0.06 * height;
  });
}

void raise_fold(const geometry::TriangleMesh& mesh, LimbChain& arm, double sign, double height) {
  arm.parted = arm.fold;
  if (!arm.found() || arm.fold.z() > kLowFold * height || raised_deg(arm) > 45 ||
      apart_at_armpit(mesh, sign, height))
    return;
  const std::size_t last = arm.rings.size() - 1;
  const Vec3 axis = arm.rings[std::min<std::size_t>(last, 16)].centre -
                    arm.rings[std::min<std::size_t>(last, 3)].centre;
  arm.fold += axis / axis.z() * (kUsualFold * height - arm.fold.z());
}

}  // namespace

double raised_deg(const LimbChain& arm) {
  const std::size_t last = arm.rings.size() - 1;
  const Vec3 axis = arm.rings[std::min<std::size_t>(last, 16)].centre -
                    arm.rings[std::min<std::size_t>(last, 3)].centre;
  return degrees(std::atan2(std::hypot(axis.x(), axis.y()), -axis.z()));
}

ScanLimbs find_limbs(const geometry::TriangleMesh& mesh, double height) {
  const double step = kStep * height;
  const LoopTree tree(mesh, step);
  ScanLimbs found;
  found.limb.assign(mesh.vertices.size(), ScanLimb::core);
  std::vector<Branch> branches = far_branches(tree, kShortLimb * height, step);

  const auto tip_height = [&](const Branch& b) { return mesh.vertices[std::size_t(b.tip)].z(); };
  std::stable_sort(branches.begin(), branches.end(),
                   [&](const Branch& a, const Branch& b) { return tip_height(a) < tip_height(b); });
  const auto leaf = [&](const Branch& b) { return tree.node_of[std::size_t(b.tip)]; };
  std::vector<std::pair<int, ScanLimb>> tops;
  int trunk_end = leaf(branches[0]);
  const bool two_legs = branches.size() >= 2 && tip_height(branches[1]) < kFootHeight * height;
  if (two_legs) {
    trunk_end = common_node(tree, leaf(branches[0]), leaf(branches[1]));
    int top[2] = {child_towards(tree, leaf(branches[0]), trunk_end),
                  child_towards(tree, leaf(branches[1]), trunk_end)};
    std::array<LimbChain, 2> legs = {chain_of(tree, top[0], top[1], mesh, step),
                                     chain_of(tree, top[1], top[0], mesh, step)};
    const bool swap = legs[0].rings[legs[0].rings.size() / 2].centre.x() <
                      legs[1].rings[legs[1].rings.size() / 2].centre.x();
    if (swap) std::swap(legs[0], legs[1]), std::swap(top[0], top[1]);
    found.leg = std::move(legs);
    tops = {{top[0], ScanLimb::left_leg}, {top[1], ScanLimb::right_leg}};
  }
  for (std::size_t i = two_legs ? 2 : 1; i < branches.size(); ++i) {
    const int parting = common_node(tree, leaf(branches[i]), trunk_end);
    if (parting == trunk_end) continue;  // grows out of a leg
    const int top = child_towards(tree, leaf(branches[i]), parting);
    const int trunk = child_towards(tree, trunk_end, parting);
    const double beside =
        tree.nodes[std::size_t(top)].centre.x() - tree.nodes[std::size_t(trunk)].centre.x();
    const std::size_t side = beside > 0 ? 0 : 1;
    LimbChain chain = chain_of(tree, top, trunk, mesh, step);
    if (found.arm[side].found() && found.arm[side].rings.size() >= chain.rings.size()) continue;
    found.arm[side] = std::move(chain);
    const ScanLimb limb = side == 0 ? ScanLimb::left_arm : ScanLimb::right_arm;
    std::erase_if(tops, [&](const auto& t) { return t.second == limb; });
    tops.push_back({top, limb});
  }
  std::vector<ScanLimb> of_node(tree.nodes.size(), ScanLimb::core);
  for (const auto& [top, limb] : tops) of_node[std::size_t(top)] = limb;
  for (std::size_t n = 1; n < of_node.size(); ++n) {
    if (of_node[n] == ScanLimb::core) of_node[n] = of_node[std::size_t(tree.nodes[n].parent)];
  }
  for (std::size_t v = 0; v < found.limb.size(); ++v)
    found.limb[v] = of_node[std::size_t(tree.node_of[v])];

  // An arm that borders on something else well below its fold has grown together with it.
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = std::size_t(t[c]), b = std::size_t(t[(c + 1) % 3]);
      for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
        const ScanLimb arm = side == 0 ? ScanLimb::left_arm : ScanLimb::right_arm;
        if (found.limb[a] != arm || found.limb[b] == arm) continue;
        if (tree.way[a] > found.arm[side].rings.front().reach + kShortLimb * height)
          found.arm[side].touches = true;
      }
    }
  }
  raise_fold(mesh, found.arm[0], 1, height);
  raise_fold(mesh, found.arm[1], -1, height);
  return found;
}

}  // namespace loosefit::body
