#include "loosefit/render/cut_form.h"

#include <map>
#include <numeric>

#include "loosefit/base/union_find.h"

namespace loosefit::render {
namespace {

using Rim = std::vector<std::array<int, 2>>;

/// A rim in pieces that hang together, in the order of their first edges.
std::vector<Rim> openings(const Rim& rim, std::size_t vertices) {
  UnionFind together(static_cast<int>(vertices));
  for (const auto& [a, b] : rim) together.unite(a, b);
  std::map<int, std::size_t> place;
  std::vector<Rim> pieces;
  for (const auto& edge : rim) {
    const auto [at, is_new] = place.try_emplace(together.find(edge[0]), pieces.size());
    if (is_new) pieces.emplace_back();
    pieces[at->second].push_back(edge);
  }
  return pieces;
}

}  // namespace

CutForm::CutForm(geometry::TriangleMesh surface)
    : mesh_(std::move(surface)), origin_(mesh_.vertices.size()) {
  std::iota(origin_.begin(), origin_.end(), 0);
}

void CutForm::cut_at(const std::vector<double>& keep, const Vec3& lid) {
  ClippedSurface part = clipped(mesh_, keep);
  for (int& v : part.origin) v = origin_[v];
  mesh_ = std::move(part.mesh);
  origin_ = std::move(part.origin);
  for (const Rim& rim : openings(part.rim, mesh_.vertices.size())) {
    const int beside = origin_[rim.front()[0]];
    close_with_fan(mesh_, rim, lid);
    origin_.resize(mesh_.vertices.size(), beside);
  }
}

}  // namespace loosefit::render
