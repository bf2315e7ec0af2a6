#include "trial_membrane.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/fabric/bending_energy.h"
#include "loosefit/particles/tile.h"

namespace loosefit::bench {

using fabric::CurvaturePatch;

TrialMembrane::TrialMembrane(const std::vector<Triangle>& triangles,
                             const std::vector<std::array<Vec2, 3>>& triangle_uv,
                             const fabric::Material& m, const MembraneTrial& trial)
    : triangles_(triangles), trial_(trial) {
  const double nu = m.poisson, plate = 1 - nu * nu;
  Mat3 law;
  law << m.stiffness_weft / plate, nu * std::sqrt(m.stiffness_weft * m.stiffness_warp) / plate, 0,
      nu * std::sqrt(m.stiffness_weft * m.stiffness_warp) / plate, m.stiffness_warp / plate, 0, 0,
      0, m.stiffness_shear;
  mesh_ = fabric::curvature_patches(triangles, triangle_uv,
                                    std::vector<Mat3>(triangles.size(), fabric::plate_rigidity(m)));
  for (const auto& [a, b, c] : triangle_uv) {
    const double d = a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]);
    Flat f;
    f.ru = {(b[1] - c[1]) / d, (c[1] - a[1]) / d, (a[1] - b[1]) / d};
    f.rv = {(c[0] - b[0]) / d, (a[0] - c[0]) / d, (b[0] - a[0]) / d};
    f.area = 0.5 * std::abs(d);
    const Vec2 edge[] = {c - b, a - c, b - a};
    for (int k = 0; k < 3; ++k)
      f.chords.row(k) << edge[k][0] * edge[k][0], edge[k][1] * edge[k][1], edge[k][0] * edge[k][1];
    f.inverse = f.chords.inverse();
    flat_.push_back(f);
  }
  const double own = trial.triangle_share;
  Mat3 on_triangles = own * law, on_patches = (1 - own) * law;
  if (trial.shear_stays) on_triangles(2, 2) = law(2, 2), on_patches(2, 2) = 0;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    points_.push_back({flat_[t].area, {t}, {1.0}, {}, on_triangles});
  if (own < 1) {
    double share = 1;  // of each triangle in a patch
    std::vector<std::vector<int>> patches;
    std::map<std::pair<int, int>, std::vector<int>> edges;
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
      for (int k = 0; k < 3; ++k) {
        const int v = triangles[t][k], w = triangles[t][(k + 1) % 3];
        edges[{std::min(v, w), std::max(v, w)}].push_back(t);
      }
    if (trial.smooth == MembraneTrial::Smooth::nodes) {
      share = 1.0 / 3;
      for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
        for (int v : triangles[t]) {
          if (v >= static_cast<int>(patches.size())) patches.resize(v + 1);
          patches[v].push_back(t);
        }
    } else if (trial.smooth == MembraneTrial::Smooth::edges) {
      share = 1.0 / 3;
      for (const auto& [edge, beside] : edges) patches.push_back(beside);
    } else {
      // Whoever has the fewest partners left chooses first, the longest edge.
      std::vector<std::vector<std::pair<double, int>>> beside(triangles.size());
      for (const auto& [edge, pair] : edges) {
        if (pair.size() != 2) continue;
        const auto length_in = [&](int t) {
          for (int k = 0; k < 3; ++k) {
            const int v = triangles[t][k], w = triangles[t][(k + 1) % 3];
            if (std::min(v, w) == edge.first && std::max(v, w) == edge.second)
              return (triangle_uv[t][(k + 1) % 3] - triangle_uv[t][k]).norm();
          }
          return 0.0;
        };
        const double length = length_in(pair[0]);
        beside[pair[0]].push_back({length, pair[1]});
        beside[pair[1]].push_back({length, pair[0]});
      }
      std::vector<char> taken(triangles.size(), 0);
      const auto left = [&](int t) {
        int n = 0;
        for (const auto& [length, other] : beside[t]) n += !taken[other];
        return n;
      };
      std::vector<std::vector<int>> queue(4);
      for (int t = 0; t < static_cast<int>(triangles.size()); ++t) queue[left(t)].push_back(t);
      for (int n = 0; n < 4;) {
        if (queue[n].empty()) {
          ++n;
          continue;
        }
        const int t = queue[n].back();
        queue[n].pop_back();
        if (taken[t] || left(t) != n) continue;
        taken[t] = 1;
        std::pair<double, int> best{-1, -1};
        for (const auto& [length, other] : beside[t])
          if (!taken[other]) best = std::max(best, {length, other});
        if (best.second < 0) {
          patches.push_back({t});
          continue;
        }
        taken[best.second] = 1;
        patches.push_back({t, best.second});
        for (int side : {t, best.second})
          for (const auto& [length, other] : beside[side])
            if (!taken[other]) queue[left(other)].push_back(other), n = std::min(n, left(other));
      }
    }
    for (const std::vector<int>& around : patches) {
      Point p{0, around, {}, {}, on_patches};
      for (int t : around) p.area += share * flat_[t].area;
      for (int t : around) p.weight.push_back(share * flat_[t].area / p.area);
      points_.push_back(p);
    }
  }
  for (Point& p : points_) {
    for (int t : p.triangle) {
      int count = 0;
      const int* of = particles_of(t, count);
      p.particle.insert(p.particle.end(), of, of + count);
    }
    std::sort(p.particle.begin(), p.particle.end());
    p.particle.erase(std::unique(p.particle.begin(), p.particle.end()), p.particle.end());
  }
}

