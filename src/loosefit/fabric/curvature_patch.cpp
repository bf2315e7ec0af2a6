#include "loosefit/fabric/curvature_patch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::fabric {
namespace {

/// A flat triangle with the gradients of its barycentric coordinates.
struct FlatTriangle {
  std::array<Vec2, 3> p;
  std::array<Vec2, 3> gradient;  ///< [1/m]
  double area = 0;               ///< [m²]
  double height(int corner) const { return 1 / gradient[corner].norm(); }
};

FlatTriangle flat_triangle(const std::array<Vec2, 3>& p, std::size_t index) {
  FlatTriangle f;
  f.p = p;
  const Vec2 a = p[1] - p[0], b = p[2] - p[0];
  const double twice = a[0] * b[1] - a[1] * b[0];
  if (!(std::abs(twice) > 0))
    throw GeometryError("pattern triangle " + std::to_string(index) + " has no area");
  f.area = 0.5 * std::abs(twice);
  for (int k = 0; k < 3; ++k) {
    const Vec2 e = p[(k + 2) % 3] - p[(k + 1) % 3];
    f.gradient[k] = Vec2(-e[1], e[0]) / twice;
  }
  return f;
}

/// Second derivatives (uu, vv, 2uv) of the product of two barycentric coordinates.
Vec3 product_curvature(const Vec2& a, const Vec2& b) {
  return {2 * a[0] * b[0], 2 * a[1] * b[1], 2 * (a[0] * b[1] + a[1] * b[0])};
}

/// A neighbour's free corner, unfolded into the plane of `f` across the edge opposite `corner`;
/// `along` is its foot on that edge as a share from corner + 1 to corner + 2.
Vec2 unfold(const FlatTriangle& f, int corner, double along, double height) {
  const Vec2 &start = f.p[(corner + 1) % 3], &end = f.p[(corner + 2) % 3];
  return start + along * (end - start) - height * f.gradient[corner].normalized();
}

/// Columns of S for all three angles, borders included, their neighbours being mirror images.
Mat3 quadratic_fit(const FlatTriangle& f, const std::array<Vec2, 3>& outer,
                   const std::array<double, 3>& height) {
  Mat3 meets;  // row: outer corner, column: product of the two other barycentric coordinates
  Mat3 curvature;
  const Vec2 centre = (f.p[0] + f.p[1] + f.p[2]) / 3;
  for (int k = 0; k < 3; ++k) {
    Vec3 lambda;
    for (int m = 0; m < 3; ++m) lambda[m] = 1.0 / 3 + f.gradient[m].dot(outer[k] - centre);
    for (int i = 0; i < 3; ++i) meets(k, i) = lambda[(i + 1) % 3] * lambda[(i + 2) % 3];
    curvature.col(k) = product_curvature(f.gradient[(k + 1) % 3], f.gradient[(k + 2) % 3]);
  }
  Mat3 heights = Mat3::Zero();
  for (int k = 0; k < 3; ++k) heights(k, k) = height[k];
  // The six corners lie on a conic when `meets` is singular (two neighbours that share their free
  // corner, for one). Then each edge bends about itself: half of every angle belongs to this side.
  constexpr double kWorstCondition = 50;
  const Mat3 inverse = meets.inverse();
  if (std::abs(meets.determinant()) > 1e-9 &&
      inverse.cwiseAbs().maxCoeff() * meets.cwiseAbs().maxCoeff() < kWorstCondition)
    return curvature * inverse * heights;
  for (int k = 0; k < 3; ++k) {
    const Vec2 n = f.gradient[k].normalized();
    const double share = 1 / f.height(k);  // l / (2 A)
    curvature.col(k) = share * Vec3(n[0] * n[0], n[1] * n[1], 2 * n[0] * n[1]);
  }
  return curvature;
}

/// The angles at borders are unknown; they follow from the others by the natural condition that
/// the moment about a free border vanishes (M_nn = 0), so that any constant curvature that obeys it
/// is exact. Where the patch says little about κ_nn, and in corners with two borders, they take the
/// values of least energy. The columns of border angles become zero.
Mat3 release_borders(const Mat3& s, const Mat3& rigidity, const FlatTriangle& f,
                     const std::array<int, 9>& hinge) {
  const int borders = (hinge[0] < 0) + (hinge[1] < 0) + (hinge[2] < 0);
  Mat3 released = s;
  for (int k = 0; k < 3; ++k) {
    if (hinge[k] >= 0) continue;
    const Vec3 own = released.col(k);
    const Vec2 n = f.gradient[k].normalized();
    const Vec3 normal(n[0] * n[0], n[1] * n[1], 2 * n[0] * n[1]);
    constexpr double kLeastCosine = 0.5;
    const double cosine = normal.dot(rigidity * own) /
                          std::sqrt(normal.dot(rigidity * normal) * own.dot(rigidity * own));
    const Vec3 test = borders == 1 && std::abs(cosine) > kLeastCosine ? normal : own;
    const double own_moment = test.dot(rigidity * own);
    if (std::abs(own_moment) > 0)
      for (int j = 0; j < 3; ++j)
        if (j != k) released.col(j) -= own * (test.dot(rigidity * released.col(j)) / own_moment);
    released.col(k).setZero();
  }
  return released;
}

/// (κ_uu, κ_vv, 2κ_uv) → aᵀ κ a.
Vec3 along(const Vec2& a) { return {a[0] * a[0], a[1] * a[1], a[0] * a[1]}; }

/// Slope, out of the triangle and over its plane, at the middle of the edge opposite `corner`, of
/// the height function with curvature κ that vanishes at the corners: v · κ.
Vec3 mid_edge_slope(const FlatTriangle& f, int corner) {
  const Vec2 &start = f.p[(corner + 1) % 3], &end = f.p[(corner + 2) % 3];
  return (0.5 * along(f.p[corner] - 0.5 * (start + end)) - 0.125 * along(end - start)) /
         f.height(corner);
}

/// Index of `hinge` in the patch; the next free one if it is new.
int place_of(CurvaturePatch& patch, int hinge) {
  for (int k = 0; k < patch.hinges; ++k)
    if (patch.hinge[k] == hinge) return k;
  patch.hinge[patch.hinges] = hinge;
  return patch.hinges++;
}

/// Which particles a patch moves with, and where its hinges find theirs among them.
void list_particles(const std::vector<std::array<int, 4>>& hinges, const Triangle& corners,
                    CurvaturePatch& patch) {
  for (int k = 0; k < 3; ++k) patch.particle[k] = corners[k];
  for (int k = 0; k < patch.hinges; ++k) {
    if (patch.hinge[k] < 0) continue;
    for (int a = 0; a < 4; ++a) {
      const int v = hinges[patch.hinge[k]][a];
      int place = 0;
      while (place < patch.count && patch.particle[place] != v) ++place;
      if (place == patch.count) patch.particle[patch.count++] = v;
      patch.slot[k][a] = place;
    }
  }
}

}  // namespace

