#pragma once
#include <tbb/parallel_for.h>

#include <array>

#include "loosefit/particles/active_set.h"
#include "loosefit/particles/energy.h"

namespace loosefit::particles {

/// Element kernels work on tiles of this many elements, structure of arrays: their loops over a
/// tile have no branch and no call, so that the compiler vectorises them. No fewer than the widest
/// registers hold; of more, the rows of a tile leave the fastest cache.
inline constexpr int kTile = 8;

using TileRow = std::array<double, kTile>;
using TileIndex = std::array<int, kTile>;

inline int tiles_for(std::size_t elements) {
  return static_cast<int>((elements + kTile - 1) / kTile);
}

/// f(begin, end) over parts of [0, n) of at least `grain`, on all threads. The parts depend on the
/// number of threads: f must give the same numbers however [0, n) is cut.
template <class F>
void for_ranges(int n, int grain, const F& f) {
  if (n <= grain) {
    f(0, n);
    return;
  }
  tbb::parallel_for(
      tbb::blocked_range<int>(0, n, grain),
      [&](const tbb::blocked_range<int>& r) { f(r.begin(), r.end()); }, tbb::static_partitioner());
}

/// f(tile) for every tile, at least 512 elements at a time.
template <class F>
void for_tiles(int tiles, const F& f) {
  for_ranges(tiles, 512 / kTile, [&](int begin, int end) {
    for (int tile = begin; tile < end; ++tile) f(tile);
  });
}

/// f(tile) for a subset of the tiles.
template <class F>
void for_tiles(const IndexSubset& tiles, const F& f) {
  for_ranges(tiles.size(), 512 / kTile, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) f(tiles[k]);
  });
}

/// Those of `tiles` with an element that has a corner in the active set; all of them if that is
/// null.
template <class Tile>
IndexSubset tiles_in(const ActiveSet* active_set, const std::vector<Tile>& tiles) {
  if (!active_set) return IndexSubset(tiles.size());
  return IndexSubset(tiles.size(), [&](int t) {
    for (const TileIndex& corner : tiles[t].corner)
      for (int particle : corner)
        if (active_set->inside[particle]) return true;
    return false;
  });
}

/// Corners of the elements of a tile, as rows: point[corner][coordinate][element].
template <std::size_t Corners>
void gather_points(const VectorField& x, const std::array<TileIndex, Corners>& corner,
                   std::array<std::array<TileRow, 3>, Corners>& point) {
  for (std::size_t c = 0; c < Corners; ++c)
    for (int i = 0; i < kTile; ++i) {
      const Vec3& p = x[corner[c][i]];
      point[c][0][i] = p[0];
      point[c][1][i] = p[1];
      point[c][2][i] = p[2];
    }
}

/// The rows of a tile element by element: out[Rows i + r] = row[r][i].
template <std::size_t Rows>
void spread(const std::array<TileRow, Rows>& row, double* out) {
  constexpr int kLine = 8;  // numbers that are read together
  static_assert(kTile % kLine == 0);
  for (int i = 0; i < kTile; i += kLine)
    for (std::size_t r = 0; r < Rows; ++r)
      for (int j = i; j < i + kLine; ++j) out[Rows * j + r] = row[r][j];
}

/// Sum of a row in a fixed order that does not depend on threads or on vector width.
inline double sum_of(const TileRow& row) {
  constexpr int kChains = 8;
  static_assert(kTile % kChains == 0);
  std::array<double, kChains> chain{};
  for (int i = 0; i < kTile; i += kChains)
    for (int c = 0; c < kChains; ++c) chain[c] += row[i + c];
  return ((chain[0] + chain[1]) + (chain[2] + chain[3])) +
         ((chain[4] + chain[5]) + (chain[6] + chain[7]));
}

/// Four numbers that stand together in memory, for loops that the compiler does not vectorise.
using Quad [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

}  // namespace loosefit::particles

/// Compiles a function once for each vector width and picks one when the program starts. Without
/// contraction of products and sums all of them give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define LOOSEFIT_VECTORISED __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define LOOSEFIT_VECTORISED
#endif