const int* TrialMembrane::particles_of(int t, int& count) const {
  if (trial_.arc == MembraneTrial::Arc::none) {
    count = 3;
    return triangles_[t].data();
  }
  const CurvaturePatch& p = mesh_.patches[t];
  count = p.count;
  if (trial_.arc == MembraneTrial::Arc::own_angles) {
    // Corners and the free corners of the neighbours come first.
    int last = 2;
    for (int k = 0; k < 3; ++k)
      if (p.hinge[k] >= 0)
        for (int a = 0; a < 4; ++a) last = std::max(last, p.slot[k][a]);
    count = last + 1;
  }
  return p.particle.data();
}

Eigen::Matrix<double, 3, 9> TrialMembrane::fit_of(int t) const {
  const CurvaturePatch& p = mesh_.patches[t];
  if (trial_.arc == MembraneTrial::Arc::patch) return p.s;
  Eigen::Matrix<double, 3, 9> s = Eigen::Matrix<double, 3, 9>::Zero();
  s.leftCols<3>() = p.fit;
  return s;
}

void TrialMembrane::find_angles(const particles::VectorField& x) const {
  if (trial_.arc == MembraneTrial::Arc::none) return;
  angle_.resize(mesh_.hinges.size());
  turn_.resize(mesh_.hinges.size());
  for (std::size_t h = 0; h < mesh_.hinges.size(); ++h) {
    const auto& v = mesh_.hinges[h];
    const Vec3 e = x[v[1]] - x[v[0]];
    const Vec3 a = x[v[2]] - x[v[0]], b = x[v[3]] - x[v[0]];
    const double l = e.norm();
    const Vec3 n1 = e.cross(a), n2 = b.cross(e);
    angle_[h] = std::atan2(n1.cross(n2).dot(e / l), n1.dot(n2));
    turn_[h][2] = -l / n1.squaredNorm() * n1;
    turn_[h][3] = -l / n2.squaredNorm() * n2;
    const double s1 = a.dot(e) / (l * l), s2 = b.dot(e) / (l * l);
    turn_[h][1] = -(s1 * turn_[h][2] + s2 * turn_[h][3]);
    turn_[h][0] = -(turn_[h][1] + turn_[h][2] + turn_[h][3]);
  }
}

