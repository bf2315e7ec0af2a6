#include "loosefit/solver/matrix_choice.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace loosefit::solver {
namespace {

/// Says which matrices are definite: from so large a shift on, for each kind.
class Matrices : public NewtonProblem {
 public:
  std::map<particles::HessianKind, double> definite_from;  ///< shift [1/s²]
  std::string asked;  ///< e, h, p: assembled; a digit per factor: definite

  double evaluate(const particles::VectorField&, particles::VectorField&) override { return 0; }
  void restrict(particles::VectorField&) const override {}
  void assemble(const particles::VectorField&, particles::HessianKind kind) override {
    kind_ = kind;
    asked += kind == particles::HessianKind::exact              ? 'e'
             : kind == particles::HessianKind::half_compression ? 'h'
                                                                : 'p';
  }
  bool factorise(double shift) override {
    shifts.push_back(shift);
    const bool definite = shift >= definite_from[kind_];
    asked += definite ? '1' : '0';
    return definite;
  }
  void solve(const particles::VectorField&, particles::VectorField&) override {}
  double max_step(const particles::VectorField&, const particles::VectorField&) override {
    return 1;
  }
  std::vector<double> shifts;

 private:
  particles::HessianKind kind_ = particles::HessianKind::exact;
};

constexpr double kNever = 1e300;

constexpr bool kCalm = true;

TEST(MatrixChoice, TakesTheExactMatrixAfterACalmStepAlone) {
  Matrices m;
  EXPECT_EQ(factorise(m, {}, 0, kCalm, {}), MatrixKind::exact);
  EXPECT_EQ(factorise(m, {}, 0, !kCalm, {}), MatrixKind::half_compression);
  EXPECT_EQ(m.asked, "e1h1");
}

TEST(MatrixChoice, GoesOnUntilOneIsDefinite) {
  Matrices m;
  m.definite_from[particles::HessianKind::exact] = kNever;
  EXPECT_EQ(factorise(m, {}, 0, kCalm, {}), MatrixKind::half_compression);
  m.definite_from[particles::HessianKind::half_compression] = kNever;
  EXPECT_EQ(factorise(m, {}, 0, kCalm, {}), MatrixKind::projected);
  EXPECT_EQ(m.asked, "e0h1e0h0p1");
}

TEST(MatrixChoice, RegularisesASingularProjectedMatrixOrGivesUp) {
  Matrices m;
  m.definite_from[particles::HessianKind::exact] =
      m.definite_from[particles::HessianKind::half_compression] = kNever;
  m.definite_from[particles::HessianKind::projected] = 50;
  MatrixTuning tuning;
  EXPECT_EQ(factorise(m, {}, 0.5, kCalm, tuning), MatrixKind::regularised);
  EXPECT_EQ(m.shifts.back(), 100.5);
  m.definite_from[particles::HessianKind::projected] = kNever;
  EXPECT_EQ(factorise(m, {}, 0.5, kCalm, tuning), std::nullopt);
  tuning.max_regularisations = 0;
  m.definite_from[particles::HessianKind::projected] = 50;
  EXPECT_EQ(factorise(m, {}, 0.5, kCalm, tuning), std::nullopt);
}

TEST(MatrixChoice, LeavesOutTheKindsThatItsTuningLeavesOut) {
  Matrices m;
  MatrixTuning tuning;
  tuning.exact = tuning.half_compression = false;
  factorise(m, {}, 0, kCalm, tuning);
  EXPECT_EQ(m.asked, "p1");
}

}  // namespace
}  // namespace loosefit::solver
