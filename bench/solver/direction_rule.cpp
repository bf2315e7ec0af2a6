#include "direction_rule.h"

#include <Eigen/Dense>
#include <deque>

#include "vector_sums.h"

namespace loosefit::bakeoff {
namespace {

particles::VectorField downhill(const particles::VectorField& g, const Preconditioner& solve) {
  particles::VectorField z;
  solve(g, z);
  for (Vec3& v : z) v = -v;
  return z;
}

class Plain : public DirectionRule {
 public:
  particles::VectorField direction(const particles::VectorField& g, const Preconditioner& solve,
                                   const Product&, const Inertia&) override {
    return downhill(g, solve);
  }
};

class Lbfgs : public DirectionRule {
 public:
  explicit Lbfgs(int memory) : memory_(memory) {}

  particles::VectorField direction(const particles::VectorField& g, const Preconditioner& solve,
                                   const Product&, const Inertia& inertia) override {
    const std::size_t m = past_.size();
    std::vector<particles::VectorField> y(m);
    std::vector<double> alpha(m), rho(m);
    particles::VectorField q = g;
    for (std::size_t k = m; k-- > 0;) {
      y[k] = past_[k].y;
      add(1, inertia(past_[k].s), y[k]);
      rho[k] = 1 / particles::dot(y[k], past_[k].s);
      alpha[k] = rho[k] * particles::dot(past_[k].s, q);
      add(-alpha[k], y[k], q);
    }
    particles::VectorField dx;
    solve(q, dx);
    for (std::size_t k = 0; k < m; ++k)
      add(alpha[k] - rho[k] * particles::dot(y[k], dx), past_[k].s, dx);
    for (Vec3& v : dx) v = -v;
    return dx;
  }
  void accepted(const particles::VectorField& s, const particles::VectorField& y) override {
    // Along a direction that curves downwards a definite matrix has nothing to learn.
    if (!(particles::dot(s, y) > 1e-8 * norm(s) * norm(y))) return;
    past_.push_back({s, y});
    if (static_cast<int>(past_.size()) > memory_) past_.pop_front();
  }
  void forget() override { past_.clear(); }

 private:
  struct Change {
    particles::VectorField s, y;
  };
  int memory_;
  std::deque<Change> past_;
};

class Inexact : public DirectionRule {
 public:
  Inexact(double forcing, int most) : forcing_(forcing), most_(most) {}

  particles::VectorField direction(const particles::VectorField& g, const Preconditioner& solve,
                                   const Product& multiply, const Inertia& inertia) override {
    particles::VectorField dx(g.size(), Vec3::Zero()), r = g, z, hp;
    for (Vec3& v : r) v = -v;
    solve(r, z);
    particles::VectorField p = z;
    double rz = particles::dot(r, z);
    const double goal = forcing_ * forcing_ * rz;
    for (int k = 0; k < most_; ++k) {
      multiply(p, hp);
      add(1, inertia(p), hp);
      const double curvature = particles::dot(p, hp);
      if (!(curvature > 0)) return k == 0 ? z : dx;
      const double step = rz / curvature;
      add(step, p, dx);
      add(-step, hp, r);
      solve(r, z);
      const double next = particles::dot(r, z);
      if (!(next > goal)) break;
      for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + next / rz * p[i];
      rz = next;
    }
    return dx;
  }
  bool multiplies() const override { return true; }

 private:
  double forcing_;
  int most_;
};

class Conjugate : public DirectionRule {
 public:
  particles::VectorField direction(const particles::VectorField& g, const Preconditioner& solve,
                                   const Product&, const Inertia&) override {
    particles::VectorField d = downhill(g, solve);
    const double gz = -particles::dot(g, d);
    if (!g_.empty() && gz_ > 0) {
      const double beta = (gz + particles::dot(g_, d)) / gz_;
      if (beta > 0) add(beta, d_, d);
    }
    g_ = g;
    gz_ = gz;
    d_ = d;
    return d;
  }
  void forget() override { g_.clear(); }

 private:
  particles::VectorField g_, d_;
  double gz_ = 0;
};

class Anderson : public DirectionRule {
 public:
  explicit Anderson(int memory) : memory_(memory) {}

  particles::VectorField direction(const particles::VectorField& g, const Preconditioner& solve,
                                   const Product&, const Inertia&) override {
    particles::VectorField f = downhill(g, solve);
    if (!s_.empty()) {
      past_.push_back({s_, difference(f, f_)});
      if (static_cast<int>(past_.size()) > memory_) past_.pop_front();
    }
    f_ = f;
    s_.clear();
    const int m = static_cast<int>(past_.size());
    if (m == 0) return f;
    Eigen::MatrixXd a(m, m);
    Eigen::VectorXd b(m);
    for (int i = 0; i < m; ++i) {
      b[i] = particles::dot(past_[i].df, f);
      for (int j = 0; j <= i; ++j) a(i, j) = a(j, i) = particles::dot(past_[i].df, past_[j].df);
    }
    a.diagonal().array() += 1e-12 * a.diagonal().maxCoeff();
    const Eigen::VectorXd gamma = a.ldlt().solve(b);
    for (int i = 0; i < m; ++i) {
      add(-gamma[i], past_[i].s, f);
      add(-gamma[i], past_[i].df, f);
    }
    return f;
  }
  void accepted(const particles::VectorField& s, const particles::VectorField&) override { s_ = s; }
  void forget() override {
    past_.clear();
    s_.clear();
  }

 private:
  struct Change {
    particles::VectorField s, df;
  };
  int memory_;
  std::deque<Change> past_;
  particles::VectorField f_, s_;
};

}  // namespace

std::unique_ptr<DirectionRule> make_plain() { return std::make_unique<Plain>(); }
std::unique_ptr<DirectionRule> make_lbfgs(int memory) { return std::make_unique<Lbfgs>(memory); }
std::unique_ptr<DirectionRule> make_inexact(double forcing, int most_products) {
  return std::make_unique<Inexact>(forcing, most_products);
}
std::unique_ptr<DirectionRule> make_conjugate() { return std::make_unique<Conjugate>(); }
std::unique_ptr<DirectionRule> make_anderson(int memory) {
  return std::make_unique<Anderson>(memory);
}

}  // namespace loosefit::bakeoff