TrialMembrane::Local TrialMembrane::local(int t, const particles::VectorField& x,
                                          bool with_rows) const {
  const Flat& f = flat_[t];
  const Triangle& c = triangles_[t];
  Vec3 u = Vec3::Zero(), v = Vec3::Zero();
  for (int k = 0; k < 3; ++k) u += f.ru[k] * x[c[k]], v += f.rv[k] * x[c[k]];
  Local l;
  l.strain = Vec3(0.5 * (u.squaredNorm() - 1), 0.5 * (v.squaredNorm() - 1), u.dot(v));
  l.curvature = l.reach = Vec3::Zero();
  int count = 3;
  particles_of(t, count);
  if (with_rows) {
    l.rows.assign(count, Mat3::Zero());
    for (int k = 0; k < 3; ++k) {
      l.rows[k].row(0) = f.ru[k] * u.transpose();
      l.rows[k].row(1) = f.rv[k] * v.transpose();
      l.rows[k].row(2) = f.ru[k] * v.transpose() + f.rv[k] * u.transpose();
    }
  }
  if (trial_.arc == MembraneTrial::Arc::none) return l;
  const CurvaturePatch& p = mesh_.patches[t];
  const auto s = fit_of(t);
  const int hinges = trial_.arc == MembraneTrial::Arc::patch ? p.hinges : 3;
  for (int j = 0; j < hinges; ++j)
    if (p.hinge[j] >= 0) l.curvature += angle_[p.hinge[j]] * s.col(j);
  l.reach = f.chords * l.curvature;
  l.strain += f.inverse * (l.reach.cwiseAbs2() / 24);
  if (!with_rows) return l;
  const Mat3 lever = f.inverse * (l.reach / 12).asDiagonal() * f.chords;
  for (int j = 0; j < hinges; ++j) {
    if (p.hinge[j] < 0) continue;
    const Vec3 d = lever * s.col(j);
    for (int a = 0; a < 4; ++a) l.rows[p.slot[j][a]] += d * turn_[p.hinge[j]][a].transpose();
  }
  return l;
}

Vec3 TrialMembrane::strain(int triangle, const particles::VectorField& x) const {
  find_angles(x);
  return local(triangle, x, false).strain;
}

double TrialMembrane::value(const particles::VectorField& x) const {
  find_angles(x);
  std::vector<Vec3> strain(triangles_.size());
  for (std::size_t t = 0; t < strain.size(); ++t)
    strain[t] = local(static_cast<int>(t), x, false).strain;
  double sum = 0;
  for (const Point& p : points_) {
    Vec3 e = Vec3::Zero();
    for (std::size_t k = 0; k < p.triangle.size(); ++k) e += p.weight[k] * strain[p.triangle[k]];
    sum += 0.5 * p.area * e.dot(p.law * e);
  }
  return sum;
}

void TrialMembrane::add_gradient(const particles::VectorField& x, particles::VectorField& g) const {
  find_angles(x);
  std::vector<Local> locals(triangles_.size());
  for (std::size_t t = 0; t < locals.size(); ++t) locals[t] = local(static_cast<int>(t), x, true);
  std::vector<Vec3> stress(triangles_.size(), Vec3::Zero());
  for (const Point& p : points_) {
    Vec3 e = Vec3::Zero();
    for (std::size_t k = 0; k < p.triangle.size(); ++k)
      e += p.weight[k] * locals[p.triangle[k]].strain;
    const Vec3 s = p.area * (p.law * e);
    for (std::size_t k = 0; k < p.triangle.size(); ++k) stress[p.triangle[k]] += p.weight[k] * s;
  }
  for (std::size_t t = 0; t < locals.size(); ++t) {
    int count = 0;
    const int* of = particles_of(static_cast<int>(t), count);
    for (int i = 0; i < count; ++i) g[of[i]] += locals[t].rows[i].transpose() * stress[t];
  }
}

void TrialMembrane::add_pattern(const particles::VectorField&, particles::BlockPattern& p) const {
  for (const Point& point : points_)
    for (std::size_t i = 0; i < point.particle.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) p.add(point.particle[i], point.particle[j]);
}

