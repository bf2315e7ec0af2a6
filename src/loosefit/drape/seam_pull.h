#pragma once
#include <vector>

#include "loosefit/particles/energy.h"

namespace loosefit::drape {

/// Threads that pull the partners of an open seam together. Between two partners at distance d
///
///   Π = k ε² (√(1 + d²/ε²) − 1)                                     [J]
///
/// a spring of length zero and stiffness k [N/m] near its goal, whose force does not exceed k ε
/// however far it has to go (ε [m]): a stronger one would draw cloth through a limb. Convex. Of n
/// partners of one point each pair has k/(n − 1).
class SeamPull : public particles::Energy {
 public:
  /// partners: particles that are to become one, several in each entry.
  SeamPull(const std::vector<std::vector<int>>& partners, double stiffness, double reach);
  double value(const particles::VectorField& x) const override;
  void add_gradient(const particles::VectorField& x, particles::VectorField& g) const override;
  void add_pattern(const particles::VectorField& x,
                   particles::BlockPattern& pattern) const override;
  void add_hessian(const particles::VectorField& x, particles::BlockMatrix& h,
                   particles::HessianKind kind) const override;

 private:
  struct Thread {
    int a, b;
    double stiffness;  ///< [N/m]
  };
  std::vector<Thread> threads_;
  double reach_;
};

/// Largest distance between two partners [m].
double widest_gap(const std::vector<std::vector<int>>& partners, const std::vector<Vec3>& x);

}  // namespace loosefit::drape
