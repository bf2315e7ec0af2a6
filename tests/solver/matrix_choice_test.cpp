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

/// Steps with the same matrices; what was asked in each.
std::string ask(MatrixChoice& choice, Matrices& matrices, int steps, double per_dt2) {
  std::string all;
  for (int k = 0; k < steps; ++k) {
    matrices.asked.clear();
    choice.factorise(matrices, {}, per_dt2);
    all += (k ? " " : "") + matrices.asked;
  }
  return all;
}

TEST(MatrixChoice, StaysWithTheExactMatrixWhileItIsDefinite) {
  Matrices m;
  MatrixChoice choice{MatrixTuning{}};
  EXPECT_EQ(choice.factorise(m, {}, 0), MatrixKind::exact);
  EXPECT_EQ(ask(choice, m, 3, 0), "e1 e1 e1");
}

TEST(MatrixChoice, PausesTwiceAsLongAfterEachFailure) {
  Matrices m;
  m.definite_from[particles::HessianKind::exact] =
      m.definite_from[particles::HessianKind::half_compression] = kNever;
  MatrixChoice choice{MatrixTuning{}};
  // With inertia there is no mass shift. Pauses of 1, 2 and 4 steps.
  EXPECT_EQ(ask(choice, m, 7, 1.0), "e0h0p1 p1 e0h0p1 p1 p1 e0h0p1 p1");
}

TEST(MatrixChoice, ShiftsTheExactMatrixByALittleInertiaInStaticStepsOnly) {
  Matrices m;
  m.definite_from[particles::HessianKind::exact] = 20;
  MatrixTuning tuning;
  MatrixChoice choice{tuning};
  EXPECT_EQ(choice.factorise(m, {}, 0), MatrixKind::mass_shifted);
  EXPECT_EQ(choice.factorise(m, {}, 0), MatrixKind::mass_shifted);  // 25/s²: still enough
  EXPECT_EQ(m.shifts, (std::vector<double>{0, 100, 0, 25}));
  EXPECT_EQ(choice.factorise(m, {}, 0), MatrixKind::half_compression);  // 6.25/s² is not
  tuning.mass_shift = false;
  MatrixChoice without{tuning};
  EXPECT_EQ(without.factorise(m, {}, 0), MatrixKind::half_compression);
}

TEST(MatrixChoice, RegularisesASingularProjectedMatrixOrGivesUp) {
  Matrices m;
  m.definite_from[particles::HessianKind::exact] =
      m.definite_from[particles::HessianKind::half_compression] = kNever;
  m.definite_from[particles::HessianKind::projected] = 50;
  MatrixTuning tuning;
  MatrixChoice choice{tuning};
  EXPECT_EQ(choice.factorise(m, {}, 0.5), MatrixKind::regularised);
  EXPECT_EQ(m.shifts.back(), 100.5);
  m.definite_from[particles::HessianKind::projected] = kNever;
  EXPECT_EQ(choice.factorise(m, {}, 0.5), std::nullopt);
  tuning.max_regularisations = 0;
  m.definite_from[particles::HessianKind::projected] = 50;
  MatrixChoice without{tuning};
  EXPECT_EQ(without.factorise(m, {}, 0.5), std::nullopt);
}

TEST(MatrixChoice, LeavesOutTheKindsThatItsTuningLeavesOut) {
  Matrices m;
  MatrixTuning tuning;
  tuning.exact = tuning.half_compression = false;
  MatrixChoice choice{tuning};
  EXPECT_EQ(ask(choice, m, 2, 0), "p1 p1");
}

}  // namespace
}  // namespace loosefit::solver
