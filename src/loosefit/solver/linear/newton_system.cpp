#include "loosefit/solver/linear/newton_system.h"

#include "loosefit/base/check.h"
#include "loosefit/particles/vector_sums.h"

namespace loosefit::solver {

bool NewtonSystem::factorise(const particles::BlockMatrix& a, const std::vector<double>& shift,
                             const std::vector<char>& held) {
  a_ = &a;
  shift_ = &shift;
  held_ = &held;
  used_double_ = in_double_;
  if (!in_double_ && single_.factorise(a, shift, held)) {
    broke_down_ = 0;
    double_.release();
    return true;
  }
  // Indefinite, or a matter of precision? Each time that it was the former, ask less often.
  if (!in_double_ && !try_double_.ready()) return false;
  if (!double_.factorise(a, shift, held)) {
    if (!in_double_) {
      try_double_.failed();
      double_.release();
    }
    return false;
  }
  used_double_ = true;
  if (!in_double_) in_double_ = ++broke_down_ == tuning_.max_breakdowns;
  single_.release();
  return true;
}

void NewtonSystem::solve(const std::vector<Vec3>& g, std::vector<Vec3>& dx) {
  LOOSEFIT_ASSERT(a_ && static_cast<int>(g.size()) == a_->particles());
  std::vector<Vec3> b(g.size());
  for (std::size_t i = 0; i < g.size(); ++i) b[i] = -g[i];
  drop_held(b);
  if (!used_double_ && !conjugate_gradients(b, dx)) {
    in_double_ = true;
    single_.release();
    used_double_ = double_.factorise(*a_, *shift_, *held_);
  }
  if (used_double_) double_.solve(b, dx);
  drop_held(dx);
}

bool NewtonSystem::conjugate_gradients(const std::vector<Vec3>& b, std::vector<Vec3>& x) {
  std::vector<Vec3> r = b, z, p, ap(b.size());
  x.assign(b.size(), Vec3::Zero());
  const double enough = tuning_.accuracy * tuning_.accuracy * particles::dot(b, b);
  single_.solve(r, z);
  p = z;
  double rz = particles::dot(r, z);
  for (int k = 0; k < tuning_.max_iterations; ++k) {
    multiply(p, ap);
    const double curvature = particles::dot(p, ap);
    if (!(curvature > 0)) {
      // Indefinite by less than single precision sees: what there is goes down.
      if (k == 0) x = z;
      return true;
    }
    const double step = rz / curvature;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += step * p[i];
      r[i] -= step * ap[i];
    }
    if (particles::dot(r, r) <= enough) return true;
    single_.solve(r, z);
    const double next = particles::dot(r, z);
    if (!(next > 0)) return false;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + next / rz * p[i];
    rz = next;
  }
  return false;
}

void NewtonSystem::multiply(const std::vector<Vec3>& x, std::vector<Vec3>& y) const {
  for (std::size_t i = 0; i < x.size(); ++i) y[i] = (*shift_)[i] * x[i];
  a_->add_product(x, y);
  drop_held(y);
}

void NewtonSystem::drop_held(std::vector<Vec3>& v) const {
  for (std::size_t i = 0; i < held_->size(); ++i)
    if ((*held_)[i]) v[i].setZero();
}

}  // namespace loosefit::solver