CurvaturePatches curvature_patches(const std::vector<Triangle>& triangles,
                                   const std::vector<std::array<Vec2, 3>>& triangle_uv,
                                   const std::vector<Mat3>& rigidity,
                                   const std::vector<char>& built_in) {
  const auto is_built_in = [&](int t) { return !built_in.empty() && built_in[t]; };
  using Side = geometry::MeshTopology::Side;
  const geometry::MeshTopology topology(triangles);
  std::vector<FlatTriangle> flat;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    flat.push_back(flat_triangle(triangle_uv[t], t));
  CurvaturePatches result;
  result.patches.resize(triangles.size());
  std::vector<std::array<Vec2, 3>> outer(triangles.size());
  std::vector<std::array<double, 3>> height(triangles.size());
  struct Neighbour {
    int triangle = -1, corner = 0;  ///< −1: a free border; its corner opposite the shared edge
  };
  std::vector<std::array<Neighbour, 3>> neighbour(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    result.patches[t].area = flat[t].area;
    for (int k = 0; k < 3; ++k) {
      const Vec2 &start = flat[t].p[(k + 1) % 3], &end = flat[t].p[(k + 2) % 3];
      const double along = (flat[t].p[k] - start).dot(end - start) / (end - start).squaredNorm();
      height[t][k] = flat[t].height(k);
      outer[t][k] = unfold(flat[t], k, along, height[t][k]);
    }
  }
  // In the order of the triangles, so that a hinge is near them in memory, too.
  const auto add_hinge = [&](std::span<const Side> sides) {
    const int hinge = static_cast<int>(result.hinges.size());
    for (int i = 0; i < 2; ++i) {
      const Side &here = sides[i], &there = sides[1 - i];
      const int opposite = (here.corner + 2) % 3, foreign = (there.corner + 2) % 3;
      const FlatTriangle& other = flat[there.triangle];
      // The neighbour runs along the edge the other way.
      const Vec2 &start = other.p[(there.corner + 1) % 3], &end = other.p[there.corner];
      const double along =
          (other.p[foreign] - start).dot(end - start) / (end - start).squaredNorm();
      result.patches[here.triangle].hinge[opposite] = hinge;
      neighbour[here.triangle][opposite] = {there.triangle, foreign};
      if (is_built_in(there.triangle)) {
        // The mirror image across the clamp line: twice the angle, at this triangle's own height.
        height[here.triangle][opposite] *= 2;
        continue;
      }
      height[here.triangle][opposite] = other.height(foreign);
      outer[here.triangle][opposite] =
          unfold(flat[here.triangle], opposite, along, other.height(foreign));
    }
    const Side &a = sides[0], &b = sides[1];
    result.hinges.push_back(
        {triangles[a.triangle][a.corner], triangles[a.triangle][(a.corner + 1) % 3],
         triangles[a.triangle][(a.corner + 2) % 3], triangles[b.triangle][(b.corner + 2) % 3]});
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto sides = topology.sides(topology.edge(static_cast<int>(t), k));
      if (sides.size() == 2 && sides[0].triangle == static_cast<int>(t) && sides[0].corner == k)
        add_hinge(sides);
    }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!is_built_in(static_cast<int>(t)))
      result.patches[t].fit = release_borders(quadratic_fit(flat[t], outer[t], height[t]),
                                              rigidity[t], flat[t], result.patches[t].hinge);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    CurvaturePatch& patch = result.patches[t];
    if (!is_built_in(static_cast<int>(t)))
      for (int k = 0; k < 3; ++k) {
        // s = ½ (θ + own slope − neighbour's slope); in a clamp line s = θ, at a border the own.
        const double length = (flat[t].p[(k + 1) % 3] - flat[t].p[(k + 2) % 3]).norm();
        const Vec2 n = flat[t].gradient[k].normalized();
        const Vec3 nn = length / flat[t].area * Vec3(n[0] * n[0], n[1] * n[1], 2 * n[0] * n[1]);
        const auto [other, corner] = neighbour[t][k];
        if (other >= 0 && is_built_in(other)) {
          patch.s.col(k) += nn;
          continue;
        }
        const double half = other < 0 ? 1.0 : 0.5;
        patch.s.leftCols<3>() += half * nn * (mid_edge_slope(flat[t], k).transpose() * patch.fit);
        if (other < 0) continue;
        patch.s.col(k) += half * nn;
        const CurvaturePatch& there = result.patches[other];
        const Eigen::RowVector3d slope =
            mid_edge_slope(flat[other], corner).transpose() * there.fit;
        for (int j = 0; j < 3; ++j)
          if (there.hinge[j] >= 0)
            patch.s.col(place_of(patch, there.hinge[j])) -= half * slope[j] * nn;
      }
    list_particles(result.hinges, triangles[t], patch);
  }
  return result;
}

}  // namespace loosefit::fabric
