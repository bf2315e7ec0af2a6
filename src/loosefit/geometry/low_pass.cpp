#include "loosefit/geometry/low_pass.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>

namespace loosefit::geometry {
namespace {

constexpr double kMostCotangent = 30;  // of slivers

using Places = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Two implicit steps of diffusion on the part of a surface that is not held.
class Diffusion {
 public:
  Diffusion(const std::vector<Vec3>& places, const std::vector<Triangle>& triangles,
            const std::vector<double>& spreads)
      : row_(places.size(), -1) {
    int rows = 0;
    for (std::size_t v = 0; v < places.size(); ++v)
      if (spreads[v] > 0) {
        row_[v] = rows++;
        vertex_.push_back(static_cast<int>(v));
      }
    mass_ = Eigen::VectorXd::Constant(rows, 1e-12);
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(rows);
    std::vector<Eigen::Triplet<double>> entries;
    for (const Triangle& t : triangles) {
      const double area = triangle_area(places[t[0]], places[t[1]], places[t[2]]);
      if (!(area > 0)) continue;
      for (int k = 0; k < 3; ++k) {
        if (row_[t[k]] >= 0) mass_[row_[t[k]]] += area / 3;
        // The edge opposite this corner; half of a step for each of the two.
        const int a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        if (row_[a] < 0 && row_[b] < 0) continue;
        const double cotangent =
            std::clamp((places[a] - places[t[k]]).dot(places[b] - places[t[k]]) / (2 * area), 0.0,
                       kMostCotangent);
        const double length = 0.5 * (spreads[a] + spreads[b]);
        const double weight = 0.5 * 0.5 * cotangent * length * length;
        for (const auto& [one, other] : {std::pair{a, b}, {b, a}}) {
          if (row_[one] < 0) continue;
          diagonal[row_[one]] += weight;
          if (row_[other] >= 0)
            entries.emplace_back(row_[one], row_[other], -weight);
          else
            held_.push_back({row_[one], other, weight});
        }
      }
    }
    for (int i = 0; i < rows; ++i) entries.emplace_back(i, i, mass_[i] + diagonal[i]);
    Eigen::SparseMatrix<double> matrix(rows, rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    factors_.compute(matrix);
  }
  bool works() const { return !vertex_.empty() && factors_.info() == Eigen::Success; }
  std::vector<Vec3> apply(std::vector<Vec3> values) const {
    Places right(mass_.size(), 3);
    for (int step = 0; step < 2; ++step) {
      for (Eigen::Index i = 0; i < right.rows(); ++i)
        right.row(i) = mass_[i] * values[vertex_[i]].transpose();
      for (const Held& h : held_) right.row(h.row) += h.weight * values[h.vertex].transpose();
      const Places solved = factors_.solve(right);
      for (Eigen::Index i = 0; i < right.rows(); ++i) values[vertex_[i]] = solved.row(i);
    }
    return values;
  }

 private:
  struct Held {
    int row, vertex;
    double weight;
  };
  std::vector<int> row_, vertex_;
  Eigen::VectorXd mass_;
  std::vector<Held> held_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace

std::vector<Vec3> low_passed(std::vector<Vec3> values, const TriangleMesh& mesh,
                             const std::vector<double>& spreads) {
  const Diffusion diffusion(mesh.vertices, mesh.triangles, spreads);
  if (!diffusion.works()) return values;
  std::vector<Vec3> smooth(values.size(), Vec3::Zero());
  for (int time = 0; time < 3; ++time) {
    const std::vector<Vec3> part = diffusion.apply(values);
    for (std::size_t v = 0; v < values.size(); ++v) {
      smooth[v] += part[v];
      values[v] -= part[v];
    }
  }
  return smooth;
}

}  // namespace loosefit::geometry
