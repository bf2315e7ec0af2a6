#include "loosefit/fabric/crimp_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/wool_sample.h"

namespace loosefit::fabric {
namespace {

CrimpLaw linear_law(double weft, double warp, double coupling) {
  CrimpLaw law;
  law.u = StressCurve::linear(weft);
  law.v = StressCurve::linear(warp);
  law.coupling = coupling;
  law.linear_u = weft;
  law.linear_v = warp;
  return law;
}

CrimpLaw wool_law() {
  const Material wool = support::wool_sample();
  CrimpLaw law;
  law.u = StressCurve::tension(wool.curve_weft);
  law.v = StressCurve::tension(wool.curve_warp);
  law.coupling = 0.2 * std::sqrt(law.u.smallest_tangent() * law.v.smallest_tangent());
  law.is_linear = false;
  law.linear_u = law.u.at(0).tangent;
  law.linear_v = law.v.at(0).tangent;
  return law;
}

struct Response {
  double energy;
  Vec2 stress, crimp;
  Mat2 tangent;
};

Response at(const CrimpLaw& law, const Vec2& strain, const Vec2& load) {
  PlaneRows e{};
  std::array<particles::TileRow, 2> loads{};
  for (int k = 0; k < 2; ++k) e[k].fill(strain[k]), loads[k].fill(load[k]);
  CrimpLaw::Rows rows;
  PlaneTangent c;
  law.respond(e, loads, rows, &c);
  Mat2 tangent;
  tangent << c[0][0], c[2][0], c[2][0], c[1][0];
  return {rows.energy[0],
          {rows.stress[0][0], rows.stress[1][0]},
          {rows.crimp[0][0], rows.crimp[1][0]},
          tangent};
}

/// Laws with loads of buckling: alike, unlike, coupled strongly, measured.
std::vector<std::pair<CrimpLaw, Vec2>> laws() {
  return {{linear_law(300, 700, 0), {2, 2}},
          {linear_law(300, 700, 200), {2, 9}},
          {linear_law(500, 400, -150), {4, 1}},
          {wool_law(), {3, 8}}};
}

std::vector<Vec2> strains(int count) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> u(-0.2, 0.1);
  std::vector<Vec2> all;
  for (int i = 0; i < count; ++i) all.push_back({u(rng), u(rng)});
  return all;
}

double elastic(const CrimpLaw& law, const Vec2& e) {
  return law.u.at(e[0]).energy + law.v.at(e[1]).energy + law.coupling * e[0] * e[1];
}

TEST(CrimpLaw, IsTheMinimumOverAllCrimps) {
  for (const auto& [law, load] : laws())
    for (const Vec2& strain : strains(40)) {
      const Response r = at(law, strain, load);
      const auto with = [&](const Vec2& c) {
        double waves = 0;
        for (int k = 0; k < 2; ++k) waves += load[k] * (c[k] + 0.75 * c[k] * c[k]);
        return elastic(law, strain + c) + waves;
      };
      EXPECT_NEAR(with(r.crimp), r.energy, 1e-12 * (1 + r.energy));
      EXPECT_GE(r.crimp.minCoeff(), 0);
      for (double du : {-1e-4, 0.0, 1e-4})
        for (double dv : {-1e-4, 0.0, 1e-4}) {
          const Vec2 other = (r.crimp + Vec2(du, dv)).cwiseMax(0);
          EXPECT_GE(with(other), r.energy - 1e-12) << strain.transpose();
        }
    }
}

TEST(CrimpLaw, StressAndTangentAreDerivatives) {
  const double h = 1e-7;
  for (const auto& [law, load] : laws())
    for (const Vec2& strain : strains(200)) {
      const Response r = at(law, strain, load);
      for (int k = 0; k < 2; ++k) {
        const Vec2 d = h * Vec2::Unit(k);
        const Response a = at(law, strain - d, load), b = at(law, strain + d, load);
        EXPECT_NEAR((b.energy - a.energy) / (2 * h), r.stress[k], 1e-5 * (1 + r.stress.norm()));
        if (((a.crimp.array() > 0) != (b.crimp.array() > 0)).any()) continue;  // the tangent jumps
        const Vec2 row = (b.stress - a.stress) / (2 * h);
        EXPECT_LT((row - r.tangent.col(k)).norm(), 1e-4 * (1 + r.tangent.norm()));
      }
    }
}

TEST(CrimpLaw, IsConvexAndPositive) {
  const std::vector<Vec2> all = strains(60);
  for (const auto& [law, load] : laws())
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
      const Response a = at(law, all[i], load), b = at(law, all[i + 1], load),
                     middle = at(law, 0.5 * (all[i] + all[i + 1]), load);
      EXPECT_LE(middle.energy, 0.5 * (a.energy + b.energy) + 1e-12);
      EXPECT_GE(a.tangent.determinant(), -1e-9 * a.tangent.squaredNorm());
      EXPECT_GE(a.tangent.trace(), 0);
    }
}

TEST(CrimpLaw, IsTheElasticLawInTension) {
  for (const auto& [law, load] : laws()) {
    const Vec2 e(0.02, 0.03);
    const Response r = at(law, e, load);
    EXPECT_EQ(r.crimp, Vec2(0, 0));
    EXPECT_NEAR(r.energy, elastic(law, e), 1e-12);
  }
}

// Love 1927, art. 263: an elastic line bent by P through the angle α at its ends has
// P/P_c = (2K/π)² and is shortened by Δ = 2 − 2E/K, K and E of the modulus sin(α/2).
TEST(CrimpLaw, CarriesTheForceOfTheElastica) {
  const double load = 2;
  const CrimpLaw law = linear_law(2e6, 2e6, 0);  // yarns that hardly shorten
  EXPECT_NEAR(at(law, {-1e-3, 0}, {load, load}).stress[0], -load, 0.01 * load);
  for (double angle : {0.2, 0.5, 0.8, 1.1}) {
    const double k = std::sin(angle / 2);
    const double shortening = 2 - 2 * std::comp_ellint_2(k) / std::comp_ellint_1(k);
    const double force = load * std::pow(2 * std::comp_ellint_1(k) / kPi, 2);
    const double stretch = 1 - shortening;
    const Response r = at(law, {0.5 * (stretch * stretch - 1), 0}, {load, load});
    EXPECT_NEAR(-r.stress[0] * stretch, force, (0.003 + 2.5 * shortening * shortening) * force)
        << angle;
  }
}

// Timoshenko and Gere 1961: a hinged strip of length L buckles at π² B/L², here in half a wave.
TEST(EulerLoad, IsThatOfAWaveOneEdgeLong) {
  const double h = 0.01, area = std::sqrt(3.0) / 4 * h * h, rigidity = 5e-6;
  EXPECT_NEAR(CrimpLaw::euler_load(rigidity, area), kPi * kPi * rigidity / (0.25 * h * h), 1e-12);
}

}  // namespace
}  // namespace loosefit::fabric