void TrialMembrane::add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                                particles::HessianKind kind) const {
  const double negative = kind == particles::HessianKind::exact              ? 1
                          : kind == particles::HessianKind::half_compression ? 0.5
                                                                             : 0;
  find_angles(x);
  std::vector<Local> locals(triangles_.size());
  for (std::size_t t = 0; t < locals.size(); ++t) locals[t] = local(static_cast<int>(t), x, true);
  std::vector<Vec3> stress(triangles_.size(), Vec3::Zero());
  for (const Point& p : points_) {
    Vec3 e = Vec3::Zero();
    std::vector<Mat3> rows(p.particle.size(), Mat3::Zero());
    for (std::size_t k = 0; k < p.triangle.size(); ++k) {
      const int t = p.triangle[k];
      e += p.weight[k] * locals[t].strain;
      int count = 0;
      const int* of = particles_of(t, count);
      for (int i = 0; i < count; ++i) {
        const auto at = std::lower_bound(p.particle.begin(), p.particle.end(), of[i]);
        rows[at - p.particle.begin()] += p.weight[k] * locals[t].rows[i];
      }
    }
    const Vec3 s = p.area * (p.law * e);
    for (std::size_t k = 0; k < p.triangle.size(); ++k) stress[p.triangle[k]] += p.weight[k] * s;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        h.add(p.particle[i], p.particle[j], p.area * rows[i].transpose() * p.law * rows[j]);
  }
  // Stress on the second derivatives of the strain.
  std::vector<double> moment(mesh_.hinges.size(), 0.0);
  for (std::size_t t = 0; t < locals.size(); ++t) {
    const Flat& f = flat_[t];
    Mat2 tension;
    tension << stress[t][0], stress[t][2], stress[t][2], stress[t][1];
    const Eigen::SelfAdjointEigenSolver<Mat2> split(tension);
    Vec2 kept = split.eigenvalues();
    for (double& k : kept)
      if (k < 0) k *= negative;
    tension = split.eigenvectors() * kept.asDiagonal() * split.eigenvectors().transpose();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) {
        const double w = Vec2(f.ru[i], f.rv[i]).dot(tension * Vec2(f.ru[j], f.rv[j]));
        h.add(triangles_[t][i], triangles_[t][j], w * Mat3::Identity());
      }
    if (trial_.arc == MembraneTrial::Arc::none) continue;
    const CurvaturePatch& p = mesh_.patches[t];
    const auto s = fit_of(t);
    const int hinges = trial_.arc == MembraneTrial::Arc::patch ? p.hinges : 3;
    const Vec3 pull = f.inverse.transpose() * stress[t];
    for (int j = 0; j < hinges; ++j)
      if (p.hinge[j] >= 0)
        moment[p.hinge[j]] += pull.cwiseProduct(locals[t].reach).dot(f.chords * s.col(j)) / 12;
    int count = 0;
    const int* of = particles_of(static_cast<int>(t), count);
    for (int k = 0; k < 3; ++k) {
      double w = pull[k] / 12;
      if (w < 0) w *= negative;
      if (w == 0) continue;
      std::vector<Vec3> row(count, Vec3::Zero());
      for (int j = 0; j < hinges; ++j)
        if (p.hinge[j] >= 0)
          for (int a = 0; a < 4; ++a)
            row[p.slot[j][a]] += f.chords.row(k).dot(s.col(j)) * turn_[p.hinge[j]][a];
      for (int i = 0; i < count; ++i)
        for (int j = 0; j <= i; ++j) h.add(of[i], of[j], w * row[i] * row[j].transpose());
    }
  }
  if (trial_.arc == MembraneTrial::Arc::none || negative == 0) return;
  // Moments on the second derivatives of the angles.
  for (std::size_t first = 0; first < mesh_.hinges.size(); first += particles::kTile) {
    fabric::HingePoints point;
    particles::TileRow zero{}, scale{};
    for (int i = 0; i < particles::kTile; ++i) {
      const std::size_t hinge = std::min(first + i, mesh_.hinges.size() - 1);
      if (first + i < mesh_.hinges.size()) scale[i] = negative * moment[hinge];
      for (int a = 0; a < 4; ++a)
        for (int c = 0; c < 3; ++c) point[a][c][i] = x[mesh_.hinges[hinge][a]][c];
    }
    fabric::HingeBlocks rows;
    fabric::hinge_blocks(point, zero, scale, rows);
    for (int i = 0; i < particles::kTile && first + i < mesh_.hinges.size(); ++i) {
      const auto& v = mesh_.hinges[first + i];
      int block = 0;
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b, ++block) {
          Mat3 m;
          for (int q = 0; q < 3; ++q)
            for (int r = 0; r < 3; ++r) m(r, q) = rows[9 * block + 3 * q + r][i];
          h.add(v[a], v[b], m);
        }
    }
  }
}

}  // namespace loosefit::bench
