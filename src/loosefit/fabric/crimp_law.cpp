#include "loosefit/fabric/crimp_law.h"

#include <algorithm>
#include <cmath>

namespace loosefit::fabric {
namespace {

constexpr double kRise = CrimpLaw::kRise;
/// Of the initial tangent, the least that a step divides by: a curve may yield in tension.
constexpr double kLeast = 1e-3;

/// The crimp c ≥ 0 with M c + q ≥ 0 and (M c + q)·c = 0, M = (mu k; k mv) positive definite.
struct Complement {
  double u, v;
};
inline Complement complement(double mu, double mv, double k, double qu, double qv) {
  const double only_u = std::max(0.0, -qu / mu), only_v = std::max(0.0, -qv / mv);
  const double det = mu * mv - k * k;
  const double both_u = (k * qv - mv * qu) / det, both_v = (k * qu - mu * qv) / det;
  const bool u_alone = qv + k * only_u >= 0, v_alone = qu + k * only_v >= 0;
  return {u_alone ? only_u : v_alone ? 0.0 : both_u, u_alone ? 0.0 : v_alone ? only_v : both_v};
}

/// (C⁻¹ + S⁻¹)⁻¹ over the buckled directions: C = (a k; k b) of the yarns, S = slope of the waves.
inline void soften(double& a, double& b, double& k, double su, double sv, bool in_u, bool in_v) {
  const double mu = in_u ? a + su : 1, mv = in_v ? b + sv : 1, off = in_u && in_v ? k : 0;
  const double det = mu * mv - off * off;
  // C − C_B M⁻¹ C_Bᵀ, with the columns of C that have buckled.
  const double au = in_u ? a : 0, ku = in_u ? k : 0, kv = in_v ? k : 0, bv = in_v ? b : 0;
  const double uu = a - (mv * au * au - 2 * off * au * kv + mu * kv * kv) / det;
  const double vv = b - (mv * ku * ku - 2 * off * ku * bv + mu * bv * bv) / det;
  const double uv = k - (mv * au * ku - off * (au * bv + ku * kv) + mu * kv * bv) / det;
  a = uu, b = vv, k = uv;
}

LOOSEFIT_VECTORISED
void respond_linear(double a, double b, double k, const PlaneRows& strain,
                    const std::array<particles::TileRow, 2>& load, CrimpLaw::Rows& out) {
  for (int i = 0; i < particles::kTile; ++i) {
    const double lu = load[0][i], lv = load[1][i];
    const double su = a * strain[0][i] + k * strain[1][i];
    const double sv = k * strain[0][i] + b * strain[1][i];
    const Complement c = complement(a + kRise * lu, b + kRise * lv, k, su + lu, sv + lv);
    const double u = su + a * c.u + k * c.v, v = sv + k * c.u + b * c.v;
    out.stress[0][i] = u;
    out.stress[1][i] = v;
    out.crimp[0][i] = c.u;
    out.crimp[1][i] = c.v;
    out.energy[i] = 0.5 * (u * (strain[0][i] + c.u) + v * (strain[1][i] + c.v)) +
                    lu * c.u * (1 + 0.5 * kRise * c.u) + lv * c.v * (1 + 0.5 * kRise * c.v);
  }
}

}  // namespace

double CrimpLaw::euler_load(double rigidity, double area) {
  return kEuler * rigidity * std::sqrt(3.0) / (4 * area);
}

void CrimpLaw::respond(const PlaneRows& strain, const std::array<particles::TileRow, 2>& load,
                       Rows& out, PlaneTangent* tangent) const {
  if (is_linear) respond_linear(linear_u, linear_v, coupling, strain, load, out);
  for (int i = 0; i < particles::kTile; ++i) {
    double a = linear_u, b = linear_v, k = coupling;
    const double lu = load[0][i], lv = load[1][i];
    if (!is_linear) {
      // Newton on the complementarity problem; one step where the yarns are linear in compression.
      constexpr int kMost = 50, kHalvings = 30;
      const double least_u = kLeast * u.at(0).tangent, least_v = kLeast * v.at(0).tangent;
      const auto energy = [&](const Complement& at) {
        const double eu = strain[0][i] + at.u, ev = strain[1][i] + at.v;
        return u.at(eu).energy + v.at(ev).energy + k * eu * ev +
               lu * at.u * (1 + 0.5 * kRise * at.u) + lv * at.v * (1 + 0.5 * kRise * at.v);
      };
      Complement c{0, 0};
      StressCurve::Response ru = u.at(strain[0][i]), rv = v.at(strain[1][i]);
      for (int step = 0; step < kMost; ++step) {
        const double eu = strain[0][i] + c.u, ev = strain[1][i] + c.v;
        const double mu = std::max(ru.tangent, least_u) + kRise * lu;
        const double mv = std::max(rv.tangent, least_v) + kRise * lv;
        const double qu = ru.stress + k * ev + lu * (1 + kRise * c.u) - mu * c.u - k * c.v;
        const double qv = rv.stress + k * eu + lv * (1 + kRise * c.v) - k * c.u - mv * c.v;
        Complement next = complement(mu, mv, k, qu, qv);
        if (next.u == c.u && next.v == c.v) break;
        // The step of a bent curve may go too far.
        const double now = energy(c);
        for (int n = 0; n < kHalvings && energy(next) > now; ++n)
          next = {0.5 * (c.u + next.u), 0.5 * (c.v + next.v)};
        const double moved = std::max(std::abs(next.u - c.u), std::abs(next.v - c.v));
        c = next;
        ru = u.at(strain[0][i] + c.u), rv = v.at(strain[1][i] + c.v);
        if (moved < 1e-14) break;
      }
      const double eu = strain[0][i] + c.u, ev = strain[1][i] + c.v;
      out.stress[0][i] = ru.stress + k * ev;
      out.stress[1][i] = rv.stress + k * eu;
      out.crimp[0][i] = c.u;
      out.crimp[1][i] = c.v;
      out.energy[i] = ru.energy + rv.energy + k * eu * ev + lu * c.u * (1 + 0.5 * kRise * c.u) +
                      lv * c.v * (1 + 0.5 * kRise * c.v);
      a = ru.tangent, b = rv.tangent;
    }
    if (!tangent) continue;
    soften(a, b, k, kRise * lu, kRise * lv, out.crimp[0][i] > 0, out.crimp[1][i] > 0);
    (*tangent)[0][i] = a;
    (*tangent)[1][i] = b;
    (*tangent)[2][i] = k;
  }
}

}  // namespace loosefit::fabric
