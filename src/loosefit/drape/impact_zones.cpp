#include "loosefit/drape/impact_zones.h"

#include <map>
#include <set>

#include "loosefit/base/union_find.h"
#include "loosefit/contact/candidate_pairs.h"
#include "loosefit/contact/pair_distance.h"
#include "loosefit/geometry/nearest_rotation.h"

namespace loosefit::drape {
namespace {

/// Displacements of the rigid motion nearest to the given ones (Kabsch 1976), or their mean.
void make_rigid(const std::vector<int>& members, const std::vector<Vec3>& x,
                const std::vector<Vec3>& wanted, bool may_turn, std::vector<Vec3>& u) {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  for (int i : members) from += x[i], to += x[i] + wanted[i];
  from /= static_cast<double>(members.size()), to /= static_cast<double>(members.size());
  Mat3 sum = Mat3::Zero();
  for (int i : members) sum += (x[i] + wanted[i] - to) * (x[i] - from).transpose();
  const Mat3 turn = may_turn ? geometry::nearest_rotation(sum) : Mat3(Mat3::Identity());
  for (int i : members) u[i] = to + turn * (x[i] - from) - x[i];
}

}  // namespace

std::vector<Vec3> without_impacts(const contact::ContactFeatures& features,
                                  const std::vector<Vec3>& x, const std::vector<Vec3>& displacement,
                                  int rounds) {
  std::vector<Vec3> u = displacement;
  contact::CandidatePairs candidates(features);
  UnionFind zones(x.size());  // particles that move together
  std::set<int> stiff;        // particles of zones that had better not turn
  for (int round = 0; round < rounds; ++round) {
    bool joined = false, again = false;
    for (const contact::FeaturePair& pair : candidates.approaching(x, u)) {
      if (contact::time_of_impact(pair.kind, pair.points(x), pair.points(u)) >= 1) continue;
      bool apart = false;
      for (int k = 1; k < 4; ++k) apart |= zones.unite(pair.particle[0], pair.particle[k]);
      joined |= apart;
      // Turning features that all but touch, on straight ways, may count as meeting.
      if (!apart) again |= stiff.insert(pair.particle[0]).second;
    }
    if (!joined && !again) break;
    std::map<int, std::vector<int>> members;
    for (int i = 0; i < static_cast<int>(x.size()); ++i) members[zones.find(i)].push_back(i);
    std::set<int> shifted;
    for (int i : stiff) shifted.insert(zones.find(i));
    for (const auto& [zone, list] : members)
      if (list.size() > 1) make_rigid(list, x, displacement, !shifted.count(zone), u);
  }
  return u;
}

}  // namespace loosefit::drape
